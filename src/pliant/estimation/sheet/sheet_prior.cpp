#include "pliant/estimation/sheet/sheet_prior.h"

#include <cstddef>

namespace pliant {
namespace {

constexpr double kCordsDiffer = 0.02;  // N

bool are_cords_of_a_clip(const SheetUnknown& one, const SheetUnknown& other) {
  return !one.clip.empty() && one.owner == other.owner && one.clip == other.clip;
}

}  // namespace

double SheetPrior::miss(const Eigen::VectorXd& values) const {
  double off = -mean;
  for (const auto& [unknown, factor] : sum) off += factor * values(unknown);
  return off / sd;
}

std::vector<SheetPrior> priors_of(const std::vector<SheetUnknown>& unknowns) {
  std::vector<SheetPrior> priors;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    const auto place = static_cast<Eigen::Index>(u);
    const SheetUnknown& own = unknowns[u];
    if (own.prior) priors.push_back({{{place, 1.0}}, own.prior->mean, own.prior->sd});
    const bool pair = u > 0 && are_cords_of_a_clip(unknowns[u - 1], own);
    if (pair && !own.fixed && !unknowns[u - 1].fixed) {
      priors.push_back({{{place - 1, -1.0}, {place, 1.0}}, 0, kCordsDiffer});
    }
  }
  return priors;
}

}  // namespace pliant
