#include "pliant/material/bending_conversion.h"

#include <functional>
#include <limits>
#include <memory>

#include <Eigen/QR>

#include "pliant/base/assert.h"
#include "pliant/material/grid_bending.h"
#include "pliant/material/plate_patch.h"

namespace pliant {
namespace {

// How a mesh answers to its hinges, and which directions are to be met.
struct SheetModel {
  std::function<RigidityShares(const BendingVector&)> shares;
  Eigen::Vector4d direction_weights;  // of squared relative errors
  bool is_sheet = true;               // there are hinges enough to speak of a sheet
};

Eigen::Vector4d direction_weights(Diagonals diagonals) {
  if (diagonals == Diagonals::rising) return {1, 1, 0, 1};
  if (diagonals == Diagonals::falling) return {1, 1, 1, 0};
  return {1, 1, 0.5, 0.5};
}

SheetModel sheet_model(const TriangleMesh& mesh, const std::vector<Hinge>& hinges) {
  if (const auto pattern = grid_pattern(mesh, hinges)) {
    return {[=](const BendingVector& k) { return grid_rigidity(*pattern, k); },
            direction_weights(pattern->diagonals)};
  }
  constexpr std::size_t kMinHinges = 30;
  const auto patch = std::make_shared<PlatePatch>(mesh);
  return {[patch](const BendingVector& k) { return patch->rigidity(k); },
          direction_weights(Diagonals::alternating), patch->hinge_count() >= kMinHinges};
}

Eigen::Vector4d by_direction(const BendingVector& stiffness) {
  return {stiffness(0), stiffness(1), stiffness(2), stiffness(2)};
}

// Hinges a hundred times softer than the sheet fold almost freely, and ten times stiffer ones
// hardly bend: beyond, factors would change nothing but the conditioning.
constexpr double kLeastFactor = 0.01, kGreatestFactor = 10;

// Least squares of a x = b between the limits of factors. With three unknowns every choice of those
// that stand on a limit can be tried; the solution is the best candidate within the limits.
Eigen::Vector3d bounded_least_squares(const Eigen::Matrix<double, 4, 3>& a,
                                      const Eigen::Vector4d& b) {
  constexpr int kChoices = 3;  // of each unknown: at its lower limit, at its upper limit, free
  Eigen::Vector3d best = Eigen::Vector3d::Ones();
  double least = std::numeric_limits<double>::infinity();
  for (int choice = 0; choice < kChoices * kChoices * kChoices; ++choice) {
    const int choices[3] = {choice % kChoices, choice / kChoices % kChoices,
                            choice / (kChoices * kChoices)};
    Eigen::Matrix<double, 4, 3> free_columns = Eigen::Matrix<double, 4, 3>::Zero();
    Eigen::Vector3d x;
    for (int j = 0; j < 3; ++j) {
      x(j) = choices[j] == 1 ? kGreatestFactor : kLeastFactor;
      if (choices[j] == 2) free_columns.col(j) = a.col(j);
    }
    // Least change: none of the unknowns whose columns are zero.
    x += free_columns.completeOrthogonalDecomposition().solve(b - a * x).eval();
    const bool is_within = x.minCoeff() >= kLeastFactor && x.maxCoeff() <= kGreatestFactor;
    const double error = (a * x - b).squaredNorm();
    if (is_within && error < least) {
      least = error;
      best = x;
    }
  }
  return best;
}

// What the sheet shows over what it should, less 1.
Eigen::Vector4d relative_errors(const SheetModel& model, const BendingVector& sheet,
                                const BendingVector& factors) {
  const BendingVector stiffness = factors.cwiseProduct(sheet);
  const Eigen::Vector4d shown = model.shares(stiffness) * stiffness;
  return shown.cwiseQuotient(by_direction(sheet)).array() - 1;
}

// Gauss-Newton on the relative errors: shares * stiffness is what the sheet shows, and the shares
// are its derivative, so that a full step solves shares * stiffness = target.
BendingVector solve_factors(const SheetModel& model, const BendingVector& sheet) {
  constexpr int kMaxIterations = 50;
  constexpr double kTolerance = 1e-7;
  constexpr double kLeastStep = 1e-4;
  const Eigen::Vector4d root_weights = model.direction_weights.cwiseSqrt();
  const Eigen::Vector4d scale = root_weights.cwiseQuotient(by_direction(sheet));
  const auto error_at = [&](const BendingVector& factors) {
    return relative_errors(model, sheet, factors).cwiseProduct(root_weights).norm();
  };
  BendingVector factors = BendingVector::Ones();
  double error = error_at(factors);
  for (int i = 0; i < kMaxIterations && error > kTolerance; ++i) {
    const RigidityShares shares = model.shares(factors.cwiseProduct(sheet));
    const BendingVector step =
        bounded_least_squares(scale.asDiagonal() * shares * sheet.asDiagonal(), root_weights) -
        factors;
    double length = 1, next = error_at(factors + step);
    while (next > error && length > kLeastStep) {
      length /= 2;
      next = error_at(factors + length * step);
    }
    if (next > error) break;
    factors += length * step;
    error = next;
    if (length * step.norm() <= kTolerance) break;
  }
  return factors;
}

}  // namespace

struct BendingConverter::Mesh {
  SheetModel model;
};

BendingConverter::BendingConverter(const TriangleMesh& mesh, const std::vector<Hinge>& hinges)
    : mesh_(std::make_unique<Mesh>(Mesh{sheet_model(mesh, hinges)})) {}

BendingConverter::~BendingConverter() = default;

BendingConversion BendingConverter::operator()(const BendingVector& sheet_stiffness) const {
  PLIANT_ASSERT((sheet_stiffness.array() > 0).all(), "a sheet has a positive bending stiffness");
  const SheetModel& model = mesh_->model;
  BendingConversion conversion;
  if (model.is_sheet) conversion.factors = solve_factors(model, sheet_stiffness);
  conversion.errors = relative_errors(model, sheet_stiffness, conversion.factors);
  return conversion;
}

Eigen::Matrix3d BendingConverter::factors_by_sheet(const BendingVector& sheet_stiffness) const {
  constexpr double kStep = 1e-3;  // of the stiffness; factors are solved to 1e-7
  Eigen::Matrix3d derivative;
  for (int j = 0; j < 3; ++j) {
    const BendingVector step = kStep * sheet_stiffness(j) * BendingVector::Unit(j);
    const BendingVector change =
        (*this)(sheet_stiffness + step).factors - (*this)(sheet_stiffness - step).factors;
    derivative.col(j) = change / (2 * step(j));
  }
  return derivative;
}

BendingConversion bending_conversion(const TriangleMesh& mesh, const std::vector<Hinge>& hinges,
                                     const BendingVector& sheet_stiffness) {
  return BendingConverter(mesh, hinges)(sheet_stiffness);
}

Eigen::Vector4d sheet_stiffness(const TriangleMesh& mesh, const std::vector<Hinge>& hinges,
                                const BendingVector& hinge_stiffness) {
  return sheet_model(mesh, hinges).shares(hinge_stiffness) * hinge_stiffness;
}

}  // namespace pliant
