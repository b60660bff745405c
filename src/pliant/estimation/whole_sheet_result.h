#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/whole_sheet_test.h"

namespace pliant {

/// How a test that is only predicted compares with its prediction.
struct WholeSheetResult {
  std::string type;
  ExperimentInfo info;
  Eigen::VectorXd measured;  ///< SI
  WholeSheetPrediction prediction;
  double rms = 0;  ///< of the used rows, SI
};

}  // namespace pliant
