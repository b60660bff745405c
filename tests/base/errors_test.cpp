#include "pliant/base/errors.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

TEST(InputErrorText, NamesFileLineFieldProblemAndExpectation) {
  const InputError error({"a.csv", 7, "force_N"}, "\"x\" is not a finite number", "a number");
  EXPECT_STREQ(error.what(), "a.csv:7: force_N: \"x\" is not a finite number; expected a number");
  EXPECT_EQ(error.where().line, 7);
  EXPECT_EQ(error.expected(), "a number");
}

TEST(InputErrorText, LeavesOutWhatIsUnknown) {
  EXPECT_STREQ(InputError({"a.csv"}, "is empty").what(), "a.csv: is empty");
  EXPECT_STREQ(InputError({}, "no study given").what(), "no study given");
  EXPECT_STREQ(InputError({"", 3, ""}, "bad").what(), "line 3: bad");
  EXPECT_STREQ(InputError({"", 0, "--seed"}, "bad", "a number").what(),
               "--seed: bad; expected a number");
}

TEST(InputErrorText, StaysOneReadableLineWhateverTheInputHolds) {
  const InputError error({"a\nb", 1, "f\x1b[2J"}, std::string(100'000, 'x'));
  const std::string line = error.what();
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_EQ(line.find('\x1b'), std::string::npos);
  EXPECT_LT(line.size(), 2000U);
}

TEST(QuotedValue, ShowsControlCharactersAndBrokenUtf8AsEscapes) {
  EXPECT_EQ(quoted_value("a\tb\x01"), "\"a\\tb\\x01\"");
  EXPECT_EQ(quoted_value("caf\xC3\xA9"), "\"caf\xC3\xA9\"");
  EXPECT_EQ(quoted_value("caf\xE9"), "\"caf\\xe9\"");
  EXPECT_EQ(quoted_value("\xC2\x9B"), "\"\\xc2\\x9b\"");  // a control sequence introducer
}

TEST(QuotedValue, CutsLongValuesBetweenCharacters) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "\xC3\xA9";
  const std::string shown = quoted_value(text);
  EXPECT_LT(shown.size(), 70U);
  EXPECT_TRUE(shown.ends_with("\xC3\xA9...\""));
}

TEST(SolverErrorText, TellsIterationsAndResidual) {
  const SolverError error("the equilibrium of frame 3", 50, 1.25e-3);
  EXPECT_STREQ(error.what(),
               "the equilibrium of frame 3 did not converge after 50 iterations (best residual "
               "0.00125)");
  EXPECT_STREQ(SolverError("the equilibrium", 0, 0).what(), "the equilibrium did not converge");
  EXPECT_STREQ(SolverError("the step", 5, INFINITY).what(),
               "the step did not converge after 5 iterations");
}

TEST(Assertion, ThrowsWithItsPlaceInEveryBuildType) {
  try {
    PLIANT_ASSERT(1 + 1 == 3, "arithmetic");
    FAIL();
  } catch (const AssertionError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("errors_test.cpp:"), std::string::npos);
    EXPECT_NE(text.find("arithmetic (1 + 1 == 3 is false)"), std::string::npos);
  }
}

}  // namespace
}  // namespace pliant
