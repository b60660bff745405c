// What one pull of a real fabric says of the next; skipped where PLIANT_TEST_DATA does not hold
// them.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "real/real_fit.h"

namespace pliant::test {
namespace {

using nlohmann::json;

struct Pull {
  double rest_length = INFINITY;  ///< mm, the shortest that was seen
  std::string rows = "force_N,length_mm\n";
};

/// The pulls of a knitted swatch; the distance of its clamps is that of two points of a video.
std::map<int, Pull> pulls_in(const std::filesystem::path& record) {
  std::map<int, Pull> pulls;
  std::ifstream in(record);
  for (std::string line; std::getline(in, line);) {
    std::vector<double> cells;
    std::istringstream texts(line);
    for (std::string text; std::getline(texts, text, ',');) {
      cells.push_back(std::strtod(text.c_str(), nullptr));
    }
    if (cells.size() != 17 || cells[0] < 1) continue;
    const double length = std::hypot(cells[13] - cells[15], cells[14] - cells[16]);
    if (!std::isfinite(length)) continue;
    Pull& pull = pulls[static_cast<int>(cells[0])];
    pull.rest_length = std::min(pull.rest_length, length);
    pull.rows += fmt::format("{},{}\n", cells[2], length);
  }
  return pulls;
}

/// A fit of pulls; `more` are further lines of the study.
json fit_pulls(const TemporaryFolder& folder, const std::map<int, Pull>& pulls,
               const std::string& more = "") {
  std::string study = "pliant: study/1\nname: knit\n" + more + "experiments:\n";
  for (const auto& [number, pull] : pulls) {
    study += fmt::format(
        "  - {{name: pull-{0}, type: tensile-cycles, direction: weft, data: pull-{0}.csv, length: "
        "{1:.3f} mm, width: 35 mm}}\n",
        number, pull.rest_length);
  }
  return fit_file(folder, folder.write("study.yaml", study)).fit;
}

// Five pulls of each swatch. Each is predicted by the first alone, and fitted by itself. The bounds
// are a fifth above what was found.
TEST(RealKnit, TheFirstPullPredictsTheOthers) {
  const std::map<std::string, double> highest{
      {"garter_x", 7}, {"garter_y", 9.5}, {"stockinette_x", 8}, {"stockinette_y", 4}};
  for (const auto& [swatch, percent] : highest) {
    const auto record = measurement("cloth_knit_uniaxial/knit_acrylic_" + swatch + ".csv");
    SKIP_WITHOUT(record);
    const std::map<int, Pull> pulls = pulls_in(record);
    ASSERT_EQ(pulls.size(), 5U);
    const TemporaryFolder folder;
    for (const auto& [number, pull] : pulls) {
      folder.write(fmt::format("pull-{}.csv", number), pull.rows);
    }
    const json by_first = fit_pulls(folder, pulls, "validate: [pull-2, pull-3, pull-4, pull-5]\n");
    fmt::print("{:<14} by the first: ", swatch);
    for (const json& e : by_first["experiments"]) {
      fmt::print(" {:>6}", cell(e["rms_percent_of_peak"]));
      EXPECT_LT(e["rms_percent_of_peak"], percent) << swatch << " " << e["name"];
    }
    fmt::print("\n{:<14} by itself:    ", "");
    for (const auto& [number, pull] : pulls) {
      const json own = fit_pulls(folder, {{number, pull}});
      fmt::print(" {:>6}", cell(own["experiments"].front()["rms_percent_of_peak"]));
      EXPECT_LT(own["experiments"].front()["rms_percent_of_peak"], 2) << swatch << " " << number;
    }
    fmt::print("\n");
  }
}

}  // namespace
}  // namespace pliant::test
