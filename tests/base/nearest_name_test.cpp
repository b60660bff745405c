#include "pliant/base/nearest_name.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace pliant {
namespace {

const std::vector<std::string> kNames = {"length", "width", "clip_mass", "data"};

TEST(NearestName, FindsSlipsOfTheKeyboard) {
  EXPECT_EQ(nearest_name("lenght", kNames), "length");
  EXPECT_EQ(nearest_name("clipmass", kNames), "clip_mass");
  EXPECT_EQ(nearest_name("Width", kNames), "width");
  EXPECT_EQ(nearest_name("date", kNames), "data");
}

TEST(NearestName, CountsExchangedNeighboursAsOneSlip) {
  const std::vector<std::string> commands = {"init", "import", "fit", "info"};
  EXPECT_EQ(nearest_name("fti", commands), "fit");
  EXPECT_EQ(nearest_name("inof", commands), "info");
  EXPECT_EQ(nearest_name("ftii", commands), "");
}

TEST(NearestName, IsEmptyForWordsThatAreFarFromAll) {
  EXPECT_EQ(nearest_name("temperature", kNames), "");
  EXPECT_EQ(nearest_name("", kNames), "");
  EXPECT_EQ(nearest_name(std::string(100'000, 'x'), kNames), "");
  EXPECT_EQ(nearest_name("length", std::vector<std::string>{}), "");
}

TEST(DidYouMean, AsksForTheNearestNameOrNothing) {
  EXPECT_EQ(did_you_mean("lenght", kNames), " (did you mean \"length\"?)");
  EXPECT_EQ(did_you_mean("temperature", kNames), "");
}

TEST(ListOfNames, ReadsLikeASentence) {
  const std::vector<std::string> one = {"a"};
  const std::vector<std::string> three = {"a", "b", "c"};
  EXPECT_EQ(list_of_names(one), "\"a\"");
  EXPECT_EQ(list_of_names(three), "\"a\", \"b\" or \"c\"");
  EXPECT_TRUE(list_of_names(std::vector<std::string>(100, "x")).ends_with(", ..."));
}

}  // namespace
}  // namespace pliant
