#pragma once

#include <memory>
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

/// What pulls at the clips of a sample in each frame; of this class itself: nothing does.
class FrameForces {
 public:
  virtual ~FrameForces() = default;

  /// Empty where there is none, or its clock is to be found yet.
  const FrameLog& log() const { return log_; }
  /// Where the cords of cells are in a frame, in the sample's axes.
  virtual void see_cords(int /*frame*/, std::vector<std::optional<CordLine>> /*lines*/) {}
  /// Standard deviation of a component of a clip's force (N), where it is known.
  virtual std::optional<double> noise() const { return std::nullopt; }
  /// What may be out of balance for each cord and be no fault (N).
  virtual double balance_bound() const { return kCordFriction; }
  /// Whether cords are told or seen, and none of them in a frame.
  virtual bool is_free(int /*frame*/) const { return false; }
  virtual bool needs_clock() const { return false; }
  /// Whether the way of the clip that the log is of is to be told.
  virtual bool needs_way() const { return false; }
  /// @param ways  of that clip, outwards and against the other, NaN where it is not known (m)
  /// @return what was found, for the user
  /// @throws InputError
  virtual std::string find_clock(const std::vector<double>& /*ways*/) { return {}; }

  /// What speaks against them, once the clock is known.
  /// @param ways  as above
  virtual std::vector<std::string> warnings(const std::vector<double>& /*ways*/) const {
    return {};
  }

  /// Puts time and forces into a frame.
  /// @param held  of each clip
  /// @return why that frame cannot be used, or nothing
  std::string add_to(SessionFrame& frame, int number, const std::vector<HeldPlace>& held) const;

 protected:
  FrameLog log_;

 private:
  /// The forces; there is a place for the cords of each clip.
  virtual std::string add_forces(SessionFrame& /*frame*/, std::size_t /*number*/,
                                 const std::vector<HeldPlace>& /*held*/) const {
    return {};
  }
};

/// Those of a dic/1 file: cords of a table, cords that are seen while cells pull them, or a
/// tester's log.
/// @param dic    outlives the forces
/// @param clips  of the session
/// @throws InputError
std::unique_ptr<FrameForces> frame_forces(const DicFile& dic,
                                          const std::vector<SessionClip>& clips);

}  // namespace pliant
