#include "pliant/estimation/linear_start.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include <Eigen/QR>

#include "pliant/estimation/addend_starts.h"
#include "pliant/material/law_path.h"

namespace pliant {
namespace {

constexpr int kTauSteps = 16;
constexpr double kSmallestTau = 0.002;  // shares of the largest strain
constexpr double kLargestTau = 2;
constexpr double kLeastShare = 1e-3;  // of an addend that the linear fit dropped: keeps it alive

struct LinearSystem {
  Eigen::MatrixXd matrix;
  Eigen::VectorXd right;
};

// The stress of a law along the measured path of an experiment.
class MeasuredWalk {
 public:
  MeasuredWalk(const MeasuredPath& path, const ComponentLaw& law, bool tension_only)
      : path_(path),
        tension_only_(tension_only),
        law_(law),
        fixed_(Eigen::VectorXd::Zero(law.parameter_count())),
        walk_(law_, rest()) {}

  // Rows must be asked for in order.
  PathStress at(size_t row) {
    const auto anchor = static_cast<size_t>(path_.anchor[row]);
    if (!path_.starts_flat.empty() && path_.starts_flat[row]) {
      walk_ = LawPath(law_, rest());
      walk_.turn_at(strain(row), fixed_);
    } else if (row == 0 || path_.specimen[row] != path_.specimen[row - 1]) {
      PathPoint start = rest();
      start.strain = strain(row);
      walk_ = LawPath(law_, start, time(row));
    } else if (path_.anchor[row] != path_.anchor[row - 1]) {
      walk_.turn_at(strain(anchor), fixed_);
    }
    const PathStress here = walk_.at(strain(row), time(row));
    walk_.pass(strain(row), fixed_, time(row));
    return here;
  }

 private:
  PathPoint rest() const { return {0, 0, fixed_, fixed_}; }
  double time(size_t row) const { return path_.time.empty() ? kEndless : path_.time[row]; }
  double strain(size_t row) const {
    return tension_only_ ? std::max(path_.strain[row], 0.0) : path_.strain[row];
  }

  const MeasuredPath& path_;
  bool tension_only_;
  ComponentLaw law_;
  Eigen::VectorXd fixed_;
  LawPath walk_;
};

// What friction and the addends answer to the path of an experiment: d stress / d a and b, and the
// stress of each addend.
class MemoryColumns {
 public:
  MemoryColumns(const MeasuredPath& path, const ComponentLaw& shape, double tau,
                bool tension_only) {
    if (shape.friction_law != FrictionLaw::none) {
      friction_.emplace(path, ComponentLaw{ScalarCurve::none(), FrictionLaw::dahl, {0, 0, tau}},
                        tension_only);
    }
    for (const Addend& addend : shape.addends) {
      addends_.emplace_back(
          path, ComponentLaw{ScalarCurve::none(), FrictionLaw::none, {}, {addend}}, tension_only);
    }
  }

  // Rows must be asked for in order.
  Eigen::VectorXd at(size_t row) {
    Eigen::VectorXd columns((friction_ ? 2 : 0) + std::ssize(addends_));
    if (friction_) columns.head<2>() = friction_->at(row).friction_gradient.head<2>();
    Eigen::Index next = friction_ ? 2 : 0;
    for (MeasuredWalk& addend : addends_) columns(next++) = addend.at(row).stress;
    return columns;
  }

 private:
  std::optional<MeasuredWalk> friction_;
  std::vector<MeasuredWalk> addends_;
};

// Unknowns of a linear start: control values, a and b, and a factor of each addend.
Eigen::Index law_columns(const ComponentLaw& shape) {
  return shape.stiffness.size() + (shape.friction_law == FrictionLaw::none ? 0 : 2) +
         std::ssize(shape.addends);
}

LinearSystem assemble(const ComponentProblem& problem, const ComponentLaw& shape, double tau) {
  const Eigen::Index stiffness = shape.stiffness.size(), law = law_columns(shape);
  const auto experiments = problem.experiments().size();
  LinearSystem system;
  system.matrix.setZero(problem.used_rows(), law + static_cast<int>(experiments));
  system.right.resize(problem.used_rows());
  Eigen::Index row = 0;
  for (size_t e = 0; e < experiments; ++e) {
    const ComponentExperiment& experiment = *problem.experiments()[e];
    const MeasuredPath& path = experiment.path();
    const bool tension_only = experiment.info().component.starts_with("stretch");
    const double peak =
        std::abs(*std::max_element(path.force.begin(), path.force.end(),
                                   [](double a, double b) { return std::abs(a) < std::abs(b); }));
    MemoryColumns memory(path, shape, tau, tension_only);
    for (size_t i = 0; i < path.strain.size(); ++i) {
      const Eigen::VectorXd response = memory.at(i);
      if (!problem.used(e)[i]) continue;
      const double weight = 1 / peak;
      const double strain = tension_only ? std::max(path.strain[i], 0.0) : path.strain[i];
      system.right(row) = weight * path.force[i];
      if (!experiment.nuisance().empty()) {
        system.matrix(row, law + static_cast<int>(e)) = weight;
      }
      if (!tension_only || path.strain[i] > 0) {
        const double factor = weight * path.factor[i];
        system.matrix.row(row).head(stiffness) =
            factor * strain * shape.stiffness.weights(strain).transpose();
        system.matrix.row(row).segment(stiffness, response.size()) = factor * response.transpose();
      }
      ++row;
    }
  }
  return system;
}

// The solution of least length in units of the columns where there are many: each unknown takes its
// share.
Eigen::VectorXd least_squares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& right) {
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(matrix);
  if (qr.rank() == matrix.cols()) return qr.solve(right);
  Eigen::VectorXd unit = matrix.colwise().norm().transpose();
  for (double& length : unit) length = length > 0 ? 1 / length : 1;
  return unit.cwiseProduct(
      (matrix * unit.asDiagonal()).completeOrthogonalDecomposition().solve(right));
}

// Least squares in which the first `not_negative` unknowns are dropped, the most negative first,
// until none is negative.
Eigen::VectorXd solve_not_negative(const LinearSystem& system, int not_negative) {
  const auto columns = system.matrix.cols();
  std::vector<Eigen::Index> active(static_cast<size_t>(columns));
  for (Eigen::Index i = 0; i < columns; ++i) active[static_cast<size_t>(i)] = i;
  for (;;) {
    const Eigen::VectorXd part = least_squares(system.matrix(Eigen::all, active), system.right);
    size_t worst = active.size();
    for (size_t i = 0; i < active.size(); ++i) {
      const auto value = part(static_cast<Eigen::Index>(i));
      if (active[i] >= not_negative || value >= 0) continue;
      if (worst == active.size() || value < part(static_cast<Eigen::Index>(worst))) worst = i;
    }
    if (worst < active.size()) {
      active.erase(active.begin() + static_cast<std::ptrdiff_t>(worst));
      continue;
    }
    Eigen::VectorXd all = Eigen::VectorXd::Zero(columns);
    for (size_t i = 0; i < active.size(); ++i) all(active[i]) = part(static_cast<Eigen::Index>(i));
    return all;
  }
}

// The same by a robust loss: rows far off count less in the next of a few solutions.
Eigen::VectorXd solve_by_loss(const LinearSystem& system, int not_negative, RobustLoss loss) {
  constexpr int kReweighings = 10;
  Eigen::VectorXd solution = solve_not_negative(system, not_negative);
  for (int i = 0; loss != RobustLoss::none && i < kReweighings; ++i) {
    const Eigen::VectorXd residual = system.matrix * solution - system.right;
    const double sd = robust_sd(residual);
    if (sd == 0) break;
    const Eigen::VectorXd weight = residual.unaryExpr(
        [&](double r) { return std::sqrt(robust_weight(loss, r * r / (sd * sd))); });
    solution = solve_not_negative(
        {weight.asDiagonal() * system.matrix, weight.cwiseProduct(system.right)}, not_negative);
  }
  return solution;
}

std::array<double, 3> friction_start(const ComponentLaw& shape, double a, double b, double tau,
                                     const ComponentProblem& problem) {
  // A small a keeps friction alive where the linear fit dropped it.
  const double floor = 1e-3 * problem.peak_stress();
  if (shape.friction_law == FrictionLaw::dahl) return {std::max(a, floor), b, tau};
  const double middle = a + b * problem.largest_strain() / 2;
  return {std::max(a, floor), b, std::max(middle, floor) / tau};
}

}  // namespace

LinearStart linear_start(const ComponentProblem& problem, const ComponentLaw& shape, double tau) {
  problem.stop().throw_if_requested();
  const LinearSystem system = assemble(problem, shape, tau);
  const int stiffness = shape.stiffness.size();
  const bool friction = shape.friction_law != FrictionLaw::none;
  const Eigen::VectorXd solution =
      solve_by_loss(system, static_cast<int>(law_columns(shape)), problem.loss());
  LinearStart start;
  start.law = shape;
  start.law.stiffness = shape.stiffness.with_values(solution.data());
  if (friction) {
    start.law.friction =
        friction_start(shape, solution(stiffness), solution(stiffness + 1), tau, problem);
  }
  Eigen::Index next = stiffness + (friction ? 2 : 0);
  for (Addend& addend : start.law.addends) {
    addend = addend.scaled(std::max(solution(next++), kLeastShare));
  }
  const Eigen::VectorXd residual = system.matrix * solution - system.right;
  start.cost =
      problem.loss() == RobustLoss::none ? residual.squaredNorm() : tamed(residual).squaredNorm();
  return start;
}

namespace {

// Those of a shape whose addends are where they begin, in the order of tau.
std::vector<LinearStart> over_tau(const ComponentProblem& problem, const ComponentLaw& shape) {
  if (shape.friction_law == FrictionLaw::none) return {linear_start(problem, shape, 1)};
  std::vector<LinearStart> all;
  for (int i = 0; i < kTauSteps; ++i) {
    const double share = kSmallestTau * std::pow(kLargestTau / kSmallestTau, i / (kTauSteps - 1.0));
    all.push_back(linear_start(problem, shape, share * problem.largest_strain()));
  }
  return all;
}

std::vector<LinearStart> local_minima(const std::vector<LinearStart>& all) {
  std::vector<LinearStart> best;
  for (size_t i = 0; i < all.size(); ++i) {
    const bool below_left = i == 0 || all[i].cost <= all[i - 1].cost;
    const bool below_right = i + 1 == all.size() || all[i].cost < all[i + 1].cost;
    if (below_left && below_right) best.push_back(all[i]);
  }
  return best;
}

}  // namespace

std::vector<LinearStart> linear_starts_over_tau(const ComponentProblem& problem,
                                                const ComponentLaw& shape) {
  std::vector<LinearStart> all;
  for (const ComponentLaw& law : addend_starts(shape, problem.scale())) {
    std::ranges::move(over_tau(problem, law), std::back_inserter(all));
  }
  return all;
}

std::vector<LinearStart> linear_starts(const ComponentProblem& problem, const ComponentLaw& shape,
                                       int most) {
  std::vector<LinearStart> best;
  for (const ComponentLaw& law : addend_starts(shape, problem.scale())) {
    std::ranges::move(local_minima(over_tau(problem, law)), std::back_inserter(best));
  }
  std::sort(best.begin(), best.end(),
            [](const LinearStart& x, const LinearStart& y) { return x.cost < y.cost; });
  if (static_cast<int>(best.size()) > most) best.resize(static_cast<size_t>(most));
  return best;
}

}  // namespace pliant
