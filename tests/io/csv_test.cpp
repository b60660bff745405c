#include "pliant/io/csv.h"

#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/io/csv_writer.h"

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using Numbers = std::vector<double>;

CsvTable table(const std::string& text, const CsvOptions& options = {}) {
  return parse_csv(text, "w.csv", options);
}

InputError csv_error(const std::string& text, const CsvOptions& options = {}) {
  return input_error_of([&] { parse_csv(text, "w.csv", options); });
}

InputError force_error(const std::string& text, const CsvOptions& options = {}) {
  const CsvTable csv = table(text, options);
  return input_error_of([&] { csv.quantity("force", Dimension::force); });
}

TEST(Csv, MayBeAHeaderAloneWhereRowsAreOptional) {
  for (const char* text : {"force_N,clip", "force_N,clip\n", "force,clip\n(N),()\n# none\n"}) {
    const CsvTable csv = table(text, {.rows_optional = true});
    EXPECT_EQ(csv.rows(), 0U) << text;
    EXPECT_TRUE(csv.quantity("force", Dimension::force).empty());
    EXPECT_TRUE(csv.texts("clip").empty());
  }
  EXPECT_EQ(csv_error("", {.rows_optional = true}).problem(), "the file is empty");
}

TEST(Csv, GivesQuantitiesInSiFromColumnsInAnyOrderAndUnit) {
  const CsvTable csv = table("length_mm,force_gf,repeat\n100,100,1\n110,200,1\n");
  EXPECT_EQ(csv.rows(), 2U);
  EXPECT_EQ(csv.line(1), 3);
  EXPECT_EQ(csv.quantity("length", Dimension::length), (Numbers{0.1, 0.11}));
  EXPECT_DOUBLE_EQ(csv.quantity("force", Dimension::force)[1], 1.96133);
  EXPECT_EQ(csv.integers("repeat"), (std::vector<long>{1, 1}));
  EXPECT_EQ(csv.quantity_column("force"), "force_gf");
  EXPECT_EQ(csv.quantity_column("time"), std::nullopt);
  EXPECT_EQ(csv.quantity_unit("force"), "gf");
  EXPECT_EQ(csv.quantity_unit("time"), std::nullopt);
  EXPECT_FALSE(csv.optional_quantity("time", Dimension::time));
  EXPECT_TRUE(csv.has("repeat"));
  EXPECT_FALSE(csv.has("force"));
}

TEST(Csv, TakesUnitsInBracketsAndCompoundUnits) {
  EXPECT_EQ(table("force [kN]\n2\n").quantity("force", Dimension::force), Numbers{2000});
  EXPECT_EQ(table("force(N)\n2\n").quantity("force", Dimension::force), Numbers{2});
  EXPECT_EQ(table("force_N_per_m\n2\n").quantity("force", Dimension::force_per_length), Numbers{2});
  EXPECT_EQ(table("curvature_1_per_m\n2\n").quantity("curvature", Dimension::curvature),
            Numbers{2});
  EXPECT_EQ(table("stretch\n1.5\n").quantity("stretch", Dimension::number), Numbers{1.5});
  EXPECT_EQ(table("stretch,stretch_2\n1,2\n").quantity("stretch", Dimension::number), Numbers{1});
}

TEST(Csv, FindsNamesInAnyCaseAndUnitsAsTestersWriteThem) {
  for (const char* header : {"Force (N)", "FORCE [N]", "Force/N", "Force / N", "force in N",
                             "Force, N", "Force N", "force_N"}) {
    EXPECT_EQ(
        table(std::string("time_s\t") + header + "\n0\t2\n").quantity("force", Dimension::force),
        Numbers{2})
        << header;
  }
  // Columns that only name something are called as we call them.
  EXPECT_FALSE(table("Cycle,x\n1,2\n").has("cycle"));
  EXPECT_FALSE(table("forces_N\n1\n").optional_quantity("force", Dimension::force));
}

TEST(Csv, TakesAUnitsRowWithoutBrackets) {
  const CsvTable csv = table("Force;Time\nN;s\n2,5;1\n");
  EXPECT_EQ(csv.quantity("force", Dimension::force), Numbers{2.5});
  EXPECT_EQ(csv.rows(), 1U);
  const CsvTable dashed = table("No;Force\n-;kN\n1;2,5\n");
  EXPECT_EQ(dashed.quantity("force", Dimension::force), Numbers{2500});
  EXPECT_EQ(dashed.numbers("No"), Numbers{1});
}

TEST(Csv, TakesUnitsThatALineAboveTheHeaderLists) {
  const auto force = [](const std::string& above, const std::string& header) {
    return table(above + "\n" + header + "\n1,2\n3,4\n").quantity("force", Dimension::force);
  };
  EXPECT_EQ(force("Units: kN, mm", "Force,x"), (Numbers{1000, 3000}));
  EXPECT_EQ(force("# units: kN, mm", "Force,x"), (Numbers{1000, 3000}));
  EXPECT_EQ(force("\"Unit\",\"kN\",\"mm\"", "Force,x"), (Numbers{1000, 3000}));
  EXPECT_EQ(force("Einheit,kN", "No,Force"), (Numbers{2000, 4000}));
  EXPECT_EQ(force("Units: kN, mm", "Force (N),x"), (Numbers{1, 3}));
  // A list that is not one of the columns, and words that only begin alike, tell nothing.
  for (const char* above : {"Units: kN, mm, s", "Units: SI, mm", "United: kN, mm"}) {
    EXPECT_THAT(input_error_of([&] { force(above, "Force,x"); }).what(),
                ::testing::HasSubstr("the column has no unit"))
        << above;
  }
}

TEST(Csv, FindsSynonymsWhoseUnitFits) {
  const CsvOptions options{.synonyms = {{"force", {"load"}},
                                        {"extension", {"elongation", "stroke"}},
                                        {"strain", {"elongation"}}}};
  const CsvTable csv = table("Load (kN),Elongation (%),Stroke (mm)\n2,10,5\n", options);
  EXPECT_EQ(csv.quantity("force", Dimension::force), Numbers{2000});
  EXPECT_EQ(csv.quantity("extension", Dimension::length), Numbers{0.005});
  EXPECT_EQ(csv.quantity("strain", Dimension::fraction), Numbers{0.1});
  // Our own name is meant where it stands, and a unit that does not fit is told.
  EXPECT_EQ(table("load_N,force_mN\n1,2\n", options).quantity("force", Dimension::force),
            Numbers{0.002});
}

TEST(Csv, TakesTheColumnWhoseUnitFitsOfSeveralThatATesterCallsAlike) {
  const CsvOptions options{.synonyms = {{"force", {"load"}}, {"extension", {"elongation"}}}};
  const CsvTable csv =
      table("Elongation (%),Elongation (mm),Load (N),Load (kgf),Load min\n5,2,3,4,5\n", options);
  EXPECT_EQ(csv.quantity("extension", Dimension::length), Numbers{0.002});
  EXPECT_EQ(csv.quantity("force", Dimension::force), Numbers{3});
  EXPECT_EQ(table("Force (raw),force_N\n1,2\n").quantity("force", Dimension::force), Numbers{2});
  EXPECT_EQ(force_error("force_N,force_kN\n1,2\n").where().field, "force_kN");
}

TEST(Csv, LeavesOutWhatAnInstrumentWritesAboveTheHeader) {
  const CsvTable csv = table(
      "\"Test Method\",\"strip, 50 mm\"\nSpecimen,1\nWidth,50,mm\n\n"
      "Time,Extension,Load\n(s),(mm),(N)\n0,0,0.1\n1,2,0.2\n");
  EXPECT_EQ(csv.header_line(), 5);
  EXPECT_EQ(csv.rows(), 2U);
  EXPECT_EQ(csv.quantity("load", Dimension::force), (Numbers{0.1, 0.2}));
  const CsvTable german = table("Prüfung;17\nKraft;Weg\nN;mm\n1,5;2,0\n1,6;2,1\n");
  EXPECT_EQ(german.quantity("Kraft", Dimension::force), (Numbers{1.5, 1.6}));
}

TEST(Csv, ReadsEveryLineEndMarkAndSeparator) {
  for (const char* text :
       {"a,b\n1,2\n3,4\n", "a,b\r\n1,2\r\n3,4\r\n", "a,b\r1,2\r3,4\r", "a,b\n1,2\n3,4",
        "a;b\n1;2\n3;4\n", "a\tb\n1\t2\n3\t4\n",
        "\xEF\xBB\xBF"
        "a,b\n1,2\n3,4\n",
        " a , b \n 1 , 2 \n 3,4\n", "a,b,\n1,2,\n3,4,,\n", "\n# c\na,b\n\n1,2\n,\n# d\n3,4\n\n"}) {
    const CsvTable csv = table(text);
    EXPECT_EQ(csv.rows(), 2U) << text;
    EXPECT_EQ(csv.numbers("a"), (Numbers{1, 3})) << text;
    EXPECT_EQ(csv.numbers("b"), (Numbers{2, 4})) << text;
  }
  const std::string utf16(
      "\xFF\xFE"
      "a\0\n\0"
      "1\0\n\0",
      10);
  EXPECT_EQ(table(utf16).numbers("a"), Numbers{1});
}

TEST(Csv, CountsLinesOverCommentsQuotedLineEndsAndSkippedRows) {
  const CsvTable csv = table("preamble, x\nmore\na,b\n# c\n\"x\ny\",1\nz,2\n", {.skip_rows = 2});
  EXPECT_EQ(csv.header_line(), 3);
  EXPECT_EQ(csv.line(0), 5);
  EXPECT_EQ(csv.line(1), 7);
  EXPECT_EQ(csv.texts("a")[0], "x\ny");
}

TEST(Csv, UnescapesQuotedCells) {
  const CsvTable csv = table("a,\"b, c\"\n\"say \"\"hi\"\"\",\"1\"\n\"\",5\" ruler\n");
  EXPECT_EQ(csv.texts("a"), (std::vector<std::string>{"say \"hi\"", ""}));
  EXPECT_EQ(csv.texts("b, c"), (std::vector<std::string>{"1", "5\" ruler"}));
}

TEST(Csv, TakesADecimalCommaWhereTheSeparatorIsNone) {
  const CsvTable csv = table("force_N;length_mm\n1,5;100\n-2,25e1;100,5\n3;101\n");
  EXPECT_EQ(csv.quantity("force", Dimension::force), (Numbers{1.5, -22.5, 3}));
  EXPECT_EQ(table("a;b\n1.5;2\n").numbers("a"), Numbers{1.5});
}

TEST(Csv, RefusesDecimalCommasBesidePointsAndThousandsSeparators) {
  const InputError error = force_error("force_N;x\n999.5;1\n1,234;2\n");
  EXPECT_EQ(error.where().line, 3);
  EXPECT_EQ(error.where().field, "force_N");
  EXPECT_EQ(force_error("force_N;x\n1.234,5;1\n").where().line, 2);
  EXPECT_EQ(force_error("force_N,x\n\"1,234\",1\n").problem(), "\"1,234\" is not a finite number");
}

TEST(Csv, TakesAUnitsRowUnderTheHeader) {
  const CsvTable csv = table("Time;force;[x]\n(s);(kN);\n0,5;2;1\n");
  EXPECT_EQ(csv.rows(), 1U);
  EXPECT_EQ(csv.quantity("force", Dimension::force), Numbers{2000});
  EXPECT_EQ(table("Time;Load\n(s);(kN)\n0;2\n", {.columns = {{"force", "Load"}}})
                .quantity("force", Dimension::force),
            Numbers{2000});
}

TEST(Csv, MapsOurNamesToTheFilesHeaders) {
  const std::string text =
      "Load (N),Extension [mm],Force_N_per_m,T \xC2\xB0"
      "C,Grip\n1,2,3,4,5\n";
  const CsvTable csv = table(text, {.columns = {{"force", "Load (N)"},
                                                {"extension", "Extension [mm]"},
                                                {"stress", "Force_N_per_m"},
                                                {"temperature",
                                                 "T \xC2\xB0"
                                                 "C"},
                                                {"grip_mm", "Grip"},
                                                {"step", "Grip"}}});
  EXPECT_EQ(csv.quantity("force", Dimension::force), Numbers{1});
  EXPECT_EQ(csv.quantity("extension", Dimension::length), Numbers{0.002});
  EXPECT_EQ(csv.quantity("stress", Dimension::force_per_length), Numbers{3});
  EXPECT_EQ(csv.quantity("temperature", Dimension::temperature), Numbers{277.15});
  EXPECT_EQ(csv.quantity("grip", Dimension::length), Numbers{0.005});
  EXPECT_EQ(csv.integers("step"), std::vector<long>{5});
  EXPECT_EQ(csv.quantity_column("force"), "Load (N)");
}

TEST(Csv, RefusesAMappingThatTheFileContradicts) {
  const InputError missing = force_error("Load (N),x\n1,2\n", {.columns = {{"force", "Laod (N)"}}});
  EXPECT_STREQ(missing.what(),
               "w.csv:1: force: there is no column \"Laod (N)\" (did you mean \"Load (N)\"?); "
               "expected \"Load (N)\" or \"x\"");
  EXPECT_EQ(force_error("Load (kN)\n1\n", {.columns = {{"force_N", "Load (kN)"}}}).problem(),
            "its unit is kN, not N");
  EXPECT_EQ(force_error("Load\n1\n", {.columns = {{"force", "Load"}}}).problem(),
            "the column has no unit");
}

TEST(Csv, TellsWhichColumnIsMissing) {
  const InputError error = force_error("\n# c\nlength_mm,time_s\n1,2\n");
  EXPECT_EQ(error.where().file, "w.csv");
  EXPECT_EQ(error.where().line, 3);
  EXPECT_EQ(error.where().field, "force");
  EXPECT_EQ(error.problem(), "there is no such column (the file has \"length_mm\" or \"time_s\")");
  EXPECT_NE(error.expected().find("force_UNIT (N, kN"), std::string::npos);
  const CsvTable csv = table("a\n1\n");
  input_error_of([&] { csv.numbers("b"); });
  input_error_of([&] { csv.integers("b"); });
  input_error_of([&] { csv.texts("b"); });
}

TEST(Csv, RefusesRepeatedColumnsAndTwoColumnsOfOneQuantity) {
  EXPECT_STREQ(csv_error("a,b,a \n1,2,3\n").what(),
               "w.csv:1: a: the column is given twice; expected each header once");
  const InputError error = force_error("force_N,force_gf\n1,2\n");
  EXPECT_EQ(error.where().field, "force_gf");
  EXPECT_EQ(error.problem(), "a second column for force (the first is \"force_N\")");
}

TEST(Csv, RefusesColumnsWithoutUnitOrWithOneOfAnotherKind) {
  EXPECT_EQ(force_error("force\n1\n").problem(), "the column has no unit");
  EXPECT_EQ(force_error("force_mm\n1\n").problem(), "\"mm\" is no unit of force");
  EXPECT_EQ(force_error("force (pound)\n1\n").problem(), "\"pound\" is no unit of force");
}

TEST(Csv, NamesLineAndColumnOfWhatIsNoFiniteNumber) {
  for (const char* cell : {"abc", "nan", "NaN", "inf", "-Inf", "1e999", "1 2", "12N", "#N/A"}) {
    const InputError error = force_error(std::string("x,force_N\n1,2\n1,") + cell + "\n1,3\n");
    EXPECT_EQ(error.where().line, 3) << cell;
    EXPECT_EQ(error.where().field, "force_N") << cell;
  }
  EXPECT_EQ(force_error("x,force_N\n1,\n").problem(), "the cell is empty");
  const CsvTable csv = table("a\n1.5\n");
  EXPECT_EQ(input_error_of([&] { csv.integers("a"); }).expected(), "a whole number");
}

TEST(Csv, RefusesEmptyFilesAndFilesWithoutRows) {
  for (const char* text : {"", "\n\n", "# only\n", ";;;\n", "\xEF\xBB\xBF"}) {
    EXPECT_EQ(csv_error(text).problem(), "the file is empty") << text;
  }
  for (const char* text : {"a,b", "a,b\n", "a,b\n# c\n", "a,b\n(N),(mm)\n"}) {
    EXPECT_EQ(csv_error(text).problem(), "there are no rows of data under the header") << text;
    EXPECT_EQ(csv_error(text).where().line, 1) << text;
  }
  EXPECT_EQ(table("a\n1\n").rows(), 1U);
}

TEST(Csv, RefusesAPreambleWithoutATableAndNamesSkipRows) {
  EXPECT_NE(csv_error("1,2\n3,4\n").expected().find("skip_rows"), std::string::npos);
  const InputError ragged = csv_error("Instrument X\nforce_N,length_mm\nlow,high\n");
  EXPECT_EQ(ragged.where().line, 2);
  EXPECT_NE(ragged.expected().find("skip_rows"), std::string::npos);
  EXPECT_EQ(csv_error("a\n1\n", {.skip_rows = 5}).problem(), "the file is empty");
  csv_error("a\n1\n", {.skip_rows = -1});
}

TEST(Csv, RefusesRaggedRows) {
  const InputError error = csv_error("a,b\n1,2\n3\n");
  EXPECT_EQ(error.where().line, 3);
  EXPECT_EQ(error.problem(), "the row has 1 cells");
  EXPECT_EQ(csv_error("a,b\n1,2,3\n").where().line, 2);
}

TEST(Csv, RefusesBrokenQuotes) {
  const InputError open = csv_error("a,b\n1,2\n\"3,4\n5,6\n");
  EXPECT_EQ(open.where().line, 3);
  EXPECT_EQ(open.problem(), "a quote is opened and never closed");
  EXPECT_EQ(csv_error("a,b\n\"1\"x,2\n").problem(), "text after a closing quote");
}

TEST(Csv, RefusesLinesWithoutEnd) {
  const InputError error = csv_error("a,b\n1,2\n" + std::string(kMaxCsvLineSize + 1, '1'));
  EXPECT_EQ(error.where().line, 3);
  EXPECT_EQ(error.problem(), "the line is too long");
  EXPECT_EQ(csv_error("a\n\"" + std::string(kMaxCsvLineSize, '\n') + "\"").where().line, 2);
}

TEST(Csv, ReadsOtherEncodingsByName) {
  const std::string text = "\xC1\xA6_N\n1\n";  // the Chinese word for force, in GBK
  const CsvOptions options{.encoding = "gbk", .columns = {{"force", "\xE5\x8A\x9B_N"}}};
  EXPECT_EQ(table(text, options).quantity("force", Dimension::force), Numbers{1});
  EXPECT_EQ(csv_error(text).where().line, 1);
}

TEST(Csv, ListsTheColumnsThatWereNeverRead) {
  const CsvTable csv = table("force_N,note,cycle\n1,a,2\n");
  csv.quantity("force", Dimension::force);
  EXPECT_EQ(csv.unused_columns(), (std::vector<std::string>{"note", "cycle"}));
  csv.texts("note");
  csv.integers("cycle");
  EXPECT_TRUE(csv.unused_columns().empty());
}

TEST(Csv, IsReadFromAFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_csv(folder.write("w.csv", "a\n1\n")).numbers("a"), Numbers{1});
  EXPECT_EQ(input_error_of([&] { read_csv(folder.path()); }).problem(), "is a directory");
}

TEST(Csv, KeepsItsCellsWhenMoved) {
  CsvTable first = table("a\n1\n");
  const CsvTable second = std::move(first);
  EXPECT_EQ(second.numbers("a"), Numbers{1});
}

TEST(CsvWriter, WritesWhatReadCsvReadsBackAsItWas) {
  const std::vector<std::string> header = {"force_N", "a, \"b\""};
  CsvWriter writer(header);
  const Numbers values = {1.0 / 3.0, 5e-324, -1.7976931348623157e308, 100.0};
  const std::vector<std::string> texts = {"# no comment", "two\nlines", " blank ", "a;b\t\"c\""};
  for (std::size_t i = 0; i < values.size(); ++i) writer.cell(values[i]).cell(texts[i]).end_row();
  const CsvTable csv = table(writer.text());
  EXPECT_EQ(csv.quantity("force", Dimension::force), values);
  EXPECT_EQ(csv.texts("a, \"b\""), texts);
}

TEST(CsvWriter, WritesNaNAsAnEmptyCellAndChecksTheRowLength) {
  const std::vector<std::string> header = {"a", "b"};
  CsvWriter writer(header);
  writer.row(Numbers{std::nan(""), 2.5});
  writer.cell(3).cell("x").end_row();
  EXPECT_EQ(writer.text(), "a,b\n,2.5\n3,x\n");
  EXPECT_ANY_THROW(writer.row(Numbers{1.0}));
}

}  // namespace
}  // namespace pliant
