// Laws of solids on Treloar's and Kawabata's rubbers (1944, 1981: uniaxial and equibiaxial tension,
// pure shear); skipped where PLIANT_TEST_DATA does not hold them.

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"
#include "real/real_fit.h"

namespace pliant::test {
namespace {

constexpr std::array<std::array<const char*, 2>, 3> kModes{
    {{"uniaxial", "UT"}, {"equibiaxial", "ET"}, {"planar", "PS"}}};
constexpr std::array kLaws{"neo-hookean",  "mooney-rivlin", "yeoh",
                           "arruda-boyce", "ogden-3",       "additive"};

std::filesystem::path table(const std::string& rubber, const std::string& mode) {
  return measurement("rubber_hyperelastic/" + rubber + "_" + mode + ".txt");
}

/// The columns of a file, which blanks part, as a table: nominal stress (MPa) and stretch.
std::string csv_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::string text = "stretch,nominal_stress_MPa\n";
  for (double stress = 0, stretch = 0; stream >> stress >> stretch;) {
    text += fmt::format("{},{}\n", stretch, stress);
  }
  return text;
}

StudyResult fit(const std::string& rubber, const std::string& law, const std::string& validate) {
  const TemporaryFolder folder;
  std::string text = "pliant: study/1\nname: " + rubber + "\nexperiments:\n";
  for (const auto& [mode, file] : kModes) {
    const std::string csv = std::string(mode) + ".csv";
    folder.write(csv, csv_of(table(rubber, file)));
    text +=
        fmt::format("  - {{name: {}, type: homogeneous, mode: {}, data: {}}}\n", mode, mode, csv);
  }
  text += "model: {kind: solid, law: " + law + "}\n";
  if (!validate.empty()) text += "validate: [" + validate + "]\n";
  return fit_study(read_study(folder.write("study.yaml", text)), {}, {});
}

void print(const std::string& rubber, const std::string& law, const StudyResult& result) {
  fmt::print("{:<15} {:<14} {:2} numbers {:5.2f} s ", rubber, law, result.parameters.size(),
             result.seconds);
  for (const ExperimentResult& e : result.experiments) {
    fmt::print("  {}{} {:5.2f} % R^2 {:7.4f}", e.name,
               e.role == ExperimentRole::validate ? " (predicted)" : "", e.rms_percent,
               e.r_squared.value());
  }
  fmt::print("\n");
}

double worst(const StudyResult& result) {
  double least = 1;
  for (const ExperimentResult& e : result.experiments) least = std::min(least, *e.r_squared);
  return least;
}

TEST(RealRubber, IsMetByOgdensAndByConvexAdditiveEnergiesInEveryMode) {
  SKIP_WITHOUT(table("treloar_1944", "UT"));
  for (const char* rubber : {"treloar_1944", "kawabata_1981"}) {
    double ogden = 0;
    for (const char* law : kLaws) {
      const StudyResult result = fit(rubber, law, "");
      print(rubber, law, result);
      EXPECT_TRUE(result.converged) << law;
      if (std::string(law) == "ogden-3") ogden = worst(result);
      if (std::string(law) == "additive") {
        EXPECT_GE(worst(result), std::min(ogden, 0.99));
        for (const double value :
             result.material.components.at("stretch-bar").stiffness->values()) {
          EXPECT_GE(value, 0);
        }
      }
    }
    EXPECT_GE(ogden, 0.99);
  }
}

TEST(RealRubber, TwoModesPredictTheThird) {
  SKIP_WITHOUT(table("treloar_1944", "UT"));
  for (const char* rubber : {"treloar_1944", "kawabata_1981"}) {
    for (const auto& [mode, file] : kModes) {
      for (const char* law : kLaws) print(rubber, law, fit(rubber, law, mode));
    }
  }
}

}  // namespace
}  // namespace pliant::test
