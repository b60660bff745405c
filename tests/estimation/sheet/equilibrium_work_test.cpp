// What derivatives of equilibria save.

#include <gtest/gtest.h>

#include "pliant/estimation/sheet/sheet_problem.h"

#include "support/virtual_sheets.h"

namespace pliant {
namespace {

constexpr int kFrames = 4;
constexpr int kUnknowns = 3;  // |k|: control values of the stretch along weft

Material with_weft(std::vector<double> values) {
  Material material = test::sheet_cloth(true);
  material.components.at("stretch.weft").stiffness =
      ScalarCurve::hermite({0, 0.05, 0.1}, std::move(values));
  return material;
}

/// A stretch of a sheet whose stiffness is to be found.
class WeftProblem {
 public:
  WeftProblem() : test_("weft", session(), SheetObjective::clip_forces) {
    problem_ = std::make_unique<SheetProblem>(
        std::vector<const SheetTest*>{&test_}, with_weft({100, 100, 100}),
        std::vector<ComponentGroup>{{"stretch.weft"}}, std::vector<double>{0.1}, context_);
  }

  const SheetProblem& problem() const { return *problem_; }
  EquilibriumCounts counts() const { return problem_->rows().work().counts; }

 private:
  static Session session() {
    return test::virtual_stretch(with_weft({80, 150, 300}), 0, 7, kFrames);
  }

  RunContext context_;
  SheetTest test_;
  std::unique_ptr<SheetProblem> problem_;
};

/// The same problem with derivatives by forward differences.
LeastSquaresProblem by_differences(LeastSquaresProblem problem, int& evaluations) {
  problem.evaluate = [evaluate = problem.evaluate, &evaluations](const Eigen::VectorXd& at,
                                                                 Eigen::VectorXd& residual,
                                                                 Eigen::MatrixXd* jacobian) {
    ++evaluations;
    if (!evaluate(at, residual, nullptr)) return false;
    if (!jacobian) return true;
    jacobian->resize(residual.size(), at.size());
    for (Eigen::Index k = 0; k < at.size(); ++k) {
      const double step = 1e-3 * at(k);
      Eigen::VectorXd beside = at, changed = residual;
      beside(k) += step;
      if (!evaluate(beside, changed, nullptr)) return false;
      jacobian->col(k) = (changed - residual) / step;
    }
    return true;
  };
  return problem;
}

LeastSquaresProblem counted(LeastSquaresProblem problem, int& evaluations) {
  problem.evaluate = [evaluate = problem.evaluate, &evaluations](const auto& at, auto& residual,
                                                                 auto* jacobian) {
    ++evaluations;
    return evaluate(at, residual, jacobian);
  };
  return problem;
}

TEST(EquilibriumWork, OfAFitIsAPartInKPlusOneOfThatWithForwardDifferences) {
  const WeftProblem ours, theirs;
  int our_evaluations = 0, their_evaluations = 0;
  const LeastSquaresOptions options{.function_tolerance = 1e-8, .parameter_tolerance = 1e-6};
  const LeastSquaresProblem problem = ours.problem().least_squares();
  const LeastSquaresSummary found =
      solve_least_squares(counted(problem, our_evaluations), ours.problem().start(), options, {});
  const LeastSquaresSummary differences =
      solve_least_squares(by_differences(theirs.problem().least_squares(), their_evaluations),
                          theirs.problem().start(), options, {});
  // Both find the truth: tenths of a newton per metre are what the tolerance of equilibria leaves.
  for (const LeastSquaresSummary& summary : {found, differences}) {
    EXPECT_NEAR(summary.parameters(0), 80, 0.5);
    EXPECT_NEAR(summary.parameters(2), 300, 0.5);
  }
  // One equilibrium a frame for a material that is tried, against |k| + 1.
  EXPECT_EQ(ours.counts().equilibria, kFrames * our_evaluations);
  EXPECT_EQ(theirs.counts().equilibria, (kUnknowns + 1) * kFrames * their_evaluations);
  EXPECT_GE(theirs.counts().equilibria, (kUnknowns + 1) * ours.counts().equilibria);
  // What a fit reports is what differences have really taken.
  EXPECT_EQ(ours.counts().equilibria + ours.counts().differences,
            (kUnknowns + 1) * kFrames * our_evaluations);
  EXPECT_EQ(theirs.counts().differences, 0);
}

TEST(EquilibriumWork, CountsNoUnknownThatIsFixed) {
  const Session session = test::virtual_stretch(with_weft({80, 150, 300}), 0, 7, kFrames);
  const SheetTest test("weft", session, SheetObjective::clip_forces);
  const RunContext context;
  FitOptions options;
  options.fix.emplace("stretch.weft.k", 100);
  const SheetProblem problem({&test}, with_weft({100, 100, 100}), {{"stretch.weft"}}, {0.1},
                             context, {}, options);
  const LeastSquaresProblem squares = problem.least_squares();
  Eigen::VectorXd residual(squares.residuals);
  Eigen::MatrixXd jacobian(squares.residuals, kUnknowns);
  ASSERT_TRUE(squares.evaluate(problem.start(), residual, &jacobian));
  EXPECT_EQ(problem.rows().work().counts.equilibria, kFrames);
  EXPECT_EQ(problem.rows().work().counts.differentiated, 0);
  EXPECT_EQ(problem.rows().work().counts.differences, 0);
}

TEST(EquilibriumWork, SharesOutTheSecondsOnTheClock) {
  const WeftProblem weft;
  const LeastSquaresProblem squares = weft.problem().least_squares();
  Eigen::VectorXd residual(squares.residuals);
  Eigen::MatrixXd jacobian(squares.residuals, kUnknowns);
  ASSERT_TRUE(squares.evaluate(weft.problem().start(), residual, &jacobian));
  const EquilibriumSeconds seconds = weft.problem().rows().work().seconds;
  EXPECT_GT(seconds.search, 0);
  EXPECT_GT(seconds.derivatives, 0);
  const EquilibriumSeconds shared = EquilibriumSeconds{3, 1}.on_the_clock(2);
  EXPECT_EQ(shared.search, 1.5);
  EXPECT_EQ(shared.derivatives, 0.5);
}

}  // namespace
}  // namespace pliant
