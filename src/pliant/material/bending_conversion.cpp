#include "pliant/material/bending_conversion.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

#include "pliant/base/assert.h"
#include "pliant/material/bounded_factors.h"
#include "pliant/material/grid_bending.h"
#include "pliant/material/plate_patch.h"

namespace pliant {
namespace {

// docs/architecture.md, Bending: sheets and hinges. Friction: docs/bending.md, Friction of sheets
// and of hinges.

// How a mesh answers to its hinges, and which directions are to be met.
struct SheetModel {
  std::function<RigidityShares(const BendingVector&)> shares;
  std::function<BentShape(const BendingVector&)> shape;  // of hinges with a stiffness at rest
  Eigen::Vector4d direction_weights;                     // of squared relative errors
  bool is_sheet = true;  // there are hinges enough to speak of a sheet
};

Eigen::Vector4d direction_weights(Diagonals diagonals) {
  if (diagonals == Diagonals::rising) return {1, 1, 0, 1};
  if (diagonals == Diagonals::falling) return {1, 1, 1, 0};
  return {1, 1, 0.5, 0.5};
}

SheetModel sheet_model(const TriangleMesh& mesh, const std::vector<Hinge>& hinges) {
  if (const auto pattern = grid_pattern(mesh, hinges)) {
    const BentShape shape = [=](const HingeStress& stress) {
      return bent_cell(*pattern, stress, kSlipCurvature);
    };
    return {[=](const BendingVector& k) { return grid_rigidity(*pattern, k); },
            [=](const BendingVector&) { return shape; }, direction_weights(pattern->diagonals)};
  }
  constexpr std::size_t kMinHinges = 30;
  const auto patch = std::make_shared<PlatePatch>(mesh);
  // Irregular meshes relax by little. That friction hinders them is left out: a plate would have to
  // be solved anew for each direction, again and again.
  const auto elastic_shape = [patch](const BendingVector& k) -> BentShape {
    return [bent = patch->bent(k)](const HingeStress&) { return bent; };
  };
  return {[patch](const BendingVector& k) { return patch->rigidity(k); }, elastic_shape,
          direction_weights(Diagonals::alternating), patch->hinge_count() >= kMinHinges};
}

Eigen::Vector4d by_direction(const BendingVector& stiffness) {
  return {stiffness(0), stiffness(1), stiffness(2), stiffness(2)};
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
        bounded_factors(scale.asDiagonal() * shares * sheet.asDiagonal(), root_weights) - factors;
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

BendingLaws bending_laws(const Material& material) {
  BendingLaws laws;
  for (std::size_t c = 0; c < laws.size(); ++c) {
    constexpr std::array kNames{"bend.weft", "bend.warp", "bend.diagonal"};
    const auto law = law_of(material, kNames[c]);
    PLIANT_ASSERT(law.has_value(), "a component that was not measured has no law");
    laws[c] = *law;
  }
  return laws;
}

BendingVector stiffness_at_rest(const BendingLaws& laws) {
  return {laws[0].stiffness_at_rest(), laws[1].stiffness_at_rest(), laws[2].stiffness_at_rest()};
}

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

BendingConversion BendingConverter::operator()(const BendingLaws& sheet) const {
  const BendingVector at_rest = stiffness_at_rest(sheet);
  BendingConversion conversion = (*this)(at_rest);
  conversion.slip = slip(sheet, conversion.factors);
  return conversion;
}

BendingVector BendingConverter::slip(const BendingLaws& sheet, const BendingVector& factors) const {
  const SheetModel& model = mesh_->model;
  const bool rubs =
      std::ranges::any_of(sheet, [](const ComponentLaw& law) { return law.remembers(); });
  if (!rubs || !model.is_sheet) return BendingVector::Ones();
  const BentShape shape = model.shape(factors.cwiseProduct(stiffness_at_rest(sheet)));
  return hinge_slip(sheet, factors, model.direction_weights, shape);
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
