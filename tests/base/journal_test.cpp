#include "pliant/base/journal.h"

#include <gtest/gtest.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

using Numbers = Journal::Numbers;

/// Asks twice; counts how often the answer had to be worked out.
int worked_out(Journal& journal) {
  int worked = 0;
  const auto work = [&](double answer) {
    return journal.answer(answer == 1 ? "one" : "two", [&] {
      ++worked;
      return Numbers{answer};
    });
  };
  EXPECT_EQ(work(1), Numbers{1});
  EXPECT_EQ(work(2), Numbers{2});
  return worked;
}

TEST(Journal, AnswersWhatItKnows) {
  Journal::Content written;
  Journal first([&](const Journal::Content& content) { written = content; });
  EXPECT_EQ(worked_out(first), 2);
  written.entries.pop_back();
  Journal second([](const auto&) {});
  second.resume(written, "progress.bin");
  EXPECT_EQ(worked_out(second), 1);
}

TEST(Journal, KnowsWhereTheWorkOnAQuestionWas) {
  Journal::Content written;
  Journal journal([&](const Journal::Content& content) { written = content; });
  journal.answer("one", [&] {
    journal.reach({0.5});
    EXPECT_EQ(written.reached, Numbers{0.5});
    journal.keep({{"shape", {3, 4}}});
    return Numbers{1};
  });
  EXPECT_TRUE(written.reached.empty());
  EXPECT_EQ(written.kept.at("shape"), (Numbers{3, 4}));
}

TEST(Journal, RefusesAnswersToOtherQuestions) {
  Journal journal([](const auto&) {});
  journal.resume({{{"the fit of felt", {}}}, {}, {}}, "progress.bin");
  try {
    journal.answer("the fit of cotton", [] { return Numbers{}; });
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where().file, "progress.bin");
    EXPECT_NE(error.problem().find("felt"), std::string::npos);
    EXPECT_NE(error.expected().find("cotton"), std::string::npos);
  }
}

TEST(Journal, KeepsThePartsOfWorkThatGoesOnSideBySide) {
  Journal::Content written;
  Journal first([&](const Journal::Content& content) { written = content; });
  EXPECT_EQ(worked_out(first.part("weft")), 2);
  EXPECT_EQ(worked_out(first.part("warp")), 2);
  EXPECT_EQ(worked_out(first), 2);
  EXPECT_EQ(written.parts.at("weft").size(), 2u);
  written.parts.at("warp").pop_back();
  Journal second([](const auto&) {});
  second.resume(written, "progress.bin");
  EXPECT_EQ(worked_out(second.part("warp")), 1);
  EXPECT_EQ(worked_out(second.part("weft")), 0);
  EXPECT_EQ(worked_out(second.part("bias")), 2);
  EXPECT_EQ(worked_out(second), 0);
}

TEST(Journal, OfNobodyForgets) {
  EXPECT_EQ(worked_out(forgetful_journal()), 2);
  EXPECT_EQ(worked_out(forgetful_journal().part("weft")), 2);
  EXPECT_EQ(worked_out(forgetful_journal().part("weft")), 2);
  EXPECT_TRUE(forgetful_journal().content().entries.empty());
}

}  // namespace
}  // namespace pliant
