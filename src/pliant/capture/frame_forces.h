#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/capture/clip_motion.h"
#include "pliant/capture/cord_line.h"
#include "pliant/capture/dic_file.h"
#include "pliant/capture/force_log.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// Why a frame has no force.
inline constexpr const char* kBeyondLog = "was taken when the log was not running";

/// What pulls at the clips of a sample in each frame: cords of a table, or that are seen while
/// cells pull them, or a tester's log, whose clock may have to be found first.
class FrameForces {
 public:
  /// @param dic    outlives the forces
  /// @param clips  of the session
  /// @throws InputError
  FrameForces(const DicFile& dic, const std::vector<SessionClip>& clips, int frames);

  /// Empty where there is none, or its clock is to be found yet.
  const FrameLog& log() const { return log_; }
  const CellLog& cells() const { return cells_; }
  /// Where the cords of the cells are in a frame, in the sample's axes.
  void see_cords(int frame, std::vector<std::optional<CordLine>> lines);
  /// Standard deviation of a component of a clip's force (N), where it is known.
  std::optional<double> noise() const;
  /// Whether cords are told or seen, and none of them in a frame.
  bool is_free(int frame) const;
  bool needs_clock() const { return needs_clock_; }
  /// @param ways  of the clip that a tester's log is of, outwards and against the other, NaN where
  ///              it is not known (m); cells have those of their cords
  /// @return what was found, for the user
  /// @throws InputError
  std::string find_clock(const std::vector<double>& ways);
  /// Whether a tester's log is of a clip whose way is to be told.
  bool needs_way() const { return needs_clock_ && lines_.empty(); }
  /// Of the clip that the log is of.
  std::size_t pulled() const;

  /// Puts time and forces into a frame.
  /// @param held  of each clip
  /// @return why that frame cannot be used, or nothing
  std::string add_to(SessionFrame& frame, int number, const std::vector<HeldPlace>& held) const;

 private:
  std::vector<double> ways_of_cords() const;
  void place_cells(double start);
  double largest_pull(std::size_t cell) const;
  std::string add_cells(SessionFrame& frame, std::size_t number) const;
  std::string add_tester(SessionFrame& frame, std::size_t number,
                         const std::vector<HeldPlace>& held) const;

  const DicFile& dic_;
  int frames_;
  FrameLog rows_, log_;
  bool needs_clock_ = false;
  CellRows cell_rows_;
  CellLog cells_;
  std::vector<std::vector<std::optional<CordLine>>> lines_;  // by frame and cell
  std::vector<std::vector<std::vector<CordForce>>> cords_;   // by frame and clip
};

}  // namespace pliant
