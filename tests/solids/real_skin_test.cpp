// Skin in vivo: four cycles of an extensometer, 9.5 mm, held for up to a minute; skipped where
// PLIANT_TEST_DATA does not hold them.

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/io/workbook.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"
#include "real/real_fit.h"

namespace pliant::test {
namespace {

struct Reading {
  double extension, force;  // mm, N
};

/// A reading every half second, the force from where it begins.
std::vector<Reading> readings(const std::filesystem::path& file) {
  constexpr std::size_t kEvery = 50;
  std::istringstream lines(workbook_text(file, ""));
  std::vector<Reading> all;
  for (std::string line; std::getline(lines, line);) {
    std::erase(line, '"');
    Reading reading{};
    double time = 0;
    if (std::istringstream(line) >> time >> reading.extension >> reading.force) {
      all.push_back(reading);
    }
  }
  std::vector<Reading> some;
  for (std::size_t i = 0; i < all.size(); i += kEvery) some.push_back(all[i]);
  const double zero = some.front().force;
  for (Reading& reading : some) reading.force -= zero;
  return some;
}

/// What a law without rates leaves at least, in % of the peak: it has one force while the stretch
/// is held, and the data have another at each time.
double least_without_rates(const std::vector<Reading>& data) {
  double squares = 0, peak = 0;
  for (std::size_t first = 0; first < data.size();) {
    std::size_t end = first;
    double sum = 0;
    while (end < data.size() && data[end].extension == data[first].extension) {
      sum += data[end++].force;
    }
    const double mean = sum / static_cast<double>(end - first);
    for (std::size_t i = first; i < end; ++i) {
      squares += std::pow(data[i].force - mean, 2);
      peak = std::max(peak, std::abs(data[i].force));
    }
    first = end;
  }
  return 100 * std::sqrt(squares / static_cast<double>(data.size())) / peak;
}

// The distance of the pads and their width are not in the record: 20 mm and 20 mm^2 are assumed,
// which scale the numbers of the laws and hardly what these leave.
TEST(RealSkin, UnloadsAsAHyperelasticLawWithDahlFrictionDoes) {
  const std::filesystem::path file = measurement("skin_in_vivo_cyclic/healthy_skin_extension.xlsx");
  SKIP_WITHOUT(file);
  if (!reads_workbooks()) GTEST_SKIP() << "this build reads no workbooks";
  const std::vector<Reading> data = readings(file);
  const TemporaryFolder folder;
  std::string csv = "extension_mm,force_N\n";
  for (const Reading& r : data) csv += fmt::format("{},{}\n", r.extension, r.force);
  folder.write("skin.csv", csv);
  std::map<std::string, double> left;
  const std::string yeoh = "I1-bar: {addends: [polynomial]}",
                    friction = "green.xx: {stiffness: none, addends: [dahl]}";
  for (const auto& [name, components] : std::map<std::string, std::string>{
           {"yeoh", "components: {" + yeoh + "}"},
           {"yeoh + dahl", "components: {" + yeoh + ", " + friction + "}"}}) {
    const StudyResult result = fit_study(
        read_study(folder.write(
            "study.yaml",
            "pliant: study/1\nname: skin\nexperiments:\n"
            "  - {name: arm, type: homogeneous, mode: uniaxial, data: skin.csv, length: 20 mm, "
            "area: 20 mm^2}\nmodel: {kind: solid, " +
                components + "}\n")),
        {}, {});
    const ExperimentResult& e = result.experiments.front();
    left[name] = e.rms_percent;
    fmt::print("{:<12} {:5.2f} % of the peak, R^2 {:6.4f}\n", name, e.rms_percent, *e.r_squared);
    for (const ParameterEstimate& p : result.parameters) {
      fmt::print("  {} {:.4g} +- {:.2g} {}\n", p.name, p.value, p.std_error.value_or(NAN), p.unit);
    }
  }
  const double least = least_without_rates(data);
  fmt::print("no law without rates leaves less than {:.2f} %\n", least);
  EXPECT_LT(left["yeoh + dahl"], 0.8 * left["yeoh"]);
  EXPECT_LT(least, left["yeoh + dahl"]);
}

}  // namespace
}  // namespace pliant::test
