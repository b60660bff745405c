// Files of testers with one slip each, of a unit, a column or a size: what is asked names it. The
// fabrics are made up, with the weights and stiffnesses of real ones; without a slip nothing is
// asked of them.

#include <cmath>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/study/study_experiments.h"
#include "pliant/study/test_template.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Fabric {
  std::string name;
  double density;  // g/m^2
  double tension;  // N/m, the largest of its test
  double strain;   // there, %
  double bending;  // N m
  double shear;    // N/m at 8 degrees
};

void PrintTo(const Fabric& fabric, std::ostream* out) { *out << fabric.name; }

const Fabric kSilk{"silk", 36, 500, 3.5, 1.2e-6, 2.4};
const Fabric kCotton{"cotton", 120, 2000, 6, 6e-6, 8};
const Fabric kDenim{"denim", 400, 4000, 5, 6e-5, 24};
const Fabric kJersey{"jersey", 180, 100, 50, 2.5e-6, 4};
// Pulled as far as Kawabata and cameras do, not to where they break.
const Fabric kPoplin{"poplin", 120, 270, 6, 6e-6, 8};
const Fabric kDenimAtEase{"denim_at_ease", 400, 570, 5, 6e-5, 24};
const Fabric kShirting{"shirting", 150, 490, 1.2, 6e-6, 8};
const Fabric kTerry{"terry", 300, 95, 62, 6e-6, 8};
const Fabric kFelt{"felt", 1300, 2000, 1, 1e-3, 200};

/// Steps of a cycle as shares of its largest, there and back.
std::vector<std::pair<double, bool>> cycle() {
  std::vector<std::pair<double, bool>> steps;
  for (int i = 0; i <= 20; ++i) steps.emplace_back(i / 20.0, true);
  for (int i = 19; i >= 0; --i) steps.emplace_back(i / 20.0, false);
  return steps;
}

/// Cloth stiffens, and gives less back than it took.
double carried(double share, bool loading) {
  return loading ? 0.4 * share + 0.6 * std::pow(share, 3) : 0.2 * share + 0.8 * std::pow(share, 4);
}

/// A column: its header and what is written for an SI value.
struct Column {
  std::string header;
  double per_si = 1;
  double offset = 0;
};

std::string table(const Column& first, const Column& second,
                  const std::function<std::pair<double, double>(double, bool)>& row) {
  std::string text = first.header + "," + second.header + "\n";
  for (const auto& [share, loading] : cycle()) {
    const auto [a, b] = row(share, loading);
    text += fmt::format("{:.6g},{:.6g}\n", first.per_si * a + first.offset,
                        second.per_si * b + second.offset);
  }
  return text;
}

const Column kForce{"force_N"};
const Column kExtension{"extension_mm", 1e3};
constexpr double kLength = 0.2, kWidth = 0.05;  // m

std::string pull(const Fabric& fabric, const Column& force = kForce,
                 const Column& stretch = kExtension) {
  return table(force, stretch, [&](double share, bool loading) {
    return std::pair{fabric.tension * kWidth * carried(share, loading),
                     kLength * fabric.strain / 100 * share};
  });
}

/// Up to 5 N, as far as that stretches a soft fabric.
std::string hang(const Fabric& fabric, const Column& weight = {"weight_N"}) {
  return table(weight, {"length_mm", 1e3}, [&](double share, bool loading) {
    const double stretch = loading ? share : std::sqrt(share);
    return std::pair{5 * share, kLength * (1 + fabric.strain / 100 * stretch)};
  });
}

std::string shear(const Fabric& fabric, const Column& angle = {"angle_deg", 180 / 3.14159265},
                  const Column& force = {"force_N_per_m"}) {
  return table(angle, force, [&](double share, bool loading) {
    return std::pair{share * 8 / 180 * 3.14159265, fabric.shear * carried(share, loading)};
  });
}

std::string bend(const Fabric& fabric, const Column& curvature = {"curvature_1_per_m"},
                 const Column& moment = {"moment_N"}) {
  return table(curvature, moment, [&](double share, bool loading) {
    return std::pair{250 * share, fabric.bending * 250 * carried(share, loading)};
  });
}

/// Overhangs are two bending lengths.
std::string push(const Fabric& fabric, const Column& overhang = {"overhang_mm", 1e3}) {
  const double length = std::cbrt(fabric.bending / (fabric.density * 1e-3 * 9.81));
  std::string text = overhang.header + ",repeat\n";
  for (int i = 1; i <= 4; ++i) {
    text += fmt::format("{:.4g},{}\n", 2 * length * (0.97 + 0.01 * i) * overhang.per_si, i);
  }
  return text;
}

std::string study_of(const Fabric& fabric, const std::string& type, const std::string& own = "",
                     const std::string& density = "") {
  return fmt::format(
      "pliant: study/1\nname: {}\ndensity: {}\nexperiments:\n  - {{name: one, type: {}, data: "
      "one.csv{}{}}}\n",
      fabric.name, density.empty() ? fmt::format("{} g/m^2", fabric.density) : density, type,
      type == "shear-cycles" ? "" : ", direction: warp", own);
}

const std::string kStrip = ", length: 200 mm, width: 50 mm";

/// All that a study and its data are asked.
std::vector<std::string> questions(const std::string& study, const std::string& csv) {
  const TemporaryFolder folder;
  folder.write("one.csv", csv);
  const Study read = read_study(folder.write("study.yaml", study));
  StudyResult result = describe(read);
  read_experiments(read, result);
  return result.questions;
}

class PlausibleFabric : public ::testing::TestWithParam<Fabric> {};

TEST_P(PlausibleFabric, IsNotQuestioned) {
  const Fabric& fabric = GetParam();
  EXPECT_THAT(questions(study_of(fabric, "tensile-cycles", kStrip), pull(fabric)), IsEmpty());
  EXPECT_THAT(questions(study_of(fabric, "hanging-weights", kStrip), hang(fabric)), IsEmpty());
  EXPECT_THAT(questions(study_of(fabric, "shear-cycles"), shear(fabric)), IsEmpty());
  EXPECT_THAT(questions(study_of(fabric, "pure-bending"), bend(fabric)), IsEmpty());
  EXPECT_THAT(questions(study_of(fabric, "bending-length"), push(fabric)), IsEmpty());
}

INSTANTIATE_TEST_SUITE_P(Of, PlausibleFabric,
                         ::testing::Values(kSilk, kCotton, kDenim, kJersey, kPoplin, kDenimAtEase,
                                           kShirting, kTerry, kFelt),
                         [](const auto& instance) { return instance.param.name; });

struct Slip {
  std::string name, study, csv;
  std::string named;  ///< in what is asked
};

void PrintTo(const Slip& slip, std::ostream* out) { *out << slip.name; }

std::string tensile(const Fabric& fabric) { return study_of(fabric, "tensile-cycles", kStrip); }

const std::vector<Slip> kSlips{
    {"MetresReadAsMillimetres", tensile(kCotton), pull(kCotton, kForce, {"extension_mm", 1}),
     "`extension` in m, not mm"},
    {"MillimetresReadAsMetres", tensile(kSilk), pull(kSilk, kForce, {"extension_m", 1e3}),
     "`extension` in mm, not m"},
    {"CentimetresReadAsMillimetres", tensile(kCotton), pull(kCotton, kForce, {"extension_mm", 100}),
     "`extension` in cm, not mm"},
    {"KilonewtonsReadAsNewtons", tensile(kDenim), pull(kDenim, {"force_N", 1e-3}),
     "`force` in kN, not N"},
    {"NewtonsReadAsKilonewtons", tensile(kJersey), pull(kJersey, {"force_kN", 1}),
     "`force` in N, not kN"},
    {"GramsReadAsNewtons", tensile(kSilk), pull(kSilk, {"force_N", 1000 / 9.81}),
     "`force` in gf, not N"},
    {"NewtonsReadAsGrams", tensile(kJersey), pull(kJersey, {"force_gf", 1}),
     "`force` in N, not gf"},
    {"DistanceOfTheClampsAsExtension", tensile(kCotton),
     pull(kCotton, kForce, {"extension_mm", 1e3, 200}), "an absolute length"},
    {"ExtensionAsDistanceOfTheClamps", tensile(kDenim),
     pull(kDenim, kForce, {"length_mm", 1e3, 0.05}), "is it an extension"},
    {"ClampsInCentimetres", tensile(kJersey), pull(kJersey, kForce, {"length_mm", 100, 20}),
     "`length` in cm, not mm"},
    {"SwappedColumns", tensile(kCotton), pull(kCotton, {"extension_mm"}, {"force_N", 1e3}),
     "`extension` and `force` swapped"},
    {"WidthInCentimetres", study_of(kSilk, "tensile-cycles", ", length: 200 mm, width: 50 cm"),
     pull(kSilk), "`width` 50 mm, not 500 mm"},
    {"GaugeLengthInCentimetres",
     study_of(kDenim, "tensile-cycles", ", length: 200 cm, width: 50 mm"), pull(kDenim),
     "`length` 200 mm, not 2 m"},
    {"DensityInKilograms", study_of(kCotton, "tensile-cycles", kStrip, "120 kg/m^2"), pull(kCotton),
     "`density` 120 g/m^2, not"},
    {"DensityInOunces", study_of(kSilk, "tensile-cycles", kStrip, "1.06 g/m^2"), pull(kSilk),
     "`density` 35.94 g/m^2, not 1.06 g/m^2"},
    {"SharesReadAsPerCent", tensile(kSilk), pull(kSilk, kForce, {"strain_%", 1 / kLength}),
     "`strain` a fraction, not %"},
    {"HungGramsReadAsNewtons", study_of(kJersey, "hanging-weights", kStrip),
     hang(kJersey, {"weight_N", 1000 / 9.81}), "`weight` in gf, not N"},
    {"HungNewtonsReadAsGrams", study_of(kJersey, "hanging-weights", kStrip),
     hang(kJersey, {"weight_g", 1}), "`weight` in N, not gf"},
    {"ClipHeavierThanAllWeights",
     study_of(kCotton, "hanging-weights", kStrip + ", clip_mass: 20 g"),
     hang(kCotton, {"weight_g", 1}), "`weight` in N, not gf"},
    {"ClipInKilograms", study_of(kJersey, "hanging-weights", kStrip + ", clip_mass: 20 kg"),
     hang(kJersey), "`clip_mass` 20 g, not 20 kg"},
    {"RadiansReadAsDegrees", study_of(kSilk, "shear-cycles"), shear(kSilk, {"angle_deg", 1}),
     "`angle` in rad, not deg"},
    {"NewtonsPerCentimetre", study_of(kDenim, "shear-cycles"),
     shear(kDenim, {"angle_deg", 180 / 3.14159265}, {"force_N_per_m", 0.01}),
     "`force` in N/cm, not N/m"},
    {"CurvaturePerCentimetre", study_of(kCotton, "pure-bending"),
     bend(kCotton, {"curvature_1_per_m", 0.01}), "`curvature` in 1/cm, not 1/m"},
    {"MillinewtonsReadAsNewtons", study_of(kDenim, "pure-bending"),
     bend(kDenim, {"curvature_1_per_m"}, {"moment_N", 1e3}), "`moment` in mN, not N"},
    {"CentimetresOfALittlePulledWeave", tensile(kPoplin),
     pull(kPoplin, kForce, {"extension_mm", 100}), "`extension` in cm, not mm"},
    {"LittleForceReadAsGrams", tensile(kPoplin), pull(kPoplin, {"force_gf", 1}),
     "`force` in N, not gf"},
    {"LittleForceReadAsCentinewtons", tensile(kDenimAtEase), pull(kDenimAtEase, {"force_cN", 1}),
     "`force` in N, not cN"},
    {"CentinewtonsOfAKnit", tensile(kJersey), pull(kJersey, {"force_N", 100}),
     "`force` in cN, not N"},
    {"MillimetresOfAKnitReadAsCentimetres", tensile(kJersey),
     pull(kJersey, kForce, {"extension_cm", 1e3}), "`extension` in mm, not cm"},
    {"WidthOfAThread", study_of(kPoplin, "tensile-cycles", ", length: 200 mm, width: 5 mm"),
     pull(kPoplin), "`width` 50 mm, not 5 mm"},
    {"DensityOfATissue", study_of(kPoplin, "tensile-cycles", kStrip, "12 g/m^2"), pull(kPoplin),
     "`density` 120 g/m^2, not 12 g/m^2"},
    {"DensityOfABlanket", study_of(kPoplin, "tensile-cycles", kStrip, "1200 g/m^2"), pull(kPoplin),
     "`density` 120 g/m^2, not 1200 g/m^2"},
    {"OverhangInCentimetres", study_of(kSilk, "bending-length"), push(kSilk, {"overhang_mm", 100}),
     "`overhang` in cm, not mm"},
};

class UnitSlip : public ::testing::TestWithParam<Slip> {};

TEST_P(UnitSlip, IsNamed) {
  EXPECT_THAT(questions(GetParam().study, GetParam().csv),
              ElementsAre(HasSubstr(GetParam().named)));
}

INSTANTIATE_TEST_SUITE_P(Of, UnitSlip, ::testing::ValuesIn(kSlips),
                         [](const auto& instance) { return instance.param.name; });

TEST(SlipOfALength, ThatBeginsAtZeroIsAskedAboutWhereItIsRefused) {
  const std::string csv = pull(kCotton, kForce, {"length_mm", 1e3});
  EXPECT_THAT(test::input_error_of([&] { questions(tensile(kCotton), csv); }).what(),
              HasSubstr("is it an extension, counted from the gauge length"));
}

TEST(SlipOfASize, OtherwiseThanInTheTestersFileIsNamed) {
  const std::string csv = "Length;100.00;mm\n" + pull(kCotton);
  EXPECT_THAT(questions(study_of(kCotton, "tensile-cycles", kStrip), csv),
              ElementsAre(HasSubstr("one: the study states a length of 200 mm, the data 100 mm "
                                    "from line 1 of one.csv (Length;100.00;mm): which is right?")));
  EXPECT_THAT(questions(study_of(kCotton, "tensile-cycles", ", length: 101 mm, width: 50 mm"), csv),
              IsEmpty());
}

/// What is asked of the example of a test whose files were changed.
std::vector<std::string> questions_of_example(
    const std::string& type,
    const std::function<void(std::string& study, std::string& csv)>& slip) {
  const TemporaryFolder folder;
  TestFiles files = test_template(type);
  std::string *study = nullptr, *csv = nullptr;
  for (auto& [name, content] : files) {
    if (name == "study.yaml") study = &content;
    if (name.ends_with(".csv")) csv = &content;
  }
  slip(*study, *csv);
  for (const auto& [name, content] : files) folder.write(name, content);
  const Study read = read_study(folder.path() / "study.yaml");
  StudyResult result = describe(read);
  read_experiments(read, result);
  return result.questions;
}

void replace(const std::string& from, const std::string& to, std::string& text) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// Turns the sign of the last cell of each row.
void mirror_last_column(std::string& csv) {
  std::size_t line = csv.find("\n", csv.find("point,"));
  while (line != std::string::npos && line + 1 < csv.size()) {
    const std::size_t end = csv.find('\n', line + 1);
    const std::size_t cell = csv.rfind(',', end) + 1;
    const bool negative = csv[cell] == '-';
    csv.replace(cell, negative ? 1 : 0, negative ? "" : "-");
    line = csv.find('\n', cell);
  }
}

TEST(SlipOfAProfile, InCentimetresIsNamed) {
  EXPECT_THAT(questions_of_example(
                  "cantilever", [](std::string&, std::string& csv) { replace("_mm", "_cm", csv); }),
              ElementsAre(HasSubstr("`overhang`, `x` and `y` in mm, not cm")));
}

TEST(SlipOfAProfile, CountedDownwardsIsNamed) {
  const auto mirror = [](std::string&, std::string& csv) { mirror_last_column(csv); };
  EXPECT_THAT(questions_of_example("cantilever", mirror),
              ElementsAre(HasSubstr("is `y` counted downwards, as in pictures?")));
  EXPECT_THAT(questions_of_example("rolled-strip", mirror),
              ElementsAre(HasSubstr("is `y` counted downwards, as in pictures,")));
}

TEST(SlipOfAProfile, SwappedAxesAreNamed) {
  EXPECT_THAT(questions_of_example(
                  "cantilever",
                  [](std::string&, std::string& csv) { replace("x_mm,y_mm", "y_mm,x_mm", csv); }),
              ElementsAre(HasSubstr("are the columns `x` and `y` swapped")));
}

TEST(SlipOfABuckledStrip, MillinewtonsReadAsNewtonsAreNamed) {
  EXPECT_THAT(questions_of_example(
                  "buckling-bend",
                  [](std::string&, std::string& csv) { replace("force_N", "force_kN", csv); }),
              ElementsAre(HasSubstr("`force` in N, not kN")));
}

TEST(SlipOfTime, MillisecondsReadAsSecondsAreNamed) {
  std::string csv = "time_s,force_N,extension_mm\n";
  for (int i = 0; i <= 20; ++i) csv += fmt::format("{},{},{}\n", 1500 * i, 5 * i, 0.6 * i);
  EXPECT_THAT(questions(tensile(kCotton), csv), IsEmpty()) << "a creeping test";
  csv = "time_ms,force_N,extension_mm\n";
  for (int i = 0; i <= 20; ++i) csv += fmt::format("{},{},{}\n", i, 5 * i, 0.6 * i);
  EXPECT_THAT(questions(tensile(kCotton), csv), ElementsAre(HasSubstr("`time` in s, not ms")));
}

}  // namespace
}  // namespace pliant
