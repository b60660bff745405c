// Fits of real measurements; skipped where PLIANT_TEST_DATA does not hold them. The tables they
// print are those of the documentation.

#include "real/real_fit.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

// An acrylic elastomer, not a cloth: it is viscoelastic, and what Dahl friction leaves of its loop
// is told, not judged.
TEST(RealElastomer, FileOfATesterWithChineseHeadersIsFitted) {
  const auto folder_of_data = measurement("elastomer_cyclic_vhb4910");
  SKIP_WITHOUT(folder_of_data);
  for (const auto& [file, rate] : std::map<std::string, std::string>{
           {"vhb4910_0d01_2d0.csv", "0.01 1/s"}, {"vhb4910_0d05_2d0.csv", "0.05 1/s"}}) {
    const TemporaryFolder folder;
    std::filesystem::copy_file(folder_of_data / file, folder.path() / file);
    const auto study = folder.write(
        "study.yaml",
        fmt::format(
            "pliant: study/1\nname: VHB 4910\ninfo: {{strain rate: {}, note: viscoelastic}}\n"
            "experiments:\n  - name: stretch\n    type: tensile-cycles\n    direction: warp\n"
            "    length: 80 mm\n    width: 22 mm\n"
            "    data: {{file: {}, encoding: gbk, columns: {{time: \u65f6\u95f4, "
            "extension: \u4f4d\u79fb, force: \u529b}}}}\n",
            rate, file));
    const RealFit real = fit_file(folder, study);
    fmt::print("VHB 4910 at {} (viscoelastic)\n", rate);
    print_table(real.fit);
    const json e = experiment_named(real.fit, "stretch");
    EXPECT_LT(e["rms_percent_of_peak"], e["rms_elastic_percent_of_peak"]);
  }
}

// VHB 4910 at 0.01, 0.03 and 0.05 per second, every so many rows: of a law that relaxes two rates
// tell the third, of one without rates they do not.
TEST(RealElastomer, OfTwoRatesPredictsTheThird) {
  const auto folder_of_data = measurement("elastomer_cyclic_vhb4910");
  SKIP_WITHOUT(folder_of_data);
  const TemporaryFolder folder;
  std::string study = "pliant: study/1\nname: VHB 4910\nvalidate: [mid]\nexperiments:\n";
  for (const auto& [name, file, every] : {std::tuple{"slow", "vhb4910_0d01_2d0.csv", 50},
                                          {"mid", "vhb4910_0d03_2d0_1.csv", 16},
                                          {"fast", "vhb4910_0d05_2d0.csv", 10}}) {
    std::ifstream record(folder_of_data / file);
    std::string line, csv = "time_s,extension_mm,force_N\n";
    for (int row = -3; std::getline(record, line); ++row) {  // of three lines of headers
      std::erase_if(line, [](char c) { return c == '"' || c == '\r'; });
      if (row >= 0 && row % every == 0) csv += line + "\n";
    }
    folder.write(std::string(name) + ".csv", csv);
    study += fmt::format(
        "  - {{name: {0}, type: tensile-cycles, direction: warp, length: 80 mm, width: 22 mm, "
        "initial_friction: rest, data: {0}.csv}}\n",
        name);
  }
  const auto missed_by = [&](const std::string& model) {
    const RealFit real = fit_file(
        folder, folder.write("study.yaml", study +
                                               "model: {membrane: soft-constraint, components: "
                                               "{stretch.warp: {" +
                                               model + "}}}\n"));
    fmt::print("VHB 4910, {}\n", model);
    print_table(real.fit);
    return experiment_named(real.fit, "mid")["rms_percent_of_peak"].get<double>();
  };
  const double without_rates = missed_by("friction: dahl");
  EXPECT_GT(without_rates, 9);
  EXPECT_LT(missed_by("addends: [maxwell]"), 6);
  EXPECT_LT(missed_by("friction: none, addends: [maxwell, maxwell]"), 6);
}

void expect_no_friction(const json& fit) {
  std::string said;
  for (const json& sentence : fit["undetermined"]) said += sentence.get<std::string>() + "\n";
  EXPECT_THAT(said, HasSubstr("friction"));
  for (const json& p : fit["parameters"]) {
    EXPECT_THAT(p["name"].get<std::string>(), ::testing::Not(HasSubstr("friction")));
  }
}

// Hand-knitted swatches, loaded only, the distance of the clamps from a video; repeats are
// specimens' rows in one file.
TEST(RealKnit, LoadingOnlyIsFittedElastically) {
  const auto record = measurement("cloth_knit_uniaxial/knit_acrylic_garter_x.csv");
  SKIP_WITHOUT(record);
  const TemporaryFolder folder;
  // The clamps' distance is the difference of two columns: the first repeat alone, computed here.
  std::ifstream in(record);
  std::string line, csv = "force_N,length_mm\n";
  double shortest = 1e9;
  while (std::getline(in, line)) {
    if (line.rfind("1,", 0) != 0) continue;
    std::vector<double> cells;
    std::istringstream texts(line);
    for (std::string text; std::getline(texts, text, ',');)
      cells.push_back(std::atof(text.c_str()));
    const double length = std::hypot(cells[13] - cells[15], cells[14] - cells[16]);
    shortest = std::min(shortest, length);
    csv += fmt::format("{},{}\n", cells[2], length);
  }
  folder.write("stretch.csv", csv);
  const auto study = folder.write(
      "study.yaml",
      fmt::format("pliant: study/1\nname: garter stitch\nexperiments:\n"
                  "  - {{name: stretch, type: tensile-cycles, direction: weft, data: stretch.csv, "
                  "length: {:.3f} mm, width: 35 mm, rest_length: unknown}}\n",
                  shortest));
  const RealFit real = fit_file(folder, study);
  print_table(real.fit);
  expect_no_friction(real.fit);
}

/// Adds the header that a file lacks, and fits what it holds.
RealFit fit_loading(const TemporaryFolder& folder, const std::filesystem::path& data,
                    const std::string& header, const std::string& geometry) {
  std::string rows = content_of(data);
  if (header.empty()) {
    rows.replace(0, rows.find('\n'), "extension_mm,force_N");
  } else {
    rows = header + "\n" + rows;
  }
  folder.write("data.csv", rows);
  return fit_file(folder,
                  folder.write("study.yaml", "pliant: study/1\nname: " + data.stem().string() +
                                                 "\nexperiments:\n  - {name: stretch, type: "
                                                 "tensile-cycles, data: data.csv, " +
                                                 geometry + "}\n"));
}

TEST(RealOffAxis, LoadingOnlyIsFittedElastically) {
  for (const char* angle : {"00", "30", "60", "90"}) {
    const auto data =
        measurement(fmt::format("cloth_offaxis_uniaxial/nylon_strips_{}deg.csv", angle));
    SKIP_WITHOUT(data);
    const TemporaryFolder folder;
    const RealFit real = fit_loading(folder, data, "extension_mm,force_N",
                                     "direction: warp, length: 97 mm, width: 27 mm");
    fmt::print("nylon strips at {} degrees\n", angle);
    print_table(real.fit);
    expect_no_friction(real.fit);
  }
}

TEST(RealBiasExtension, LoadingOnlyIsFittedElastically) {
  const auto data = measurement("cloth_bias_extension/glass_plain_150_450.csv");
  SKIP_WITHOUT(data);
  const TemporaryFolder folder;
  const RealFit real =
      fit_loading(folder, data, "", "direction: bias, length: 450 mm, width: 150 mm");
  print_table(real.fit);
  expect_no_friction(real.fit);
}

}  // namespace
}  // namespace pliant::test
