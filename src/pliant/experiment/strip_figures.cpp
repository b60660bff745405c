#include "pliant/experiment/strip_figures.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/loop_metrics.h"

namespace pliant {
namespace {

constexpr double kGivenBack = 0.05;  // noise and creep of an elastic strip stay below

/// Lengths whose smallest is far below the gauge length and that grow several times over: they are
/// counted from it.
bool are_extensions(double least, double most) { return least < 0.5 && most > 3 * least; }

/// Extensions whose smallest is a good part of the gauge length already.
bool are_distances(double least, double most) { return least > 0.5 && most < 5 * least; }

}  // namespace

StripFigures::StripFigures(const TestSpec& size, double density)
    : gauge_length_(size.length),
      strip_width_(size.width),
      density_(is_plausible(figures::kAreaDensity, density) ? density : 0) {
  if (size.length > 0) {
    length_ = field("length", Dimension::length, size.length);
    add(figures::kLength, size.length, {{length_}});
  }
  if (size.width > 0) {
    width_ = field("width", Dimension::length, size.width);
    add(density_ > 0 ? figures::kCutWidth : figures::kWidth, size.width, {{width_}});
  }
  if (density_ > 0) {
    weight_ = field("density", Dimension::area_density, density);
    add(figures::kAreaDensity, density, {{weight_}});
  }
}

void StripFigures::add_by_weight(const FabricFigure& by_weight, const FabricFigure& alone,
                                 double per_width, std::vector<Power> powers) {
  if (density_ == 0) return add(alone, per_width, std::move(powers));
  powers.push_back({weight_, -1});
  add(by_weight, per_width / (density_ * kStandardGravity), std::move(powers));
}

std::optional<std::string> StripFigures::add_pull(const PulledRows& rows, Reading force) {
  const auto [shortest, longest] = std::ranges::minmax_element(rows.length);
  const double least = *shortest / gauge_length_, most = *longest / gauge_length_;
  const bool distances = rows.column == "length";
  if (distances && are_extensions(least, most)) {
    return fmt::format(
        "`length` begins at {}, far below the gauge length, {}: is it an extension, counted from "
        "the gauge length (a column `extension`)?",
        millimetres(*shortest), millimetres(gauge_length_));
  }
  if (rows.column == "extension" && are_distances(least - 1, most - 1)) {
    return fmt::format(
        "`extension` is {} at least, and the gauge length {}: is it the distance between the "
        "clamps, an absolute length (a column `length`)?",
        millimetres(*shortest - gauge_length_), millimetres(gauge_length_));
  }
  const double load_there = rows.force[static_cast<std::size_t>(longest - rows.length.begin())];
  const double load_here = rows.force[static_cast<std::size_t>(shortest - rows.length.begin())];
  if (load_there <= load_here) {
    return fmt::format(
        "the force falls from {:.3g} to {:.3g} N while the strip is stretched: is a pull counted "
        "negative?",
        load_here, load_there);
  }
  const Reading stretch = column(
      rows.column, rows.column == "strain" ? Dimension::fraction : Dimension::length, rows.unit);
  std::vector<Power> powers;
  if (distances) {
    add(figures::kStart, least, {{stretch}, {length_, -1}});
    // Of a length that begins elsewhere no strain is known.
    if (least < figures::kStart.least || least > figures::kStart.most) return std::nullopt;
  } else {
    powers.push_back({stretch});
    if (rows.column == "extension") powers.push_back({length_, -1});
  }
  const double strain = std::max(std::abs(most - 1), std::abs(least - 1));
  add(figures::kStrain, strain, powers);
  const double load = std::max(std::abs(load_there), std::abs(load_here)) / strip_width_;
  add_by_weight(figures::kLoad, figures::kTension, load, {{force}, {width_, -1}});
  std::vector<Power> of_stiffness = powers;
  for (Power& power : of_stiffness) power.exponent *= -1;
  of_stiffness.insert(of_stiffness.end(), {{force}, {width_, -1}});
  const double stiffness = (load_there - load_here) / (most - least) / strip_width_;
  add_by_weight(figures::kStiffness, figures::kModulus, stiffness, of_stiffness);
  if (density_ == 0) return std::nullopt;
  add_of_weighed(rows, {load, {{force}, {width_, -1}}}, {strain, std::move(powers)},
                 {stiffness, std::move(of_stiffness)});
  return std::nullopt;
}

void StripFigures::add_of_weighed(const PulledRows& rows, Figure load, const Figure& strain,
                                  Figure stiffness) {
  for (Figure* figure : {&load, &stiffness}) {
    figure->value /= density_ * kStandardGravity;
    figure->powers.push_back({weight_, -1});
  }
  const Figure density{density_, {{weight_}}};
  add(figures::kPulledDensity, density_, {{weight_}});
  add_below(figures::kStiffnessOfHeavyCloth, stiffness, figures::kSoftDensity, density);
  add_below(figures::kStraightensCrimp, load, figures::kCrimpStiffness, stiffness);
  if (rows.comes_back) add_above(figures::kFarStretch, strain, figures::kReturnedLoad, load);
  if (!rows.is_driven) return;
  std::vector<Power> of_work = strain.powers;
  of_work.insert(of_work.end(), load.powers.begin(), load.powers.end());
  add(figures::kWork, load.value * strain.value, std::move(of_work));
}

void StripFigures::add_rate(const PulledRows& rows, const std::vector<double>& time,
                            Reading clock) {
  double way = 0, duration = 0;
  for (std::size_t i = 1; i < time.size(); ++i) {
    if (time[i] <= time[i - 1]) continue;  // another specimen
    way += std::abs(rows.length[i] - rows.length[i - 1]) / gauge_length_;
    duration += time[i] - time[i - 1];
  }
  if (duration > 0 && way > 0) add(figures::kStrainRate, way / duration, {{clock, -1}});
}

void StripFigures::add_shear_stiffness(double stiffness, std::vector<Power> powers) {
  add_by_weight(figures::kShearStiffness, figures::kShearModulus, stiffness, std::move(powers));
}

void StripFigures::add_bending_stiffness(double stiffness, std::vector<Power> powers) {
  if (density_ == 0) return add(figures::kBendingStiffness, stiffness, std::move(powers));
  powers.push_back({weight_, -1});
  for (Power& power : powers) power.exponent /= 3;
  add(figures::bending_length_of(density_), std::cbrt(stiffness / (density_ * kStandardGravity)),
      std::move(powers));
}

std::optional<std::string> swap_question(const ComponentExperiment& experiment,
                                         std::string_view abscissa, std::string_view ordinate) {
  const auto series = experiment.loop(experiment.measured());
  const auto loop = series ? loop_metrics(*series, experiment.path()) : std::nullopt;
  if (!loop || !(loop->loop_loss < -kGivenBack)) return std::nullopt;
  return fmt::format(
      "the cloth gives back {:.0f} % more work than it took: are the columns `{}` and `{}` "
      "swapped?",
      -100 * loop->loop_loss, abscissa, ordinate);
}

std::vector<std::string> first_asked(std::initializer_list<std::optional<std::string>> questions) {
  for (const auto& question : questions) {
    if (question) return {*question};
  }
  return {};
}

}  // namespace pliant
