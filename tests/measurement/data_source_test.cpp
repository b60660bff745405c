#include "pliant/measurement/data_source.h"

#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Reads `data:` from a document in the folder.
DataSource source_of(const TemporaryFolder& folder, const std::string& yaml) {
  const Document document =
      parse_yaml("data: " + yaml + "\n", (folder.path() / "study.yaml").string());
  Fields fields = Value(document).fields();
  return read_data_source(fields.require("data"));
}

std::vector<std::string> file_names(const DataSource& source) {
  std::vector<std::string> names;
  for (const auto& file : source.files) names.push_back(file.filename().string());
  return names;
}

std::vector<std::string> names_of(const std::vector<SpecimenRows>& specimens) {
  std::vector<std::string> names;
  for (const SpecimenRows& specimen : specimens) names.push_back(specimen.name);
  return names;
}

TEST(DataSource, PathsAreRelativeToTheDocument) {
  const TemporaryFolder folder;
  folder.write("raw/warp.csv", "force_N\n1\n");
  const DataSource source = source_of(folder, "raw/warp.csv");
  EXPECT_EQ(source.files.front(), folder.path() / "raw/warp.csv");
  EXPECT_EQ(source.written, "raw/warp.csv");
  EXPECT_THAT(DataRows(source).quantity("force", Dimension::force), ElementsAre(1));
}

TEST(DataSource, APatternIsEveryMatchingFileByTheNumbersInItsName) {
  const TemporaryFolder folder;
  for (const char* name : {"warp-2.csv", "warp-10.csv", "warp-1.csv", "weft-1.csv", "warp-3.txt"}) {
    folder.write(name, "force_N\n1\n");
  }
  EXPECT_THAT(file_names(source_of(folder, "\"warp-*.csv\"")),
              ElementsAre("warp-1.csv", "warp-2.csv", "warp-10.csv"));
  folder.write("sub/a.csv", "force_N\n1\n");
  folder.write("sub/.a.csv", "hidden");
  EXPECT_THAT(file_names(source_of(folder, "\"sub/*\"")), ElementsAre("a.csv"));
}

TEST(DataSource, APatternWithoutAMatchIsRefused) {
  const TemporaryFolder folder;
  for (const char* pattern : {"\"warp-*.csv\"", "\"none/*.csv\"", "{file: \"x*.csv\"}"}) {
    const InputError error = input_error_of([&] { source_of(folder, pattern); });
    EXPECT_EQ(error.where().line, 1);
    EXPECT_THAT(error.what(), HasSubstr("matches no file"));
  }
}

TEST(DataSource, AFileThatIsNotThereIsRefusedWhenRead) {
  const TemporaryFolder folder;
  const DataSource source = source_of(folder, "none.csv");
  const InputError error = input_error_of([&] { const DataRows rows(source); });
  EXPECT_THAT(error.problem(), HasSubstr("none.csv"));
  EXPECT_EQ(error.where().field, "data");  // where the study asks for it
}

TEST(DataSource, MapsColumnsAndSkipsAPreamble) {
  const TemporaryFolder folder;
  folder.write("w.csv", "Tester 3000\nserial 12\nLoad (cN),Extension (mm)\n50,2\n100,4\n");
  const DataSource source = source_of(
      folder,
      R"y({file: w.csv, columns: {force: "Load (cN)", extension: "Extension (mm)"}, skip_rows: 2})y");
  const DataRows rows(source);
  EXPECT_THAT(rows.quantity("force", Dimension::force), ElementsAre(0.5, 1));
  EXPECT_THAT(rows.quantity("extension", Dimension::length), ElementsAre(0.002, 0.004));
  EXPECT_EQ(rows.location(1, "force").line, 5);
}

TEST(DataSource, ReadsOtherEncodings) {
  const TemporaryFolder folder;
  // A header with an ISO 8859-1 umlaut.
  folder.write("w.csv", "Kraft (N),L\xe4nge (mm)\n1,80\n");
  const DataSource source =
      source_of(folder, R"y({file: w.csv, encoding: latin1, columns: {length: "Länge (mm)"}})y");
  EXPECT_THAT(DataRows(source).quantity("length", Dimension::length), ElementsAre(0.08));
}

TEST(DataSource, AnUnknownKeyNamesTheNearest) {
  const TemporaryFolder folder;
  const InputError error =
      input_error_of([&] { source_of(folder, "{file: w.csv, colums: {force: F}}"); });
  EXPECT_EQ(error.where().field, "data.colums");
  EXPECT_THAT(error.what(), HasSubstr("did you mean \"columns\"?"));
}

TEST(DataRows, RowsOfAllFilesFollowEachOther) {
  const TemporaryFolder folder;
  folder.write("a-1.csv", "force_N,cycle\n1,1\n2,1\n");
  folder.write("a-2.csv", "# another unit\ncycle,force_cN\n2,300\n");
  const DataRows rows(source_of(folder, "\"a-*.csv\""));
  EXPECT_EQ(rows.rows(), 3);
  EXPECT_THAT(rows.quantity("force", Dimension::force), ElementsAre(1, 2, 3));
  EXPECT_THAT(*rows.optional_integers("cycle"), ElementsAre(1, 1, 2));
  EXPECT_FALSE(rows.optional_quantity("length", Dimension::length));
  EXPECT_FALSE(rows.optional_texts("specimen"));
  EXPECT_THAT(rows.location(2, "force").file, HasSubstr("a-2.csv"));
  EXPECT_EQ(rows.location(2, "force").line, 3);
}

TEST(DataRows, AColumnThatOnlySomeFilesHaveIsRefused) {
  const TemporaryFolder folder;
  folder.write("a-1.csv", "force_N,time_s\n1,0\n");
  folder.write("a-2.csv", "force_N\n2\n");
  const DataRows rows(source_of(folder, "\"a-*.csv\""));
  const InputError error = input_error_of([&] { rows.optional_quantity("time", Dimension::time); });
  EXPECT_THAT(error.where().file, HasSubstr("a-2.csv"));
}

TEST(DataRows, ASpecimenIsAFileOrARunOfTheSpecimenColumn) {
  const TemporaryFolder folder;
  folder.write("a-1.csv", "force_N\n1\n2\n");
  folder.write("a-2.csv", "force_N,specimen\n3,left\n4,right\n5,right\n");
  const auto specimens = DataRows(source_of(folder, "\"a-*.csv\"")).specimens();
  EXPECT_THAT(names_of(specimens), ElementsAre("a-1", "left", "right"));
  EXPECT_EQ(specimens[1].first, 2);
  EXPECT_EQ(specimens[2].first, 3);
  EXPECT_EQ(specimens[2].count, 2);
}

TEST(DataRows, ASpecimenThatComesBackIsRefused) {
  const TemporaryFolder folder;
  folder.write("w.csv", "force_N,specimen\n3,A\n4,B\n5,A\n");
  const InputError error =
      input_error_of([&] { DataRows(source_of(folder, "w.csv")).specimens(); });
  EXPECT_EQ(error.where().line, 4);
  EXPECT_EQ(error.where().field, "specimen");
  EXPECT_THAT(error.what(), HasSubstr("\"A\" comes a second time"));
}

TEST(DataRows, SpecimensOfSeveralFilesHaveNamesOfTheirOwn) {
  const TemporaryFolder folder;
  folder.write("monday.csv", "force_N,specimen\n3,1\n4,2\n");
  folder.write("tuesday.csv", "force_N,specimen\n3,1\n4,2\n");
  const auto names = names_of(DataRows(source_of(folder, "\"*day.csv\"")).specimens());
  EXPECT_EQ(names.size(), 4U);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), 4U)
      << ::testing::PrintToString(names);
}

TEST(DataRows, KeepsTheOwnColumnsAsWrittenAndTellsTheUnused) {
  const TemporaryFolder folder;
  folder.write("w.csv", "force_N;remark;length_mm\n1,50;ok;80\n2;;81\n");
  const DataRows rows(source_of(folder, "w.csv"));
  EXPECT_THAT(rows.quantity("force", Dimension::force), ElementsAre(1.5, 2));
  EXPECT_THAT(rows.unused_columns(), ElementsAre("length_mm", "remark"));
  const std::vector<OwnColumn> own = rows.own_columns();
  ASSERT_EQ(own.size(), 3U);
  EXPECT_EQ(own[0].header, "force_N");
  EXPECT_THAT(own[0].cells, ElementsAre("1,50", "2"));
  EXPECT_THAT(own[1].cells, ElementsAre("ok", ""));
}

TEST(DataRows, NothingIsUnusedWhenAllWasRead) {
  const TemporaryFolder folder;
  folder.write("w.csv", "force_N\n1\n");
  const DataRows rows(source_of(folder, "w.csv"));
  rows.quantity("force", Dimension::force);
  EXPECT_EQ(rows.quantity_unit("force"), "N");
  EXPECT_EQ(rows.quantity_unit("length"), "");
  EXPECT_THAT(rows.unused_columns(), IsEmpty());
}

}  // namespace
}  // namespace pliant
