#include "pliant/math/root.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace pliant {
namespace {

TEST(RootInBracket, FindsSmoothAndKinkedRootsToRounding) {
  const auto cosine = [](double x) { return std::cos(x); };
  EXPECT_NEAR(root_in_bracket(cosine, 0, 3), std::numbers::pi / 2, 1e-15);
  const auto kinked = [](double x) { return x < 0.3 ? 10 * (x - 0.3) : 1e-3 * (x - 0.3); };
  EXPECT_NEAR(root_in_bracket(kinked, -5, 8), 0.3, 1e-15);
  const auto steep = [](double x) { return std::expm1(40 * (x - 0.9)); };
  EXPECT_NEAR(root_in_bracket(steep, 0, 1), 0.9, 1e-15);
}

TEST(RootInBracket, ReturnsAnEndThatIsARoot) {
  const auto line = [](double x) { return x - 2; };
  EXPECT_EQ(root_in_bracket(line, 2, 5), 2);
  EXPECT_EQ(root_in_bracket(line, -1, 2), 2);
}

TEST(FirstRoot, FindsTheNearestOfSeveralRootsInTheDirectionOfTravel) {
  const auto sine = [](double x) { return std::sin(x); };
  EXPECT_NEAR(*first_root(sine, 1, 0.1, 20), std::numbers::pi, 1e-15);
  EXPECT_NEAR(*first_root(sine, 1, -0.1, -20), 0, 1e-15);
  EXPECT_NEAR(*first_root(sine, 4, 0.1, 20), 2 * std::numbers::pi, 2e-15);
}

TEST(FirstRoot, FindsNothingBeyondTheLimit) {
  const auto sine = [](double x) { return std::sin(x); };
  EXPECT_FALSE(first_root(sine, 1, 0.1, 3));
  EXPECT_TRUE(first_root(sine, 1, 0.1, 3.2));
}

TEST(FirstRoot, IsTheStartWhereTheStartIsARoot) {
  EXPECT_EQ(first_root([](double x) { return x; }, 0, 0.1, 1), 0);
}

}  // namespace
}  // namespace pliant
