// Fits of sheets that were stopped go on where they were.

#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/study/sheet_study.h"

#include "support/five_sheet_tests.h"

namespace pliant {
namespace {

/// What a fit remembers when it is stopped after so many changes of its journal.
Journal::Content stopped_after(const Study& study, int changes) {
  StopFlag stop;
  int seen = 0;
  Journal journal([&](const auto&) {
    if (++seen == changes) stop.request();
  });
  const RunContext context{silent_progress(), stop.token(), 2, 0, journal};
  EXPECT_THROW(fit_sheet_study(study, context), Interrupted);
  return journal.content();
}

/// A fit that goes on from there.
struct Resumed {
  StudyResult result;
  int changes = 0;                // of its journal
  Journal::Content after_twelve;  // of its searches, between two of them

  Resumed(const Study& study, Journal::Content content) {
    Journal journal([&](const Journal::Content& now) {
      ++changes;
      if (now.entries.size() == 12 && now.reached.empty()) after_twelve = now;
    });
    journal.resume(std::move(content), "progress.bin");
    result = fit_sheet_study(study, {silent_progress(), {}, 2, 0, journal});
  }
};

class SlowSheetResume : public testing::Test {
 protected:
  const test::FiveSheetTests tests{test::sheet_cloth(true), "", 9, 4};
  const Study study = tests.study();
};

TEST_F(SlowSheetResume, EndsWhereTheWholeFitDoesAndGivesTheSameBitsBetweenSearches) {
  const Resumed whole(study, {});
  for (const double share : {0.5, 0.9}) {
    const int changes = static_cast<int>(share * whole.changes);
    const Journal::Content content = stopped_after(study, changes);
    ASSERT_FALSE(content.entries.empty());
    const Resumed rest(study, content);
    EXPECT_LT(rest.changes, whole.changes - changes + 10) << "not all is worked out again";
    ASSERT_EQ(rest.result.parameters.size(), whole.result.parameters.size());
    for (std::size_t i = 0; i < whole.result.parameters.size(); ++i) {
      const ParameterEstimate& expected = whole.result.parameters[i];
      const ParameterEstimate& found = rest.result.parameters[i];
      EXPECT_EQ(found.name, expected.name);
      // A search that was stopped takes other steps than one that was not.
      EXPECT_NEAR(found.value, expected.value, 1e-3 * expected.value) << found.name;
    }
    ASSERT_EQ(rest.result.stages.size(), whole.result.stages.size());
  }
  ASSERT_EQ(whole.after_twelve.entries.size(), 12u);
  const Resumed rest(study, whole.after_twelve);
  for (std::size_t i = 0; i < whole.result.parameters.size(); ++i) {
    EXPECT_EQ(rest.result.parameters[i].value, whole.result.parameters[i].value);
    EXPECT_EQ(rest.result.parameters[i].std_error, whole.result.parameters[i].std_error);
  }
  EXPECT_EQ(rest.result.work->counts.equilibria, whole.result.work->counts.equilibria);
  EXPECT_EQ(rest.result.work->counts.differences, whole.result.work->counts.differences);
}

TEST_F(SlowSheetResume, RefusesTheProgressOfOtherData) {
  const Journal::Content content = stopped_after(study, 12);
  const test::FiveSheetTests others(test::sheet_cloth(false), "", 9, 4);
  EXPECT_THROW(Resumed(others.study(), content), InputError);
  const test::FiveSheetTests linear(test::sheet_cloth(true), ", variant: linear-orthotropic", 9, 4);
  EXPECT_THROW(Resumed(linear.study(), content), InputError);
}

}  // namespace
}  // namespace pliant
