#pragma once

#include <span>
#include <vector>

#include "pliant/experiment/experiment.h"

namespace pliant {

/// Forces or stresses of a solid along rows, some of which begin at rest; a law that remembers goes
/// along the others.
class SolidExperiment : public Experiment {
 public:
  /// Half cycles.
  std::vector<Frame> frames() const override { return frames_; }
  /// One from each row at rest to the next.
  std::vector<std::vector<int>> series() const override;
  double reference() const override;

  /// Rows that begin at rest, rising.
  const std::vector<int>& beginnings() const { return beginnings_; }

 protected:
  /// Appends rows that begin at rest, in half cycles of what drives them.
  void append_from_rest(int first_row, std::span<const double> driven, int specimen);

 private:
  std::vector<Frame> frames_;
  std::vector<int> beginnings_;
};

/// Gives what is predicted of all rows to a sink, frame by frame.
void give_by_frames(const Experiment& experiment, const PredictedFrame& all, FrameSink& sink);

}  // namespace pliant
