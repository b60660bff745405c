// Equations that are added up frame by frame are those of rows that are stored.

#include "pliant/estimation/estimating_equations.h"

#include <gtest/gtest.h>

#include "pliant/estimation/component_problem.h"
#include "pliant/estimation/measured_noise.h"
#include "pliant/estimation/sheet/sheet_problem.h"

#include "estimation/virtual_study.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::VirtualStudy;

/// Compares the sums of two problems that are alike: each begins its equilibria at the same place.
void expect_sums_of_rows(const Problem& summing, const Problem& storing) {
  const Eigen::VectorXd values = 1.1 * starts_of(storing.unknowns());
  const std::vector<Eigen::Index> free = free_unknowns(storing.unknowns());
  const ProblemPart& part = storing.parts().front();
  const auto sums = predicted_sums(summing, values, {part.weight}, free, {});
  const auto rows = storing.predict(0, values, /*derivatives=*/true);
  ASSERT_TRUE(sums && rows);
  const Eigen::MatrixXd jacobian = part.weight.asDiagonal() * rows->by(Eigen::all, free).eval();
  const Eigen::VectorXd residual =
      part.weight.cwiseProduct(rows->value - part.experiment->measured());
  const std::vector<Frame> frames = part.experiment->frames();
  ASSERT_EQ(sums->groups.size(), frames.size());
  ASSERT_GT(frames.size(), 1u);
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(std::ssize(free));
  for (std::size_t f = 0; f < frames.size(); ++f) {
    const Eigen::MatrixXd own = jacobian.middleRows(frames[f].first, frames[f].count);
    // Of rows that count by their noise, the gradient scatters as it slopes.
    EXPECT_TRUE(sums->groups[f].slope.isApprox(own.transpose() * own, 1e-12)) << f;
    EXPECT_TRUE(sums->groups[f].scatter.isApprox(own.transpose() * own, 1e-12)) << f;
    gradient += sums->groups[f].part;
  }
  EXPECT_GT(gradient.norm(), 0);
  EXPECT_TRUE(gradient.isApprox(jacobian.transpose() * residual, 1e-10));
  EXPECT_TRUE(sums->slope().isApprox(jacobian.transpose() * jacobian, 1e-12));
}

TEST(PredictedSums, AreThoseOfTheStoredRowsOfAStrip) {
  const Material fabric = published_fabric("polyester");
  const VirtualStudy measured(lab_of(fabric, strip_cycles({0.05, 0.1, 0.2})));
  const Study study = measured.study();
  const auto experiment = read_experiment(study.experiments.front(), study);
  const ComponentProblem problem({experiment.get()});
  const ComponentLaw law = *law_of(fabric, "stretch.warp");
  const Problem rows = problem.problem(law, problem.unknowns(law, {}));
  expect_sums_of_rows(rows, rows);
}

TEST(PredictedSums, AreThoseOfTheStoredRowsOfASession) {
  const Material cloth = test::sheet_cloth(false);
  const SheetTest weft("weft", test::virtual_stretch(cloth, 0, 5, 3), SheetObjective::clip_forces);
  const SheetProblem one({&weft}, cloth, {{"stretch.weft"}, {"shear"}}, {0.1, 0.1}, {});
  const SheetProblem other({&weft}, cloth, {{"stretch.weft"}, {"shear"}}, {0.1, 0.1}, {});
  expect_sums_of_rows(one.rows(), other.rows());
}

}  // namespace
}  // namespace pliant
