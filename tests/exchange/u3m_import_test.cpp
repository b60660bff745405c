#include "pliant/exchange/u3m_import.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/io/csv.h"
#include "pliant/study/study.h"

#include "exchange/u3m_text.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::record;
using test::record_with;
using test::TemporaryFolder;
using test::test_json;
using test::TestText;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

std::string complete_direction() {
  return fmt::format(R"({{"S1": {0}, "S2": {0}, "D1": {0}, "D2": {0}, "U1": {0}}})", test_json());
}

ImportedStudy import_text(const std::string& text, const ImportOptions& options = {}) {
  const TemporaryFolder folder;
  return import_u3m(folder.write("fabric.json", text), options);
}

InputError refusal_of(const std::string& text) {
  return input_error_of([&] { import_text(text); });
}

Study study_of(const ImportedStudy& imported, const TemporaryFolder& folder) {
  for (const auto& [name, content] : imported.files) folder.write(name, content);
  return read_study(folder.write("study.yaml", imported.study_yaml));
}

std::vector<std::string> names_of(const Study& study) {
  std::vector<std::string> names;
  for (const ExperimentSpec& spec : study.experiments) names.push_back(spec.name);
  return names;
}

std::vector<std::string> all_names() {
  std::vector<std::string> names;
  for (const std::string direction : {"warp", "weft", "bias"}) {
    for (const char* test :
         {"stretch-8cm", "stretch-2cm", "bend-down-8cm", "bend-down-2cm", "bend-up-2cm"}) {
      names.push_back(direction + "-" + test);
    }
  }
  return names;
}

TEST(U3mImport, EveryTestBecomesAnExperimentThatTheStudyReaderAccepts) {
  const std::string direction = complete_direction();
  const ImportedStudy imported =
      import_text(record(fmt::format(R"({{"M": 150, "L": {0}, "W": {0}, "B": {0}}})", direction)));
  const TemporaryFolder folder;
  const Study study = study_of(imported, folder);
  EXPECT_EQ(names_of(study), all_names());
  EXPECT_THAT(imported.warnings, IsEmpty());
  EXPECT_DOUBLE_EQ(study.density, 0.150);
  EXPECT_THAT(study.validate, ElementsAre("*-stretch-2cm", "*-bend-down-8cm"));
  for (const ExperimentSpec& spec : study.experiments) {
    EXPECT_DOUBLE_EQ(spec.test->width, 0.05);
    EXPECT_DOUBLE_EQ(spec.test->length, 0.08);
    if (spec.name.find("bend") != std::string::npos) {
      EXPECT_EQ(spec.type, "buckling-bend");
      const bool up = spec.name.ends_with("up-2cm");
      EXPECT_EQ(spec_of<BucklingBendSpec>(spec).side, up ? BucklingSide::up : BucklingSide::down);
      continue;
    }
    EXPECT_EQ(read_experiment(spec, study)->rows(), 6);
  }
}

TEST(U3mImport, BendsOfAClothOfUnknownWeightAreLeftOut) {
  const std::string bends = fmt::format(R"("D1": {0}, "U1": {0})", test_json());
  const ImportedStudy imported =
      import_text(record(fmt::format(R"({{"L": {{"S2": {}, {}}}}})", test_json(), bends)));
  EXPECT_EQ(imported.files.size(), 1U);
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("warp-bend-up-2cm is left out")));
  EXPECT_THAT(refusal_of(record(fmt::format(R"({{"L": {{{}}}}})", bends))).problem(),
              HasSubstr("bends alone"));
}

TEST(U3mImport, CentimetresAndGramForceBecomeMillimetresAndNewtons) {
  const ImportedStudy imported = import_text(record_with({}));
  ASSERT_EQ(imported.files.size(), 1U);
  EXPECT_EQ(imported.files[0].first, "warp-stretch-8cm.csv");
  const CsvTable table = parse_csv(imported.files[0].second, "warp-stretch-8cm.csv");
  const std::vector<double> force = table.quantity("force", Dimension::force);
  const std::vector<double> length = table.quantity("length", Dimension::length);
  ASSERT_EQ(force.size(), 6U);
  EXPECT_DOUBLE_EQ(force[2], 0.030 * 9.80665);
  EXPECT_DOUBLE_EQ(length[2], 0.09);
}

TEST(U3mImport, CyclesArePairsOfSegments) {
  const std::string up = "[8.0, 0, 8.5, 10]", down = "[8.5, 9, 8.0, 0]";
  const ImportedStudy imported =
      import_text(record_with({.tree = fmt::format("[{0}, {1}, {0}, {1}, {0}]", up, down)}));
  const CsvTable table = parse_csv(imported.files[0].second, "warp.csv");
  EXPECT_THAT(table.integers("cycle"), ElementsAre(1, 1, 1, 1, 2, 2, 2, 2, 3, 3));
  EXPECT_THAT(imported.notes, Contains(HasSubstr("5 half cycles (the last cycle does not return")));
}

TEST(U3mImport, SegmentsThatMoveTheSameWayAreWarnedOf) {
  const std::string up = "[8.0, 0, 8.5, 10]";
  const ImportedStudy imported = import_text(record_with({.tree = fmt::format("[{0}, {0}]", up)}));
  EXPECT_THAT(imported.warnings,
              Contains(HasSubstr("half cycle 2 does not go back where 1 came from")));
}

TEST(U3mImport, NumbersMayBeTexts) {
  const ImportedStudy numbers = import_text(record_with({}));
  const ImportedStudy texts = import_text(record(
      R"({"M": "150", "L": {"S2": {"length": "8.0", "width": " 5 ", "freq": "50",
          "time": "1000000000", "samplesTree": [["8.0", "0", "8.5", "10", "9.0", "30"],
          ["8.9", "20", "8.4", "2", "8.05", "0"]]}}})"));
  EXPECT_EQ(texts.study_yaml, numbers.study_yaml);
  EXPECT_EQ(texts.files, numbers.files);
}

TEST(U3mImport, MissingBlocksAreWarnedOf) {
  const ImportedStudy imported = import_text(record(
      fmt::format(R"({{"M": 150, "L": {{"S2": {}, "S1": null}}, "W": null}})", test_json())));
  EXPECT_THAT(imported.warnings,
              ElementsAre("warp-stretch-2cm is missing: L of the file has no S1",
                          "warp-bend-down-8cm is missing: L of the file has no D2",
                          "warp-bend-down-2cm is missing: L of the file has no D1",
                          "warp-bend-up-2cm is missing: L of the file has no U1",
                          "nothing was measured along the weft: the file has no W",
                          "nothing was measured along the bias: the file has no B"));
  const TemporaryFolder folder;
  const Study study = study_of(imported, folder);
  EXPECT_THAT(names_of(study), ElementsAre("warp-stretch-8cm"));
  EXPECT_THAT(study.validate, IsEmpty());
}

TEST(U3mImport, AStretchAtTwoCentimetresIsFittedWhereItIsTheOnlyOne) {
  const ImportedStudy imported = import_text(record(fmt::format(
      R"({{"M": 150, "L": {{"S1": {0}, "S2": {0}}}, "W": {{"S1": {0}}}}})", test_json())));
  const TemporaryFolder folder;
  EXPECT_THAT(study_of(imported, folder).validate, ElementsAre("warp-stretch-2cm"));
}

TEST(U3mImport, ATestWithTooFewSamplesIsLeftOut) {
  const ImportedStudy imported = import_text(
      record(fmt::format(R"({{"M": 150, "L": {{"S2": {}, "S1": {}, "D1": {{"width": 5}}}}}})",
                         test_json(), test_json({.tree = "[[8.0, 0, 8.1, 1], []]"}))));
  EXPECT_EQ(imported.files.size(), 1U);
  EXPECT_THAT(imported.warnings, Contains("warp-stretch-2cm is left out: 2 samples show no curve"));
  EXPECT_THAT(imported.warnings,
              Contains("warp-bend-down-2cm is left out: 0 samples show no curve"));
}

TEST(U3mImport, TheDensityIsLeftOutWhenTheFileHasNone) {
  const ImportedStudy imported =
      import_text(record(fmt::format(R"({{"L": {{"S2": {}}}}})", test_json())));
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("no mass per area (M)")));
  EXPECT_THAT(imported.study_yaml, Not(HasSubstr("density")));
}

TEST(U3mImport, TheClampDistanceDefaultsToTheNominalOne) {
  const ImportedStudy imported = import_text(
      record(R"({"M": 150, "L": {"S2": {"width": 5, "samplesTree": [[8, 0, 9, 5, 8, 0]]}}})"));
  EXPECT_THAT(imported.warnings, Contains(HasSubstr("the nominal 8 cm is taken")));
  EXPECT_THAT(imported.study_yaml, HasSubstr("length: 80 mm"));
}

TEST(U3mImport, AWidthThatIsGivenReplacesTheFilesAndBothAreTold) {
  const ImportedStudy imported = import_text(record_with({}), {.width_m = 0.04});
  EXPECT_THAT(imported.study_yaml, HasSubstr("width: 40 mm"));
  EXPECT_THAT(imported.notes, Contains("strip width 4 cm (as given; the file tells 5 cm)"));
  EXPECT_THAT(import_text(record_with({})).notes, Contains("strip width 5 cm (from the file)"));
}

TEST(U3mImport, TheWidthOfADirectionHoldsForItsTests) {
  const ImportedStudy imported = import_text(
      record(R"({"M": 150, "L": {"width": 4, "S2": {"samplesTree": [[8, 0, 9, 5, 8, 0]]}}})"));
  EXPECT_THAT(imported.study_yaml, HasSubstr("width: 40 mm"));
}

TEST(U3mImport, WithoutAnyWidthTheImportAsksForOne) {
  const std::string text = record_with({.more = R"("freq": 50)"});
  EXPECT_THAT(refusal_of(text).problem(), HasSubstr("no strip width for warp-stretch-8cm"));
  EXPECT_THAT(import_text(text, {.width_m = 0.05}).study_yaml, HasSubstr("width: 50 mm"));
}

TEST(U3mImport, DatesAndTheOrderOfTheTestsAreKept) {
  const ImportedStudy imported = import_text(
      record(fmt::format(R"({{"M": 150, "L": {{"S1": {}, "S2": {}}}}})",
                         test_json({.more = R"("width": 5, "time": 1000000300)"}), test_json())));
  const TemporaryFolder folder;
  const Study study = study_of(imported, folder);
  EXPECT_EQ(study.info.at("tested_warp"), "2001-09-09T01:46:40Z to 2001-09-09T01:51:40Z");
  EXPECT_EQ(study.info.at("order_warp"), "stretch-8cm, stretch-2cm");
  EXPECT_EQ(study.info.at("sampling_stretch"), "50 Hz");
  EXPECT_THAT(imported.notes,
              Contains("warp: stretch-2cm came 300 s after stretch-8cm; on the same "
                       "strip, it was stretched before (`after: warp-stretch-8cm` follows it)"));
}

TEST(U3mImport, RowsGetTimesWhereThereAreNoPauses) {
  const std::string text =
      record(fmt::format(R"({{"M": 150, "L": {{"width": 5, "S2": {}}}}})", test_json()));
  const auto times = [&](bool without_pauses) {
    const ImportedStudy imported = import_text(text, {.without_pauses = without_pauses});
    const auto file = std::ranges::find(imported.files, std::string("warp-stretch-8cm.csv"),
                                        &std::pair<std::string, std::string>::first);
    return parse_csv(file->second, "warp-stretch-8cm.csv")
        .optional_quantity("time", Dimension::time);
  };
  EXPECT_FALSE(times(false).has_value());
  const auto seconds = times(true);
  ASSERT_TRUE(seconds.has_value());
  for (std::size_t i = 0; i < seconds->size(); ++i) {
    EXPECT_NEAR((*seconds)[i], static_cast<double>(i) / 50, 1e-12);
  }
}

TEST(U3mImport, TheVendorsSectionIsKeptAsInformation) {
  const std::string custom =
      R"({"acme": {"name": "Jersey: \"5\"", "company": "Acme", "stretch": {"length": "12.5"},
          "composition": [{"fiber_name": "Cotton", "percentage": 0.95}, {"fiber_name": "Wool"}],
          "shear": 3, "colour": "red"}})";
  const ImportedStudy imported =
      import_text(record(fmt::format(R"({{"M": 150, "L": {{"hwSerialNumber": 77, "S2": {}}},
      "warnings": {{"Bend": "low-force"}}}})",
                                     test_json()),
                         custom));
  const TemporaryFolder folder;
  const Study study = study_of(imported, folder);
  EXPECT_EQ(study.name, "Jersey: \"5\"");
  EXPECT_EQ(study.info.at("company"), "Acme");
  EXPECT_EQ(study.info.at("composition"), "Cotton 95 %, Wool");
  EXPECT_EQ(study.info.at("vendor_stretch_length"), "12.5 (vendor's own export)");
  EXPECT_EQ(study.info.at("vendor_shear"), "3 (vendor's own export)");
  EXPECT_EQ(study.info.at("hardware_serial"), "77");
  EXPECT_EQ(study.info.at("instrument_warnings"), "Bend: low-force");
  EXPECT_EQ(study.info.count("vendor_colour"), 0U);
}

TEST(U3mImport, AnEncryptedVendorSectionIsPassedOver) {
  const std::string raw = fmt::format(R"({{"M": 150, "L": {{"S2": {}}}}})", test_json());
  const ImportedStudy imported = import_text(record(raw, R"({"acme": "QUJD"})"));
  EXPECT_THAT(imported.study_yaml, HasSubstr("name: \"fabric\""));
}

TEST(U3mImport, ThicknessIsThatOfTheFirstContact) {
  const ImportedStudy imported = import_text(record(fmt::format(
      R"({{"M": 150, "L": {{"S2": {}}}, "T": {{"samplesTree": [[0.03, -100, 0.02, -200],
          [-0.001, -900]]}}}})",
      test_json())));
  EXPECT_THAT(imported.notes, Contains(HasSubstr("thickness 0.3 mm at 0.9807 N, first contact")));
}

TEST(U3mImport, AFileWithoutMeasurementsSaysSo) {
  for (const char* text :
       {R"({"schema": "1.1", "custom": null, "raw_data": null})", R"({"raw_data": {"M": 150}})",
        R"({"raw_data": {"M": 1, "L": {"S2": {"width": 5, "samplesTree": []}}}})", "{}", "[1, 2]",
        R"({"schema": "1.1", "material": {"name": "a", "physics": null}})",
        R"({"material": {"physics": {"devices": {"fab": "null"}}}})"}) {
    const InputError error = refusal_of(text);
    EXPECT_EQ(error.problem(), "has no raw measurements") << text;
    EXPECT_THAT(error.expected(), HasSubstr("raw_data with at least one of L, W, B")) << text;
  }
}

TEST(U3mImport, BadValuesAreRefusedWhereTheyStand) {
  struct Case {
    TestText text;
    const char* field;
    const char* problem;
  };
  const Case cases[] = {
      {{.tree = "[[8, 0, 9, 1, 10]]"}, "raw_data.L.S2.samplesTree[0]", "has 5 values"},
      {{.tree = "[[8, 0], [9, \"much\"]]"}, "raw_data.L.S2.samplesTree[1][1]", "\"much\""},
      {{.tree = "[[8, 0], [9, NaN]]"}, "", "invalid literal"},
      {{.tree = "[[8, \"nan\"]]"}, "raw_data.L.S2.samplesTree[0][1]", "not a finite number"},
      {{.tree = "[[8, null]]"}, "raw_data.L.S2.samplesTree[0][1]", "has no value"},
      {{.tree = "[[0, 1]]"}, "raw_data.L.S2.samplesTree[0][0]", "out of range"},
      {{.tree = "[[-8, 1]]"}, "raw_data.L.S2.samplesTree[0][0]", "out of range"},
      {{.tree = "[[8, 1e300]]"}, "raw_data.L.S2.samplesTree[0][1]", "out of range"},
      {{.tree = "[[[8, 1]]]"}, "raw_data.L.S2.samplesTree[0][0]", "is a list"},
      {{.tree = "[8, 1]"}, "raw_data.L.S2.samplesTree[0]", "is a single value"},
      {{.length = "0"}, "raw_data.L.S2.length", "out of range"},
      {{.length = "-2"}, "raw_data.L.S2.length", "out of range"},
      {{.more = R"("width": 0)"}, "raw_data.L.S2.width", "out of range"},
      {{.more = R"("width": 5, "freq": -1)"}, "raw_data.L.S2.freq", "out of range"},
      {{.more = R"("width": 5, "time": 1e20)"}, "raw_data.L.S2.time", "out of range"},
  };
  for (const Case& bad : cases) {
    const InputError error = refusal_of(record_with(bad.text));
    EXPECT_EQ(error.where().line, 3) << bad.problem;
    EXPECT_EQ(error.where().field, bad.field);
    EXPECT_THAT(error.what(), HasSubstr(bad.problem));
  }
}

TEST(U3mImport, AnAbsurdDensityIsRefused) {
  const std::string warp = fmt::format(R"("L": {{"S2": {}}})", test_json());
  EXPECT_EQ(refusal_of(record("{\"M\": -1, " + warp + "}")).where().field, "raw_data.M");
  EXPECT_EQ(refusal_of(record("{\"M\": [], " + warp + "}")).where().field, "raw_data.M");
}

TEST(U3mImport, AnotherMajorVersionIsRefusedAndAnotherMinorOneWarnedOf) {
  const std::string raw = fmt::format(R"({{"M": 150, "L": {{"S2": {}}}}})", test_json());
  const auto of_version = [&](const std::string& version) {
    return fmt::format(R"({{"schema": "{}", "raw_data": {}}})", version, raw);
  };
  EXPECT_EQ(refusal_of(of_version("2.0")).where().field, "schema");
  EXPECT_THAT(import_text(of_version("1.2")).warnings, Contains(HasSubstr("is read as 1.1")));
  EXPECT_THAT(import_text(fmt::format(R"({{"raw_data": {}}})", raw)).warnings,
              Contains(HasSubstr("does not say its version")));
}

TEST(U3mImport, TruncatedAndDeeplyNestedFilesAreRefused) {
  const std::string whole = record_with({});
  EXPECT_THROW(import_text(whole.substr(0, whole.size() / 2)), InputError);
  EXPECT_THROW(import_text("{\"raw_data\": " + std::string(100'000, '[')), InputError);
}

TEST(U3mImport, TheFuzzersFirstInputsGiveReadableStudiesOrAreRefused) {
  int imported = 0, refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(
           std::filesystem::path(PLIANT_SOURCE_DIR) / "tests/corpus/u3m")) {
    SCOPED_TRACE(entry.path().filename());
    ImportedStudy study;
    try {
      study = import_u3m(entry.path());
    } catch (const InputError& error) {
      EXPECT_EQ(error.where().file, entry.path().string());
      ++refused;
      continue;
    }
    const TemporaryFolder folder;
    EXPECT_NO_THROW(study_of(study, folder));
    ++imported;
  }
  EXPECT_EQ(imported, 4);
  EXPECT_EQ(refused, 5);
}

TEST(RealU3mImport, FabRecordOfACottonKnitIsRead) {
  const char* data = std::getenv("PLIANT_TEST_DATA");
  const auto file = std::filesystem::path(data == nullptr ? "" : data) /
                    "cloth_hysteresis_fab/fab_knit_cotton_300gsm.json";
  if (!std::filesystem::exists(file)) GTEST_SKIP() << "PLIANT_TEST_DATA does not hold " << file;
  ASSERT_TRUE(is_u3m(file));
  const ImportedStudy imported = import_u3m(file);
  const TemporaryFolder folder;
  const Study study = study_of(imported, folder);
  EXPECT_EQ(names_of(study), all_names());
  EXPECT_THAT(imported.warnings, IsEmpty());
  EXPECT_DOUBLE_EQ(study.density, 0.3);
  EXPECT_THAT(imported.notes, Contains("strip width 4 cm (from the file)"));

  struct Expected {
    const char* name;
    int rows;
    double peak;  // N
  };
  const Expected expected[] = {
      {"warp-stretch-8cm", 1519, 3.946}, {"warp-stretch-2cm", 1606, 2.837},
      {"weft-stretch-8cm", 1271, 1.939}, {"weft-stretch-2cm", 1609, 1.580},
      {"bias-stretch-8cm", 1569, 2.541}, {"bias-stretch-2cm", 1691, 1.817}};
  for (const auto& [name, rows, peak] : expected) {
    const auto spec = std::find_if(study.experiments.begin(), study.experiments.end(),
                                   [&](const ExperimentSpec& s) { return s.name == name; });
    ASSERT_NE(spec, study.experiments.end()) << name;
    const auto experiment = read_experiment(*spec, study);
    EXPECT_EQ(experiment->rows(), rows) << name;
    // The expected peaks are rounded to 1 mN.
    EXPECT_NEAR(experiment->measured().maxCoeff(), peak, 0.5e-3) << name;
    EXPECT_DOUBLE_EQ(spec->test->width, 0.04);
  }
}

}  // namespace
}  // namespace pliant
