#include "pliant/estimation/sheet/sample_stage.h"

#include <cmath>

#include "pliant/estimation/sampled_numbers.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/geometry/spread_points.h"

namespace pliant {
namespace {

/// Places by hand, or at the middles of the cells of a grid over the sheet at rest.
std::vector<Eigen::Vector3d> places_of(const SampleOptions& options, const TriangleMesh& sheet) {
  if (!options.places.empty()) return options.places;
  const Eigen::Vector2d low = sheet.rest_corners.rowwise().minCoeff();
  const Eigen::Vector2d size = sheet.rest_corners.rowwise().maxCoeff() - low;
  return middles_of_cells({low.x(), low.y(), 0}, {size.x(), size.y(), 0}, options.grid);
}

MaterialSamples samples_of(const FitSettings& settings, const SheetStage& stage,
                           const Material& material) {
  const SampleOptions& options = *settings.model.samples;
  const Session& session = stage.tests.front()->session();
  const std::vector<Eigen::Vector3d> places = places_of(options, session.rest);
  MaterialSamples samples;
  samples.width = options.width.value_or(
      places.size() > 1 ? spacing_of_neighbours(places)
                        : std::hypot(session.sample.width, session.sample.height));
  for (const Eigen::Vector3d& place : places) {
    SampledComponents& sample = samples.at.emplace_back(SampledComponents{place, {}});
    for (const ComponentGroup& group : stage.groups) {
      if (!may_differ(settings, group)) continue;
      for (const std::string& name : group) {
        sample.components[name] = material.components.at(name);
      }
    }
  }
  return samples;
}

/// Numbers that samples have more than the sheet that is the same everywhere.
int numbers_more(const SheetStage& stage, const Material& material) {
  int more = 0;
  for (const ComponentGroup& group : stage.groups) {
    more += (copies_of(material, group.front()) - 1) * law_of(material, group).parameter_count();
  }
  return more;
}

/// Places of vertices are measured each for itself; the noise of a pose is in all forces of a
/// frame.
double effective_rows(const SheetStage& stage) {
  double rows = 0;
  for (const SheetTest* test : stage.tests) {
    const bool positions = test->objective() == SheetObjective::positions;
    for (int frame = 0; frame < test->frame_count(); ++frame) {
      rows += positions ? test->compared(frame) : 1;
    }
  }
  return rows;
}

}  // namespace

void fit_samples(SheetFitting& fitting, const SheetStage& stage) {
  Material& material = fitting.fit().material;
  const double without = fitting.solve(stage);
  material.samples = samples_of(fitting.settings(), stage, material);
  const double with = fitting.solve_and_record(stage);
  const double rows = effective_rows(stage);
  if (without > accuracy_of(stage) &&
      is_worth({without, 0, 0, rows}, {with, numbers_more(stage, material), 0, rows})) {
    return;
  }
  fitting.fit().warnings.emplace_back(kNoSamples);
}

}  // namespace pliant
