#pragma once

#include "pliant/material/density/density.h"

namespace pliant {

/// Weights of material samples as laws read them: eight rows, the columns of one batch of points
/// after those of the one before.
/// @param weights  a column a point, of which the last stands for those that fill up
inline Eigen::MatrixXd lane_weights(const Eigen::MatrixXd& weights, int batches) {
  const Eigen::Index samples = weights.rows();
  Eigen::MatrixXd lanes(kLanes, samples * batches);
  for (Eigen::Index i = 0; i < kLanes * batches && samples > 0; ++i) {
    const Eigen::Index point = std::min(i, weights.cols() - 1);
    lanes.block(i % kLanes, i / kLanes * samples, 1, samples) = weights.col(point).transpose();
  }
  return lanes;
}

/// Those of a batch.
inline LaneView of_batch(const Eigen::MatrixXd& lanes, int batch, int batches) {
  const Eigen::Index samples = lanes.cols() / batches;
  return {lanes.data() + kLanes * samples * batch, kLanes, samples};
}

}  // namespace pliant
