#include "pliant/contact/obstacle_contact.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "pliant/contact/barrier.h"

namespace pliant {

/// What a point remembers of its last accepted step.
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

}  // namespace

ObstacleContact::ObstacleContact(ObstacleShape shape, std::vector<int> points,
                                 Eigen::VectorXd stiffness, double thickness,
                                 const CoulombFriction& friction)
    : shape_(std::move(shape)),
      points_(std::move(points)),
      stiffness_(std::move(stiffness)),
      thickness_(thickness),
      friction_(friction) {}

void ObstacleContact::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  for (size_t i = 0; i < points_.size(); ++i) evaluate_point(i, at, derivatives);
}

void ObstacleContact::evaluate_point(size_t i, const Evaluation& at,
                                     Derivatives& derivatives) const {
  const int point = points_[i];
  const Eigen::Vector3d position = at.configuration.positions.col(point);
  const Memory memory = Memory::read(at.history + Memory::kSize * static_cast<Eigen::Index>(i));
  if (!admits_point(i, at)) {
    derivatives.energy.stored = INFINITY;
    return;
  }
  if (distance_to(shape_, position) >= thickness_ && memory.normal_force == 0) return;
  const SurfaceDistance surface = surface_distance(shape_, position);
  const Barrier pushed = barrier(surface.distance, thickness_);
  const double stiffness = stiffness_(static_cast<Eigen::Index>(i));
  const SlipEnergy rubbed = slip_of(memory, position);
  derivatives.energy.stored += stiffness * pushed.energy;
  derivatives.energy.work += rubbed.energy - slip_of(memory, memory.position).energy;
  if (derivatives.gradient) {
    derivatives.gradient->col(point) += stiffness * pushed.slope * surface.normal + rubbed.force;
  }
  if (!derivatives.hessian) return;
  Eigen::Matrix3d hessian =
      stiffness * pushed.curvature * surface.normal * surface.normal.transpose() + rubbed.hessian;
  // The surface's own curvature makes the energy less convex.
  if (at.curvature == Curvature::exact) hessian += stiffness * pushed.slope * surface.curvature;
  derivatives.hessian->coordinates.add_coupling(at.configuration, point, point, hessian,
                                                derivatives.hessian->matrix);
}

SlipEnergy ObstacleContact::slip_of(const Memory& memory, const Eigen::Vector3d& position) const {
  const double bound =
      memory.normal_force * (memory.slides ? friction_.sliding : friction_.sticking);
  const Eigen::Matrix3d plane = tangent_plane(surface_distance(shape_, memory.position).normal);
  return slip_energy(plane * (memory.slip + position - memory.position), bound, plane);
}

bool ObstacleContact::admits(const Evaluation& at) const {
  for (size_t i = 0; i < points_.size(); ++i) {
    if (!admits_point(i, at)) return false;
  }
  return true;
}

// Distances change no faster than points move: only who may have met the surface is looked at
// closer.
bool ObstacleContact::admits_point(size_t i, const Evaluation& at) const {
  const Eigen::Vector3d position = at.configuration.positions.col(points_[i]);
  const auto first = Memory::kSize * static_cast<Eigen::Index>(i);
  const Eigen::Vector3d before = Eigen::Vector3d::Map(at.history + first);
  const double distance = distance_to(shape_, position);
  if (!(distance > 0)) return false;
  if (distance + distance_to(shape_, before) > (position - before).norm()) return true;
  return pliant::least_distance(shape_, before, position) > 0;
}

Eigen::Index ObstacleContact::history_size() const {
  return Memory::kSize * static_cast<Eigen::Index>(points_.size());
}

Eigen::VectorXd ObstacleContact::initial_history(const Evaluation& at) const {
  Eigen::VectorXd history(history_size());
  for (size_t i = 0; i < points_.size(); ++i) {
    const Eigen::Vector3d position = at.configuration.positions.col(points_[i]);
    const auto index = static_cast<Eigen::Index>(i);
    const double distance = std::max(distance_to(shape_, position), 1e-3 * thickness_);
    const double force = -stiffness_(index) * barrier(distance, thickness_).slope;
    Memory{position, Eigen::Vector3d::Zero(), force, false}.write(history.data() +
                                                                  Memory::kSize * index);
  }
  return history;
}

Energy ObstacleContact::advance(const Evaluation& at, double* next) const {
  Energy energy;
  for (size_t i = 0; i < points_.size(); ++i) {
    const auto index = static_cast<Eigen::Index>(i);
    const Memory memory = Memory::read(at.history + Memory::kSize * index);
    const Eigen::Vector3d position = at.configuration.positions.col(points_[i]);
    Memory now{position, Eigen::Vector3d::Zero(), 0, false};
    const double distance = distance_to(shape_, position);
    if (distance < thickness_) {
      const Eigen::Matrix3d plane = tangent_plane(surface_distance(shape_, position).normal);
      const Eigen::Vector3d slip = plane * (memory.slip + position - memory.position);
      now.slip = elastic_slip(slip);
      now.slides = slip.norm() > kSlipLength;
      const Barrier pushed = barrier(distance, thickness_);
      now.normal_force = -stiffness_(index) * pushed.slope;
      energy.stored += stiffness_(index) * pushed.energy;
    }
    if (memory.normal_force > 0) {
      energy.work += slip_of(memory, position).energy - slip_of(memory, memory.position).energy;
    }
    now.write(next + Memory::kSize * index);
  }
  return energy;
}

double ObstacleContact::least_distance(const Eigen::Matrix3Xd& positions) const {
  double least = std::numeric_limits<double>::infinity();
  for (const int point : points_) {
    least = std::min(least, distance_to(shape_, positions.col(point)));
  }
  return least;
}

}  // namespace pliant
