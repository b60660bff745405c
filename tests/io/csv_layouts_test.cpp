// How tables lie in files of testing machines: under tables of results, several specimens side by
// side or one below the other, without names, in workbooks.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/io/csv.h"
#include "pliant/io/workbook.h"

#include "input_error_of.h"
#include "support/workbook.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

CsvTable table(const std::string& text, const CsvOptions& options = {}) {
  return parse_csv(text, "w.csv", options);
}

TEST(CsvLayouts, TheTableWithMostRowsIsThatOfTheReadings) {
  const CsvTable csv = table("Result,Peak (N)\n1,7\n2,8\n\nforce_N,x\n1,2\n3,4\n5,6\n");
  EXPECT_EQ(csv.header_line(), 5);
  EXPECT_EQ(csv.preamble(), "Result,Peak (N)\n1,7\n2,8\n\n");
  EXPECT_THAT(csv.numbers("x"), ElementsAre(2, 4, 6));
}

TEST(CsvLayouts, RowsWithoutNumbersDoNotMakeTheRowAboveThemAHeader) {
  const CsvTable csv = table("a,b\n1,2\nlow,high\n3,4\n5,6\n7,8\n");
  EXPECT_EQ(csv.header_line(), 1);
  EXPECT_EQ(csv.rows(), 5u);
}

TEST(CsvLayouts, SpecimensSideBySideBecomeOneTable) {
  const CsvTable csv =
      table("t;Probe 1;;Probe 2\nt;F;x;F;x\ns;N;mm;N;mm\n0;1;2;3;4\n1;5;6;7;8\n2;;;9;10\n");
  EXPECT_THAT(csv.headers(), ElementsAre("t", "F", "x", "specimen"));
  EXPECT_THAT(csv.quantity("F", Dimension::force), ElementsAre(1, 5, 3, 7, 9));
  EXPECT_THAT(csv.quantity("t", Dimension::time), ElementsAre(0, 1, 0, 1, 2));
  // The line above does not name them: it has three names.
  EXPECT_THAT(csv.texts("specimen"), ElementsAre("1", "1", "2", "2", "2"));
  EXPECT_EQ(csv.line(4), 6);
  const CsvTable named = table("Probe A;;Probe B\nF;x;F;x\n1;2;3;4\n");
  EXPECT_THAT(named.texts("specimen"), ElementsAre("Probe A", "Probe B"));
}

TEST(CsvLayouts, EmptyCellsMayEndEveryRow) {
  const CsvTable csv = table("a;1;2;3\nF;x;;\nN;mm;;\n1;2;;\n3;4;;\n");
  EXPECT_THAT(csv.quantity("F", Dimension::force), ElementsAre(1, 3));
}

TEST(CsvLayouts, ColumnsThatComeTwiceWithoutTheirGroupAreRefused) {
  for (const char* header : {"a,b,a", "a,a", "a,b,c,a"}) {
    EXPECT_THAT(input_error_of([&] { table(std::string(header) + "\n1,2,3,4\n"); }).problem(),
                HasSubstr("given twice"))
        << header;
  }
}

TEST(CsvLayouts, SpecimensBelowEachOtherBecomeOneTable) {
  const CsvTable csv =
      table("Probe A\nF;x\nN;mm\n1;2\n3;4\n\nProbe B\nWidth;50;mm\nF;x\nN;mm\n5;6\n");
  EXPECT_THAT(csv.quantity("F", Dimension::force), ElementsAre(1, 3, 5));
  EXPECT_THAT(csv.texts("specimen"), ElementsAre("Probe A", "Probe A", "2"));
  EXPECT_EQ(csv.line(2), 11);
}

TEST(CsvLayouts, SpecimensBelowEachOtherKeepTheirRowsWhereLinesEndInASeparator) {
  const CsvTable csv = table("F;x;\nN;mm;\n1;2;\n3;4;\n5;6;\n\nF;x;\nN;mm;\n7;8;\n9;10;\n");
  EXPECT_EQ(csv.rows(), 5U);
  EXPECT_THAT(csv.texts("specimen"), ElementsAre("1", "1", "1", "2", "2"));
}

TEST(CsvLayouts, TheFirstSpecimenIsNotLostWhereTheNextOneHasMoreRows) {
  const CsvTable csv = table("F;x\nN;mm\n1;2\n3;4\n\nF;x\nN;mm\n5;6\n7;8\n9;10\n");
  EXPECT_THAT(csv.texts("specimen"), ElementsAre("1", "1", "2", "2", "2"));
}

TEST(CsvLayouts, AWrongRowAmongSpecimensIsRefusedAtItsLine) {
  const InputError error =
      input_error_of([] { table("F;x\nN;mm\n1;2\n3\n5;6\n7;8\nF;x\nN;mm\n7;8\n9;10\n"); });
  EXPECT_EQ(error.where().line, 4);
}

TEST(CsvLayouts, WordsBelowTheRowsAreLeftOut) {
  const CsvTable csv = table("a;b\n1;2\n3;4\n\nEnd of test\nMean;3\n");
  EXPECT_EQ(csv.rows(), 2u);
  EXPECT_EQ(csv.footer(), "End of test\nMean;3");
  EXPECT_EQ(table("a,b\n1,2\n").footer(), "");
}

TEST(CsvLayouts, WordsAmongTheRowsAreRefused) {
  const InputError error = input_error_of([] { table("a;b\n1;2\npaused\n3;4\n"); });
  EXPECT_STREQ(error.what(),
               "w.csv:3: \"paused\" stands among the rows; expected rows alone, and words below "
               "the last of them");
  // What should be a number is no closing word.
  input_error_of([] { table("a;b\n1;2\nNaN;\n").numbers("a"); });
}

TEST(CsvLayouts, SeparatorsOfThousandsAreNamed) {
  for (const char* text : {"a,b\n1,2\n\"1,234.5\",4\n", "a;b\n1;2\n1.234,5;4\n"}) {
    EXPECT_THAT(input_error_of([&] { table(text).numbers("a"); }).what(),
                HasSubstr("has a thousands separator; expected numbers without"));
  }
}

TEST(CsvLayouts, ColumnsGoByTheirNumbersWhereNoNamesStandAboveThem) {
  const CsvOptions options{.columns = {{"force", "2 (N)"}, {"length_mm", "1"}},
                           .numbered_columns = true};
  const CsvTable csv = table("QMAT 5\n1,5;100\n2,5;200\n", options);
  EXPECT_THAT(csv.quantity("force", Dimension::force), ElementsAre(100, 200));
  EXPECT_THAT(csv.quantity("length", Dimension::length), ElementsAre(0.0015, 0.0025));
  EXPECT_EQ(csv.header_line(), 0);
  EXPECT_EQ(csv.line(0), 2);
  EXPECT_THAT(input_error_of([] { table("1,2\n3,4\n"); }).expected(), HasSubstr("force: 2 (N)"));
}

TEST(CsvLayouts, AUnitMayStandBehindAHeaderThatTellsNone) {
  const CsvTable csv = table("Load,Load 2\n2,3\n", {.columns = {{"force", "load (kN)"}}});
  EXPECT_THAT(csv.quantity("force", Dimension::force), ElementsAre(2000));
  const CsvTable contradicted =
      table("Load (N),x\n2,3\n", {.columns = {{"force", "Load (N) (kN)"}}});
  EXPECT_EQ(input_error_of([&] { contradicted.quantity("force", Dimension::force); }).problem(),
            "its unit is N, not kN");
}

TEST(Workbooks, AreReadAsTheirTables) {
  if (!reads_workbooks()) GTEST_SKIP() << "no liborcus";
  const TemporaryFolder folder;
  const auto file = folder.write(
      "w.XLSX",
      test::workbook({{"About", {{"Operator", "KL"}}},
                      {"Data", {{}, {"force_N", "note, or \"not\""}, {"1.5", "a"}, {"2", ""}}},
                      {"Other", {{"x", "y"}, {"1", "2"}, {"3", "4"}}}}));
  const CsvTable first = read_csv(file, {.sheet = "Data"});
  EXPECT_THAT(first.numbers("force_N"), ElementsAre(1.5, 2));
  EXPECT_THAT(first.texts("note, or \"not\""), ElementsAre("a", ""));
  EXPECT_EQ(first.line(0), 3);
  EXPECT_THAT(read_csv(file).numbers("y"), ElementsAre(2, 4));
  EXPECT_THAT(input_error_of([&] { read_csv(file, {.sheet = "Dato"}); }).what(),
              HasSubstr("sheet: there is no sheet \"Dato\" (did you mean \"Data\"?)"));
}

TEST(Workbooks, MayKeepTheirTextsInCellsAndFormulas) {
  if (!reads_workbooks()) GTEST_SKIP() << "no liborcus";
  using test::WorkbookTexts;
  const TemporaryFolder folder;
  for (const auto texts : {WorkbookTexts::in_cells, WorkbookTexts::of_formulas}) {
    const auto file = folder.write(
        "w.xlsx", test::workbook({{"A", {{"force_N", "note"}, {"1.5", "a &amp; b"}}}}, texts));
    const CsvTable csv = read_csv(file, {.sheet = "A"});
    EXPECT_THAT(csv.numbers("force_N"), ElementsAre(1.5));
    EXPECT_THAT(csv.texts("note"), ElementsAre("a & b"));
  }
}

TEST(Workbooks, NameTheirSheets) {
  if (!reads_workbooks()) GTEST_SKIP() << "no liborcus";
  const TemporaryFolder folder;
  const auto file = folder.write("w.xlsx", test::workbook({{"Parameter", {}}, {"Probe 1", {}}}));
  EXPECT_THAT(workbook_sheets(file), ElementsAre("Parameter", "Probe 1"));
}

TEST(Workbooks, ThatAreNoneAreRefused) {
  const TemporaryFolder folder;
  EXPECT_THAT(input_error_of([&] { read_csv(folder.write("w.xlsx", "force_N\n1\n")); }).problem(),
              HasSubstr("workbook"));
  std::string broken = test::workbook({{"Data", {{"force_N", "x"}, {"1", "2"}}}});
  broken.resize(broken.size() / 2);
  input_error_of([&] { read_csv(folder.write("w.xlsx", broken)); });
}

}  // namespace
}  // namespace pliant
