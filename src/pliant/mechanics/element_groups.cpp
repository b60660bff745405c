#include "pliant/mechanics/element_groups.h"

#include <algorithm>

namespace pliant {
namespace {

// Batches of a group: enough work for a thread to be worth waking, and few borders between groups,
// where a wave comes back to numbers that the wave before has touched.
constexpr int kGroup = 128;

std::vector<int> touched_by(const ElementGroups::Group& group,
                            const ElementGroups::Touched& touched) {
  std::vector<int> all;
  for (int batch = group.begin; batch < group.end; ++batch) touched(batch, all);
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

}  // namespace

// Each group joins the first wave that touches nothing of its own.
ElementGroups::ElementGroups(int batches, const Touched& touched) {
  std::vector<std::vector<size_t>> waves_at;  // that touch a point or clip
  for (int first = 0; first < batches; first += kGroup) {
    const Group group{first, std::min(first + kGroup, batches)};
    const std::vector<int> own = touched_by(group, touched);
    waves_at.resize(std::max(waves_at.size(), static_cast<size_t>(own.back()) + 1));
    std::vector<bool> taken(waves_.size() + 1, false);
    for (const int one : own) {
      for (const size_t wave : waves_at[static_cast<size_t>(one)]) taken[wave] = true;
    }
    const auto free = std::find(taken.begin(), taken.end(), false) - taken.begin();
    const auto wave = static_cast<size_t>(free);
    if (wave == waves_.size()) waves_.emplace_back();
    waves_[wave].push_back(group);
    for (const int one : own) waves_at[static_cast<size_t>(one)].push_back(wave);
  }
}

}  // namespace pliant
