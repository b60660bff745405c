#include "pliant/contact/near_pairs.h"

#include <cstdint>
#include <utility>

namespace pliant {

namespace {

// Whether no point goes further than `most` beyond the mean of all: what all move alike brings none
// nearer to another.
bool stay_together(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to, double most) {
  const Eigen::Vector3d common = (to - from).rowwise().mean();
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    const Eigen::Vector3d own = to.col(i) - from.col(i) - common;
    if (own.squaredNorm() > most * most) return false;
  }
  return true;
}

}  // namespace

bool NearPairs::serves(const List& list, const Eigen::Matrix3Xd& positions) const {
  return stay_together(list.positions, positions, skin_ / 2);
}

std::shared_ptr<const NearPairs::List> NearPairs::last() const {
  const std::lock_guard lock(mutex_);
  return list_;
}

NearPairs::Pairs NearPairs::at(const Eigen::Matrix3Xd& positions, SearchCosts* costs) const {
  const Timed counted(costs, &SearchCosts::pairs);
  const auto known = last();
  if (known && serves(*known, positions)) return known->pairs;
  const Eigen::Matrix3Xd ways = Eigen::Matrix3Xd::Zero(3, positions.cols());
  return keep(positions, surface_->near_pairs(positions, ways, reach_ + skin_))->pairs;
}

NearPairs::Pairs NearPairs::between(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                                    SearchCosts* costs) const {
  const Timed counted(costs, &SearchCosts::pairs);
  const auto known = last();
  if (known && serves(*known, from) && serves(*known, to)) return known->pairs;
  return keep(to, surface_->near_pairs(from, to - from, reach_ + skin_))->pairs;
}

NearPairs::Pairs NearPairs::between_if_few(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to,
                                           SearchCosts* costs) const {
  const Timed counted(costs, &SearchCosts::pairs);
  // Cloth that lies on itself in some layers has tens of neighbours a triangle.
  constexpr std::int64_t kMost = 200'000, kMostOfTriangle = 100;
  const auto known = last();
  if (known && serves(*known, from) && serves(*known, to)) return known->pairs;
  if (stay_together(from, to, 1.001 * skin_)) return between(from, to);
  auto found = surface_->near_pairs_among(kMost + kMostOfTriangle * surface_->triangles(), from,
                                          to - from, reach_ + skin_);
  return found ? keep(to, std::move(*found))->pairs : nullptr;
}

std::shared_ptr<const NearPairs::List> NearPairs::keep(const Eigen::Matrix3Xd& positions,
                                                       std::vector<SurfacePair> pairs) const {
  auto made = std::make_shared<const List>(
      List{positions, std::make_shared<const std::vector<SurfacePair>>(std::move(pairs))});
  const std::lock_guard lock(mutex_);
  list_ = made;
  return made;
}

}  // namespace pliant
