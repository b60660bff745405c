#include "pliant/experiment/homogeneous/homogeneous_point.h"

#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "pliant/material/limit_barriers.h"

namespace pliant {
namespace {

using Strain = Eigen::Matrix<double, 6, 1>;
using Numbers = Eigen::Array<double, kLanes, Eigen::Dynamic>;

Numbers alike(const Eigen::VectorXd& values) {
  return values.transpose().replicate(kLanes, 1).array();
}

/// One point, as eight that are alike: laws answer eight at once.
struct OnePoint {
  Numbers strain, last, history;

  OnePoint(const Strain& at, const Strain& from, const Eigen::VectorXd& remembered)
      : strain(alike(at)), last(alike(from)), history(alike(remembered)) {}

  Samples samples() const { return {view(strain), view(last), view(last), view(history)}; }
  static LaneView view(const Numbers& numbers) {
    return LaneView(numbers.data(), kLanes, numbers.cols());
  }
};

Strain strain_of(const Eigen::Vector3d& logs) {
  Strain strain = Strain::Zero();
  strain.head<3>() = ((2 * logs.array()).unaryExpr([](double x) { return std::expm1(x); }) / 2);
  return strain;
}

}  // namespace

/// The logarithms of the stretches are `fixed` + `along` times those of the free sides.
struct HomogeneousPoint::Free {
  Eigen::Vector3d fixed = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, Eigen::Dynamic> along = decltype(along)(3, 0);
  Eigen::VectorXd guess;

  Free(const HomogeneousRow& row, bool incompressible) {
    const double one = std::log(row.stretch);
    const bool narrows = row.mode == HomogeneousMode::uniaxial;
    double two = 0;
    if (row.mode == HomogeneousMode::equibiaxial) two = one;
    if (row.mode == HomogeneousMode::biaxial) two = std::log(row.stretch_2);
    fixed << one, two, incompressible ? -one - two : 0;
    if (incompressible && narrows) {
      along.resize(3, 1);
      along << 0, 1, -1;
      guess = Eigen::VectorXd::Constant(1, -one / 2);  // what an isotropic solid does
    } else if (!incompressible) {
      along = Eigen::Matrix3d::Identity().rightCols(narrows ? 2 : 1);
      guess = Eigen::VectorXd::Constant(along.cols(), -one / 4);
    }
  }

  Eigen::Vector3d logs(const Eigen::VectorXd& at) const { return fixed + along * at; }
};

/// Energy, Kirchhoff stresses along the axes and their derivatives by the logarithms.
struct HomogeneousPoint::Response3 {
  double energy = 0;
  Eigen::Vector3d stress;
  Eigen::Matrix3d tangent;
};

HomogeneousPoint::HomogeneousPoint(const ParametricDensity& law, bool incompressible,
                                   bool derivatives)
    : law_(law),
      incompressible_(incompressible),
      derivatives_(derivatives),
      last_(Strain::Zero()),
      history_(Eigen::VectorXd::Zero(law.history_size())) {
  const Eigen::Index count = derivatives ? law.parameters().size() : 0;
  last_by_ = Eigen::MatrixXd::Zero(6, count);
  history_by_ = Eigen::MatrixXd::Zero(law.history_size(), count);
}

HomogeneousPoint::Response3 HomogeneousPoint::respond(const Eigen::Vector3d& logs) const {
  const OnePoint point(strain_of(logs), last_, history_);
  Response response(6);
  law_.add(point.samples(), {.limits = limits_, .seconds = seconds_}, response);
  const Eigen::Vector3d squares = (2 * logs.array()).exp();
  Response3 result;
  result.energy = response.stored(0) + response.work(0);
  for (int i = 0; i < 3; ++i) {
    result.stress(i) = squares(i) * response.stress(0, i);
    for (int j = 0; j < 3; ++j) {
      result.tangent(i, j) = squares(i) * response.tangent(0, 6 * i + j) * squares(j);
    }
    result.tangent(i, i) += 2 * result.stress(i);
  }
  return result;
}

// Newton's method on the energy of the free sides; where it is not convex, down its slope.
std::optional<Eigen::VectorXd> HomogeneousPoint::search(const Free& free,
                                                        Eigen::VectorXd at) const {
  constexpr int kMost = 100;
  constexpr double kStep = 0.5;       // of a logarithm at once
  constexpr double kSettled = 1e-15;  // of the logarithms
  Response3 here = respond(free.logs(at));
  for (int iteration = 0; iteration < kMost; ++iteration) {
    if (!std::isfinite(here.energy)) return std::nullopt;
    const Eigen::VectorXd slope = free.along.transpose() * here.stress;
    const Eigen::MatrixXd curvature = free.along.transpose() * here.tangent * free.along;
    const Eigen::LLT<Eigen::MatrixXd> factor(curvature);
    const double scale = here.tangent.cwiseAbs().maxCoeff();
    Eigen::VectorXd step = factor.info() == Eigen::Success
                               ? Eigen::VectorXd(-factor.solve(slope))
                               : Eigen::VectorXd(-slope / std::max(scale, 1e-300));
    const double longest = step.cwiseAbs().maxCoeff();
    if (!(longest > kSettled)) return at;
    if (longest > kStep) step *= kStep / longest;
    // Rounding of the energy must not stop the last steps.
    const double slack = 1e-13 * std::abs(here.energy);
    for (int halved = 0;; ++halved) {
      const Response3 next = respond(free.logs(at + step));
      if (next.energy <= here.energy + slack) {
        at += step;
        here = next;
        break;
      }
      if (halved == 40) return longest < 1e-9 ? std::optional(at) : std::nullopt;
      step /= 2;
    }
    if (longest < 1e-12 && factor.info() == Eigen::Success) return at;
  }
  return std::nullopt;
}

double HomogeneousPoint::share_left(const Eigen::Vector3d& logs) const {
  const OnePoint point(strain_of(logs), last_, history_);
  Lane left = Lane::Ones();
  law_.lower_to_share_left(point.samples(), left);
  return left(0);
}

std::optional<Eigen::Vector3d> HomogeneousPoint::within_limits(const Free& free) {
  Eigen::VectorXd at = free.guess;
  const auto follow = [&](const LimitBarrier& limits) {
    limits_ = limits;
    const auto found = search(free, at);
    if (found) at = *found;
    return found.has_value();
  };
  for (const LimitBarrier& barrier : kLimitBarriers) follow(barrier);
  const bool found = share_left(free.logs(at)) > 0 && follow({});
  return found ? std::optional(free.logs(at)) : std::nullopt;
}

std::optional<Eigen::Vector3d> HomogeneousPoint::equilibrium(const Free& free) {
  limits_ = {};
  if (free.along.cols() == 0) {
    return share_left(free.fixed) > 0 ? std::optional(free.fixed) : std::nullopt;
  }
  if (law_.is_limited()) return within_limits(free);
  const auto found = search(free, free.guess);
  return found ? std::optional(free.logs(*found)) : std::nullopt;
}

HomogeneousStress HomogeneousPoint::stress_of(const Free& free, const Eigen::Vector3d& logs) {
  const Response3 at = respond(logs);
  const Eigen::Vector3d pull(1, 0, incompressible_ ? -1 : 0);
  const double per_stretch = std::exp(-logs(0));
  HomogeneousStress result;
  result.value = per_stretch * pull.dot(at.stress);
  result.stretches = logs.array().exp();
  const Strain strain = strain_of(logs);
  if (!derivatives_) {
    advance(strain);
    return result;
  }
  const auto count = static_cast<int>(last_by_.cols());
  const auto history = static_cast<int>(history_.size());
  const OnePoint point(strain, last_, history_);
  SampleDerivatives own(6, history, count);
  law_.differentiate(point.samples(), {.seconds = seconds_}, /*lane=*/0, 0, 0, own);
  const Eigen::Vector3d squares = (2 * logs.array()).exp();
  Eigen::MatrixXd stress_by =  // at fixed strain
      squares.asDiagonal() * (own.stress_by_parameter + own.stress_by_last * last_by_ +
                              own.stress_by_history * history_by_)
                                 .topRows<3>();
  Eigen::MatrixXd logs_by = Eigen::MatrixXd::Zero(3, count);
  if (free.along.cols() > 0) {
    const Eigen::MatrixXd curvature = free.along.transpose() * at.tangent * free.along;
    logs_by = -free.along * curvature.fullPivLu().solve(free.along.transpose() * stress_by);
    stress_by += at.tangent * logs_by;
  }
  result.by = per_stretch * pull.transpose() * stress_by;
  Eigen::MatrixXd strain_by = Eigen::MatrixXd::Zero(6, count);
  strain_by.topRows<3>() = squares.asDiagonal() * logs_by;
  history_by_ = own.next_by_parameter + own.next_by_strain * strain_by +
                own.next_by_last * last_by_ + own.next_by_history * history_by_;
  last_by_ = strain_by;
  advance(strain);
  return result;
}

void HomogeneousPoint::advance(const Strain& strain) {
  const OnePoint point(strain, last_, history_);
  Numbers next(kLanes, history_.size());
  next.setZero();
  Lane work = Lane::Zero();
  law_.advance(point.samples(), {.seconds = seconds_},
               MutableLaneView(next.data(), kLanes, next.cols()), work);
  history_ = next.row(0).transpose().matrix();
  last_ = strain;
}

std::optional<HomogeneousStress> HomogeneousPoint::move_to(const HomogeneousRow& row) {
  const Free free(row, incompressible_);
  seconds_ = row.seconds;
  const auto logs = equilibrium(free);
  if (!logs) return std::nullopt;
  return stress_of(free, *logs);
}

}  // namespace pliant
