// Data that are disturbed in one way: the fit names it. Data that are not are left in peace.

#include "pliant/estimation/residual_warnings.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Weights hung three times, lengths read with a noise of 0.1 mm.
VirtualHangingWeights read_weights() {
  VirtualHangingWeights test = hung_weights();
  test.instrument.length_noise = 0.1e-3;
  return test;
}

using Rows = VirtualStudy::Rows;

/// Warnings of the fit to edited rows; the last column is the length (mm).
std::vector<std::string> warnings_of(const std::function<void(Rows&)>& edit) {
  VirtualStudy study(lab_of(published_fabric("cotton"), read_weights()));
  study.edit_rows("weights.csv", edit);
  return study.fit().warnings;
}

TEST(ResidualWarnings, LeaveCleanDataInPeace) {
  EXPECT_THAT(warnings_of([](Rows&) {}), IsEmpty());
}

TEST(ResidualWarnings, NameADrift) {
  const auto warnings = warnings_of([](Rows& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i].back() += 4.0 * static_cast<double>(i) / static_cast<double>(rows.size());
    }
  });
  EXPECT_THAT(warnings, Contains(HasSubstr("the zero drifts")));
}

TEST(ResidualWarnings, NameRepeatsThatDiffer) {
  const auto warnings = warnings_of([](Rows& rows) {
    for (std::vector<double>& row : rows) {
      if (row.front() == 2) row.back() += 3;  // the second time the strip is 3 mm longer
    }
  });
  EXPECT_THAT(warnings, Contains(HasSubstr("repeats differ")));
}

/// Residuals of two specimens, two cycles each, row by row of a loop.
std::vector<std::string> warnings_of_residuals(
    const std::function<double(int specimen, int cycle)>& off) {
  ExperimentResult result;
  result.name = "strips";
  MeasuredPath path;
  std::vector<double> measured;
  RandomStream random(7);
  for (const int specimen : {0, 1}) {
    for (const int cycle : {0, 1}) {
      for (int row = 0; row < 40; ++row) {
        path.specimen.push_back(specimen);
        path.direction.push_back(row < 20 ? 1 : -1);
        path.strain.push_back(0.01 * (row < 20 ? row : 40 - row));
        measured.push_back(off(specimen, cycle) + 0.1 * random.normal());
      }
    }
  }
  result.measured = Eigen::Map<Eigen::VectorXd>(measured.data(), std::ssize(measured));
  result.predicted = Eigen::VectorXd::Zero(result.measured.size());
  result.used.assign(measured.size(), 1);
  result.rms = std::sqrt(result.measured.squaredNorm() / static_cast<double>(measured.size()));
  return residual_warnings(result, path);
}

TEST(ResidualWarnings, NameTheCoarsestCauseThatIsEnough) {
  EXPECT_THAT(warnings_of_residuals([](int, int) { return 0; }), IsEmpty());
  EXPECT_THAT(warnings_of_residuals([](int specimen, int) { return specimen == 0 ? -1 : 1; }),
              ElementsAre(HasSubstr("goes with its specimens")));
  EXPECT_THAT(warnings_of_residuals([](int, int cycle) { return cycle == 0 ? -1 : 1; }),
              ElementsAre(HasSubstr("repeats differ")));
}

TEST(ResidualWarnings, NameCoarseReadings) {
  const auto warnings = warnings_of([](Rows& rows) {
    for (std::vector<double>& row : rows) row.back() = std::round(row.back());
  });
  EXPECT_THAT(warnings, Contains(HasSubstr("a grid of 1 mm")));
}

}  // namespace
}  // namespace pliant
