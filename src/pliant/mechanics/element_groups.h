#pragma once

#include <functional>
#include <vector>

#include "pliant/base/parallel.h"

namespace pliant {

/// Neighbouring batches of elements in groups, and the groups in waves: within a wave no two groups
/// touch the same point or clip, so that they may add to the same gradient and Hessian at the same
/// time. Sums are taken in one order for any number of threads.
class ElementGroups {
 public:
  /// Batches begin .. end - 1.
  struct Group {
    int begin = 0, end = 0;
  };
  /// Appends the numbers of what a batch touches, points and clips, repeated at will.
  using Touched = std::function<void(int batch, std::vector<int>& touched)>;

  ElementGroups() = default;
  ElementGroups(int batches, const Touched& touched);

  const std::vector<std::vector<Group>>& waves() const { return waves_; }

  /// The sum of work(batch) over all batches.
  template <class Value, class Work>
  Value sum(const Work& work) const {
    Value total{};
    for (const std::vector<Group>& wave : waves_) {
      std::vector<Value> parts(wave.size());
      parallel_for(static_cast<int>(wave.size()), [&](int i) {
        const Group& group = wave[static_cast<size_t>(i)];
        Value part{};
        for (int batch = group.begin; batch < group.end; ++batch) part += work(batch);
        parts[static_cast<size_t>(i)] = part;
      });
      for (const Value& part : parts) total += part;
    }
    return total;
  }

 private:
  std::vector<std::vector<Group>> waves_;
};

}  // namespace pliant
