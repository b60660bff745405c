// `pliant info`: what it finds out about a material's law, and what it says about each kind of
// file.

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sys/wait.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/schema_text.h"
#include "pliant/io/text_file.h"
#include "pliant/material/material_file.h"
#include "pliant/study/virtual_lab.h"

#include "apps/pliant/component_facts.h"
#include "apps/pliant/file_info.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant::test {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

namespace fs = std::filesystem;
using Json = nlohmann::json;

const fs::path kSource = PLIANT_SOURCE_DIR;

std::vector<StrainInterval> bending_snap(const std::string& material) {
  const Material m = read_material(kSource / "materials" / (material + ".json"));
  return facts_of(m.components.at("bend.warp")).friction->snapping;
}

// Strain is three times the curvature. Table 5.2: b reaches the elastic tangent k1 + 2 k2 strain.
TEST(Snapping, FeltSnapsBelowCurvatureFive) {
  const auto intervals = bending_snap("felt");
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_EQ(intervals[0].from, 0);
  EXPECT_NEAR(intervals[0].to / 3, (1.5e-5 - 1.453e-5) / (2 * 1.5e-8) / 3, 1e-9);
  EXPECT_EQ(std::lround(intervals[0].to / 3), 5);
}

TEST(Snapping, PaperSnapsBelowCurvatureFiftySeven) {
  const auto intervals = bending_snap("paper");
  ASSERT_EQ(intervals.size(), 1u);
  EXPECT_EQ(intervals[0].from, 0);
  EXPECT_EQ(std::lround(intervals[0].to / 3), 57);
}

MaterialComponent frictional(ScalarCurve stiffness, DahlParameters dahl) {
  MaterialComponent component;
  component.stiffness = std::move(stiffness);
  component.friction = ComponentFriction{dahl, {}};
  return component;
}

TEST(ComponentFacts, PersistentStrainOfALinearLawIsClosedForm) {
  const DahlParameters dahl{2.0, 3.0, 0.05};
  const ComponentFacts facts = facts_of(frictional(ScalarCurve::constant(100), dahl));
  // Saturated unloading comes to rest at (a + b tau) / (k - b); [T] 5.2.3 with b = 0: a / k.
  EXPECT_NEAR(*facts.friction->persistent_strain, (2 + 3 * 0.05) / (100 - 3), 1e-12);
  EXPECT_DOUBLE_EQ(facts.friction->appearance->persistent, 0.02);
  EXPECT_DOUBLE_EQ(facts.friction->appearance->saturation, 0.02 + 0.05 * std::log(40));
}

TEST(ComponentFacts, FrictionMayHoldEveryStrain) {
  const ComponentFacts facts = facts_of(frictional(ScalarCurve::constant(2), {1, 3, 0.1}));
  EXPECT_FALSE(facts.friction->persistent_strain.has_value());
}

TEST(ComponentFacts, StiffnessIsGivenAtTheEndOfTheRange) {
  MaterialComponent component = frictional(ScalarCurve::affine(4, 10), {1, 0, 0.01});
  EXPECT_FALSE(facts_of(component).at_end.has_value()) << "no range is stated";
  component.range = std::pair(0.0, 0.5);
  const ComponentFacts facts = facts_of(component);
  EXPECT_DOUBLE_EQ(facts.at_zero.secant, 4);
  EXPECT_DOUBLE_EQ(facts.at_end->secant, 9);
  EXPECT_DOUBLE_EQ(facts.at_end->tangent, 14);
  // Saturated after 50 tau: friction is a.
  EXPECT_NEAR(facts.at_end->loading, 9 + 1 / 0.5, 1e-12);
}

TEST(ComponentFacts, AHermiteCurveEndsAtItsLastControlPoint) {
  MaterialComponent component;
  component.stiffness = ScalarCurve::hermite({0, 0.2}, {10, 12});
  EXPECT_DOUBLE_EQ(facts_of(component).at_end->strain, 0.2);
  EXPECT_FALSE(facts_of(component).friction.has_value());
}

TEST(ComponentFacts, SidesOfFrictionAreToldApart) {
  MaterialComponent component = frictional(ScalarCurve::constant(10), {1, 0, 0.1});
  component.friction->negative = DahlParameters{2, 0, 0.1};
  const ComponentFacts facts = facts_of(component);
  EXPECT_DOUBLE_EQ(*facts.friction->persistent_strain, 0.1);
  EXPECT_DOUBLE_EQ(*facts.negative_friction->persistent_strain, 0.2);
}

/// A folder with virtual measurements of spandex: weights to fit, cycles to predict.
class SpandexFolder : public TemporaryFolder {
 public:
  SpandexFolder() {
    write("spandex.json", read_text_file(kSource / "materials" / "spandex.json"));
    const fs::path lab = write(
        "lab.yaml",
        "pliant: lab/1\nname: spandex\nmaterial: spandex.json\nexperiments:\n"
        "  - {name: weights, type: hanging-weights, direction: warp, peaks: [2 N, 4 N]}\n"
        "  - {name: cycles, type: tensile-cycles, direction: warp, peaks: [20 %], slack: 1 mm}\n"
        "validate: [cycles]\n");
    for (const auto& [name, content] : make_measurements(read_lab(lab), {})) write(name, content);
  }
};

TEST(Info, OfAStudyTellsWhatEachExperimentHoldsAndIsFor) {
  const SpandexFolder folder;
  const FileInfo info = describe_file(folder.path() / "study.yaml");
  EXPECT_EQ(info.json["type"], "study/1");
  const auto& weights = info.json["experiments"][0];
  EXPECT_EQ(weights["name"], "weights");
  EXPECT_EQ(weights["direction"], "warp");
  EXPECT_EQ(weights["component"], "stretch.warp");
  EXPECT_EQ(weights["role"], "fit");
  EXPECT_EQ(weights["rows"], 5 + 9);  // 0 1 2 1 0 and 0 1 2 3 4 3 2 1 0 N
  EXPECT_EQ(weights["specimens"].size(), 1u);
  EXPECT_EQ(weights["unloads"], true);
  EXPECT_EQ(weights["reversals"], 3);
  // The largest weight and half of the cloth's own: 0.157 kg/m^2 on 100 mm x 100 mm.
  EXPECT_NEAR(weights["peak_force"].get<double>(), 4 + 0.157 * 0.01 / 2 * 9.80665, 1e-12);
  const auto& cycles = info.json["experiments"][1];
  EXPECT_EQ(cycles["role"], "validate");
  EXPECT_THAT(cycles["estimated_along"], ElementsAre("cycles.force_offset"));
  EXPECT_NEAR(cycles["strain_range"][1].get<double>(), (1.2 * 1.2 - 1) / 2, 0.01);
}

TEST(Info, OfAStudyTellsWhatWillBeFittedAndWhy) {
  const SpandexFolder folder;
  const FileInfo info = describe_file(folder.path() / "study.yaml");
  ASSERT_EQ(info.json["fit"]["components"].size(), 1u);
  const auto& component = info.json["fit"]["components"][0];
  EXPECT_EQ(component["component"], "stretch.warp");
  EXPECT_EQ(component["stiffness"], "affine") << "only weights are fitted";
  EXPECT_EQ(component["friction"], "dahl");
  EXPECT_EQ(component["friction_because"], "the data unloads");
  EXPECT_THAT(info.lines,
              Contains(HasSubstr("affine stiffness, friction dahl (the data unloads)")));
}

std::string study_of(const std::string& experiments) {
  return "pliant: study/1\nname: x\ndefaults: {length: 100 mm, width: 50 mm}\nexperiments:\n" +
         experiments;
}

TEST(Info, OfDataThatOnlyLoadsTellsWhyThereIsNoFriction) {
  const TemporaryFolder folder;
  folder.write("up.csv", "force_N,length_mm\n0,100\n1,110\n2,118\n3,124\n");
  const fs::path file = folder.write(
      "study.yaml",
      study_of("  - {name: up, type: tensile-cycles, direction: weft, data: up.csv}\n"));
  const FileInfo info = describe_file(file);
  const auto& component = info.json["fit"]["components"][0];
  EXPECT_EQ(component["stiffness"], "hermite");
  EXPECT_EQ(component["control_points"], 5);
  EXPECT_EQ(component["friction"], "none");
  EXPECT_THAT(component["friction_because"].get<std::string>(), HasSubstr("only loads"));
  EXPECT_EQ(info.json["experiments"][0]["unloads"], false);
}

TEST(Info, LocatesMissingDataInTheStudyAndNamesAllOfIt) {
  const TemporaryFolder folder;
  const fs::path file =
      folder.write("study.yaml",
                   study_of("  - {name: a, type: tensile-cycles, direction: weft, data: a.csv}\n"
                            "  - {name: b, type: tensile-cycles, direction: warp, data: b.csv}\n"));
  const InputError error = input_error_of([&] { describe_file(file); });
  EXPECT_EQ(error.where().file, file.string());
  EXPECT_EQ(error.where().line, 5);
  EXPECT_EQ(error.where().field, "experiments[0].data");
  EXPECT_THAT(error.problem(),
              AllOf(HasSubstr("a.csv"), HasSubstr("b.csv"), HasSubstr("do not exist")));
}

TEST(Info, RunsTheFullReaderOnTheData) {
  const TemporaryFolder folder;
  folder.write("a.csv", "force_N,length_mm\n0,100\n1,nan\n2,110\n");
  const fs::path file =
      folder.write("study.yaml",
                   study_of("  - {name: a, type: tensile-cycles, direction: weft, data: a.csv}\n"));
  const InputError error = input_error_of([&] { describe_file(file); });
  EXPECT_EQ(error.where().file, (folder.path() / "a.csv").string());
  EXPECT_EQ(error.where().line, 3);
}

TEST(Info, OfAMaterialWarnsOfSnapping) {
  const FileInfo info = describe_file(kSource / "materials" / "paper.json");
  EXPECT_EQ(info.json["type"], "material/1");
  EXPECT_EQ(info.json["components"]["bend.weft"]["status"], "unmeasured");
  const auto& bend = info.json["components"]["bend.warp"];
  EXPECT_EQ(bend["units"]["stiffness"], "N m");
  EXPECT_NEAR(bend["friction"]["snaps_while_unloading"][0][1].get<double>() / 3, 57, 0.5);
  EXPECT_THAT(
      info.warnings,
      ElementsAre(AllOf(StartsWith("bend.warp is not monotone on unloading below curvature"),
                        HasSubstr("curvature 56.8"))));
}

TEST(Info, OfAMaterialTellsWhatTextileInstrumentsWouldRead) {
  const FileInfo info = describe_file(kSource / "materials" / "doublecloth.json");
  const auto& textile = info.json["components"]["bend.warp"]["textile"];
  // Saturated closed forms: 3 k1 + 1800 k2 and 2 (a + 300 b); friction settles within a tau of 8.
  const double rigidity = 3 * 62.19e-7 + 1800 * 0.07e-7,
               hysteresis = 2 * (12.84e-4 + 300 * 0.05e-4);
  EXPECT_NEAR(textile["kes_B_N_m"].get<double>(), rigidity, 1e-5 * rigidity);
  EXPECT_NEAR(textile["kes_B_gf_cm2_per_cm"].get<double>(), rigidity / 9.80665e-5, 1e-4);
  EXPECT_NEAR(textile["kes_2HB_gf_cm_per_cm"].get<double>(), hysteresis / 9.80665e-3, 1e-4);
  EXPECT_FALSE(textile["kes_beyond_range"].get<bool>());
  const double length = textile["bending_length_m"].get<double>();
  EXPECT_GT(length, std::cbrt(3 * 62.19e-7 / (0.255 * 9.80665)));  // friction stiffens
  EXPECT_NEAR(textile["flexural_rigidity_N_m"].get<double>(), 0.255 * 9.80665 * std::pow(length, 3),
              1e-12);
  EXPECT_THAT(info.lines, Contains(AllOf(HasSubstr("snaps on unloading"), HasSubstr("never"))));
  EXPECT_THAT(info.lines, Contains(AllOf(HasSubstr("KES bending B"), HasSubstr("gf cm^2/cm"))));
}

TEST(Info, OfAMaterialTellsTheSecantModuliOfATester) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("knit.json", R"({"pliant": "material/1", "name": "knit",
      "kind": "cloth", "components": {"stretch.warp": {"stiffness": {"curve": "constant", "value": 50},
      "range": [0, 0.22]}}})");
  const FileInfo info = describe_file(file);
  // At 10 % of extension: the force factor 1.1 times the Green strain 0.105 over 0.1.
  EXPECT_THAT(info.lines, Contains(AllOf(HasSubstr("secant modulus"),
                                         HasSubstr("57.75 N/m at 10 % extension"))));
  const auto& figures = info.json["components"]["stretch.warp"]["textile"]["figures"];
  EXPECT_EQ(figures[0]["name"], "secant_modulus");
  EXPECT_NEAR(figures[0]["value"].get<double>(), 57.75, 1e-9);
}

TEST(Info, OfAMaterialTellsStrainsInTheTermsOfATester) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("knit.json", R"({"pliant": "material/1", "name": "knit",
      "kind": "cloth", "components": {"stretch.warp": {"stiffness": {"curve": "constant", "value": 50},
      "range": [0, 0.22]}, "bend.warp": {"stiffness": {"curve": "constant", "value": 5e-6},
      "range": [0, 300]}}})");
  const FileInfo info = describe_file(file);
  EXPECT_THAT(info.lines, Contains(HasSubstr("up to 20 % extension (Green strain 22 %)")));
  EXPECT_THAT(info.lines, Contains(HasSubstr("up to curvature 100 1/m")));
}

TEST(Info, OfAMaterialTellsWhereBendingSnaps) {
  const FileInfo info = describe_file(kSource / "materials" / "felt.json");
  EXPECT_THAT(info.lines,
              Contains(AllOf(HasSubstr("snaps on unloading"), HasSubstr("below curvature 5.2"))));
}

TEST(Info, OfHingesTellsNoTextileNumbers) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("hinges.json", R"({"pliant": "material/1", "name": "h",
      "kind": "cloth", "density": 0.2, "bending_of": "hinges", "bending_mesh": "grid", "components":
      {"bend.warp": {"stiffness": {"curve": "constant", "value": 1e-5}}}})");
  EXPECT_FALSE(describe_file(file).json["components"]["bend.warp"].contains("textile"));
}

TEST(Info, OfASheetWithoutDensityTellsNoBendingLength) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("light.json", R"({"pliant": "material/1", "name": "light",
      "kind": "cloth", "components": {"bend.warp": {"stiffness": {"curve": "constant", "value": 1e-5},
      "range": [0, 300]}}})");
  const FileInfo info = describe_file(file);
  const auto& textile = info.json["components"]["bend.warp"]["textile"];
  EXPECT_TRUE(textile["bending_length_m"].is_null());
  EXPECT_TRUE(textile["kes_beyond_range"].get<bool>());
  EXPECT_NEAR(textile["kes_B_N_m"].get<double>(), 3e-5, 1e-15);
}

TEST(Info, OfEveryMaterialThatComesWithTheProgramIsGiven) {
  for (const auto& entry : fs::directory_iterator(kSource / "materials")) {
    EXPECT_NO_THROW(describe_file(entry.path())) << entry.path();
  }
}

TEST(Info, OfATableTellsUnitsRangesAndUse) {
  const TemporaryFolder folder;
  const FileInfo info = describe_file(folder.write(
      "t.csv", "force_cN;extension (mm);note;number\n0;0,5;first;1\n250;12,5;second;2\n"));
  EXPECT_EQ(info.json["type"], "csv");
  EXPECT_EQ(info.json["rows"], 2);
  const auto& columns = info.json["columns"];
  EXPECT_EQ(columns[0]["quantity"], "force");
  EXPECT_EQ(columns[0]["unit"], "cN");
  EXPECT_DOUBLE_EQ(columns[0]["max"].get<double>(), 2.5) << "in SI";
  EXPECT_DOUBLE_EQ(columns[1]["min"].get<double>(), 0.0005);
  EXPECT_EQ(columns[2]["different_texts"], 2);
  EXPECT_EQ(columns[3]["max"], 2.0);
  EXPECT_THAT(info.json["usable_as"], ElementsAre("tensile-cycles"));
  EXPECT_THAT(info.lines, Contains(HasSubstr("0 to 250 cN")));
}

TEST(Info, OfATableRefusesWhatIsNoNumberWhereAQuantityStands) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("t.csv", "force_N,length_mm\n1,2\n1,x\n");
  EXPECT_EQ(input_error_of([&] { describe_file(file); }).where().line, 3);
}

TEST(Info, OfAnInstrumentFileListsItsTests) {
  const FileInfo info = describe_file(kSource / "tests" / "corpus" / "u3m" / "two_directions.json");
  EXPECT_EQ(info.json["type"], "u3m");
  EXPECT_FALSE(info.json["tests"].empty());
  EXPECT_TRUE(info.json["tests"][0].contains("force_range"));
}

TEST(Info, OfALabTellsItsExperiments) {
  const SpandexFolder folder;
  const FileInfo info = describe_file(folder.path() / "lab.yaml");
  EXPECT_EQ(info.json["type"], "lab/1");
  EXPECT_EQ(info.json["experiments"].size(), 2u);
  EXPECT_THAT(info.lines, Contains(HasSubstr("2 N, 4 N; 1 repeat")));
}

TEST(Info, RefusesWhatIsNoneOfPliantsFiles) {
  const TemporaryFolder folder;
  const auto problem = [&](const fs::path& file) {
    return input_error_of([&] { describe_file(file); }).problem();
  };
  EXPECT_THAT(problem(folder.write("a.yaml", "pliant: recipe/1\n")), HasSubstr("unknown type"));
  EXPECT_THAT(problem(folder.write("b.yaml", "name: x\n")), HasSubstr("is missing"));
  EXPECT_THAT(problem(folder.write("c.json", "{\"pliant\": \"study/1\"")), testing::Not(IsEmpty()));
  EXPECT_THAT(problem(folder.write("d.yaml", "pliant: study/9\nname: x\n")), HasSubstr("version"));
  EXPECT_THAT(problem(folder.write("e.bin", "")), HasSubstr("empty"));
  EXPECT_THAT(problem(TemporaryFolder().path()), HasSubstr("holds no study.yaml"));
  EXPECT_THAT(problem(folder.path() / "none.yaml"), HasSubstr("cannot be read"));
}

TEST(Info, TellsADocumentByItsContentWhereTheNameSaysNothing) {
  const TemporaryFolder folder;
  const std::string material = read_text_file(kSource / "materials" / "spandex.json");
  EXPECT_EQ(describe_file(folder.write("material", material)).json["type"], "material/1");
  folder.write("spandex.json", material);
  const std::string lab =
      "# a lab\npliant: lab/1\nmaterial: spandex.json\nexperiments:\n"
      "  - {name: w, type: hanging-weights, direction: warp, peaks: [2 N]}\n";
  EXPECT_EQ(describe_file(folder.write("lab", lab)).json["type"], "lab/1");
  EXPECT_EQ(describe_file(folder.write("table", "a,b\n1,2\n")).json["type"], "csv");
}

/// What a run of the program printed and how it ended.
struct ShellRun {
  std::string output;
  int status = -1;
};

/// @param arguments  as for a shell; standard error goes where they send it
ShellRun run_in_shell(const std::string& arguments) {
  ShellRun run;
  FILE* pipe = ::popen(("'" PLIANT_EXECUTABLE "' " + arguments).c_str(), "r");
  std::array<char, 4096> part{};
  while (const std::size_t size = std::fread(part.data(), 1, part.size(), pipe)) {
    run.output.append(part.data(), size);
  }
  const int ended = ::pclose(pipe);
  run.status = WIFEXITED(ended) ? WEXITSTATUS(ended) : -1;
  return run;
}

TEST(InfoCommand, PrintsTheDescriptionOnStandardOutput) {
  const std::string file = (kSource / "materials" / "spandex.json").string();
  const ShellRun run = run_in_shell("info '" + file + "' 2>/dev/null");
  EXPECT_EQ(run.status, 0);
  EXPECT_THAT(run.output, AllOf(StartsWith(file + ": material/1\n"), HasSubstr("157 g/m^2")));
}

TEST(InfoCommand, PrintsOneJsonObjectAndNothingElse) {
  const std::string file = (kSource / "materials" / "felt.json").string();
  const ShellRun run = run_in_shell("info --json '" + file + "' 2>/dev/null");
  EXPECT_EQ(run.status, 0);
  EXPECT_EQ(Json::parse(run.output)["name"], "felt");
}

TEST(InfoCommand, IsSilentOnRequest) {
  const std::string file = (kSource / "materials" / "spandex.json").string();
  EXPECT_EQ(run_in_shell("info --quiet '" + file + "' 2>/dev/null").output, "");
}

TEST(InfoCommand, PrintsEverySchema) {
  for (const std::string& type : schema_types()) {
    const ShellRun run = run_in_shell("info --schema " + type);
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.output, schema_text(type));
  }
}

TEST(InfoCommand, RefusesWithALocatedLineAndStatusTwo) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("study.yaml", "pliant: study/1\nname: x\nexperimets: []\n");
  const ShellRun run = run_in_shell("info '" + file.string() + "' 2>&1");
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.output, StartsWith("error: " + file.string() + ":"));
  EXPECT_EQ(std::count(run.output.begin(), run.output.end(), '\n'), 1);
  for (const char* arguments : {"info", "info --schema studies", "info --schema study x.yaml"}) {
    EXPECT_EQ(run_in_shell(std::string(arguments) + " 2>/dev/null").status, 2) << arguments;
  }
}

TEST(InfoCommand, DescribesTheResultsOfTheOtherCommands) {
  const SpandexFolder folder;
  const std::string base = folder.path().string();
  const auto json_of = [&](const std::string& name) {
    const ShellRun run = run_in_shell("info --json '" + base + "/" + name + "' 2>/dev/null");
    EXPECT_EQ(run.status, 0) << name;
    return Json::parse(run.output);
  };
  ASSERT_EQ(run_in_shell("fit --quiet '" + base + "/study.yaml' -o '" + base + "/fit'").status, 0);
  const Json fit = json_of("fit");
  EXPECT_EQ(fit["type"], "fit/1 results");
  EXPECT_EQ(fit["made_by"], "fit");
  EXPECT_EQ(fit["parameters"].size(), 5u);
  EXPECT_EQ(json_of("fit/fit.json")["type"], "fit/1");
  EXPECT_EQ(json_of("fit/study.resolved.yaml")["fit"]["estimator"], "path");
  EXPECT_EQ(json_of("fit/predictions/cycles.csv")["type"], "csv");
  EXPECT_EQ(json_of("fit/parameters.csv")["rows"], 5);

  ASSERT_EQ(run_in_shell("evaluate --quiet '" + base + "/study.yaml' -m '" + base +
                         "/fit/material.json' -o '" + base + "/evaluation'")
                .status,
            0);
  EXPECT_EQ(json_of("evaluation")["type"], "evaluation/1 results");

  ASSERT_EQ(run_in_shell("lab --quiet '" + base + "/lab.yaml' -o '" + base + "/lab'").status, 0);
  EXPECT_EQ(json_of("lab")["made_by"], "lab");

  fs::remove(folder.path() / "fit" / "curves.csv");
  const ShellRun broken = run_in_shell("info '" + base + "/fit' 2>&1");
  EXPECT_EQ(broken.status, 2);
  EXPECT_THAT(broken.output, HasSubstr("curves.csv: is missing"));
}

}  // namespace
}  // namespace pliant::test
