#include "pliant/experiment/loop_branches.h"

#include <cmath>

namespace pliant {

double LoopBranch::reach() const { return x.empty() ? 0 : std::abs(x.back() - x.front()); }

std::optional<double> LoopBranch::at(double place) const {
  for (size_t i = 1; i < x.size(); ++i) {
    const double a = x[i - 1], b = x[i];
    if ((a - place) * (b - place) > 0 || a == b) continue;
    return y[i - 1] + (place - a) / (b - a) * (y[i] - y[i - 1]);
  }
  return std::nullopt;
}

std::vector<LoopBranch> branches_of(const LoopSeries& series, const MeasuredPath& path) {
  std::vector<LoopBranch> branches;
  for (int i = 0; i < series.abscissa.size(); ++i) {
    const auto row = static_cast<size_t>(i);
    const bool same = !branches.empty() && branches.back().direction == path.direction[row] &&
                      branches.back().specimen == path.specimen[row];
    if (!same) {
      LoopBranch next;
      next.direction = path.direction[row];
      next.specimen = path.specimen[row];
      // A branch begins where the one before it ended.
      if (!branches.empty() && branches.back().specimen == next.specimen) {
        next.x.push_back(branches.back().x.back());
        next.y.push_back(branches.back().y.back());
      }
      branches.push_back(next);
    }
    branches.back().x.push_back(series.abscissa(i));
    branches.back().y.push_back(series.ordinate(i));
  }
  return branches;
}

}  // namespace pliant
