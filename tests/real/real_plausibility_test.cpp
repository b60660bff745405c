// Of no real measurement that can be read a unit or a size is asked about; skipped where
// PLIANT_TEST_DATA does not hold them.

#include <cmath>
#include <cstdio>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "real/real_fit.h"

namespace pliant::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// `pliant info` of a file says nothing of ranges of fabrics.
void expect_no_question(const std::filesystem::path& file) {
  const ProgramRun run = run_program({"info", file.string()});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.out + run.err, Not(HasSubstr("? ("))) << file;
  EXPECT_THAT(run.out + run.err, Not(HasSubstr("swapped"))) << file;
}

std::string tensile(const std::string& name, const std::string& direction, double length_mm,
                    double width_mm, const std::string& data) {
  return fmt::format(
      "pliant: study/1\nname: real\nmodel: {{strips: sheet}}\nexperiments:\n"
      "  - {{name: {}, type: tensile-cycles, direction: {}, length: {} mm, width: {} mm, data: "
      "{}}}\n",
      name, direction, length_mm, width_mm, data);
}

/// Extension (mm) and force (N) of a file of pairs, the force divided by the number of strips.
std::string pull_of(const std::filesystem::path& record, int strips) {
  std::string rows = "extension_mm,force_N\n";
  std::ifstream in(record);
  for (std::string line; std::getline(in, line);) {
    double extension = 0, force = 0;
    if (std::sscanf(line.c_str(), "%lf , %lf", &extension, &force) != 2) continue;
    rows += fmt::format("{},{}\n", extension, force / strips);
  }
  return rows;
}

TEST(RealPlausibility, OfTheLoopsAndBucklesOfAKnitNothingIsAsked) {
  const auto record = measurement("cloth_hysteresis_fab/fab_knit_cotton_300gsm.json");
  SKIP_WITHOUT(record);
  const TemporaryFolder folder;
  const auto study = folder.path() / "study";
  ASSERT_EQ(run_program({"import", record.string(), "-o", study.string()}).status, 0);
  expect_no_question(study / "study.yaml");
}

TEST(RealPlausibility, OfStripsOfNylonAndGlassNothingIsAsked) {
  SKIP_WITHOUT(measurement("cloth_offaxis_uniaxial/nylon_strips_00deg.csv"));
  const TemporaryFolder folder;
  for (const int angle : {0, 30, 60, 90}) {
    folder.write(
        "pull.csv",
        pull_of(measurement(fmt::format("cloth_offaxis_uniaxial/nylon_strips_{:02}deg.csv", angle)),
                12));
    expect_no_question(folder.write(
        "study.yaml", tensile("nylon", fmt::format("{} deg", angle), 97, 2.25, "pull.csv")));
  }
  folder.write("pull.csv", pull_of(measurement("cloth_bias_extension/glass_plain_150_450.csv"), 1));
  expect_no_question(folder.write("study.yaml", tensile("glass", "bias", 450, 150, "pull.csv")));
}

TEST(RealPlausibility, OfAnElastomerThatIsStretchedToTwiceItsLengthNothingIsAsked) {
  SKIP_WITHOUT(measurement("elastomer_cyclic_vhb4910/vhb4910_0d01_2d0.csv"));
  const TemporaryFolder folder;
  for (const char* speed : {"0d01_2d0", "0d03_2d0_1", "0d05_2d0"}) {
    const auto record = measurement(fmt::format("elastomer_cyclic_vhb4910/vhb4910_{}.csv", speed));
    const std::string data = fmt::format(
        "{{file: {}, encoding: gbk, columns: {{time: \"\u65f6\u95f4\", extension: "
        "\"\u4f4d\u79fb\", force: \"\u529b\"}}}}",
        record.string());
    expect_no_question(folder.write("study.yaml", tensile("vhb", "warp", 80, 22, data)));
  }
}

/// The clamps' distance and the force of a swatch, from a table of its markers; the clamp is
/// 35.5 mm wide.
struct Swatch {
  std::string rows = "specimen,force_N,length_mm\n";
  double length = 0, width = 0;  // mm

  explicit Swatch(const std::filesystem::path& record) {
    std::ifstream in(record);
    std::string line;
    std::getline(in, line);
    double clamp = 1, fabric = 0;
    const std::size_t sizes = line.find("clampSize_px");
    std::sscanf(line.c_str() + sizes, "clampSize_px=%lf", &clamp);
    std::sscanf(line.c_str() + line.find("fabricSize_px"), "fabricSize_px=%lf", &fabric);
    width = fabric * 35.5 / clamp;
    std::getline(in, line);  // the header: repeat, frame, force, then x and y of seven markers
    while (std::getline(in, line)) {
      std::vector<std::string> cells;
      std::istringstream row(line);
      for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
      if (cells.size() < 17) continue;
      const auto number = [&](std::size_t i) { return std::strtod(cells[i].c_str(), nullptr); };
      const double distance = std::hypot(number(13) - number(15), number(14) - number(16));
      if (!std::isfinite(distance)) continue;
      if (length == 0) length = distance;
      rows += fmt::format("{},{},{}\n", cells[0], number(2), distance);
    }
  }
};

TEST(RealPlausibility, OfSwatchesOfAHandMadeKnitNothingIsAsked) {
  SKIP_WITHOUT(measurement("cloth_knit_uniaxial/knit_acrylic_garter_x.csv"));
  const TemporaryFolder folder;
  for (const char* knit : {"garter_x", "garter_y", "stockinette_x", "stockinette_y"}) {
    const Swatch swatch(measurement(fmt::format("cloth_knit_uniaxial/knit_acrylic_{}.csv", knit)));
    folder.write("pull.csv", swatch.rows);
    expect_no_question(
        folder.write("study.yaml", tensile(knit, "warp", swatch.length, swatch.width, "pull.csv")));
  }
}

TEST(RealPlausibility, OfAPhotographedStripNothingIsAsked) {
  const auto photo = measurement("cloth_cantilever_images/example_image.jpg");
  SKIP_WITHOUT(photo);
  const TemporaryFolder folder;
  const auto study = folder.path() / "study";
  const ProgramRun run =
      run_program({"import", photo.string(), "-o", study.string(), "--scale", "0.1101 mm",
                   "--areal-load", "13.6 N/m^2", "--width", "50 mm", "--direction", "warp"});
  if (run.err.find("built without OpenCV") != std::string::npos) GTEST_SKIP() << run.err;
  expect_no_question(study / "study.yaml");
}

TEST(RealPlausibility, OfGarmentsNothingIsAskedButInAnotherUnit) {
  const auto folder_of_garments = measurement("garment_meshes");
  SKIP_WITHOUT(folder_of_garments);
  const TemporaryFolder folder;
  folder.write("cloth.json", R"({"pliant": "material/1", "name": "cloth", "kind": "cloth",
 "density": 0.15, "components": {}})");
  int garments = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder_of_garments)) {
    if (entry.path().extension() != ".obj") continue;
    const auto scene = [&](const char* unit) {
      return folder.write("scene.yaml",
                          fmt::format("pliant: scene/1\ncloth: [{{name: garment, mesh: {{file: {}, "
                                      "unit: {}}}, material: cloth.json}}]\ntime: {{step: 5 ms, "
                                      "duration: 1 s}}\n",
                                      entry.path().string(), unit));
    };
    const ProgramRun run = run_program({"info", scene("m").string()});
    if (run.status != 0) continue;  // a mesh that is refused
    ++garments;
    EXPECT_THAT(run.out + run.err, Not(HasSubstr("(fabrics:"))) << entry.path();
    const ProgramRun small = run_program({"info", scene("mm").string()});
    EXPECT_THAT(small.out + small.err, HasSubstr("is `unit` 1 m, not 1 mm")) << entry.path();
  }
  EXPECT_GT(garments, 0);
}

}  // namespace
}  // namespace pliant::test
