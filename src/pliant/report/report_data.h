#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pliant/report/curves.h"
#include "pliant/report/prediction.h"
#include "pliant/report/results.h"
#include "pliant/report/strip_shapes.h"

namespace pliant::report {

/// Everything a report is made from.
struct ReportData {
  Results results;
  std::vector<ComponentCurve> curves;
  std::vector<Prediction> predictions;  ///< one an experiment, in the order of the results
  std::vector<std::optional<StripShapes>> shapes;  ///< alike; none where there are no strips
  /// `stvk`, ... where the directory's material file names it: decides how strains are explained.
  std::string membrane;
};

/// @throws InputError where a file of the directory is missing or not what its format says
ReportData read_report_data(const std::filesystem::path& directory);

}  // namespace pliant::report
