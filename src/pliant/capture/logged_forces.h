#pragma once

#include "pliant/capture/frame_forces.h"
#include "pliant/capture/frame_moments.h"
#include "pliant/capture/log_clock.h"

namespace pliant {

/// What is expected where a clock is not found.
inline constexpr const char* kStatedStart =
    "`start`, the time of the first frame by the log's clock";

/// Forces by a log, whose clock may have to be found first.
class LoggedForces : public FrameForces {
 public:
  bool needs_clock() const override { return needs_clock_; }
  std::string find_clock(const std::vector<double>& ways) override;

 protected:
  /// A log and the ways that go with it.
  struct Together {
    ClockLog log;
    std::vector<double> ways;  ///< in each frame, NaN where they were not seen (m)
    std::string by;            ///< whose ways they are, e.g. "the clip upper"
  };

  /// @param dic  outlives the forces, and has some
  explicit LoggedForces(const DicFile& dic)
      : dic_(dic),
        moments_(moments_by_names(dic.files())),
        needs_clock_(dic.forces->needs_clock()) {}

  /// To be called when the rows are read: places them where the clock is known.
  void place_by_stated_start();

  /// Whether a frame was taken beside the times of the log.
  bool is_beyond(std::size_t frame, const std::vector<double>& times) const;

  const DicForces& forces() const { return *dic_.forces; }
  /// When the frames were taken, see moments_by_names.
  const std::vector<int>& moments() const { return moments_; }
  const DicFile& dic() const { return dic_; }

 private:
  /// @throws InputError where the log tells of no way
  virtual Together together(const std::vector<double>& ways) const = 0;
  /// NaN at moments of which there is no frame.
  std::vector<double> by_moment(const std::vector<double>& of_frames) const;
  /// Finds the rows of each frame.
  /// @param start  of the first frame by the log's clock (s)
  virtual void place(double start) = 0;

  const DicFile& dic_;
  std::vector<int> moments_;
  bool needs_clock_;
};

}  // namespace pliant
