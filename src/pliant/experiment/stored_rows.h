#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/experiment.h"
#include "pliant/experiment/predictor.h"

namespace pliant {

/// All rows of an experiment as they are predicted.
struct PredictedRows {
  Eigen::VectorXd value;        ///< SI
  Eigen::MatrixXd by;           ///< rows x chosen parameters; empty unless asked for
  Eigen::VectorXd length_gain;  ///< empty, or |d value / d length|
};

/// Puts the rows of all frames of an experiment in one place.
class StoredRows : public FrameSink {
 public:
  /// @param derivatives  columns of what comes; 0: none are wanted
  explicit StoredRows(const Experiment& experiment, Eigen::Index derivatives = 0);

  void take(int frame, const PredictedFrame& rows) override;

  const PredictedRows& rows() const& { return rows_; }
  PredictedRows rows() && { return std::move(rows_); }

 private:
  std::vector<Frame> frames_;
  PredictedRows rows_;
};

}  // namespace pliant
