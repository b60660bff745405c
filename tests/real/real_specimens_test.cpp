// What one pull of a real fabric says of the next; skipped where PLIANT_TEST_DATA does not hold
// them.

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
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

/// The rows of a knitted swatch: the pull, its force (third) and the places of its marks.
std::vector<std::vector<double>> rows_of(const std::filesystem::path& record) {
  std::vector<std::vector<double>> rows;
  std::ifstream in(record);
  for (std::string line; std::getline(in, line);) {
    std::vector<double> cells;
    std::istringstream texts(line);
    for (std::string text; std::getline(texts, text, ',');) {
      cells.push_back(std::strtod(text.c_str(), nullptr));
    }
    if (cells.size() == 17 && cells[0] >= 1) rows.push_back(std::move(cells));
  }
  return rows;
}

/// The pulls of a knitted swatch; the distance of its clamps is that of two points of a video.
std::map<int, Pull> pulls_in(const std::filesystem::path& record) {
  std::map<int, Pull> pulls;
  for (const std::vector<double>& cells : rows_of(record)) {
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

/// Marks along the pull and across it; they are at rest in the first picture.
struct Narrowing {
  double length = INFINITY, width = 0;  // mm
  std::string rows = "length_mm,width_mm\n";
};

std::map<int, Narrowing> narrowings_in(const std::filesystem::path& record) {
  std::map<int, Narrowing> pulls;
  for (const std::vector<double>& cells : rows_of(record)) {
    const double length = std::hypot(cells[7] - cells[9], cells[8] - cells[10]);
    const double width = std::hypot(cells[3] - cells[5], cells[4] - cells[6]);
    if (!std::isfinite(length) || !std::isfinite(width)) continue;
    Narrowing& pull = pulls[static_cast<int>(cells[0])];
    if (!std::isfinite(pull.length)) {
      pull.length = length;
      pull.width = width;
    }
    pull.rows += fmt::format("{},{}\n", length, width);
  }
  return pulls;
}

// What the first pull of a swatch tells of its width predicts those of the others; errors in % of
// the range of the widths. Each begins at its own first picture.
TEST(RealKnit, TheFirstPullTellsHowTheOthersNarrow) {
  int predicted = 0, within = 0;
  for (const char* swatch : {"garter_x", "garter_y", "stockinette_x", "stockinette_y"}) {
    const auto record = measurement(fmt::format("cloth_knit_uniaxial/knit_acrylic_{}.csv", swatch));
    SKIP_WITHOUT(record);
    const TemporaryFolder folder;
    std::string study =
        "pliant: study/1\nname: knit\nvalidate: [pull-2, pull-3, pull-4, pull-5]\nexperiments:\n";
    for (const auto& [number, pull] : narrowings_in(record)) {
      folder.write(fmt::format("pull-{}.csv", number), pull.rows);
      study += fmt::format(
          "  - {{name: pull-{0}, type: lateral-contraction, direction: weft, data: pull-{0}.csv, "
          "length: {1:.3f} mm, width: {2:.3f} mm}}\n",
          number, pull.length, pull.width);
    }
    const json fit = fit_file(folder, folder.write("study.yaml", study)).fit;
    fmt::print("{:<14}", swatch);
    for (const json& e : fit["experiments"]) {
      fmt::print(" {:>6}", cell(e["rms_percent_of_peak"]));
      if (e["role"] == "fit") {
        EXPECT_LT(e["rms_percent_of_peak"], 1) << swatch;
        continue;
      }
      ++predicted;
      within += e["rms_percent_of_peak"] < 15 ? 1 : 0;
      EXPECT_LT(e["rms_percent_of_peak"], 30) << swatch << " " << e["name"];
    }
    fmt::print("\n");
  }
  EXPECT_EQ(predicted, 16);
  EXPECT_GE(within, 13);
}

}  // namespace
}  // namespace pliant::test
