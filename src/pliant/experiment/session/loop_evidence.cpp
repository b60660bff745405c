#include "pliant/experiment/session/loop_evidence.h"

#include <cmath>

#include "pliant/measurement/session/frame_measures.h"

namespace pliant {

LoopEvidence& LoopEvidence::operator+=(const LoopEvidence& other) {
  above += other.above;
  squares += other.squares;
  forces += other.forces;
  rows += other.rows;
  return *this;
}

bool LoopEvidence::shows_loop() const {
  constexpr double kChance = 4, kSmallest = 0.005;  // standard errors; of the forces
  return above > kChance * std::sqrt(squares) && above > kSmallest * std::sqrt(forces * rows);
}

LoopEvidence loop_evidence(const SheetTest& test, const Eigen::VectorXd& predicted) {
  LoopEvidence sum;
  const std::vector<Frame> frames = test.frames();
  for (int frame = 1; frame < test.frame_count(); ++frame) {
    const auto [first, count, specimen] = frames[static_cast<std::size_t>(frame)];
    const double step = travel(test.session(), frame) - travel(test.session(), frame - 1);
    const Eigen::ArrayXd force = test.measured().segment(first, count).array();
    const Eigen::ArrayXd above = force - predicted.segment(first, count).array();
    sum += {(step > 0 ? 1 : -1) * (above * force.sign()).sum(), above.square().sum(),
            force.square().sum(), count};
  }
  return sum;
}

}  // namespace pliant
