// From the table of a testing machine to a material, on the command line; and what is said where a
// command is given something else than it takes.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/workbook.h"
#include "pliant/study/test_template.h"

#include "app/run_program.h"
#include "apps/pliant/file_info.h"
#include "support/workbook.h"

namespace pliant::test {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

const std::string kTable =
    "Gauge length;100;mm\nExtension (mm);Load (N)\n0;0\n1;2\n2;4\n3;6\n4;8\n5;10\n4;7\n3;5\n2;3\n"
    "1;1\n";

TEST(InitFrom, LeadsFromATableToAMaterial) {
  const TemporaryFolder folder;
  const std::string table = folder.write("warp 1.csv", kTable).string();
  const std::string study = (folder.path() / "study").string();
  const std::string result = (folder.path() / "result").string();
  const ProgramRun written = run_program({"init", "--from", table, study});
  ASSERT_EQ(written.status, 0) << written.err;
  EXPECT_THAT(written.err, AllOf(HasSubstr("10 rows, 2 ways"), HasSubstr("to fill in: line")));

  const ProgramRun blank = run_program({"fit", study, "-o", result});
  EXPECT_EQ(blank.status, 2);
  EXPECT_THAT(blank.err, HasSubstr("experiments[0].width (the width of the strip, e.g. 50 mm)"));

  std::string text = content_of(folder.path() / "study" / "study.yaml");
  text.replace(text.find("width: ???"), 10, "width: 5 cm");
  folder.write("study/study.yaml", text);
  const ProgramRun fitted = run_program({"fit", study, "-o", result});
  EXPECT_EQ(fitted.status, 0) << fitted.err;
  EXPECT_EQ(run_program({"evaluate", study, "-m", result, "-o", result + "2"}).status, 0);
}

TEST(InitFrom, NeverReplacesAFolder) {
  const TemporaryFolder folder;
  const std::string table = folder.write("a.csv", kTable).string();
  const std::string full = folder.path().string();
  EXPECT_THAT(run_program({"init", "--from", table, "-o", full}).err, HasSubstr("is not empty"));
  EXPECT_THAT(run_program({"init", "--from", table}).err, HasSubstr("-o DIR"));
  EXPECT_THAT(run_program({"init"}).err, HasSubstr("pliant init --from FILE -o DIR"));
}

TEST(InfoOfATable, TellsThePreambleAndTheLinesOfAStudy) {
  const TemporaryFolder folder;
  const FileInfo info = describe_file(folder.write("warp.csv", kTable));
  EXPECT_EQ(info.json["facts"]["length"], "100 mm");
  EXPECT_EQ(info.json["passes"], 2);
  EXPECT_THAT(info.lines, Contains(AllOf(HasSubstr("type: tensile-cycles"),
                                         HasSubstr("direction: warp"), HasSubstr("width: ???"))));
  // A table that is of no test has none.
  EXPECT_FALSE(describe_file(folder.write("p.csv", "a,b\n1,2\n")).json.contains("study"));
}

TEST(InfoOfATable, TakesWhatAStudySaysOfItsReading) {
  const TemporaryFolder folder;
  const std::string table = folder.write("a.txt", "\xB7\n0;0\n1;2\n2;4\n").string();
  const ProgramRun run = run_program({"info", table, "--json", "--columns", "force=2 (N)",
                                      "--columns", "extension=1 (mm)", "--skip-rows", "1"});
  ASSERT_EQ(run.status, 0) << run.err;
  const auto json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["usable_as"][0], "tensile-cycles");
  EXPECT_THAT(json["study"].get<std::string>(),
              AllOf(HasSubstr("force: \"2 (N)\""), HasSubstr("skip_rows: 1")));
  EXPECT_THAT(run_program({"info", table, "--columns", "force"}).err, HasSubstr("NAME=HEADER"));
}

TEST(InfoOfATable, TellsWhatIsBelowTheRowsAndReadsDecimalCommas) {
  const TemporaryFolder folder;
  const FileInfo info =
      describe_file(folder.write("warp.csv", "Kanal 1;Kanal 2\n0,5;1\n1,5;2\nEnd of test\n"));
  EXPECT_EQ(info.json["footer"], "End of test");
  EXPECT_EQ(info.json["columns"][0]["min"], 0.5);
  EXPECT_THAT(info.lines, Contains(HasSubstr("numbers, 0.5 to 1.5")));
}

TEST(InfoOfATable, DrawsItsReadings) {
  const TemporaryFolder folder;
  const std::string table = folder.write("a.csv", kTable).string();
  const std::string page = (folder.path() / "a.html").string();
  ASSERT_EQ(run_program({"info", table, "--plot", page}).status, 0);
  // A program without its web bundle writes the facts alone.
  EXPECT_THAT(content_of(page), AllOf(HasSubstr("a.csv"), HasSubstr("Specimens")));
  const std::string other = folder.write("b.csv", "a,b\n1,2\n").string();
  const ProgramRun without = run_program({"info", other, "--plot", page});
  EXPECT_EQ(without.status, 0);
  EXPECT_THAT(without.err, HasSubstr("holds no readings"));
}

TEST(InfoOfATable, TakesWorkbooks) {
  if (!reads_workbooks()) GTEST_SKIP() << "no liborcus";
  const TemporaryFolder folder;
  const std::vector<std::vector<std::string>> rows{
      {"Load (N)", "Ext (mm)"}, {"0", "0"}, {"4", "2"}};
  const std::string file =
      folder.write("warp.xlsx", test::workbook({{"A", rows}, {"B", rows}})).string();
  const std::string page = (folder.path() / "a.html").string();
  const ProgramRun run = run_program({"info", file, "--sheet", "B", "--plot", page});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("warp.xlsx: workbook"), HasSubstr("type: tensile-cycles"),
                             HasSubstr("sheet: B ")));
  EXPECT_THAT(content_of(page), HasSubstr("warp.xlsx"));
}

TEST(Commands, NameTheWayInForFilesOfAnotherKind) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& name, const std::string& content,
                        const std::string& command = "fit") {
    const std::string file = folder.write(name, content).string();
    const ProgramRun run = run_program({command, file, "-o", (folder.path() / "o").string()});
    EXPECT_EQ(run.status, 2);
    return run.err;
  };
  EXPECT_THAT(said("a.csv", kTable), HasSubstr("`pliant init --from"));
  EXPECT_THAT(said("a.xlsx", ""), HasSubstr("`pliant init --from"));
  EXPECT_THAT(said("a.JPG", ""), HasSubstr("`pliant import"));
  EXPECT_THAT(said("a.h5", ""), HasSubstr("saved as CSV"));
  EXPECT_THAT(said("a.obj", "", "simulate"), HasSubstr("is a mesh, not a scene/1"));
  EXPECT_THAT(said("m.json", R"({"pliant": "material/1"})"),
              HasSubstr("`pliant evaluate STUDY -m"));
  EXPECT_THAT(said("s.yaml", "pliant: scene/1\n"), HasSubstr("`pliant simulate"));
  EXPECT_THAT(said("s.yaml", "pliant: study/1\n", "lab"), HasSubstr("`pliant fit"));
  EXPECT_THAT(said("arc.json", R"({"stretching": [], "bending": []})"), HasSubstr("ARCSim"));
  EXPECT_THAT(said("results/fit.json", R"({"pliant": "fit/1"})"), HasSubstr("`pliant report`"));
  EXPECT_THAT(run_program({"fit", TemporaryFolder().path().string(), "-o", "o"}).err,
              HasSubstr("holds no study.yaml"));
}

TEST(Files, OfOtherKindsAreNamedWhereverATableIsMeant) {
  const TemporaryFolder folder;
  const std::string output = (folder.path() / "o").string();
  for (const auto& [name, kind] : std::vector<std::pair<std::string, std::string>>{
           {"a.jpg", "is a photograph"},
           {"a.h5", "is an HDF5 file"},
           {"a.xls", "is a workbook of another kind"}}) {
    const std::string file = folder.write(name, "\xFF\xD8").string();
    const std::string study = folder
                                  .write("study.yaml",
                                         "pliant: study/1\nname: a\nexperiments:\n  - {name: a, "
                                         "type: tensile-cycles, direction: warp, length: 10 cm, "
                                         "width: 5 cm, data: " +
                                             name + "}\n")
                                  .string();
    EXPECT_THAT(run_program({"info", file}).err, HasSubstr(kind));
    EXPECT_THAT(run_program({"init", "--from", file, "-o", output}).err, HasSubstr(kind));
    EXPECT_THAT(run_program({"fit", study, "-o", output}).err, HasSubstr(kind));
  }
  const std::string mesh = folder.write("pants.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n").string();
  EXPECT_THAT(run_program({"init", "--from", mesh, "-o", output}).err, HasSubstr("is a mesh"));
  const std::string arcsim =
      folder.write("arc.json", R"({"stretching": [], "bending": []})").string();
  EXPECT_THAT(run_program({"info", arcsim}).err, HasSubstr("is a material of ARCSim"));
}

TEST(Folders, AreTakenForTheOnlyStudyInThem) {
  const TemporaryFolder folder;
  folder.write("warp.csv", kTable);
  const ProgramRun tables = run_program({"fit", folder.path().string(), "-o", "o"});
  EXPECT_EQ(tables.status, 2);
  EXPECT_THAT(tables.err, HasSubstr("`pliant init --from " + (folder.path() / "warp.csv").string() +
                                    " -o DIR`"));
  folder.write("poplin.yaml",
               "pliant: study/1\nname: a\nexperiments:\n  - {name: a, type: tensile-cycles, "
               "direction: warp, length: 10 cm, width: 5 cm, data: warp.csv}\n");
  folder.write("scene.yaml", "pliant: scene/1\n");
  EXPECT_THAT(run_program({"info", folder.path().string()}).out, HasSubstr("poplin.yaml: study/1"));
  folder.write("jersey.yaml", "pliant: study/1\nname: b\n");
  EXPECT_THAT(run_program({"fit", folder.path().string(), "-o", "o"}).err,
              HasSubstr("several documents of type study; expected \"jersey.yaml\" or"));
}

TEST(Usage, NamesTheNearestCommandAndOption) {
  EXPECT_THAT(run_program({"fti"}).err, HasSubstr("did you mean \"fit\"?"));
  EXPECT_THAT(run_program({"inof"}).err, HasSubstr("did you mean \"info\"?"));
  EXPECT_THAT(
      run_program({"simulte"}).err,
      HasSubstr("no command \"simulte\" (did you mean \"simulate\"?); see `pliant --help`"));
  EXPECT_THAT(
      run_program({"fit", "a.yaml", "-o", "d", "--resum"}).err,
      HasSubstr("no option \"--resum\" (did you mean \"--resume\"?); see `pliant fit --help`"));
  EXPECT_THAT(run_program({"fit", "a.yaml"}).err, HasSubstr("see `pliant fit --help`"));
}

TEST(ExampleData, AreNoticed) {
  const TemporaryFolder folder;
  const std::string study = (folder.path() / "study").string();
  for (const auto& [name, content] : test_template("tensile-cycles")) {
    folder.write("study/" + name, content);
  }
  const ProgramRun fitted = run_program({"fit", study, "-o", study + "-fit"});
  EXPECT_THAT(fitted.err, HasSubstr("the data are still those of the example"));
  std::string data = content_of(folder.path() / "study" / "warp-cycles.csv");
  data.replace(data.find("0.088"), 5, "0.089");
  folder.write("study/warp-cycles.csv", data);
  EXPECT_THAT(run_program({"fit", study, "-o", study + "-fit"}).err,
              ::testing::Not(HasSubstr("the example")));
}

}  // namespace
}  // namespace pliant::test
