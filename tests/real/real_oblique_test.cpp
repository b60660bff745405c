// Real strips cut at angles to their yarns, as sheets; skipped where PLIANT_TEST_DATA does not hold
// them.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
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

/// Pairs of numbers, line by line; lines that begin otherwise are left out.
std::vector<std::pair<double, double>> pairs_in(const std::filesystem::path& file) {
  std::vector<std::pair<double, double>> pairs;
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);) {
    double first = 0, second = 0;
    if (std::sscanf(line.c_str(), "%lf , %lf", &first, &second) == 2) {
      pairs.emplace_back(first, second);
    }
  }
  return pairs;
}

/// One of the twelve strips of 2.25 mm that were pulled side by side.
std::string one_of_twelve(const std::filesystem::path& record) {
  std::string rows = "extension_mm,force_N\n";
  for (const auto& [extension, force] : pairs_in(record)) {
    rows += fmt::format("{},{}\n", extension, force / 12);
  }
  return rows;
}

void print_parameters(const json& fit) {
  for (const json& p : fit["parameters"]) {
    fmt::print("  {} = {:.4g} +- {} N/m, {}\n", p["name"].get<std::string>(),
               p["value"].get<double>(), cell(p["std_error"], "{:.2g}"),
               p["note"].get<std::string>());
  }
}

class NylonStrips {
 public:
  static std::filesystem::path record(int angle) {
    return measurement(fmt::format("cloth_offaxis_uniaxial/nylon_strips_{:02}deg.csv", angle));
  }

  NylonStrips() {
    for (const int angle : {0, 30, 60, 90}) {
      folder_.write(fmt::format("{}.csv", angle), one_of_twelve(record(angle)));
    }
  }

  /// Strips along both yarns and one oblique one are fitted, the other is predicted.
  json fit(int predicted, const std::string& variant) const {
    std::string study = fmt::format(
        "pliant: study/1\nname: nylon\nmodel: {{strips: sheet, variant: {}, mesh: {{edge: 1.125 "
        "mm}}}}\nvalidate: [at-{}]\nexperiments:\n",
        variant, predicted);
    for (const int angle : {0, 30, 60, 90}) {
      study += fmt::format(
          "  - {{name: at-{0}, type: tensile-cycles, direction: {0} deg, data: {0}.csv, length: 97 "
          "mm, width: 2.25 mm}}\n",
          angle);
    }
    const RealFit real = fit_file(folder_, folder_.write("study.yaml", study));
    fmt::print("{}, the strip at {} degrees predicted\n", variant, predicted);
    print_table(real.fit);
    print_parameters(real.fit);
    fmt::print("  at the end the prediction is off by {:.2f} %\n", percent_at_end(predicted));
    return real.fit;
  }

  /// By how much the last fit misses the last row of a strip.
  double percent_at_end(int angle) const {
    std::ifstream in(folder_.path() / "fit" / "predictions" / fmt::format("at-{}.csv", angle));
    std::string header, line, last;
    std::getline(in, header);
    while (std::getline(in, line)) last = line;
    const auto number = [&](const char* column) {
      const auto before = std::count(
          header.begin(), header.begin() + static_cast<std::ptrdiff_t>(header.find(column)), ',');
      std::size_t at = 0;
      for (std::ptrdiff_t i = 0; i < before; ++i) at = last.find(',', at) + 1;
      return std::strtod(last.c_str() + at, nullptr);
    };
    return 100 * (number("predicted_force_N") / number("measured_force_N") - 1);
  }

 private:
  TemporaryFolder folder_;
};

double percent(const json& fit, int angle) {
  return experiment_named(fit, fmt::format("at-{}", angle))["rms_percent_of_peak"];
}

// Loading only, a curve for each angle. The strips are fitted ten times better than they predict
// each other: at their toes shear at 30 and at 60 degrees differs by a half, at the end hardly. A
// linear sheet misses the end.
TEST(RealOffAxis, OneObliqueStripPredictsTheOther) {
  SKIP_WITHOUT(NylonStrips::record(0));
  const NylonStrips strips;
  std::vector<double> shear;  // N/m, at the largest strain
  for (const auto& [fitted, predicted] : {std::pair{30, 60}, {60, 30}}) {
    const json fit = strips.fit(predicted, "nonlinear-orthotropic");
    for (const int angle : {0, 90, fitted}) EXPECT_LT(percent(fit, angle), 0.4) << angle;
    EXPECT_LT(percent(fit, predicted), 3.5);
    EXPECT_EQ(fit["parameters"].back()["component"], "shear");
    shear.push_back(fit["parameters"].back()["value"]);
    EXPECT_LT(std::abs(strips.percent_at_end(predicted)), 1.5);
    const json linear = strips.fit(predicted, "linear-orthotropic");
    EXPECT_GT(percent(linear, 0), 5 * percent(fit, 0)) << "the strips stiffen";
    EXPECT_LT(percent(linear, predicted), 4);
    EXPECT_GT(std::abs(strips.percent_at_end(predicted)), 2);
  }
  EXPECT_NEAR(shear[0], shear[1], 0.05 * shear[0]);
}

constexpr double kGlassLength = 0.45, kGlassWidth = 0.15;  // m
constexpr double kYarn = 1e5;  // N/m: they give by a thousandth, where the strip gives by a quarter

/// What a bias strip of yarns that keep their length says of shear without any simulation: the
/// shear stress at an angle between the yarns, from the work of the force (Cao et al. 2008, on
/// zones that shear by the whole angle, by half of it, and not at all).
class Trellis {
 public:
  /// @param pull  extension in mm, force in N
  explicit Trellis(std::vector<std::pair<double, double>> pull) : pull_(std::move(pull)) {}

  /// N/m
  double stress(double angle) const {
    constexpr double kStart = 0.02;  // rad: below it force and stress are taken to be straight
    if (angle < kStart) return angle / kStart * stress_above(kStart, 0);
    return stress_above(angle, stress(angle / 2));
  }

 private:
  double stress_above(double angle, double stress_at_half) const {
    const double free = kGlassLength - kGlassWidth;
    const double extension =
        free * (std::sqrt(2.0) * std::cos(std::numbers::pi / 4 - angle / 2) - 1);
    const double lever = std::cos(angle / 2) - std::sin(angle / 2);
    return (force_at(1e3 * extension) * free / kGlassWidth * lever -
            kGlassWidth * stress_at_half * std::cos(angle / 2)) /
           ((2 * kGlassLength - 3 * kGlassWidth) * std::cos(angle));
  }

  double force_at(double extension) const {
    std::pair before{0.0, 0.0};
    for (const auto& row : pull_) {
      if (row.first >= extension) {
        const double part = (extension - before.first) / (row.first - before.first);
        return before.second + part * (row.second - before.second);
      }
      before = row;
    }
    return before.second;
  }

  std::vector<std::pair<double, double>> pull_;
};

/// Shear stress of a fit's curve at a shear (sine of the angle), from the file of curves (N/m).
double fitted_stress(const std::filesystem::path& curves, double shear) {
  std::ifstream in(curves);
  std::pair before{0.0, 0.0};
  for (std::string line; std::getline(in, line);) {
    double strain = 0, stress = 0;
    if (std::sscanf(line.c_str(), "shear,%lf,%lf", &strain, &stress) != 2) continue;
    if (strain >= shear) {
      const double part = (shear - before.first) / (strain - before.first);
      return before.second + part * (stress - before.second);
    }
    before = {strain, stress};
  }
  return NAN;
}

// A strip of glass weave, read off a figure of a benchmark: one pull, so that nothing is left to be
// predicted. Its yarns are not known, but for being far stiffer than its shear.
TEST(RealBiasExtension, IsAShearOfASheetOfStiffYarns) {
  const auto record = measurement("cloth_bias_extension/glass_plain_150_450.csv");
  SKIP_WITHOUT(record);
  const TemporaryFolder folder;
  const auto pull = pairs_in(record);
  std::string rows = "extension_mm,force_N\n";
  for (const auto& [extension, force] : pull) rows += fmt::format("{},{}\n", extension, force);
  folder.write("glass.csv", rows);
  const RealFit real = fit_file(
      folder,
      folder.write("study.yaml",
                   fmt::format("pliant: study/1\nname: glass\nmodel: {{strips: sheet}}\n"
                               "fit: {{fix: {{stretch.weft.k: {0}, stretch.warp.k: {0}}}}}\n"
                               "experiments:\n  - {{name: bias, type: tensile-cycles, direction: "
                               "bias, data: glass.csv, length: {1} m, width: {2} m}}\n",
                               kYarn, kGlassLength, kGlassWidth)));
  print_table(real.fit);
  print_parameters(real.fit);
  EXPECT_LT(experiment_named(real.fit, "bias")["rms_percent_of_peak"], 2.5);
  const Trellis trellis(pull);
  for (const double degrees : {5.0, 10.0, 20.0, 30.0, 40.0, 50.0, 53.0}) {
    const double angle = degrees / 180 * std::numbers::pi;
    const double stress = fitted_stress(folder.path() / "fit" / "curves.csv", std::sin(angle));
    const double by_work = trellis.stress(angle);
    fmt::print("shear stress at {} degrees: sheet {:.2f} N/m, trellis {:.2f} N/m\n", degrees,
               stress, by_work);
    if (degrees >= 30) {
      EXPECT_NEAR(stress, by_work, 0.2 * by_work) << degrees;
    }
  }
}

}  // namespace
}  // namespace pliant::test
