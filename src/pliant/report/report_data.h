#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pliant/material/material.h"
#include "pliant/report/curves.h"
#include "pliant/report/prediction.h"
#include "pliant/report/sheet_session.h"
#include "pliant/report/strip_shapes_file.h"
#include "pliant/study/results.h"

namespace pliant::report {

/// A full-field session of the results.
struct SheetData {
  SheetSession session;
  std::optional<double> rms_distance;    ///< of all free nodes (m); where they were seen
  std::optional<double> rms_clip_force;  ///< N; where forces are compared
};

/// A test in which all of a material shows together.
struct WholeSheetData {
  ResultWholeSheet stated;
  std::string picture;  ///< an SVG document, or nothing
};

/// Everything a report is made from.
struct ReportData {
  Results results;
  std::vector<ComponentCurve> curves;
  std::vector<Prediction> predictions;  ///< one an experiment, in the order of the results
  std::vector<std::optional<StripShapes>> shapes;  ///< alike; none where there are no strips
  std::vector<std::optional<SheetData>> sheets;    ///< alike; none where there are no sessions
  std::vector<WholeSheetData> whole_sheets;
  std::optional<Material> material;  ///< of sessions and of samples, where its file is there

  /// Whether there is nothing but full-field sessions.
  bool is_of_sheets() const;
  /// Whether there is nothing but strips that were fitted as sheets.
  bool is_of_strips() const;
};

/// @throws InputError where a file of the directory is missing or not what its format says
ReportData read_report_data(const std::filesystem::path& directory);

}  // namespace pliant::report
