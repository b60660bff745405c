// Equilibria of solids whose energies have limits, against a complementarity problem with
// multipliers on the same small mesh; and their derivatives, exact and as the thesis softens them.

#include <cmath>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/solver/static_path.h"
#include "pliant/solver/within_limits.h"

#include "support/solid_bodies.h"

namespace pliant {
namespace {

constexpr double kLambda = 3e4, kMu = 1e4, kTraction = 8e3;
/// N: what rounding leaves of forces of 80 N whose limits have a millionth left is some 1e-8.
constexpr double kForceTolerance = 1e-6;

Material limited_stvk(double largest) {
  Material material = stvk_solid(kLambda, kMu);
  material.limits.push_back({{"trace", "trace-of-square"}, largest});
  return material;
}

VolumeMesh small_block() { return block_of_tetrahedra({0.2, 0.1, 0.1}, {2, 1, 1}); }

/// A block that is held at one end and pulled askew at the other.
struct PulledBlock {
  test::SolidSystem solid;
  Eigen::Matrix3Xd load;
  std::vector<int> free;  ///< nodes

  explicit PulledBlock(const Material& material)
      : solid(test::solid_system(small_block(), solid_law(material))) {
    const VolumeMesh& mesh = solid.mesh;
    solid.hold(nodes_at(mesh, 0, 0));
    load = Eigen::Matrix3Xd::Zero(3, mesh.node_count());
    const std::vector<int> end = nodes_at(mesh, 0, 0.2);
    for (const int node : end) {
      load.col(node) =
          kTraction * 0.01 / static_cast<double>(end.size()) * Eigen::Vector3d(1, 0.3, -0.2);
    }
    solid.load(load);
    solid.system->finish();
    for (int i = 0; i < mesh.node_count(); ++i) {
      if (solid.system->coordinates().is_free(i)) free.push_back(i);
    }
  }
};

/// A dense complementarity problem: the energy W(x) - load x is least where psi_e <= psi_max.
class Multipliers {
 public:
  Multipliers(const PulledBlock& block, double lambda, double mu, double largest)
      : block_(block), law_(solid_density(stvk_solid(lambda, mu)).law), largest_(largest) {
    const VolumeMesh& mesh = block.solid.mesh;
    for (int t = 0; t < mesh.tetrahedron_count(); ++t) {
      const LinearTetrahedron::Positions x = mesh.positions(Eigen::all, mesh.tetrahedra.col(t));
      rests_.push_back(tetrahedron_rest(x));
      volumes_.push_back(tetrahedron_volume(x));
    }
  }

  int unknowns() const { return 3 * static_cast<int>(block_.free.size()); }
  int elements() const { return static_cast<int>(rests_.size()); }

  struct At {
    Eigen::VectorXd energies;   ///< psi_e
    Eigen::MatrixXd slopes;     ///< elements x unknowns: d psi_e
    Eigen::MatrixXd curvature;  ///< sum of (1 + multiplier_e) V_e d2 psi_e
  };

  At evaluate(const Eigen::Matrix3Xd& positions, const Eigen::VectorXd& multipliers) const {
    const VolumeMesh& mesh = block_.solid.mesh;
    const int all = 3 * mesh.node_count();
    At at{Eigen::VectorXd(elements()), Eigen::MatrixXd::Zero(elements(), all),
          Eigen::MatrixXd::Zero(all, all)};
    for (int e = 0; e < elements(); ++e) {
      const auto& rest = rests_[static_cast<size_t>(e)];
      const LinearTetrahedron::Positions x = positions(Eigen::all, mesh.tetrahedra.col(e));
      const Response response = respond(LinearTetrahedron::strain(rest, x));
      const LinearTetrahedron::Gradient gradient = LinearTetrahedron::gradient(rest, x);
      LinearTetrahedron::Strain stress = response.stress.row(0).transpose().matrix();
      Eigen::Matrix<double, 6, 6> tangent;
      for (int k = 0; k < 36; ++k) tangent(k) = response.tangent(0, k);
      const double size = (1 + multipliers(e)) * volumes_[static_cast<size_t>(e)];
      const LinearTetrahedron::Hessian hessian =
          gradient.transpose() * tangent * gradient +
          LinearTetrahedron::weighted_hessian(rest, x, stress);
      const Eigen::RowVectorXd slope = stress.transpose() * gradient;
      at.energies(e) = response.stored(0);
      for (int i = 0; i < 12; ++i) {
        const int row = 3 * mesh.tetrahedra(i / 3, e) + i % 3;
        at.slopes(e, row) += slope(i);
        for (int j = 0; j < 12; ++j) {
          at.curvature(row, 3 * mesh.tetrahedra(j / 3, e) + j % 3) += size * hessian(i, j);
        }
      }
    }
    const std::vector<int> rows = rows_of_unknowns();
    at.slopes = at.slopes(Eigen::all, rows).eval();
    at.curvature = at.curvature(rows, rows).eval();
    return at;
  }

  Eigen::VectorXd volumes() const {
    return Eigen::Map<const Eigen::VectorXd>(volumes_.data(), std::ssize(volumes_));
  }

  /// What is left of the equilibrium of forces.
  Eigen::VectorXd forces(const At& at, const Eigen::VectorXd& multipliers) const {
    const Eigen::VectorXd sizes = volumes().cwiseProduct((multipliers.array() + 1).matrix());
    return at.slopes.transpose() * sizes - block_.load.reshaped()(rows_of_unknowns());
  }

  /// Newton's method on the equations of some active limits.
  /// @param multipliers  above 0 where limits are active
  void solve(Eigen::Matrix3Xd& positions, Eigen::VectorXd& multipliers) const {
    for (int iteration = 0; iteration < 30; ++iteration) {
      const At at = evaluate(positions, multipliers);
      const std::vector<int> active = active_of(multipliers);
      const Eigen::MatrixXd system = kkt(at, active);
      Eigen::VectorXd left(system.rows());
      left << -forces(at, multipliers), largest_ - at.energies(active).array();
      const Eigen::VectorXd step = system.fullPivLu().solve(left);
      for (int u = 0; u < unknowns(); ++u) {
        positions(u % 3, block_.free[static_cast<size_t>(u / 3)]) += step(u);
      }
      for (size_t a = 0; a < active.size(); ++a) {
        multipliers(active[a]) += step(unknowns() + static_cast<int>(a));
      }
      if (step.head(unknowns()).cwiseAbs().maxCoeff() < 1e-15) return;
    }
  }

  /// d positions of free nodes / d psi_max, by the equations of the active limits.
  Eigen::VectorXd exact_by_limit(const Eigen::Matrix3Xd& positions,
                                 const Eigen::VectorXd& multipliers) const {
    const At at = evaluate(positions, multipliers);
    const std::vector<int> active = active_of(multipliers);
    Eigen::VectorXd left = Eigen::VectorXd::Zero(unknowns() + std::ssize(active));
    left.tail(std::ssize(active)).setOnes();
    return kkt(at, active).fullPivLu().solve(left).head(unknowns());
  }

  /// [T] Eq. 4.9 with its minus sign: limits as soft constraints k C^2 / 2 of C = psi_max - psi,
  /// per volume, whose own curvature it leaves out.
  Eigen::VectorXd soft_by_limit(const Eigen::Matrix3Xd& positions,
                                const Eigen::VectorXd& multipliers, double k) const {
    const At at = evaluate(positions, Eigen::VectorXd::Zero(elements()));
    const std::vector<int> active = active_of(multipliers);
    const Eigen::MatrixXd jacobian = -at.slopes(active, Eigen::all);  // of C
    const Eigen::VectorXd stiffness = k * volumes()(active);
    // f = -dW, so that df/dq = -curvature; dC / d psi_max = 1, df / d psi_max = 0.
    const Eigen::MatrixXd matrix =
        -at.curvature - jacobian.transpose() * stiffness.asDiagonal() * jacobian;
    const Eigen::VectorXd right = -jacobian.transpose() * stiffness;
    return -matrix.fullPivLu().solve(right);
  }

  static std::vector<int> active_of(const Eigen::VectorXd& multipliers) {
    std::vector<int> active;
    for (int e = 0; e < multipliers.size(); ++e) {
      if (multipliers(e) > 0) active.push_back(e);
    }
    return active;
  }

 private:
  Response respond(const LinearTetrahedron::Strain& strain) const {
    const Eigen::Array<double, kLanes, Eigen::Dynamic> numbers =
        strain.transpose().replicate(kLanes, 1).array();
    const LaneView view(numbers.data(), kLanes, 6);
    Response response(6);
    law_->add({view, view, view, LaneView(numbers.data(), kLanes, 0)}, {}, response);
    return response;
  }

  std::vector<int> rows_of_unknowns() const {
    std::vector<int> rows;
    for (const int node : block_.free)
      rows.insert(rows.end(), {3 * node, 3 * node + 1, 3 * node + 2});
    return rows;
  }

  Eigen::MatrixXd kkt(const At& at, const std::vector<int>& active) const {
    const Eigen::Index n = unknowns(), m = std::ssize(active);
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(n + m, n + m);
    system.topLeftCorner(n, n) = at.curvature;
    const Eigen::MatrixXd slopes = at.slopes(active, Eigen::all);
    system.topRightCorner(n, m) = slopes.transpose() * volumes()(active).asDiagonal();
    system.bottomLeftCorner(m, n) = slopes;
    return system;
  }

  const PulledBlock& block_;
  std::shared_ptr<const Sum> law_;
  double largest_;
  std::vector<LinearTetrahedron::Rest> rests_;
  std::vector<double> volumes_;
};

constexpr double kLargest = 700;  // J/m^3; without it some elements come to three times as much

/// An equilibrium by barriers, and the solution of the complementarity problem next to it.
struct Solved {
  PulledBlock block{limited_stvk(kLargest)};
  Multipliers problem{block, kLambda, kMu, kLargest};
  Eigen::Matrix3Xd by_barriers, by_multipliers;
  Eigen::VectorXd barriers, multipliers;  ///< lambda of each element

  Solved() {
    State state = block.solid.system->initial_state();
    EXPECT_TRUE(test::settle(*block.solid.system, state, kForceTolerance).converged);
    by_barriers = by_multipliers = state.configuration.positions;
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(problem.elements());
    const Eigen::ArrayXd left = 1 - problem.evaluate(by_barriers, none).energies.array() / kLargest;
    barriers = (LimitBarrier{}.share / left).matrix();
    multipliers = (barriers.array() > 1e-3).select(barriers, 0);
    problem.solve(by_multipliers, multipliers);
  }
};

TEST(LimitedEquilibrium, HasTheForcesOfTheMultipliersOfTheComplementarityProblem) {
  const Solved solved;
  const auto& [block, problem, by_barriers, by_multipliers, barriers, multipliers] = solved;
  const auto at = problem.evaluate(by_multipliers, multipliers);
  // A solution of the complementarity problem, with limits that act and others that do not.
  const double scale = block.load.norm();
  EXPECT_LT(problem.forces(at, multipliers).norm(), 1e-12 * scale);
  EXPECT_GE(multipliers.minCoeff(), 0);
  EXPECT_LE(at.energies.maxCoeff(), kLargest * (1 + 1e-12));
  const auto active = std::ssize(Multipliers::active_of(multipliers));
  EXPECT_GE(active, 2);
  EXPECT_LT(active, problem.elements());
  EXPECT_GT(multipliers.maxCoeff(), 0.1);
  // Barriers come to it.
  EXPECT_LT((barriers - multipliers).cwiseAbs().maxCoeff(), 1e-4 * multipliers.maxCoeff());
  const Eigen::MatrixXd forces = at.slopes.transpose() * problem.volumes().asDiagonal();
  EXPECT_LT((forces * (barriers - multipliers)).norm(), 1e-4 * (forces * multipliers).norm());
  EXPECT_LT((by_barriers - by_multipliers).cwiseAbs().maxCoeff(), 1e-5 * 0.2);
  EXPECT_LT(problem.evaluate(by_barriers, multipliers).energies.maxCoeff(), kLargest);
}

TEST(LimitedEquilibrium, DerivativesAreExactWhereTheThesisSoftOnesAreNot) {
  const Solved solved;
  const PulledBlock& block = solved.block;
  const std::vector<std::string>& names = block.solid.system->parameters().names;
  ASSERT_EQ(names.back(), "trace+trace-of-square.limit");
  StaticPath path(*block.solid.system, {.newton = {.tolerance = kForceTolerance},
                                        .by = {static_cast<int>(names.size()) - 1}});
  const PathEquilibrium found = path.step(1);
  Eigen::VectorXd own(solved.problem.unknowns());
  for (size_t i = 0; i < block.free.size(); ++i) {
    own.segment<3>(3 * static_cast<Eigen::Index>(i)) =
        found.by_parameter.positions.col(0).segment<3>(3 * block.free[i]);
  }
  const Eigen::VectorXd exact =
      solved.problem.exact_by_limit(solved.by_multipliers, solved.multipliers);
  EXPECT_LT((own - exact).norm(), 1e-4 * exact.norm());
  // The forces that hold the block change as finite differences of equilibria say.
  std::vector<Eigen::Vector3d> held;
  const double step = 1e-3 * kLargest;
  for (const double sign : {-1.0, 1.0}) {
    const PulledBlock other(limited_stvk(kLargest + sign * step));
    State state = other.solid.system->initial_state();
    test::settle(*other.solid.system, state, kForceTolerance);
    const Eigen::Matrix3Xd& x = state.configuration.positions;
    Eigen::VectorXd moved(solved.problem.unknowns());
    for (size_t i = 0; i < block.free.size(); ++i) {
      moved.segment<3>(3 * static_cast<Eigen::Index>(i)) = x.col(block.free[i]);
    }
    if (sign < 0) own = -moved;
    if (sign > 0) own += moved;
  }
  EXPECT_LT((own / (2 * step) - exact).norm(), 1e-3 * exact.norm());
  // [T] Eq. 4.9 leaves out how the forces of limits turn with the body: whatever k, it is off.
  double least = INFINITY;
  for (double k = 1e-4; k < 1e4; k *= 10) {
    const Eigen::VectorXd soft =
        solved.problem.soft_by_limit(solved.by_multipliers, solved.multipliers, k);
    least = std::min(least, (soft - exact).norm() / exact.norm());
  }
  RecordProperty("error_of_the_soft_jacobian", std::to_string(least));
  EXPECT_GT(least, 1e-2);
}

TEST(LimitedEquilibrium, ComesBackFromBeyondALimit) {
  // Pulled by its end at once further than its limit lets any element go, and led from there.
  test::SolidSystem solid = test::solid_system(small_block(), solid_law(limited_stvk(kLargest)));
  solid.hold(nodes_at(solid.mesh, 0, 0));
  const std::vector<int> end = nodes_at(solid.mesh, 0, 0.2);
  solid.hold(end);
  solid.system->finish();
  StaticPathOptions options{.newton = {.tolerance = kForceTolerance}};
  options.schedule = [&](double time) {
    Controls controls;
    controls.time = time;
    for (const int node : end) {
      controls.places.push_back(
          {node, solid.mesh.positions.col(node) + time * Eigen::Vector3d(0.03, 0, 0)});
    }
    return controls;
  };
  StaticPath path(*solid.system, options);
  const PathEquilibrium found = path.step(1);
  EXPECT_EQ(found.equilibria, 1);
  EXPECT_GT(solid.system->share_left(path.state().configuration, {path.state()}), 0);
  // Twice as far there is nothing within the limit.
  EXPECT_THROW(path.step(2.5), SolverError);
}

}  // namespace
}  // namespace pliant
