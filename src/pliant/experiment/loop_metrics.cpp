#include "pliant/experiment/loop_metrics.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/experiment/loop_branches.h"

namespace pliant {
namespace {

// Work along the part of a branch above `low`: what a way to the other side takes is no part of the
// cycle.
double work_above(const LoopBranch& branch, double low) {
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

bool any_unloads(const std::vector<const ComponentExperiment*>& experiments) {
  return std::ranges::any_of(experiments, [](const ComponentExperiment* experiment) {
    return unloads(experiment->path());
  });
}

std::optional<LoopMetrics> loop_metrics(const LoopSeries& series, const MeasuredPath& path) {
  const std::vector<LoopBranch> branches = branches_of(series, path);
  const double range = series.abscissa.maxCoeff() - series.abscissa.minCoeff();
  const LoopBranch* load = nullptr;
  const LoopBranch* unload = nullptr;
  for (size_t i = 0; i + 1 < branches.size(); ++i) {
    const LoopBranch &up = branches[i], &down = branches[i + 1];
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
  const double loading = load->at(middle).value_or(load->y.back());
  const double unloading = unload->at(middle).value_or(unload->y.back());
  metrics.secant_modulus = (load->y.back() - load->y.front()) / series.width /
                           ((high - load->x.front()) / series.length);
  metrics.hysteresis_ratio = (loading - unloading) / ((loading + unloading) / 2);
  const double loaded = work_above(*load, load->x.front());
  metrics.loop_loss = (loaded + work_above(*unload, load->x.front())) / loaded;
  return metrics;
}

}  // namespace pliant
