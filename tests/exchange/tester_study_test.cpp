// Tables of testing machines become studies: what they tell is there, what they do not is left
// blank, and once the blanks are filled in the study holds the measurement that was made.

#include "pliant/exchange/tester_study.h"

#include <cmath>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/registry.h"
#include "pliant/io/workbook.h"
#include "pliant/study/study.h"
#include "pliant/study/study_fit.h"
#include "pliant/study/test_template.h"

#include "exchange/tester_files.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"
#include "support/workbook.h"

namespace pliant {
namespace {

using test::MadeUpFile;
using test::RefusedFile;
using test::TemporaryFolder;
using ::testing::HasSubstr;
using ::testing::Not;

/// The study that is written of a file, in a folder of its own beside it.
std::filesystem::path write_study(const TemporaryFolder& folder,
                                  const std::vector<std::pair<std::string, std::string>>& files) {
  std::vector<TesterFile> tables;
  for (const auto& [name, content] : files) {
    tables.push_back(read_tester_file(folder.write("tester/" + name, content), {}));
  }
  const ImportedStudy study = tester_study(tables);
  for (const auto& [name, content] : study.files) folder.write("study/" + name, content);
  return folder.write("study/study.yaml", study.study_yaml);
}

/// Fills in the blanks of a study; says which there were.
std::string fill_in(const std::filesystem::path& study,
                    std::map<std::string, std::string> answers) {
  answers.insert({{"direction", "warp"}, {"length", "100 mm"}, {"width", "50 mm"}});
  std::istringstream lines(test::content_of(study));
  std::string text, line, blanks;
  while (std::getline(lines, line)) {
    const bool is_blank = !line.starts_with('#') && line.find("???") != std::string::npos;
    if (is_blank) {
      const std::size_t first = line.find_first_not_of(" ");
      const std::size_t colon = line.find(':');
      const std::string field = line.substr(first, colon - first);
      blanks += (blanks.empty() ? "" : " ") + field;
      line = line.substr(0, colon + 1) + " " + answers.at(field);
    }
    text += line + "\n";
  }
  std::ofstream(study) << text;
  return blanks;
}

std::unique_ptr<ComponentExperiment> first_experiment(const std::filesystem::path& file) {
  const Study study = read_study(file);
  return read_experiment(study.experiments.front(), study);
}

/// What the made-up files of a type are exports of: so many specimens, each in a file of its own.
std::filesystem::path write_reference(const TemporaryFolder& folder, const std::string& type,
                                      int specimens = 1) {
  const bool pulled = type == "tensile-cycles";
  for (int i = 0; i < specimens; ++i) {
    folder.write(fmt::format("data-{}.csv", i), test::reference_rows(type));
  }
  return folder.write(
      "study.yaml", fmt::format("pliant: study/1\nname: a\nexperiments:\n  - {{name: a, type: {}, "
                                "data: data-*.csv{}{}}}\n",
                                type, type == "shear-cycles" ? "" : ", direction: warp",
                                pulled ? ", length: 100 mm, width: 50 mm" : ""));
}

std::unique_ptr<ComponentExperiment> reference(const std::string& type) {
  const TemporaryFolder folder;
  return first_experiment(write_reference(folder, type));
}

class TesterFiles : public ::testing::TestWithParam<MadeUpFile> {};

TEST_P(TesterFiles, BecomeTheExperimentThatTheyAre) {
  const TemporaryFolder folder;
  const MadeUpFile& file = GetParam();
  if (is_workbook(file.file) && !reads_workbooks()) GTEST_SKIP() << "no liborcus";
  const auto study = write_study(folder, {{file.file, file.content}});
  EXPECT_EQ(fill_in(study, file.columns), file.blanks) << test::content_of(study);
  const auto read = first_experiment(study);
  const auto expected = reference(file.type);
  EXPECT_EQ(read->info().type, file.type);
  ASSERT_EQ(static_cast<int>(read->info().specimens.size()), file.specimens);
  ASSERT_EQ(read->rows(), file.specimens * expected->rows());
  for (int row = 0; row < read->rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    const int same = row % expected->rows();
    const auto s = static_cast<std::size_t>(same);
    EXPECT_NEAR(read->measured()(row), expected->measured()(same), 1e-12);
    EXPECT_NEAR(read->path().strain[i], expected->path().strain[s], 1e-12);
    EXPECT_NEAR(read->path().factor[i], expected->path().factor[s], 1e-12);
  }
}

TEST_P(TesterFiles, AreFittedAsThatExperiment) {
  const TemporaryFolder folder;
  const MadeUpFile& file = GetParam();
  if (is_workbook(file.file) && !reads_workbooks()) GTEST_SKIP() << "no liborcus";
  const auto study = write_study(folder, {{file.file, file.content}});
  fill_in(study, file.columns);
  const StudyResult fit = fit_study(read_study(study), {}, {});
  const StudyResult expected =
      fit_study(read_study(write_reference(folder, file.type, file.specimens)), {}, {});
  ASSERT_EQ(fit.experiments.size(), 1u);
  EXPECT_EQ(fit.converged, expected.converged);
  EXPECT_NEAR(fit.experiments[0].rms, expected.experiments[0].rms, 1e-9);
  ASSERT_EQ(fit.parameters.size(), expected.parameters.size());
  for (std::size_t i = 0; i < fit.parameters.size(); ++i) {
    const double value = expected.parameters[i].value;
    EXPECT_NEAR(fit.parameters[i].value, value, 1e-6 * std::abs(value)) << fit.parameters[i].name;
  }
}

INSTANTIATE_TEST_SUITE_P(Of, TesterFiles, ::testing::ValuesIn(test::good_files()),
                         [](const auto& instance) { return instance.param.name; });

class RefusedFiles : public ::testing::TestWithParam<RefusedFile> {};

TEST_P(RefusedFiles, AreRefusedWithTheLineToAdd) {
  const TemporaryFolder folder;
  const InputError error = test::input_error_of([&] {
    read_study(write_study(folder, {{GetParam().file, GetParam().content}}));
  });
  EXPECT_THAT(error.what(), HasSubstr(GetParam().way_out));
}

INSTANTIATE_TEST_SUITE_P(Of, RefusedFiles, ::testing::ValuesIn(test::refused_files()),
                         [](const auto& instance) { return instance.param.name; });

TEST(TesterStudy, TellsWhereEachFieldIsFrom) {
  const TemporaryFolder folder;
  const auto study = write_study(
      folder, {{"weft 1.csv",
                "Operator;KL\nGauge length;100;mm\nPreload;0.5;N\nExtension (mm);Load (N)\n0;0\n"
                "2;4\n5;9\n1;2\n"}});
  const std::string text = test::content_of(study);
  EXPECT_THAT(text, HasSubstr("length: 100 mm          # line 2: Gauge length;100;mm\n"));
  EXPECT_THAT(text, HasSubstr("direction: weft         # by the name of the file\n"));
  EXPECT_THAT(text, HasSubstr("width: ???              # the width of the strip, e.g. 50 mm\n"));
  EXPECT_THAT(text, HasSubstr("pretension: 0.5 N       # line 3"));
  EXPECT_THAT(text, HasSubstr("operator: KL\n"));
  EXPECT_THAT(text, HasSubstr("4 rows, 2 ways to and fro"));
}

TEST(TesterStudy, MakesSpecimensOfFilesThatDifferInTheirNumber) {
  const std::string table = "Extension (mm),Load (N)\n0,0\n2,4\n5,9\n1,2\n";
  const TemporaryFolder folder;
  const auto file =
      write_study(folder, {{"warp-1.csv", table}, {"warp-2.csv", table}, {"weft-1.csv", table}});
  EXPECT_EQ(fill_in(file, {}), "length width length width");
  const Study study = read_study(file);
  ASSERT_EQ(study.experiments.size(), 2u);
  EXPECT_EQ(study.experiments[0].data.files.size(), 2u);
  EXPECT_EQ(study.experiments[0].direction, "warp");
  EXPECT_EQ(study.experiments[1].data.written, "weft-1.csv");
}

TEST(TesterStudy, TakesTheFirstSheetThatHoldsATestAndNamesThemAll) {
  if (!reads_workbooks()) GTEST_SKIP() << "no liborcus";
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> rows{
      {"Weg [mm]", "Kraft [N]"}, {"0", "0"}, {"2", "4"}};
  const auto file = folder.write(
      "pull.xlsx", test::workbook({{"Parameter", {{"Vorkraft", "0.5", "N"}, {"x", "3", "4"}}},
                                   {"Ergebnisse", {{"Probe", "Fmax [N]"}, {"1", "9"}, {"2", "8"}}},
                                   {"Probe 1", rows},
                                   {"Probe 2", rows}}));
  const TesterFile table = read_tester_file(file, {});
  EXPECT_EQ(table.csv.sheet, "Probe 1");
  const ImportedStudy study = tester_study(std::span(&table, 1));
  EXPECT_THAT(study.study_yaml, HasSubstr("sheet: \"Probe 1\""));
  EXPECT_THAT(study.notes, ::testing::Contains(HasSubstr(
                               "the sheet \"Probe 1\" of \"Parameter\", \"Ergebnisse\", \"Probe "
                               "1\" or \"Probe 2\"; `--sheet NAME` takes another")));
  EXPECT_EQ(read_tester_file(file, {.sheet = "Probe 2"}).csv.sheet, "Probe 2");
}

TEST(TesterStudy, NamesEveryBlankWithItsLine) {
  const TemporaryFolder folder;
  const auto study =
      write_study(folder, {{"pull.csv", "Extension (mm),Load (N)\n0,0\n2,4\n5,9\n1,2\n"}});
  const InputError error = test::input_error_of([&] { read_study(study); });
  EXPECT_THAT(error.what(), HasSubstr("3 fields are left blank (\?\?\?)"));
  EXPECT_THAT(error.what(), HasSubstr("line 10: experiments[0].length (the length of the strip"));
}

TEST(TesterStudy, LeavesBlankAllThatATestOfATemplateNeeds) {
  for (const std::string& name : template_tests()) {
    if (facts_of_test(name).measures_solids) continue;  // testers' tables are of cloth
    const TemporaryFolder folder;
    std::filesystem::path table;
    for (const auto& [file, content] : test_template(name)) {
      if (file.ends_with(".csv")) table = folder.write(file, content);
    }
    const TesterFile file = read_tester_file(table, {}, find_test_type(name));
    const ImportedStudy study = tester_study(std::span(&file, 1));
    const auto yaml = folder.write("study.yaml", study.study_yaml);
    fill_in(yaml, {{"density", "150 g/m^2"}, {"side", "up"}});
    EXPECT_EQ(read_study(yaml).experiments.front().type, name);
  }
}

TEST(TesterStudy, TakesForcesOfAStripThatBucklesForThat) {
  const TemporaryFolder folder;
  const auto table = folder.write("a.csv", "Force (mN),Distance (mm)\n0,20\n-9,18\n-12,15\n");
  EXPECT_EQ(read_tester_file(table, {}).type->name, "buckling-bend");
}

TEST(TesterStudy, RefusesATestThatTheColumnsAreNotOf) {
  const TemporaryFolder folder;
  const auto table = folder.write("pull.csv", "Extension (mm),Load (N)\n0,0\n2,4\n");
  const InputError error =
      test::input_error_of([&] { read_tester_file(table, {}, find_test_type("shear-cycles")); });
  EXPECT_THAT(error.what(), HasSubstr("has not the columns of shear-cycles"));
}

TEST(Studies, TakeSizesThatTheyLeaveOutFromTheTestersFile) {
  const TemporaryFolder folder;
  folder.write("pull.csv",
               "Gauge length;100;mm\nWidth;50;mm\nExtension (mm);Load (N)\n0;0\n2;4\n5;9\n1;2\n");
  const std::string study =
      "pliant: study/1\nname: a\nexperiments:\n  - {name: a, type: tensile-cycles, direction: "
      "warp, data: pull.csv";
  const auto told = first_experiment(folder.write("study.yaml", study + "}\n"));
  EXPECT_EQ(told->path().strain, reference("tensile-cycles")->path().strain);
  EXPECT_THAT(told->info().handled,
              ::testing::Contains("the study states no length: 100 mm from line 1 of pull.csv "
                                  "(Gauge length;100;mm)"));
  const auto stated = first_experiment(folder.write("own.yaml", study + ", length: 200 mm}\n"));
  EXPECT_NE(stated->path().strain, told->path().strain);
  folder.write("pull.csv", "Extension (mm);Load (N)\n0;0\n2;4\n5;9\n1;2\n");
  EXPECT_THAT(test::input_error_of([&] { read_study(folder.path() / "study.yaml"); }).what(),
              HasSubstr("length: is missing"));
}

}  // namespace
}  // namespace pliant
