#include "pliant/study/frame_measure_table.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "pliant/io/csv_writer.h"
#include "pliant/measurement/session/frame_measures.h"

namespace pliant {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A column's name, its numbers in SI units times `factor`.
struct Measure {
  const char* name;
  double factor;
  std::optional<double> (*value)(const Session& session, int frame);
};

constexpr Measure kMeasures[] = {
    {"extension_mm", 1e3, clip_extension},
    {"pull_N", 1, clip_pull},
    {"effective_shear_deg", 180 / std::numbers::pi, effective_shear},
    {"aggregated_torque_N_m", 1,
     [](const Session& session, int frame) -> std::optional<double> {
       return aggregated_torque(session, frame);
     }},
    {"stretching_force_difference_N", 1, stretching_force_difference},
};

}  // namespace

std::string frame_measure_table(const SheetComparison& sheet) {
  std::vector<std::string> header{"frame", "time_s"};
  for (const Measure& measure : kMeasures) {
    header.push_back(std::string("measured_") + measure.name);
    header.push_back(std::string("predicted_") + measure.name);
  }
  CsvWriter csv(header);
  for (int frame = 0; frame < sheet.measured.frame_count(); ++frame) {
    const auto found = std::ranges::lower_bound(sheet.frames, frame);
    const bool is_predicted = found != sheet.frames.end() && *found == frame;
    csv.cell(frame);
    csv.cell(sheet.measured.frames[static_cast<std::size_t>(frame)].time.value_or(kNone));
    for (const Measure& measure : kMeasures) {
      csv.cell(measure.factor * measure.value(sheet.measured, frame).value_or(kNone));
      const auto predicted =
          is_predicted
              ? measure.value(sheet.predicted, static_cast<int>(found - sheet.frames.begin()))
              : std::nullopt;
      csv.cell(measure.factor * predicted.value_or(kNone));
    }
    csv.end_row();
  }
  return csv.text();
}

}  // namespace pliant
