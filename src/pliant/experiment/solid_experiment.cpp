#include "pliant/experiment/solid_experiment.h"

#include <algorithm>

#include "pliant/measurement/turning_points.h"

namespace pliant {

std::vector<std::vector<int>> SolidExperiment::series() const {
  std::vector<std::vector<int>> series;
  for (int row = 0; row < rows(); ++row) {
    if (std::ranges::binary_search(beginnings_, row)) series.emplace_back();
    series.back().push_back(row);
  }
  return series;
}

double SolidExperiment::reference() const { return measured_.cwiseAbs().maxCoeff(); }

void SolidExperiment::append_from_rest(int first_row, std::span<const double> driven,
                                       int specimen) {
  beginnings_.push_back(first_row);
  for (const HalfCycle& half : half_cycles_of(driven, reversal_threshold(driven, 0))) {
    frames_.push_back({first_row + half.first, half.last - half.first + 1, specimen});
  }
}

void give_by_frames(const Experiment& experiment, const PredictedFrame& all, FrameSink& sink) {
  const std::vector<Frame> frames = experiment.frames();
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const auto [first, count, specimen] = frames[f];
    sink.take(static_cast<int>(f),
              {all.value.segment(first, count), all.by.middleRows(first, count)});
  }
}

}  // namespace pliant
