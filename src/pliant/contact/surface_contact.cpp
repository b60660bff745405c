#include "pliant/contact/surface_contact.h"

#include <algorithm>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "pliant/base/parallel.h"
#include "pliant/contact/barrier.h"
#include "pliant/contact/coulomb.h"

namespace pliant {

/// A pair that pressed against each other when a step began.
struct SurfaceContact::Rubbing {
  SurfacePair pair;
  Eigen::Vector4d weights;
  Eigen::Vector3d normal;
  double largest_friction = 0;  // N

  Eigen::Matrix3d plane() const {
    return Eigen::Matrix3d::Identity() - normal * normal.transpose();
  }
};

/// What a step begins with.
struct SurfaceContact::Lagged {
  Eigen::Matrix3Xd positions;
  std::vector<Rubbing> rubbing;
};

/// The barrier of a pair, times how much its edges cross.
struct SurfaceContact::Push {
  double energy = 0;
  double normal_force = 0;  // N
  double curvature = 0;     // by the distance, N/m
  Eigen::Vector4d weights = Eigen::Vector4d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  PairPoints gradient = PairPoints::Zero();  // N

  bool acts() const { return energy > 0; }
};

namespace {

constexpr double kKeptInWay = 0.1;  // of its distance, by what makes way

// How much two edges cross, from 0 for parallel ones to 1: smoothly (Li et al., Incremental
// Potential Contact, ACM TOG 39 (2020) 49, section 5.2).
struct Crossing {
  double share = 1;
  PairPoints gradient;  // 1/m
};

Crossing crossing_of(const PairPoints& x, double built_one, double built_other) {
  constexpr double kParallel = 1e-3;  // square of the sine up to which edges count as such
  const Eigen::Vector3d one = x.col(1) - x.col(0), other = x.col(3) - x.col(2);
  const double whole = kParallel * built_one * built_one * built_other * built_other;
  const double sine = one.cross(other).squaredNorm() / whole;
  if (sine >= 1) return {1, PairPoints::Zero()};
  const double dot = one.dot(other), slope = 2 * (1 - sine) / whole;
  const Eigen::Vector3d by_one = 2 * slope * (other.squaredNorm() * one - dot * other);
  const Eigen::Vector3d by_other = 2 * slope * (one.squaredNorm() * other - dot * one);
  Crossing crossing{sine * (2 - sine), {}};
  crossing.gradient << -by_one, by_one, -by_other, by_other;
  return crossing;
}

// What `find` makes of each of many pairs, where it makes something, in their order. Several
// threads take neighbouring pairs together.
template <class Found, class Find>
std::vector<Found> found_of(const std::vector<SurfacePair>& pairs, const Find& find) {
  constexpr size_t kTogether = 512;
  std::vector<std::vector<Found>> parts((pairs.size() + kTogether - 1) / kTogether);
  parallel_for(static_cast<int>(parts.size()), [&](int i) {
    const size_t begin = kTogether * static_cast<size_t>(i);
    const size_t end = std::min(begin + kTogether, pairs.size());
    for (size_t k = begin; k < end; ++k) {
      if (std::optional<Found> found = find(pairs[k])) {
        parts[static_cast<size_t>(i)].push_back(std::move(*found));
      }
    }
  });
  std::vector<Found> all;
  for (const std::vector<Found>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<std::vector<int>> parts_of(const SurfacePair& pair) {
  const auto& [a, b, c, d] = pair.points;
  if (pair.kind == SurfacePair::Kind::vertex_face) return {{a}, {b, c, d}};
  return {{a, b}, {c, d}};
}

double length(const Eigen::Matrix3Xd& positions, int from, int to) {
  return (positions.col(to) - positions.col(from)).norm();
}

}  // namespace

SurfaceContact::SurfaceContact(std::shared_ptr<const ContactSurface> surface,
                               Eigen::Matrix3Xd built, Eigen::VectorXd stiffness,
                               const SurfaceContactLaw& law)
    : near_(std::move(surface), law.thickness, 2 * law.thickness),
      built_(std::move(built)),
      stiffness_(std::move(stiffness)),
      law_(law) {}

SurfaceContact::~SurfaceContact() = default;

double SurfaceContact::stiffness_of(const SurfacePair& pair) const {
  double sum = 0;
  int count = 0;
  for (const int point : pair.points) {
    if (point >= stiffness_.size()) continue;  // of a body
    sum += stiffness_(point);
    ++count;
  }
  return sum / count;
}

// 0: cloth, else 1 + the number of a body.
size_t SurfaceContact::met_by(const SurfacePair& pair) const {
  const int last = *std::ranges::max_element(pair.points);
  size_t met = law_.bodies.size();
  while (met > 0 && last < law_.bodies[met - 1].first_point) --met;
  return met;
}

double SurfaceContact::friction_of(const SurfacePair& pair) const {
  const size_t met = met_by(pair);
  return met == 0 ? law_.friction : law_.bodies[met - 1].friction;
}

SurfaceContact::Push SurfaceContact::push_of(const SurfacePair& pair,
                                             const Eigen::Matrix3Xd& positions) const {
  const PairPoints x = points_of(pair, positions);
  const Gap gap = gap_between(pair.kind, x);
  const double distance = gap.distance();
  if (distance >= law_.thickness) return {};
  Push push;
  if (!(distance > 0)) {
    push.energy = INFINITY;
    return push;
  }
  const double stiffness = stiffness_of(pair);
  const Barrier pushed = barrier(distance, law_.thickness);
  Crossing crossing{1, PairPoints::Zero()};
  if (pair.kind == SurfacePair::Kind::edge_edge) {
    crossing = crossing_of(x, length(built_, pair.points[0], pair.points[1]),
                           length(built_, pair.points[2], pair.points[3]));
  }
  push.energy = stiffness * crossing.share * pushed.energy;
  push.normal_force = -stiffness * crossing.share * pushed.slope;
  push.curvature = stiffness * crossing.share * pushed.curvature;
  push.weights = gap.weights;
  push.normal = gap.line / distance;
  push.gradient = -push.normal_force * push.normal * push.weights.transpose() +
                  stiffness * pushed.energy * crossing.gradient;
  return push;
}

bool SurfaceContact::make_way(const Evaluation& at, Eigen::Matrix3Xd& positions) const {
  constexpr int kLayers = 100;
  const Eigen::Matrix3Xd& start = at.configuration.positions;
  for (int layer = 0; layer < kLayers && positions != start; ++layer) {
    const Eigen::Matrix3Xd ways = positions - start;
    bool meets = false;
    const NearPairs::Pairs near = near_.between(start, positions, at.costs);
    count_way_tests(near->size(), at.costs);
    for (const SurfacePair& pair : *near) {
      if (free_share_of(pair, start, ways, kKeptInWay) == 1) continue;
      meets = true;
      const Eigen::Vector3d way = common_way(pair, start, ways);
      for (const int point : pair.points) {
        if (near_.surface().moves(point)) positions.col(point) = start.col(point) + way;
      }
    }
    if (!meets) return true;
  }
  return positions == start;
}

// Of what is led the way of the place that is met; else that of the point that goes furthest.
Eigen::Vector3d SurfaceContact::common_way(const SurfacePair& pair, const Eigen::Matrix3Xd& start,
                                           const Eigen::Matrix3Xd& ways) const {
  const PairPoints own = points_of(pair, ways);
  Eigen::Vector4d led = gap_between(pair.kind, points_of(pair, start)).weights;
  for (int k = 0; k < 4; ++k) {
    if (near_.surface().moves(pair.points[static_cast<size_t>(k)])) led(k) = 0;
  }
  if (led.sum() != 0) return own * led / led.sum();
  Eigen::Index furthest = 0;
  own.colwise().squaredNorm().maxCoeff(&furthest);
  return own.col(furthest);
}

double SurfaceContact::free_share_of(const SurfacePair& pair, const Eigen::Matrix3Xd& from,
                                     const Eigen::Matrix3Xd& ways, double kept) const {
  const PairPoints x = points_of(pair, from);
  const double distance = gap_between(pair.kind, x).distance();
  return free_share(pair.kind, x, points_of(pair, ways),
                    distance_to_keep(distance, law_.thickness, kept));
}

void SurfaceContact::limit(const Evaluation& from, const Eigen::Matrix3Xd& to,
                           WayLimits& limits) const {
  const Eigen::Matrix3Xd& start = from.configuration.positions;
  // Where a step goes astray, points are sent far to all sides.
  double of_all = 1;
  NearPairs::Pairs near = near_.between_if_few(start, to, from.costs);
  while (!near) {
    of_all /= 2;
    near = near_.between_if_few(start, start + of_all * (to - start), from.costs);
  }
  if (of_all < 1) {
    limits.obstructed = true;
    limits.shares = limits.shares.cwiseMin(of_all);
  }
  const Eigen::Matrix3Xd ways = of_all * (to - start);
  count_way_tests(near->size(), from.costs);
  using Share = std::pair<SurfacePair, double>;
  const auto shares = found_of<Share>(*near, [&](const SurfacePair& pair) {
    const double share = free_share_of(pair, start, ways, limits.kept);
    return share == 1 ? std::nullopt : std::optional(Share{pair, share});
  });
  for (const auto& [pair, share] : shares) {
    limits.obstructed = true;
    for (const int point : pair.points) {
      limits.shares(point) = std::min(limits.shares(point), of_all * share);
    }
  }
}

void SurfaceContact::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  for (const auto& [pair, push] : pushes_at(at.configuration.positions, at.costs)) {
    add_push(pair, push, at, derivatives);
  }
  const auto before = lagged(at);
  for (const Rubbing& rubbing : before->rubbing) {
    add_friction(rubbing, at, derivatives);
  }
}

std::vector<std::pair<SurfacePair, SurfaceContact::Push>> SurfaceContact::pushes_at(
    const Eigen::Matrix3Xd& positions, SearchCosts* costs) const {
  using Pushed = std::pair<SurfacePair, Push>;
  const NearPairs::Pairs near = near_.at(positions, costs);
  return found_of<Pushed>(*near, [&](const SurfacePair& pair) {
    const Push push = push_of(pair, positions);
    return push.acts() ? std::optional(Pushed{pair, push}) : std::nullopt;
  });
}

void SurfaceContact::add_push(const SurfacePair& pair, const Push& push, const Evaluation& at,
                              Derivatives& derivatives) const {
  derivatives.energy.add_contact(push.energy);
  if (derivatives.gradient) {
    for (int k = 0; k < 4; ++k) {
      derivatives.gradient->col(pair.points[static_cast<size_t>(k)]) += push.gradient.col(k);
    }
  }
  if (!derivatives.hessian) return;
  // What the turning of the normal adds would make it less convex.
  derivatives.hessian->coordinates.add_outer_product(at.configuration, push.curvature, pair.points,
                                                     push.normal * push.weights.transpose(),
                                                     derivatives.hessian->matrix);
}

void SurfaceContact::add_friction(const Rubbing& rubbing, const Evaluation& at,
                                  Derivatives& derivatives) const {
  const Eigen::Map<const Eigen::Matrix3Xd> before(at.history, 3, built_.cols());
  const Eigen::Matrix3d plane = rubbing.plane();
  const PairPoints ways =
      points_of(rubbing.pair, at.configuration.positions) - points_of(rubbing.pair, before);
  const Eigen::Vector3d slip = plane * ways * rubbing.weights;
  const SlipEnergy rubbed = slip_energy(slip, rubbing.largest_friction, plane);
  derivatives.energy.add_rubbing(rubbed.energy);
  if (derivatives.gradient) {
    for (int k = 0; k < 4; ++k) {
      derivatives.gradient->col(rubbing.pair.points[static_cast<size_t>(k)]) +=
          rubbing.weights(k) * rubbed.force;
    }
  }
  if (!derivatives.hessian) return;
  // Along the slip and across it, wherever in the plane it goes.
  const Eigen::Vector3d across = rubbing.normal.cross(slip).norm() > 0
                                     ? rubbing.normal.cross(slip).normalized()
                                     : rubbing.normal.unitOrthogonal();
  for (const Eigen::Vector3d& direction : {across, rubbing.normal.cross(across).eval()}) {
    derivatives.hessian->coordinates.add_outer_product(
        at.configuration, direction.dot(rubbed.hessian * direction), rubbing.pair.points,
        direction * rubbing.weights.transpose(), derivatives.hessian->matrix);
  }
}

std::shared_ptr<const SurfaceContact::Lagged> SurfaceContact::lagged(const Evaluation& at) const {
  const Eigen::Map<const Eigen::Matrix3Xd> positions(at.history, 3, built_.cols());
  {
    const std::lock_guard lock(mutex_);
    if (lagged_ && lagged_->positions == positions) return lagged_;
  }
  auto made = std::make_shared<Lagged>();
  made->positions = positions;
  for (const auto& [pair, push] : pushes_at(made->positions, at.costs)) {
    const double friction = friction_of(pair);
    if (friction == 0) continue;
    made->rubbing.push_back({pair, push.weights, push.normal, friction * push.normal_force});
  }
  const std::lock_guard lock(mutex_);
  lagged_ = made;
  return made;
}

Eigen::VectorXd SurfaceContact::initial_history(const Evaluation& at) const {
  return at.configuration.positions.reshaped();
}

Energy SurfaceContact::advance(const Evaluation& at, double* next) const {
  Derivatives none;
  evaluate(at, none);
  Eigen::Map<Eigen::Matrix3Xd>(next, 3, built_.cols()) = at.configuration.positions;
  return none.energy;
}

std::vector<Touching> SurfaceContact::touching(const Eigen::Matrix3Xd& positions) const {
  std::vector<Touching> all(1 + law_.bodies.size());
  std::vector<const SurfacePair*> nearest(all.size());
  const NearPairs::Pairs near = near_.at(positions);
  for (const SurfacePair& pair : *near) {
    const double distance = gap_between(pair.kind, points_of(pair, positions)).distance();
    if (distance >= law_.thickness) continue;
    const size_t met = met_by(pair);
    Touching& touching = all[met];
    ++touching.count;
    if (distance >= touching.least_distance) continue;
    touching.least_distance = distance;
    nearest[met] = &pair;
  }
  for (size_t met = 0; met < all.size(); ++met) {
    if (nearest[met]) all[met].nearest = parts_of(*nearest[met]);
  }
  return all;
}

}  // namespace pliant
