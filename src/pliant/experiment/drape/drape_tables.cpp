#include "pliant/experiment/drape/drape_tables.h"

#include <cmath>

#include <fmt/format.h>

#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

// ISO 9073-9: which specimen is for which cloth.
constexpr double kUsualSpecimen = 0.3, kSmallSpecimen = 0.24, kLargeSpecimen = 0.36;  // m
constexpr double kLimp = 0.3, kStiff = 0.85;

}  // namespace

double mean_coefficient(const std::vector<DrapedSheet>& draped) {
  double sum = 0;
  for (const DrapedSheet& sheet : draped) sum += sheet.figures.coefficient;
  return sum / static_cast<double>(draped.size());
}

std::string drape_table(const std::vector<DrapedSheet>& draped) {
  const std::vector<std::string> header{"repeat", "drape_percent", "nodes", "amplitude_mm",
                                        "irregularity"};
  CsvWriter csv(header);
  int repeat = 0;
  for (const DrapedSheet& sheet : draped) {
    const DrapeFigures& figures = sheet.figures;
    csv.cell(++repeat).cell(1e2 * figures.coefficient).cell(figures.nodes);
    csv.cell(1e3 * figures.amplitude).cell(figures.irregularity);
    csv.end_row();
  }
  return csv.text();
}

std::string outline_table(const std::vector<DrapedSheet>& draped) {
  std::vector<std::string> header{"angle_deg"};
  for (std::size_t i = 1; i <= draped.size(); ++i) {
    header.push_back(fmt::format("radius_{}_mm", i));
  }
  CsvWriter csv(header);
  for (int i = 0; i < kSilhouetteAngles; ++i) {
    csv.cell(360.0 * i / kSilhouetteAngles);
    for (const DrapedSheet& sheet : draped) {
      csv.cell(1e3 * sheet.silhouette.radii[static_cast<std::size_t>(i)]);
    }
    csv.end_row();
  }
  return csv.text();
}

std::vector<std::string> size_advice(const std::vector<DrapedSheet>& draped,
                                     const DrapeSetup& setup) {
  if (draped.empty() || std::abs(setup.specimen - kUsualSpecimen) > 1e-9) return {};
  const double mean = mean_coefficient(draped);
  if (mean >= kLimp && mean <= kStiff) return {};
  return {fmt::format(
      "the drape coefficient is {:.0f} %, {} {:.0f} %: ISO 9073-9 takes a specimen "
      "of {:.0f} cm then",
      100 * mean, mean < kLimp ? "below" : "above", 100 * (mean < kLimp ? kLimp : kStiff),
      100 * (mean < kLimp ? kSmallSpecimen : kLargeSpecimen))};
}

}  // namespace pliant
