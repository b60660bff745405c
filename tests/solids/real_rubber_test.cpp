// Laws of solids on real polymers: Treloar's and Kawabata's rubbers (1944, 1981: uniaxial and
// equibiaxial tension, pure shear), silicones, a cyclic elastomer; skipped where PLIANT_TEST_DATA
// does not hold them.

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

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

/// @param model  of the study: "law: yeoh"
StudyResult fit_model(const std::string& rubber, const std::string& model,
                      const std::string& validate) {
  const TemporaryFolder folder;
  std::string text = "pliant: study/1\nname: " + rubber + "\nexperiments:\n";
  for (const auto& [mode, file] : kModes) {
    const std::string csv = std::string(mode) + ".csv";
    folder.write(csv, csv_of(table(rubber, file)));
    text +=
        fmt::format("  - {{name: {}, type: homogeneous, mode: {}, data: {}}}\n", mode, mode, csv);
  }
  text += "model: {kind: solid, " + model + "}\n";
  if (!validate.empty()) text += "validate: [" + validate + "]\n";
  return fit_study(read_study(folder.write("study.yaml", text)), {}, {});
}

StudyResult fit(const std::string& rubber, const std::string& law, const std::string& validate) {
  return fit_model(rubber, "law: " + law, validate);
}

void print(const std::string& rubber, const std::string& law, const StudyResult& result) {
  fmt::print("{:<15} {:<14} {:2} numbers {:5.2f} s ", rubber, law, result.parameters.size(),
             result.seconds);
  for (const ExperimentResult& e : result.experiments) {
    fmt::print("  {}{} {:5.2f} % R^2 {:7.4f}", e.name,
               e.role == ExperimentRole::validate ? " (predicted)" : "", e.rms_percent,
               e.r_squared.value());
  }
  for (const ExperimentResult& e : result.experiments) {
    for (const std::string& line : e.handled) {
      if (line.find("the prediction") != line.npos) fmt::print("\n    {}: {}", e.name, line);
    }
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
        EXPECT_GE(worst(result), 0.99);
        for (const double value :
             result.material.components.at("stretch-bar").stiffness->values()) {
          EXPECT_GE(value, 0);
        }
      }
    }
    EXPECT_GE(ogden, 0.99);
    // [T] 4.2.2: cubic Hermite energies in place of splines.
    const StudyResult hermite =
        fit_model(rubber,
                  "components: {stretch-bar: {stiffness: energy, addends: [linear]}, I2-bar: "
                  "{addends: [linear]}}",
                  "");
    print(rubber, "Hermite energy", hermite);
    EXPECT_GE(worst(hermite), 0.99);
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

/// Rows of a text file whose cells are all numbers.
std::vector<std::vector<double>> numbers_in(const std::filesystem::path& file, char separator) {
  std::ifstream stream(file);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(stream, line);) {
    std::erase(line, '"');
    std::istringstream cells(line);
    std::vector<double> row;
    bool all = true;
    for (std::string cell; std::getline(cells, cell, separator);) {
      char* end = nullptr;
      row.push_back(std::strtod(cell.c_str(), &end));
      all = all && end != cell.c_str();
    }
    if (all && !row.empty()) rows.push_back(row);
  }
  return rows;
}

StudyResult fit_of(const TemporaryFolder& folder, const std::string& experiments,
                   const std::string& model) {
  return fit_study(
      read_study(folder.write("study.yaml",
                              "pliant: study/1\nname: polymer\n"
                              "experiments:\n" +
                                  experiments + "model: {kind: solid, " + model + "}\n")),
      {}, {});
}

// Marechal et al. 2020: silicones pulled to failure, one specimen each; every fourth row.
TEST(RealSilicone, IsMetByStandardLaws) {
  const auto file = [](const std::string& name) {
    return measurement("silicone_tensile_srmd/" + name + ".csv");
  };
  SKIP_WITHOUT(file("Ecoflex_00-30"));
  for (const char* silicone : {"Ecoflex_00-30", "Ecoflex_00-50", "Dragon_Skin_10_MEDIUM"}) {
    const TemporaryFolder folder;
    std::string csv = "stretch,nominal_stress_MPa\n";
    int rows = 0;
    for (const std::vector<double>& row : numbers_in(file(silicone), ';')) {
      if (row.size() == 5 && rows++ % 4 == 0) csv += fmt::format("{},{}\n", 1 + row[3], row[4]);
    }
    folder.write("pull.csv", csv);
    for (const char* law : kLaws) {
      const StudyResult result =
          fit_of(folder, "  - {name: pull, type: homogeneous, mode: uniaxial, data: pull.csv}\n",
                 std::string("law: ") + law);
      print(silicone, law, result);
      if (std::string(law) == "yeoh" || std::string(law) == "additive") {
        EXPECT_GT(worst(result), 0.99) << law;
      }
    }
  }
}

// VHB 4910 pulled to twice its length and back at 0.01, 0.03 and 0.05 per second; every so many
// rows. What no law without rates can have is how the three differ.
TEST(RealElastomer, UnloadsAsAHyperelasticLawWithDahlFrictionDoes) {
  const auto file = [](const std::string& name) {
    return measurement("elastomer_cyclic_vhb4910/vhb4910_" + name + ".csv");
  };
  SKIP_WITHOUT(file("0d01_2d0"));
  const TemporaryFolder folder;
  std::string one, all;
  for (const auto& [name, every] : std::array<std::pair<const char*, std::size_t>, 3>{
           {{"0d01_2d0", 50}, {"0d03_2d0_1", 16}, {"0d05_2d0", 10}}}) {
    std::string csv = "extension_mm,force_N\n";
    const auto rows = numbers_in(file(name), ',');
    for (std::size_t i = 0; i < rows.size(); i += every) {
      csv += fmt::format("{},{}\n", rows[i][1], rows[i][2]);
    }
    folder.write(std::string(name) + ".csv", csv);
    const std::string experiment = fmt::format(
        "  - {{name: r{0}, type: homogeneous, mode: uniaxial, data: {0}.csv, length: 80 mm, area: "
        "22 mm^2}}\n",
        name);
    if (one.empty()) one = experiment;
    all += experiment;
  }
  const std::string friction =
      "components: {I1-bar: {addends: [polynomial]}, green.xx: {stiffness: none, addends: [dahl]}}";
  const StudyResult elastic = fit_of(folder, one, "law: yeoh");
  const StudyResult dahl = fit_of(folder, one, friction);
  print("VHB 4910", "yeoh", elastic);
  print("VHB 4910", "yeoh + dahl", dahl);
  print("VHB 4910", "yeoh", fit_of(folder, all, "law: yeoh"));
  print("VHB 4910", "yeoh + dahl", fit_of(folder, all, friction));
  EXPECT_LT(dahl.experiments.front().rms_percent, elastic.experiments.front().rms_percent / 2);
}

}  // namespace
}  // namespace pliant::test
