#include "pliant/contact/near_pairs.h"

#include <utility>

namespace pliant {

// What all points move alike brings none nearer to another.
bool NearPairs::serves(const List& list, const Eigen::Matrix3Xd& positions) const {
  const Eigen::Vector3d common = (positions - list.positions).rowwise().mean();
  for (Eigen::Index i = 0; i < positions.cols(); ++i) {
    const Eigen::Vector3d own = positions.col(i) - list.positions.col(i) - common;
    if (own.squaredNorm() > skin_ * skin_ / 4) return false;
  }
  return true;
}

std::shared_ptr<const NearPairs::List> NearPairs::last() const {
  const std::lock_guard lock(mutex_);
  return list_;
}

NearPairs::Pairs NearPairs::at(const Eigen::Matrix3Xd& positions) const {
  const auto known = last();
  if (known && serves(*known, positions)) return known->pairs;
  const Eigen::Matrix3Xd ways = Eigen::Matrix3Xd::Zero(3, positions.cols());
  return keep(positions, surface_->near_pairs(positions, ways, reach_ + skin_))->pairs;
}

NearPairs::Pairs NearPairs::between(const Eigen::Matrix3Xd& from,
                                    const Eigen::Matrix3Xd& to) const {
  const auto known = last();
  if (known && serves(*known, from) && serves(*known, to)) return known->pairs;
  return keep(to, surface_->near_pairs(from, to - from, reach_ + skin_))->pairs;
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
