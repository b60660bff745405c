#include "pliant/contact/obstacle_contact.h"

#include <algorithm>
#include <utility>

#include "pliant/contact/barrier.h"

namespace pliant {

/// What a point remembers of its last accepted step, in the body's frame.
struct ObstacleContact::Memory {
  static constexpr Eigen::Index kSize = 8;

  Eigen::Vector3d position;  // m
  Eigen::Vector3d slip;      // elastic, m
  double normal_force = 0;   // N
  bool slides = false;

  static Memory read(const double* from) {
    return {Eigen::Vector3d(from), Eigen::Vector3d(from + 3), from[6], from[7] != 0};
  }
  void write(double* to) const {
    Eigen::Vector3d::Map(to) = position;
    Eigen::Vector3d::Map(to + 3) = slip;
    to[6] = normal_force;
    to[7] = slides ? 1 : 0;
  }
};

namespace {

Eigen::Matrix3d tangent_plane(const Eigen::Vector3d& normal) {
  return Eigen::Matrix3d::Identity() - normal * normal.transpose();
}

// @param slip  elastic
double stored_slip(const Eigen::Vector3d& slip, double largest_friction) {
  return slip_energy(slip, largest_friction, Eigen::Matrix3d::Zero()).energy;
}

}  // namespace

ObstacleContact::ObstacleContact(ObstacleShape shape, std::vector<int> points,
                                 Eigen::VectorXd stiffness, double thickness,
                                 const CoulombFriction& friction, int body)
    : shape_(std::move(shape)),
      points_(std::move(points)),
      stiffness_(std::move(stiffness)),
      thickness_(thickness),
      friction_(friction),
      body_(body) {}

ObstacleContact::Memory ObstacleContact::memory_of(size_t i, const Evaluation& at) const {
  return Memory::read(at.history + Memory::kSize * static_cast<Eigen::Index>(i));
}

void ObstacleContact::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  const Pose body = at.controls.body(body_);
  for (size_t i = 0; i < points_.size(); ++i) evaluate_point(i, body, at, derivatives);
}

// Who would be met on the way from the last step goes with the body for the rest of it.
bool ObstacleContact::make_way(const Evaluation& at, Eigen::Matrix3Xd& positions) const {
  constexpr double kKept = 0.2;
  if (body_ < 0) return true;
  count_way_tests(points_.size(), at.costs);
  const Pose body = at.controls.body(body_);
  for (size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d before = memory_of(i, at).position;
    const Eigen::Vector3d way = body.local(positions.col(points_[i])) - before;
    const double share = free_share_of(before, before + way, kKept);
    if (share < 1) positions.col(points_[i]) = body.apply(before + share * way);
  }
  return true;
}

// Of a way in the body's frame.
double ObstacleContact::free_share_of(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                                      double kept) const {
  const double distance = distance_to(shape_, from);
  if (!(distance > 0)) return 1;  // the body was led over it, before it made way
  const double keep = distance_to_keep(distance, thickness_, kept);
  if ((to - from).norm() < distance - keep) return 1;
  return free_share(shape_, from, to, keep);
}

void ObstacleContact::limit(const Evaluation& from, const Eigen::Matrix3Xd& to,
                            WayLimits& limits) const {
  count_way_tests(points_.size(), from.costs);
  const Pose body = from.controls.body(body_);
  for (size_t i = 0; i < points_.size(); ++i) {
    const int point = points_[i];
    const Eigen::Vector3d begin = body.local(from.configuration.positions.col(point));
    const Eigen::Vector3d end = body.local(to.col(point));
    const Memory memory = memory_of(i, from);
    double share = free_share_of(begin, end, limits.kept);
    limits.obstructed |= share < 1;
    if (largest_friction(memory) > 0) {
      share = std::min(share, share_to_standstill(memory, begin, end));
    }
    limits.shares(point) = std::min(limits.shares(point), share);
  }
}

// A point that slides and turns back may come to rest: its stiffness there is another, and unknown
// where it slides.
double ObstacleContact::share_to_standstill(const Memory& memory, const Eigen::Vector3d& from,
                                            const Eigen::Vector3d& to) const {
  const Eigen::Vector3d before = slip_of(memory, from), way = slip_of(memory, to) - before;
  if (before.squaredNorm() <= kSlipLength * kSlipLength) return 1;
  constexpr double kWhole = 1 - 1e-9;  // a way that ends where it stops
  const double share = -before.dot(way) / way.squaredNorm();
  const bool stops = share > 0 && (before + share * way).norm() < kSlipLength;
  return stops && share < kWhole ? share : 1;
}

void ObstacleContact::evaluate_point(size_t i, const Pose& body, const Evaluation& at,
                                     Derivatives& derivatives) const {
  const int point = points_[i];
  const Eigen::Vector3d position = body.local(at.configuration.positions.col(point));
  const Memory memory = memory_of(i, at);
  const double distance = distance_to(shape_, position);
  if (distance >= thickness_ && memory.normal_force == 0) return;
  if (!(distance > 0)) {
    derivatives.energy.stored = INFINITY;
    return;
  }
  const SurfaceDistance surface = surface_distance(shape_, position);
  const Barrier pushed = barrier(distance, thickness_);
  const double stiffness = stiffness_(static_cast<Eigen::Index>(i));
  const SlipEnergy rubbed = rubbing(memory, position);
  derivatives.energy.add_contact(stiffness * pushed.energy);
  const double elastic = stored_slip(memory.slip, largest_friction(memory));
  derivatives.energy.add_contact(elastic);
  derivatives.energy.add_rubbing(rubbed.energy - elastic);
  if (derivatives.gradient) {
    derivatives.gradient->col(point) +=
        body.rotation * (stiffness * pushed.slope * surface.normal + rubbed.force);
  }
  if (!derivatives.hessian) return;
  Eigen::Matrix3d hessian =
      stiffness * pushed.curvature * surface.normal * surface.normal.transpose() + rubbed.hessian;
  // The surface's own curvature makes the energy less convex.
  if (at.curvature == Curvature::exact) hessian += stiffness * pushed.slope * surface.curvature;
  const Eigen::Matrix3d turn = body.rotation.toRotationMatrix();
  derivatives.hessian->coordinates.add_coupling(at.configuration, point, point,
                                                turn * hessian * turn.transpose(),
                                                derivatives.hessian->matrix);
}

// On the way of the places of the body where points stood when the step began.
double ObstacleContact::outside_work(const Evaluation& at, const Configuration& from,
                                     const Controls&) const {
  if (body_ < 0) return 0;
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, from.positions.cols());
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  evaluate(at, derivatives);
  const Pose body = at.controls.body(body_);
  double work = 0;
  for (size_t i = 0; i < points_.size(); ++i) {
    const int point = points_[i];
    const Eigen::Vector3d way = body.apply(memory_of(i, at).position) - from.positions.col(point);
    work -= gradient.col(point).dot(way);
  }
  return work;
}

double ObstacleContact::largest_friction(const Memory& memory) const {
  return memory.normal_force * (memory.slides ? friction_.sliding : friction_.sticking);
}

Eigen::Vector3d ObstacleContact::slip_of(const Memory& memory,
                                         const Eigen::Vector3d& position) const {
  const Eigen::Vector3d slip = memory.slip + position - memory.position;
  return tangent_plane(surface_distance(shape_, memory.position).normal) * slip;
}

SlipEnergy ObstacleContact::rubbing(const Memory& memory, const Eigen::Vector3d& position) const {
  return slip_energy(slip_of(memory, position), largest_friction(memory),
                     tangent_plane(surface_distance(shape_, memory.position).normal));
}

Eigen::Index ObstacleContact::history_size() const {
  return Memory::kSize * static_cast<Eigen::Index>(points_.size());
}

Eigen::VectorXd ObstacleContact::initial_history(const Evaluation& at) const {
  Eigen::VectorXd history(history_size());
  const Pose body = at.controls.body(body_);
  for (size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d position = body.local(at.configuration.positions.col(points_[i]));
    const auto index = static_cast<Eigen::Index>(i);
    const double distance = std::max(distance_to(shape_, position), 1e-3 * thickness_);
    const double force = -stiffness_(index) * barrier(distance, thickness_).slope;
    Memory{position, Eigen::Vector3d::Zero(), force, false}.write(history.data() +
                                                                  Memory::kSize * index);
  }
  return history;
}

// What is elastic of a slip is stored, with the largest friction of the next step; the rest of what
// friction took in this one is lost.
Energy ObstacleContact::advance(const Evaluation& at, double* next) const {
  Energy energy;
  const Pose body = at.controls.body(body_);
  for (size_t i = 0; i < points_.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    const Memory memory = memory_of(i, at);
    const Eigen::Vector3d position = body.local(at.configuration.positions.col(points_[i]));
    Memory now{position, Eigen::Vector3d::Zero(), 0, false};
    const double distance = distance_to(shape_, position);
    if (distance < thickness_) {
      const Eigen::Matrix3d plane = tangent_plane(surface_distance(shape_, position).normal);
      const Eigen::Vector3d slip = plane * (memory.slip + position - memory.position);
      now.slip = elastic_slip(slip);
      now.slides = slip.norm() > kSlipLength;
      const Barrier pushed = barrier(distance, thickness_);
      now.normal_force = -stiffness_(index) * pushed.slope;
      energy.add_contact(stiffness_(index) * pushed.energy);
      energy.add_contact(stored_slip(now.slip, largest_friction(now)));
    }
    if (memory.normal_force > 0) {
      energy.add_rubbing(rubbing(memory, position).energy -
                         stored_slip(now.slip, largest_friction(memory)));
    }
    now.write(next + Memory::kSize * index);
  }
  return energy;
}

// A motion of the body is one of all points the other way.
Eigen::Matrix3Xd ObstacleContact::change_by_motion(const Evaluation& at,
                                                   const Eigen::Vector3d& direction) const {
  Eigen::Matrix3Xd change = Eigen::Matrix3Xd::Zero(3, at.configuration.positions.cols());
  const Pose body = at.controls.body(body_);
  const Eigen::Vector3d motion = body.rotation.conjugate() * direction;
  for (size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d position = body.local(at.configuration.positions.col(points_[i]));
    const SurfaceDistance surface = surface_distance(shape_, position);
    if (surface.distance >= thickness_) continue;
    const Barrier pushed = barrier(surface.distance, thickness_);
    const Eigen::Vector3d by_place =
        pushed.curvature * surface.normal.dot(motion) * surface.normal +
        pushed.slope * surface.curvature * motion;
    change.col(points_[i]) = body.rotation * (-stiffness_(static_cast<Eigen::Index>(i)) * by_place);
  }
  return change;
}

Touching ObstacleContact::touching(const Eigen::Matrix3Xd& positions,
                                   const Controls& controls) const {
  const Pose body = controls.body(body_);
  Touching touching;
  int nearest = -1;
  for (const int point : points_) {
    const double distance = distance_to(shape_, body.local(positions.col(point)));
    touching.count += distance < thickness_ ? 1 : 0;
    if (distance >= touching.least_distance) continue;
    touching.least_distance = distance;
    nearest = point;
  }
  if (nearest >= 0) touching.nearest = {{nearest}};
  return touching;
}

}  // namespace pliant
