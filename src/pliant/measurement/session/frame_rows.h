#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/io/csv.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// A table of a session with rows of frames, by their numbers; a header alone is a table too.
class FrameRows {
 public:
  /// @param frames  of the session
  /// @throws InputError, also for a frame that is not there
  FrameRows(const std::filesystem::path& file, int frames);

  int rows() const { return static_cast<int>(frames_.size()); }
  int frame(int row) const { return frames_[static_cast<std::size_t>(row)]; }
  const CsvTable& table() const { return table_; }
  Location location(int row, std::string_view column) const;

  /// The clip of each row.
  /// @throws InputError for a clip that is not there
  std::vector<int> clips(const std::vector<SessionClip>& clips) const;

  /// Columns that were not read, in words; none where there are none.
  std::optional<std::string> unused() const;

 private:
  CsvTable table_;
  std::vector<int> frames_;
};

/// Collects the times of frames from the column `time` of tables.
class FrameTimes {
 public:
  explicit FrameTimes(int frames) : times_(static_cast<std::size_t>(frames)) {}

  /// @throws InputError for two times of a frame
  void take(const FrameRows& rows);

  /// The time of each frame (s), where a table tells it.
  /// @throws InputError where they do not increase
  std::vector<std::optional<double>> increasing() const;

 private:
  struct FrameTime {
    double time = 0;  // s
    Location where;
  };
  std::vector<std::optional<FrameTime>> times_;
};

/// Whether a table gets a column `time_s`: it has rows, all of them of frames with a time.
/// @param has_rows  of a frame
template <typename HasRows>
bool all_rows_timed(const Session& session, const HasRows& has_rows) {
  bool any = false;
  for (const SessionFrame& frame : session.frames) {
    if (!has_rows(frame)) continue;
    if (!frame.time) return false;
    any = true;
  }
  return any;
}

}  // namespace pliant
