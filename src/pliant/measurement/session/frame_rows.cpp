#include "pliant/measurement/session/frame_rows.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/nearest_name.h"

namespace pliant {

FrameRows::FrameRows(const std::filesystem::path& file, int frames)
    : table_(read_csv(file, {.rows_optional = true})) {
  for (const long number : table_.integers("frame")) {
    if (number < 0 || number >= frames) {
      throw InputError(location(static_cast<int>(frames_.size()), "frame"),
                       fmt::format("there is no frame {}", number),
                       fmt::format("numbers from 0 to {}", frames - 1));
    }
    frames_.push_back(static_cast<int>(number));
  }
}

Location FrameRows::location(int row, std::string_view column) const {
  return {table_.file(), table_.line(static_cast<std::size_t>(row)), std::string(column)};
}

std::vector<int> FrameRows::clips(const std::vector<SessionClip>& clips) const {
  std::vector<std::string> names;
  for (const SessionClip& clip : clips) names.push_back(clip.name);
  std::vector<int> found;
  for (const std::string& name : table_.texts("clip")) {
    const auto clip = std::find(names.begin(), names.end(), name);
    if (clip == names.end()) {
      throw InputError(location(static_cast<int>(found.size()), "clip"),
                       "there is no clip " + quoted_value(name) + did_you_mean(name, names),
                       names.empty() ? "no rows: the session has no clips" : list_of_names(names));
    }
    found.push_back(static_cast<int>(clip - names.begin()));
  }
  return found;
}

std::optional<std::string> FrameRows::unused() const {
  const std::vector<std::string> columns = table_.unused_columns();
  if (columns.empty()) return std::nullopt;
  return fmt::format("{}: not used: {}", table_.file(), list_of_names(columns));
}

void FrameTimes::take(const FrameRows& rows) {
  const auto read = rows.table().optional_quantity("time", Dimension::time);
  if (!read) return;
  const std::string column = *rows.table().quantity_column("time");
  for (int row = 0; row < rows.rows(); ++row) {
    const double time = (*read)[static_cast<std::size_t>(row)];
    auto& known = times_[static_cast<std::size_t>(rows.frame(row))];
    if (known && known->time != time) {
      throw InputError(
          rows.location(row, column),
          fmt::format("frame {} is at {} s, and at {} s in {}, line {}", rows.frame(row), time,
                      known->time, known->where.file, known->where.line),
          "one time a frame");
    }
    if (!known) known = FrameTime{time, rows.location(row, column)};
  }
}

std::vector<std::optional<double>> FrameTimes::increasing() const {
  std::vector<std::optional<double>> times;
  const FrameTime* last = nullptr;
  for (const auto& known : times_) {
    if (last != nullptr && known && known->time <= last->time) {
      throw InputError(known->where,
                       fmt::format("frame {} is at {} s, not after the frame before it ({} s)",
                                   times.size(), known->time, last->time),
                       "times that increase with the numbers of frames");
    }
    if (known) last = &*known;
    times.push_back(known ? std::optional(known->time) : std::nullopt);
  }
  return times;
}

}  // namespace pliant
