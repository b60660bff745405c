#include "layers/source_rules.h"

#include <algorithm>
#include <iterator>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::source_rules {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Rule = std::vector<Offence> (*)(const SourceFile&);

/// Offences of all sources of the libraries and programs against one rule.
std::vector<Offence> offences_of_the_tree(Rule rule) {
  std::vector<Offence> offences;
  for (const char* folder : {"src/pliant", "apps"}) {
    for (const SourceFile& source : source_files(PLIANT_SOURCE_DIR, folder)) {
      const std::vector<Offence> found = rule(source);
      offences.insert(offences.end(), found.begin(), found.end());
    }
  }
  return offences;
}

void expect_none(const std::vector<Offence>& offences) {
  EXPECT_TRUE(offences.empty()) << describe(offences);
}

TEST(SourceTree, HasSourcesToCheck) {
  EXPECT_FALSE(source_files(PLIANT_SOURCE_DIR, "src/pliant").empty());
}

TEST(SourceTree, IncludesOnlyEarlierLayers) { expect_none(offences_of_the_tree(layer_offences)); }

TEST(SourceTree, KeepsHeavyThirdPartyHeadersInSourceFiles) {
  expect_none(offences_of_the_tree(heavy_header_offences));
}

TEST(SourceTree, NamesNoPathOfOneMachine) {
  expect_none(offences_of_the_tree(machine_path_offences));
}

TEST(SourceTree, LibrariesNeverPrintExitOrReadTheEnvironment) {
  expect_none(offences_of_the_tree(library_manner_offences));
}

TEST(SourceTree, HasNoFileThatIsTooLong) {
  std::vector<Offence> offences;
  for (const char* folder : {"src", "apps", "tests", "bench", "fuzz"}) {
    for (const SourceFile& source : source_files(PLIANT_SOURCE_DIR, folder)) {
      const std::vector<Offence> found = length_offences(source);
      offences.insert(offences.end(), found.begin(), found.end());
    }
  }
  expect_none(offences);
}

TEST(SourceTree, HasNoTwoHeadersOfOneName) {
  std::vector<SourceFile> sources = source_files(PLIANT_SOURCE_DIR, "src");
  std::ranges::move(source_files(PLIANT_SOURCE_DIR, "apps"), std::back_inserter(sources));
  expect_none(header_name_offences(sources));
}

TEST(SourceTree, NamesATypeOfTestInItsFolderAlone) {
  // A session is a document, too.
  constexpr std::string_view kDocuments[] = {"src/pliant/measurement/session/session_document.cpp",
                                             "apps/pliant/file_info.cpp"};
  const std::vector<TestName> tests =
      test_names(source_files(PLIANT_SOURCE_DIR, "src/pliant/experiment"));
  EXPECT_GE(tests.size(), 15U);
  std::vector<Offence> offences;
  for (const char* folder : {"src/pliant", "apps"}) {
    for (const SourceFile& source : source_files(PLIANT_SOURCE_DIR, folder)) {
      if (std::ranges::find(kDocuments, source.path) != std::end(kDocuments)) continue;
      const std::vector<Offence> found = test_name_offences(source, tests);
      offences.insert(offences.end(), found.begin(), found.end());
    }
  }
  expect_none(offences);
}

TEST(SourceTree, KeepsEachTypeOfTestInAFolderOfItsName) {
  std::set<std::string> folders;
  for (const TestName& test :
       test_names(source_files(PLIANT_SOURCE_DIR, "src/pliant/experiment"))) {
    EXPECT_TRUE(is_in_folder_of_its_name(test)) << test.name << " stands in " << test.folder;
    EXPECT_TRUE(folders.insert(test.folder).second) << test.folder << " holds two tests";
  }
}

TEST(LayerRule, FindsALaterLayerWithItsFileAndLine) {
  const auto offences =
      layer_offences({"src/pliant/io/a.h", "#pragma once\n#include \"pliant/report/report.h\"\n"});
  EXPECT_EQ(offences.size(), 1U);
  EXPECT_THAT(describe(offences), HasSubstr("src/pliant/io/a.h:2: io may not include report"));
}

TEST(LayerRule, AllowsOwnAndEarlierLayersAndSubfolders) {
  const std::string text =
      "#include \"pliant/material/density/dahl.h\"\n#include \"pliant/math/spline.h\"\n";
  EXPECT_THAT(layer_offences({"src/pliant/material/material.cpp", text}), IsEmpty());
}

TEST(LayerRule, FindsFoldersThatAreInNoLayer) {
  EXPECT_EQ(layer_offences({"src/pliant/io/a.h", "#include \"pliant/utils/misc.h\"\n"}).size(), 1U);
  EXPECT_EQ(layer_offences({"src/pliant/utils/a.h", "#include \"pliant/base/b.h\"\n"}).size(), 1U);
  EXPECT_EQ(layer_offences({"apps/pliant/main.cpp", "#include \"pliant/misc.h\"\n"}).size(), 1U);
}

TEST(LayerRule, LetsProgramsIncludeEverything) {
  EXPECT_THAT(layer_offences({"apps/pliant/fit.cpp", "#include \"pliant/report/report.h\"\n"}),
              IsEmpty());
}

TEST(HeavyHeaderRule, FindsThemInHeadersOnly) {
  for (const char* include :
       {"<ceres/ceres.h>", "<opencv2/core.hpp>", "<itkImage.h>", "<embree3/rtcore.h>"}) {
    const std::string text = std::string("#include ") + include + "\n";
    EXPECT_EQ(heavy_header_offences({"src/pliant/estimation/a.h", text}).size(), 1U) << include;
    EXPECT_THAT(heavy_header_offences({"src/pliant/estimation/a.cpp", text}), IsEmpty()) << include;
  }
}

TEST(MachinePathRule, FindsAbsolutePathsAndLeavesProseAlone) {
  const std::string absolute = std::string("open(\"/") + "home" + "/me/data.csv\");\n";
  EXPECT_EQ(machine_path_offences({"src/pliant/io/a.cpp", absolute}).size(), 1U);
  EXPECT_THAT(machine_path_offences({"src/pliant/io/a.cpp", "// docs/opt/notes, ../srv/data\n"}),
              IsEmpty());
}

TEST(LibraryMannerRule, BindsLibrariesAndNotPrograms) {
  const std::string text = "std::cout << 1;\nstd::exit(1);\ngetenv(\"HOME\");\n";
  EXPECT_EQ(library_manner_offences({"src/pliant/io/a.cpp", text}).size(), 3U);
  EXPECT_THAT(library_manner_offences({"apps/pliant/main.cpp", text}), IsEmpty());
  EXPECT_THAT(library_manner_offences({"src/pliant/io/a.cpp", "std::snprintf(b, n, \"\");\n"}),
              IsEmpty());
}

TEST(LengthRule, CountsLines) {
  EXPECT_THAT(length_offences({"apps/a.cpp", std::string(450, '\n')}), IsEmpty());
  const auto offences = length_offences({"apps/a.cpp", std::string(451, '\n')});
  EXPECT_THAT(describe(offences), HasSubstr("apps/a.cpp:451: has more than 450 lines"));
}

TEST(HeaderNameRule, FindsTheSecondHeaderOfAName) {
  const auto offences = header_name_offences(
      {{"apps/a.h", ""}, {"src/pliant/io/a.cpp", ""}, {"src/pliant/io/a.h", ""}});
  EXPECT_EQ(describe(offences), "\nsrc/pliant/io/a.h:1: has the name of apps/a.h");
}

TEST(TestNameRule, FindsNamesInTextsOutsideTheirFolder) {
  const SourceFile own{"src/pliant/experiment/pull/pull_type.cpp",
                       "const TestType type{.name = \"pull-test\"};\n"};
  const std::vector<TestName> tests = test_names({own});
  ASSERT_EQ(tests.size(), 1U);
  EXPECT_EQ(tests[0].folder, "src/pliant/experiment/pull/");
  EXPECT_THAT(test_name_offences(own, tests), IsEmpty());
  const std::string text = "if (type == \"pull-test\") {}\n// \"pull-test\"\nf(\"a pull-test\");\n";
  EXPECT_EQ(test_name_offences({"apps/a.cpp", text}, tests).size(), 2U);
}

TEST(TestNameRule, TakesAllNamesOfAFile) {
  const SourceFile own{"src/pliant/experiment/pull/pull_type.cpp",
                       "TestType a{.name = \"pull\"};\nTestType b{.name = \"push\"};\n"};
  const std::vector<TestName> tests = test_names({own});
  ASSERT_EQ(tests.size(), 2U);
  EXPECT_EQ(tests[1].name, "push");
  EXPECT_TRUE(is_in_folder_of_its_name(tests[0]));
  EXPECT_FALSE(is_in_folder_of_its_name(tests[1]));
}

TEST(TestNameRule, TakesAWordOfTheNameForItsFolder) {
  EXPECT_TRUE(is_in_folder_of_its_name({"bending-length", "experiment/bending_length/"}));
  EXPECT_TRUE(is_in_folder_of_its_name({"pure-bending", "experiment/bending/"}));
  EXPECT_FALSE(is_in_folder_of_its_name({"pure-bending", "experiment/bend/"}));
}

TEST(TestNameRule, LetsSentencesUseAWordThatIsAName) {
  const std::vector<TestName> tests{{"press", "src/pliant/experiment/press/"}};
  EXPECT_THAT(test_name_offences({"apps/a.cpp", "f(\"press it\");\n"}, tests), IsEmpty());
  EXPECT_EQ(test_name_offences({"apps/a.cpp", "f(\"press\");\n"}, tests).size(), 1U);
}

}  // namespace
}  // namespace pliant::source_rules
