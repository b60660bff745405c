#include "pliant/study/test_template.h"

#include <algorithm>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/loop_metrics.h"
#include "pliant/study/study.h"
#include "pliant/study/whole_sheets.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr int kPageLines = 70;  // of A4 at 10 point
constexpr std::size_t kLineLength = 110;

std::string content_of_file(const TestFiles& files, const std::string& name) {
  for (const auto& [file, content] : files) {
    if (file == name) return content;
  }
  ADD_FAILURE() << "no file " << name;
  return {};
}

bool is_of_solid(const std::string& test) { return facts_of_test(test).measures_solids; }

class Template : public ::testing::TestWithParam<std::string> {};

TEST_P(Template, IsReadAsAStudyWithItsExample) {
  const TemporaryFolder folder;
  for (const auto& [name, content] : test_template(GetParam())) {
    folder.write(name, content);
  }
  const Study study = read_study(folder.path() / "study.yaml");
  EXPECT_GT(study.density, 0);
  const ExperimentSpec& spec = study.experiments.front();
  EXPECT_EQ(spec.type, GetParam());
  if (is_of_solid(GetParam())) {  // one way to deform it does not tell the others
    for (const ExperimentSpec& one : study.experiments) {
      const auto test = one.test->type().make_solid(one, DataRows(one.data));
      EXPECT_GE(test->rows(), 10);
      EXPECT_THAT(test->info().warnings, IsEmpty());
    }
    return;
  }
  ASSERT_EQ(study.experiments.size(), 1U);
  if (is_only_predicted(spec)) {
    const auto test = read_whole_sheet_test(spec);
    EXPECT_GE(test->measured().size(), 10);
    EXPECT_THAT(test->info().warnings, IsEmpty());
    EXPECT_THAT(test->info().questions, IsEmpty());
    return;
  }
  const auto experiment = read_experiment(spec, study);
  EXPECT_GE(experiment->rows(), 10);
  EXPECT_THAT(experiment->info().warnings, IsEmpty());
  EXPECT_THAT(experiment->info().questions, IsEmpty());
}

TEST_P(Template, ExampleUnloadsWhereTheTestDoes) {
  const TemporaryFolder folder;
  for (const auto& [name, content] : test_template(GetParam())) {
    folder.write(name, content);
  }
  const Study study = read_study(folder.path() / "study.yaml");
  if (is_only_predicted(study.experiments.front()) || is_of_solid(GetParam())) {
    GTEST_SKIP() << "it has no path";
  }
  const auto experiment = read_experiment(study.experiments.front(), study);
  EXPECT_EQ(unloads(experiment->path()),
            GetParam() != "cantilever" && GetParam() != "bending-length");
}

TEST_P(Template, ProtocolFitsOnOnePage) {
  std::istringstream protocol(content_of_file(test_template(GetParam()), "PROTOCOL.md"));
  int lines = 0;
  for (std::string line; std::getline(protocol, line); ++lines) {
    EXPECT_LE(line.size(), kLineLength) << line;
  }
  EXPECT_LE(lines, kPageLines);
}

TEST_P(Template, ProtocolTellsWhatEveryProtocolMust) {
  const std::string protocol = content_of_file(test_template(GetParam()), "PROTOCOL.md");
  for (const char* part : {"**Purpose.**", "**Standards.**", "**Samples.**", "**Procedure**",
                           "**Write down.**", "**Precision.**", "**Frequent mistakes**"}) {
    EXPECT_THAT(protocol, HasSubstr(part));
  }
  if (is_of_solid(GetParam())) return;
  for (const char* part : {"ISO 139", "Mark the warp"}) EXPECT_THAT(protocol, HasSubstr(part));
}

INSTANTIATE_TEST_SUITE_P(All, Template, ::testing::ValuesIn(template_tests()),
                         [](const auto& name) {
                           std::string text = name.param;
                           std::erase(text, '-');
                           return text;
                         });

TEST(TestTemplate, AnUnknownTestNamesTheNearestOne) {
  const InputError error = input_error_of([] { test_template("tensile-cycle"); });
  EXPECT_THAT(error.problem(), HasSubstr("did you mean \"tensile-cycles\"?"));
  EXPECT_THAT(error.expected(), HasSubstr("hanging-weights"));
}

}  // namespace
}  // namespace pliant
