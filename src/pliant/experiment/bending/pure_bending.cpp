#include "pliant/experiment/bending/pure_bending.h"

#include <utility>

#include "pliant/experiment/bending/pure_bending_type.h"
#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/strip_figures.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

StrainRecord record_of(std::vector<double> curvatures) {
  StrainRecord record;
  record.driven = std::move(curvatures);
  record.strain_of = [](double curvature) { return kStrainPerCurvature * curvature; };
  record.quantity = {"moment_N", "moment per width", "N", 1};
  record.offset = "moment_offset";
  record.apparatus.assign(record.driven.size(), 0);
  return record;
}

StrainRecord read_record(const DataRows& data) {
  StrainRecord record = record_of(data.quantity("curvature", Dimension::curvature));
  record.measured = data.quantity("moment", Dimension::force);
  require_change(record.measured, data, "moment");
  require_change(record.driven, data, "curvature");
  return record;
}

}  // namespace

PureBending::PureBending(const SampledPath& path) : ImposedStrain(record_of(path.value), path) {}

PureBending::PureBending(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth)
    : ImposedStrain(spec, spec_of<PureBendingSpec>(spec).initial_friction, data,
                    read_record(data)) {
  info_.handled.push_back(
      "the curvature drives the path, one curvature from clamp to clamp; strain is 3 x curvature");
  StripFigures strip(*spec.test, cloth.density);
  const auto curvature =
      strip.column("curvature", Dimension::curvature, data.quantity_unit("curvature"));
  const auto moment = strip.column("moment", Dimension::force, data.quantity_unit("moment"));
  strip.add(figures::kCurvature, largest_strain() / kStrainPerCurvature, {{curvature}});
  if (secant() > 0) {
    strip.add_bending_stiffness(kStrainPerCurvature * secant(), {{moment}, {curvature, -1}});
  }
  info_.questions = first_asked({swap_question(*this, "curvature", "moment"),
                                 sign_question("moment", "curvature"), strip.question()});
}

std::optional<LoopSeries> PureBending::loop(const Eigen::VectorXd& moment) const {
  std::optional<LoopSeries> series = ImposedStrain::loop(moment);
  series->abscissa /= kStrainPerCurvature;
  return series;
}

}  // namespace pliant
