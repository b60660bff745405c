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

}  // namespace
}  // namespace pliant
