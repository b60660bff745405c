#include "pliant/capture/log_doubts.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A pull out and back, of 60 rows, to 5 N, in steps of `resolution`.
std::vector<double> pull(double resolution) {
  RandomStream random(3);
  std::vector<double> forces;
  for (int row = 0; row < 60; ++row) {
    const double force = 5 - std::abs(row - 30) / 6.0 + 2e-3 * random.normal();
    forces.push_back(resolution * std::round(force / resolution));
  }
  return forces;
}

TEST(LimitDoubt, IsToldOfACellAtItsLimit) {
  std::vector<double> forces = pull(1e-3);
  for (double& force : forces) force = std::min(force, 4.0);
  EXPECT_THAT(limit_doubt(forces), HasSubstr("reads 4 N again and again"));
  for (double& force : forces) force = -force;
  EXPECT_THAT(limit_doubt(forces), HasSubstr("again and again"));
}

TEST(LimitDoubt, IsOfReadingsThatAreNotKnown) {
  const std::vector<double> all = pull(1e-3);
  EXPECT_EQ(without_limit(all), all);
  std::vector<double> cut = all;
  for (double& force : cut) force = std::min(force, 4.0);
  const std::vector<double> known = without_limit(cut);
  for (std::size_t row = 0; row < all.size(); ++row) {
    EXPECT_EQ(std::isnan(known[row]), all[row] >= 4) << row;
    if (all[row] < 4) {
      EXPECT_EQ(known[row], all[row]);
    }
  }
}

TEST(LimitDoubt, IsToldOfACellThatIsNotConnected) {
  EXPECT_THAT(limit_doubt(std::vector<double>(20, 0.31)), HasSubstr("not connected"));
}

// A coarse cell reads the same everywhere, one at rest the same zero.
TEST(LimitDoubt, IsNotToldOfOthers) {
  EXPECT_THAT(limit_doubt(pull(1e-3)), IsEmpty());
  EXPECT_THAT(limit_doubt(pull(0.5)), IsEmpty());
  std::vector<double> slack = pull(1e-3);
  std::fill_n(slack.begin(), 20, 0.0);
  EXPECT_THAT(limit_doubt(slack), IsEmpty());
  EXPECT_THAT(limit_doubt(std::vector<double>(20, 0.0)), IsEmpty());
}

/// Ways of a clip that goes out and back, frame by frame.
std::vector<double> way() {
  std::vector<double> way;
  for (int frame = 0; frame < 12; ++frame) way.push_back(1e-3 * (6 - std::abs(frame - 6)));
  return way;
}

TEST(ExtensionDoubt, IsToldOfRowsBesideOtherFrames) {
  std::vector<double> extension = way();
  std::ranges::rotate(extension, extension.begin() + 1);
  EXPECT_THAT(extension_doubt(extension, way()), HasSubstr("apart in frame"));
}

// A machine gives, and its zero is anywhere.
TEST(ExtensionDoubt, IsNotToldOfAMachineThatGives) {
  std::vector<double> extension = way();
  for (double& e : extension) e = 2e-3 + 1.07 * e;
  extension[4] = std::nan("");
  EXPECT_THAT(extension_doubt(extension, way()), IsEmpty());
}

}  // namespace
}  // namespace pliant
