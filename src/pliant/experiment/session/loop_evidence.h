#pragma once

#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// Evidence of a loop in a session: sums over frames, to be added over sessions.
struct LoopEvidence {
  double above = 0;  ///< sum of measured minus predicted forces while clips go on, less that while
                     ///< they return (N)
  double squares = 0;  ///< of the differences (N^2)
  double forces = 0;   ///< squares of the measured ones (N^2)
  int rows = 0;

  LoopEvidence& operator+=(const LoopEvidence& other);
  /// Whether the measured forces lie above the predicted ones on the way on and below them on the
  /// way back, by more than chance.
  bool shows_loop() const;
};

/// @param predicted  of all rows of the test
LoopEvidence loop_evidence(const SheetTest& test, const Eigen::VectorXd& predicted);

}  // namespace pliant
