#include "pliant/solver/dynamic_relaxation.h"

#include <algorithm>
#include <cmath>

#include "pliant/solver/newton.h"

namespace pliant {
namespace {

// A length for each block row that gives all unknowns one unit: the radius of the clip for its
// rotation, 1 for all others.
Eigen::VectorXd row_lengths(const Coordinates& coordinates, const Configuration& at) {
  Eigen::VectorXd lengths = Eigen::VectorXd::Ones(coordinates.block_rows());
  for (int k = 0; k < coordinates.clips(); ++k) {
    if (coordinates.clip_is_prescribed(k)) continue;
    const double radius = coordinates.clip_radius(k, at);
    if (radius > 0) lengths(coordinates.clip_row(k) + 1) = radius;
  }
  return lengths;
}

// For each block row the largest sum of absolute values along one of its three rows, all unknowns
// in one unit. By Gershgorin's theorem motion with time step 1 is stable for masses above a quarter
// of the sums. All three axes of a point have one mass: they exchange their stiffness when it
// turns.
Eigen::VectorXd row_sums(const BlockMatrix& stiffness, const Eigen::VectorXd& lengths) {
  const BlockPattern& pattern = stiffness.pattern();
  Eigen::Matrix3Xd sums = Eigen::Matrix3Xd::Zero(3, pattern.size());
  for (int i = 0; i < pattern.size(); ++i) {
    for (int block = pattern.row_begin(i); block < pattern.row_end(i); ++block) {
      const int j = pattern.column(block);
      const Eigen::Matrix3d size = stiffness.block(block).cwiseAbs() / (lengths(i) * lengths(j));
      sums.col(i) += size.rowwise().sum();
      if (j != i) sums.col(j) += size.colwise().sum().transpose();
    }
  }
  return sums.colwise().maxCoeff().transpose();
}

class Relaxation {
 public:
  Relaxation(const Objective& objective, const RelaxationOptions& options, Hessian& hessian,
             Configuration& at, const StopToken& stop)
      : objective_(objective),
        coordinates_(objective.system().coordinates()),
        options_(options),
        hessian_(hessian),
        at_(at),
        stop_(stop) {}

  RelaxationSummary run() {
    Eigen::VectorXd force = evaluate(at_);
    update_masses();
    while (!finished()) {
      if (move_to_peak(force)) {
        ++summary_.peaks;
        if (summary_.iterations - last_update_ > kUpdateInterval) {
          margin_ = std::max(kMargin, margin_ / 1.1);
          update_masses();
        }
      } else if (!finished()) {
        margin_ *= 2;
        update_masses();
      }
      if (!summary_.converged) force = evaluate(at_);
    }
    summary_.energy = objective_.energy(at_);
    return summary_;
  }

 private:
  static constexpr int kUpdateInterval = 200;  // an assembly costs a few evaluations of the forces
  static constexpr int kCheckInterval = 16;
  static constexpr double kMargin = 1.1, kLargestMargin = 1e9;

  bool finished() const {
    return summary_.converged || summary_.iterations >= options_.max_iterations ||
           !std::isfinite(summary_.residual) || margin_ > kLargestMargin;
  }

  Eigen::VectorXd evaluate(const Configuration& at) {
    const Eigen::Matrix3Xd gradient = objective_.gradient(at);
    summary_.residual = largest_force(coordinates_, at, gradient);
    summary_.converged = summary_.residual < options_.tolerance;
    return -coordinates_.reduce(at, gradient);
  }

  void update_masses() {
    Eigen::Matrix3Xd gradient;
    objective_.linearize(at_, Curvature::convex, gradient, hessian_);
    const Eigen::VectorXd lengths = row_lengths(coordinates_, at_);
    const Eigen::VectorXd sums = row_sums(hessian_.matrix, lengths);
    const double least = 1e-9 * sums.maxCoeff();
    masses_.resize(coordinates_.unknowns());
    for (int i = 0; i < sums.size(); ++i) {
      masses_.segment<3>(3 * i).setConstant(margin_ / 4 * std::max(sums(i), least) * lengths(i) *
                                            lengths(i));
    }
    last_update_ = summary_.iterations;
    ++summary_.mass_updates;
  }

  double kinetic_energy(const Eigen::VectorXd& velocity) const {
    return velocity.cwiseAbs2().dot(masses_) / 2;
  }

  // Moves from rest until the kinetic energy has peaked, and goes back to the peak.
  // @return false where the energy has risen, and the motion is undone, or where it has ended
  bool move_to_peak(const Eigen::VectorXd& force_at_rest) {
    const Configuration rest = at_;
    const Energy energy_at_rest = objective_.energy(rest);
    Eigen::VectorXd velocity = force_at_rest.cwiseQuotient(masses_) / 2;  // after half a time step
    double before = 0, last = kinetic_energy(velocity);
    for (int step = 1; summary_.iterations < options_.max_iterations; ++step) {
      stop_.throw_if_requested();
      const Configuration next = coordinates_.moved(at_, velocity);
      ++summary_.iterations;
      const Eigen::VectorXd force = evaluate(next);
      if (summary_.converged) {
        at_ = next;
        return false;
      }
      const Eigen::VectorXd faster = velocity + force.cwiseQuotient(masses_);
      const double now = kinetic_energy(faster);
      const bool peaked = now <= last;
      if (peaked) {
        at_ = coordinates_.moved(at_, share_to_peak(before, last, now) * velocity);
      } else {
        at_ = next;
        velocity = faster;
        before = last;
        last = now;
      }
      const bool look = peaked || !std::isfinite(now) || step % kCheckInterval == 0;
      if (look && !(objective_.energy(at_).total() <= highest(energy_at_rest))) {
        at_ = rest;
        summary_.residual = 0;  // not that of the state that was left
        return false;
      }
      if (peaked) return true;
    }
    return false;
  }

  // Share of the last displacement at which a parabola through three kinetic energies peaks.
  static double share_to_peak(double before, double last, double now) {
    const double bend = before - 2 * last + now;
    return bend < 0 ? std::clamp(0.5 + (before - now) / (2 * bend), 0.05, 1.0) : 0.5;
  }

  // What rounding makes of an energy that stays the same.
  static double highest(const Energy& energy) {
    return energy.total() + 1e-11 * (std::abs(energy.stored) + std::abs(energy.work));
  }

  const Objective& objective_;
  const Coordinates& coordinates_;
  const RelaxationOptions& options_;
  Hessian& hessian_;
  Configuration& at_;
  const StopToken& stop_;
  RelaxationSummary summary_;
  Eigen::VectorXd masses_;   // one an unknown, at a time step of 1 (N/m; N m for rotations)
  double margin_ = kMargin;  // of the masses over those of Gershgorin's bound
  int last_update_ = 0;
};

}  // namespace

RelaxationSummary relax(const Objective& objective, const RelaxationOptions& options,
                        Hessian& hessian, Configuration& at, const StopToken& stop) {
  return Relaxation(objective, options, hessian, at, stop).run();
}

}  // namespace pliant
