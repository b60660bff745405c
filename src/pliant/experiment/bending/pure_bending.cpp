#include "pliant/experiment/bending/pure_bending.h"

#include "pliant/experiment/experiment_data.h"
#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

StrainRecord read_record(const DataRows& data) {
  StrainRecord record;
  record.driven = data.quantity("curvature", Dimension::curvature);
  record.measured = data.quantity("moment", Dimension::force);
  record.strain_of = [](double curvature) { return kStrainPerCurvature * curvature; };
  record.quantity = {"moment_N", "moment per width", "N", 1};
  record.offset = "moment_offset";
  require_change(record.measured, data, "moment");
  require_change(record.driven, data, "curvature");
  record.apparatus.assign(record.driven.size(), 0);
  return record;
}

}  // namespace

PureBending::PureBending(const ExperimentSpec& spec, const DataRows& data)
    : ImposedStrain(spec, data, read_record(data)) {
  info_.handled.push_back(
      "the curvature drives the path, one curvature from clamp to clamp; strain is 3 x curvature");
}

std::optional<LoopSeries> PureBending::loop(const Eigen::VectorXd& moment) const {
  std::optional<LoopSeries> series = ImposedStrain::loop(moment);
  series->abscissa /= kStrainPerCurvature;
  return series;
}

}  // namespace pliant
