#include "pliant/study/sheet_experiment.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/session/strip_sheets.h"
#include "pliant/geometry/grid_pattern.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/measurement/session/clip_grid.h"
#include "pliant/measurement/session/on_mesh.h"
#include "pliant/study/study_experiments.h"

namespace pliant {
namespace {

/// Cells on the longer side of a sheet ([T] 3.4.1).
constexpr int kCells = 24;
/// A rest mesh that covers less of its bounding box is no rectangle along weft and warp.
constexpr double kRectangle = 0.95;

bool is_rectangle(const Session& session) {
  const Eigen::Vector3d extent =
      session.rest.positions.rowwise().maxCoeff() - session.rest.positions.rowwise().minCoeff();
  return rest_area(session.rest) > kRectangle * extent.x() * extent.y();
}

/// @throws InputError where the springs of a model have no grid to be on
void require_grid_for_springs(const ExperimentSpec& spec, const Session& session,
                              const ModelOptions& model) {
  if (!needs_grid(model) || is_cut_from_rectangles(session.rest)) return;
  throw InputError(spec.where,
                   fmt::format("springs cannot simulate {} on its own mesh, which is no grid of "
                               "rectangles along weft and warp",
                               quoted_value(spec.name)),
                   "another model, or a rectangular sheet that `model.mesh` gives a grid");
}

Session on_fit_mesh(const Session& session, const ModelOptions& model) {
  if (model.measured_mesh || !is_rectangle(session)) return session;
  const double longer = std::max(session.sample.width, session.sample.height);
  return on_mesh(session, grid_on_clips(session, model.mesh_factor *
                                                     model.mesh_edge.value_or(longer / kCells)));
}

/// One fabric has one mass per area: another one tells of a wrong mass, or of another fabric.
void warn_of_density(const std::string& name, double density, double of_study,
                     const std::vector<SheetExperiment>& experiments, StudyResult& result) {
  constexpr double kAgreement = 0.05;
  const auto differs = [&](double other) { return std::abs(density - other) > kAgreement * other; };
  const auto warn = [&](const std::string& whose, double other) {
    result.warnings.push_back(fmt::format("{}: its sheet weighs {}, {} {}: is it the same fabric?",
                                          name, format_quantity(density, Dimension::area_density),
                                          whose, format_quantity(other, Dimension::area_density)));
  };
  if (of_study > 0) {
    if (differs(of_study)) warn("the fabric, as stated,", of_study);
    return;
  }
  if (experiments.empty()) return;
  const SheetTest& first = experiments.front().test;
  const double of_first = area_density(first.session());
  if (differs(of_first)) warn("that of " + first.name(), of_first);
}

/// The strips of an experiment, one test a specimen.
void add_strips(const ExperimentSpec& spec, const Study& study,
                std::vector<SheetExperiment>& experiments, StudyResult& result) {
  if (!spec.after.empty()) {
    throw InputError(after_location(spec), "strips as sheets are not followed from test to test",
                     "strips in one dimension, or no `after`");
  }
  StripSheets strips = sheets_of_strips(spec, DataRows(spec.data), study.model, study.density);
  add_remarks(spec.name, strips, result);
  for (SheetTest& test : strips.tests) {
    experiments.push_back({std::move(test), spec.role, spec.type, spec.direction, strips.handled});
  }
}

}  // namespace

std::vector<SheetExperiment> read_sheet_experiments(const Study& study, StudyResult& result) {
  std::vector<SheetExperiment> experiments;
  for (const ExperimentSpec& spec : study.experiments) {
    if (!is_sheet(spec, study.model)) continue;
    if (!facts_of_test(spec.type).measures_sheets) {
      add_strips(spec, study, experiments, result);
      continue;
    }
    const Session measured = read_session(spec.data.files.front());
    add_remarks(spec.name, measured, result);
    warn_of_density(spec.name, area_density(measured), study.density, experiments, result);
    Session session = on_fit_mesh(measured, study.model);
    require_grid_for_springs(spec, session, study.model);
    const std::string test = session.test;
    experiments.push_back(
        {sheet_test_of(spec, std::move(session)), spec.role, spec.type, test, {}});
  }
  return experiments;
}

}  // namespace pliant
