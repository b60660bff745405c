#include "pliant/math/ssor_cg.h"

#include <cmath>
#include <initializer_list>
#include <limits>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <gtest/gtest.h>

#include "pliant/base/parallel.h"

#include "math/block_matrices.h"

namespace pliant {
namespace {

using test::cloth_matrix;
using test::dense;
using test::random_vector;

constexpr int kNodes = 8;
constexpr Eigen::Index kUnknowns = 3 * kNodes * kNodes;

/// |b - K x| / |b| in the norm of the over-relaxed preconditioner, in double precision: with
/// diagonal blocks w C C^T and the strict lower triangle L, |r| = |(C + L C^-T)^-1 r|.
double preconditioned_residual(const BlockMatrix& matrix, const Eigen::VectorXd& b,
                               const Eigen::VectorXd& x) {
  constexpr double kRelaxation = 1.5;
  const Eigen::MatrixXd k = dense(matrix);
  Eigen::MatrixXd factor = Eigen::MatrixXd::Zero(k.rows(), k.cols());
  for (Eigen::Index j = 0; j < k.cols(); j += 3) {
    const Eigen::Matrix3d diagonal = k.block<3, 3>(j, j) / kRelaxation;
    const Eigen::Matrix3d c = diagonal.llt().matrixL();
    for (Eigen::Index i = j; i < k.rows(); i += 3) {
      const Eigen::Matrix3d block = i == j ? diagonal : k.block<3, 3>(i, j);
      factor.block<3, 3>(i, j) = block * c.transpose().inverse();
    }
  }
  const Eigen::PartialPivLU<Eigen::MatrixXd> lu(factor);
  return lu.solve(b - k * x).norm() / lu.solve(b).norm();
}

struct Case {
  double stiffness, mass;
};
// Condition numbers from about 10 to about 1e4: a soft cloth at short steps, a stiff one at long.
const Case kCases[] = {{1, 1}, {100, 1}, {1e4, 1}};

TEST(SsorCg, SolvesWithProductsBesideThePattern) {
  RandomStream random(5);
  BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 100, 1);
  test::add_outer_products(random, 30, matrix);
  SsorCg solver(matrix, {.tolerance = 1e-9});
  ASSERT_TRUE(solver.factorize(matrix));
  const Eigen::VectorXd truth = random_vector(random, kUnknowns);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
  EXPECT_TRUE(solver.solve(dense(matrix) * truth, x).converged);
  EXPECT_LT((x - truth).norm(), 1e-6 * truth.norm());
}

TEST(SsorCg, MeetsItsToleranceInOnePassOfSinglePrecision) {
  RandomStream random(1);
  for (const Case& c : kCases) {
    const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, c.stiffness, c.mass);
    SsorCg solver(matrix, {});
    ASSERT_TRUE(solver.factorize(matrix));
    const Eigen::VectorXd b = random_vector(random, kUnknowns);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
    const LinearSummary summary = solver.solve(b, x);
    EXPECT_TRUE(summary.converged) << c.stiffness;
    EXPECT_LE(summary.residual, 1e-4);
    EXPECT_GT(summary.iterations, 0);
    // What single precision adds to the residual is of the tolerance's own size at most.
    EXPECT_LT(preconditioned_residual(matrix, b, x), 2e-4) << c.stiffness;
  }
}

// Where a cloth is so stiff, or its step so long, that single precision does not reach the
// tolerance, the solver goes on in double or says so.
TEST(SsorCg, IsNotDeceivedByItsOwnRounding) {
  RandomStream random(1);
  for (const double mass : {1e-2, 1e-3, 1e-4}) {
    const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 1e3, mass);
    SsorCg solver(matrix, {});
    ASSERT_TRUE(solver.factorize(matrix));
    const Eigen::VectorXd b = random_vector(random, kUnknowns);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
    const LinearSummary summary = solver.solve(b, x);
    const double residual = preconditioned_residual(matrix, b, x);
    if (summary.converged) {
      EXPECT_LT(residual, 2e-4) << mass;
    } else {
      EXPECT_NEAR(summary.residual, residual, 0.1 * residual) << mass;
    }
  }
}

TEST(SsorCg, GoesBeyondSinglePrecisionByRefinement) {
  RandomStream random(2);
  for (const Case& c : kCases) {
    const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, c.stiffness, c.mass);
    SsorCg solver(matrix, {.tolerance = 1e-10});
    ASSERT_TRUE(solver.factorize(matrix));
    const Eigen::VectorXd b = random_vector(random, kUnknowns);
    Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
    const LinearSummary summary = solver.solve(b, x);
    EXPECT_TRUE(summary.converged) << c.stiffness;
    // The solver takes the norm of its true residual in single precision.
    EXPECT_LT(preconditioned_residual(matrix, b, x), 1.01e-10) << c.stiffness;
    const Eigen::VectorXd expected = dense(matrix).llt().solve(b);
    EXPECT_LT((x - expected).norm(), 1e-10 * c.stiffness / c.mass * expected.norm()) << c.stiffness;
  }
}

TEST(SsorCg, NeedsNoIterationFromTheSolution) {
  RandomStream random(3);
  for (const double tolerance : {1e-4, 1e-10}) {
    const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 100, 1);
    SsorCg solver(matrix, {.tolerance = tolerance});
    ASSERT_TRUE(solver.factorize(matrix));
    const Eigen::VectorXd b = random_vector(random, kUnknowns);
    const Eigen::VectorXd solution = dense(matrix).llt().solve(b);
    Eigen::VectorXd x = solution;
    const LinearSummary summary = solver.solve(b, x);
    EXPECT_TRUE(summary.converged);
    EXPECT_EQ(summary.iterations, 0);
    EXPECT_EQ(x, solution);
  }
}

TEST(SsorCg, NeedsFewerIterationsFromNearTheSolution) {
  RandomStream random(4);
  const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 1000, 1);
  SsorCg solver(matrix, {});
  ASSERT_TRUE(solver.factorize(matrix));
  const Eigen::VectorXd b = random_vector(random, kUnknowns);
  const Eigen::VectorXd solution = dense(matrix).llt().solve(b);
  Eigen::VectorXd cold = Eigen::VectorXd::Zero(kUnknowns), warm = 0.99 * solution;
  EXPECT_LT(solver.solve(b, warm).iterations, solver.solve(b, cold).iterations);
}

TEST(SsorCg, GivesZeroForNoForceWhateverTheGuess) {
  RandomStream random(5);
  const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 10, 1);
  SsorCg solver(matrix, {});
  ASSERT_TRUE(solver.factorize(matrix));
  Eigen::VectorXd x = random_vector(random, kUnknowns);
  EXPECT_TRUE(solver.solve(Eigen::VectorXd::Zero(kUnknowns), x).converged);
  EXPECT_EQ(x.norm(), 0);
}

// A cloth nearly at rest: forces of 1e-24 N are as good as any others, and squares of what single
// precision can hold are not.
TEST(SsorCg, DoesNotDependOnTheUnits) {
  RandomStream random(6);
  const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 100, 1);
  const Eigen::VectorXd b = random_vector(random, kUnknowns);
  for (const double tolerance : {1e-4, 1e-8}) {
    SsorCg solver(matrix, {.tolerance = tolerance});
    ASSERT_TRUE(solver.factorize(matrix));
    for (const double unit : {1e-24, 1e-12, 1.0, 1e12, 1e24}) {
      Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
      EXPECT_TRUE(solver.solve(unit * b, x).converged) << unit;
      EXPECT_LT(preconditioned_residual(matrix, b, x / unit), 2 * tolerance) << unit;
    }
  }
  BlockMatrix scaled = matrix;
  for (const double unit : {1e-12, 1e12}) {
    for (int k = 0; k < matrix.pattern().block_count(); ++k) {
      scaled.block(k) = unit * matrix.block(k);
    }
    SsorCg solver(scaled, {});
    ASSERT_TRUE(solver.factorize(scaled));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
    EXPECT_TRUE(solver.solve(b, x).converged) << unit;
    EXPECT_LT(preconditioned_residual(matrix, b, x * unit), 2e-4) << unit;
  }
}

TEST(SsorCg, TakesNewValuesOfTheSamePattern) {
  RandomStream random(7);
  const BlockMatrix first = cloth_matrix(random, kNodes, kNodes, 100, 1);
  BlockMatrix second = first;
  for (int i = 0; i < kNodes * kNodes; ++i) second.add_to_diagonal(i, random.uniform(0, 5));
  const Eigen::VectorXd b = random_vector(random, kUnknowns);
  SsorCg solver(first, {.tolerance = 1e-8});
  for (const BlockMatrix* matrix :
       std::initializer_list<const BlockMatrix*>{&first, &second, &first}) {
    ASSERT_TRUE(solver.factorize(*matrix));
    Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
    EXPECT_TRUE(solver.solve(b, x).converged);
    EXPECT_LT(preconditioned_residual(*matrix, b, x), 1.01e-8);
  }
}

TEST(SsorCg, IsTheSameToTheBitWhenRepeated) {
  RandomStream random(8);
  const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 1e3, 1);
  const Eigen::VectorXd b = random_vector(random, kUnknowns);
  SsorCg solver(matrix, {});
  ASSERT_TRUE(solver.factorize(matrix));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns), y = x;
  solver.solve(b, x);
  solver.solve(b, y);
  EXPECT_EQ(x, y);
}

// A matrix that is swept in two halves, with and without something beside its pattern.
TEST(SsorCg, SolvesInHalvesToTheSameBitsOnAnyNumberOfThreads) {
  constexpr int kMany = 40;
  RandomStream random(12);
  BlockMatrix matrix = cloth_matrix(random, kMany, kMany, 100, 1);
  SsorCg solver(matrix, {.tolerance = 1e-9});
  for (const int products : {0, 30}) {
    test::add_outer_products(random, products, matrix);
    ASSERT_TRUE(solver.factorize(matrix));
    const Eigen::VectorXd truth = random_vector(random, 3 * kMany * kMany);
    const Eigen::VectorXd b = matrix * truth;
    Eigen::VectorXd on_one = Eigen::VectorXd::Zero(b.size()), on_two = on_one;
    EXPECT_TRUE(solver.solve(b, on_one).converged);
    with_threads(2, [&] { solver.solve(b, on_two); });
    EXPECT_LT((on_one - truth).norm(), 1e-6 * truth.norm());
    EXPECT_EQ(on_one, on_two);
  }
}

TEST(SsorCg, SaysWhenItRanOutOfIterations) {
  RandomStream random(9);
  const BlockMatrix matrix = cloth_matrix(random, kNodes, kNodes, 1e4, 1);
  SsorCg solver(matrix, {.tolerance = 1e-8, .max_iterations = 3});
  ASSERT_TRUE(solver.factorize(matrix));
  Eigen::VectorXd x = Eigen::VectorXd::Zero(kUnknowns);
  const LinearSummary summary = solver.solve(random_vector(random, kUnknowns), x);
  EXPECT_FALSE(summary.converged);
  EXPECT_LE(summary.iterations, 3);
  EXPECT_GT(summary.residual, 1e-8);
}

TEST(SsorCg, NoticesADiagonalThatIsNotPositive) {
  RandomStream random(10);
  const BlockMatrix good = cloth_matrix(random, 4, 4, 10, 1);
  SsorCg solver(good, {});
  for (const double value : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
    BlockMatrix bad = good;
    bad.block(bad.pattern().diagonal(6)) = value * Eigen::Matrix3d::Identity();
    EXPECT_FALSE(solver.factorize(bad)) << value;
  }
  EXPECT_TRUE(solver.factorize(good));
}

TEST(SsorCg, ReportsNegativeCurvatureAsNotConverged) {
  RandomStream random(11);
  for (int trial = 0; trial < 20; ++trial) {
    BlockMatrix saddle = cloth_matrix(random, 4, 4, 10, 1);
    for (int i = 0; i + 1 < 16; i += 5) {
      saddle.add(i, i + 1, random.uniform(50, 500) * Eigen::Matrix3d::Identity());
    }
    SsorCg solver(saddle, {.tolerance = trial % 2 == 0 ? 1e-4 : 1e-10});
    ASSERT_TRUE(solver.factorize(saddle));  // the diagonal blocks are in order
    Eigen::VectorXd x = Eigen::VectorXd::Zero(48);
    const LinearSummary summary = solver.solve(random_vector(random, 48), x);
    EXPECT_FALSE(summary.converged);
    EXPECT_TRUE(x.allFinite());
    EXPECT_FALSE(std::isnan(summary.residual));
  }
}

TEST(SsorCg, SolvesNothingForNoUnknowns) {
  const BlockMatrix matrix(std::make_shared<BlockPattern>(0, std::vector<std::pair<int, int>>{}));
  SsorCg solver(matrix, {});
  EXPECT_TRUE(solver.factorize(matrix));
  Eigen::VectorXd x;
  EXPECT_TRUE(solver.solve(Eigen::VectorXd(), x).converged);
}

}  // namespace
}  // namespace pliant
