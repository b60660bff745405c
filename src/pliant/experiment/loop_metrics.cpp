#include "pliant/experiment/loop_metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace pliant {
namespace {

struct Branch {
  std::vector<double> x, y;
  int direction = 0;
  int specimen = 0;
  double reach() const { return x.empty() ? 0 : std::abs(x.back() - x.front()); }
};

std::vector<Branch> branches_of(const LoopSeries& series, const MeasuredPath& path) {
  std::vector<Branch> branches;
  for (int i = 0; i < series.abscissa.size(); ++i) {
    const auto row = static_cast<size_t>(i);
    const bool same = !branches.empty() && branches.back().direction == path.direction[row] &&
                      branches.back().specimen == path.specimen[row];
    if (!same) {
      Branch next;
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

// Work along the part of a branch above `low`: what a way to the other side takes is no part of the
// cycle.
double work_above(const Branch& branch, double low) {
  double sum = 0;
  for (size_t i = 1; i < branch.x.size(); ++i) {
    const double from = branch.x[i - 1], to = branch.x[i];
    const double begin = std::max(from, low), end = std::max(to, low);
    if (begin == end) continue;
    const double slope = (branch.y[i] - branch.y[i - 1]) / (to - from);
    sum += (end - begin) * (branch.y[i - 1] + slope * ((begin + end) / 2 - from));
  }
  return sum;
}

// Ordinate where the branch passes x; its samples may be noisy, the first passage counts.
double ordinate_at(const Branch& branch, double x) {
  for (size_t i = 1; i < branch.x.size(); ++i) {
    const double a = branch.x[i - 1], b = branch.x[i];
    if ((a - x) * (b - x) > 0 || a == b) continue;
    return branch.y[i - 1] + (x - a) / (b - a) * (branch.y[i] - branch.y[i - 1]);
  }
  return branch.y.back();
}

constexpr double kUnloadingShare = 0.1;

}  // namespace

bool unloads(const MeasuredPath& path) {
  const auto [low, high] = std::minmax_element(path.strain.begin(), path.strain.end());
  const int side = -*low > *high ? -1 : 1;  // to which the path goes further
  for (size_t i = 0; i < path.strain.size(); ++i) {
    const auto anchor = static_cast<size_t>(path.anchor[i]);
    const double back = side * (path.strain[anchor] - path.strain[i]);
    if (side * path.direction[i] == -1 && back > kUnloadingShare * (*high - *low)) return true;
  }
  return false;
}

std::optional<LoopMetrics> loop_metrics(const LoopSeries& series, const MeasuredPath& path) {
  const std::vector<Branch> branches = branches_of(series, path);
  const double range = series.abscissa.maxCoeff() - series.abscissa.minCoeff();
  const Branch* load = nullptr;
  const Branch* unload = nullptr;
  for (size_t i = 0; i + 1 < branches.size(); ++i) {
    const Branch &up = branches[i], &down = branches[i + 1];
    if (up.direction != 1 || down.direction != -1 || up.specimen != down.specimen) continue;
    if (down.reach() < kUnloadingShare * range) continue;
    if (load != nullptr && down.reach() <= unload->reach()) continue;
    load = &up;
    unload = &down;
  }
  if (load == nullptr) return std::nullopt;

  LoopMetrics metrics;
  const double low = std::max(load->x.front(), unload->x.back());
  const double high = load->x.back();
  const double middle = (low + high) / 2;
  const double loading = ordinate_at(*load, middle);
  const double unloading = ordinate_at(*unload, middle);
  metrics.secant_modulus = (load->y.back() - load->y.front()) / series.width /
                           ((high - load->x.front()) / series.length);
  metrics.hysteresis_ratio = (loading - unloading) / ((loading + unloading) / 2);
  const double loaded = work_above(*load, load->x.front());
  metrics.loop_loss = (loaded + work_above(*unload, load->x.front())) / loaded;
  return metrics;
}

}  // namespace pliant
