#include "pliant/estimation/stated_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(StatedOptions, AreToldOneByOne) {
  FitOptions options;
  options.monotone_stress = true;
  options.fix = {{"shear.k", 30}};
  options.bounds = {{"*.friction.tau", {0.001, 1}}};
  options.priors = {{"stretch.weft.k", {100, 5}}};
  EXPECT_THAT(stated_options(options),
              ElementsAre(HasSubstr("no elastic stress falls"), HasSubstr("shear.k is 30"),
                          HasSubstr("*.friction.tau lies between 0.001 and 1"),
                          HasSubstr("stretch.weft.k was expected to be 100 +- 5")));
}

TEST(StatedOptions, OfAStudyThatStatesNothingAreNone) {
  EXPECT_THAT(stated_options({}), IsEmpty());
}

TEST(UnmatchedOptions, AreToldByName) {
  FitOptions options;
  options.fix = {{"stretch.warp.k", 3}, {"stretch.warp.friction.beta", 0}};
  options.bounds = {{"*.friction.tau", {0, 1}}, {"shear.*", {0, 1}}};
  const std::vector<std::string> sentences =
      unmatched_options(options, {"stretch.warp.k[0]", "stretch.warp.friction.tau"});
  EXPECT_THAT(sentences, ::testing::ElementsAre(::testing::HasSubstr("fit.bounds of shear.*"),
                                                ::testing::HasSubstr("friction.beta")));
}

}  // namespace
}  // namespace pliant
