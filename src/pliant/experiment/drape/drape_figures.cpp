#include "pliant/experiment/drape/drape_figures.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

struct Extreme {
  std::size_t place = 0;
  double radius = 0;
};

/// Maxima and minima in turn, from a maximum on; plateaus count once. Empty for a circle.
std::vector<Extreme> extremes_of(const std::vector<double>& radii) {
  const auto highest = static_cast<std::size_t>(std::ranges::max_element(radii) - radii.begin());
  std::vector<Extreme> extremes{{highest, radii[highest]}};
  for (std::size_t i = 1; i < radii.size(); ++i) {
    const std::size_t place = (highest + i) % radii.size();
    const double radius = radii[place];
    Extreme& last = extremes.back();
    if (radius == last.radius) continue;
    const bool falls = extremes.size() % 2 == 1;  // since the last one, a maximum
    const auto next = radii[(place + 1) % radii.size()];
    const bool turns =
        falls ? next > radius && radius < last.radius : next < radius && radius > last.radius;
    if (turns) extremes.push_back({place, radius});
  }
  if (extremes.size() % 2 == 1) extremes.pop_back();
  return extremes;
}

/// Takes away the neighbours that differ least until all differ by a height.
void smooth_out(double height, std::vector<Extreme>& extremes) {
  while (!extremes.empty()) {
    std::size_t least = 0;
    double difference = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < extremes.size(); ++i) {
      const double d = std::abs(extremes[(i + 1) % extremes.size()].radius - extremes[i].radius);
      if (d < difference) {
        difference = d;
        least = i;
      }
    }
    if (difference >= height) return;
    const std::size_t other = (least + 1) % extremes.size();
    extremes.erase(extremes.begin() + static_cast<long>(std::max(least, other)));
    extremes.erase(extremes.begin() + static_cast<long>(std::min(least, other)));
  }
}

std::vector<Extreme> folds_of(const std::vector<double>& radii, double height) {
  PLIANT_ASSERT(radii.size() >= 3, "an outline goes around");
  std::vector<Extreme> extremes = extremes_of(radii);
  smooth_out(height, extremes);
  // A pair that goes with the first maximum leaves a minimum in front.
  if (!extremes.empty() && extremes[0].radius < extremes[1].radius) {
    std::rotate(extremes.begin(), extremes.begin() + 1, extremes.end());
  }
  return extremes;
}

std::vector<double> turns_of_maxima(const std::vector<Extreme>& extremes, std::size_t angles) {
  std::vector<double> turns;
  for (std::size_t i = 0; i < extremes.size(); i += 2) {
    turns.push_back(static_cast<double>(extremes[i].place) / static_cast<double>(angles));
  }
  std::ranges::sort(turns);
  return turns;
}

double irregularity_of(const std::vector<double>& turns) {
  if (turns.size() < 2) return 0;
  const double mean = 1 / static_cast<double>(turns.size());
  double squares = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const double gap =
        i + 1 < turns.size() ? turns[i + 1] - turns[i] : turns.front() + 1 - turns.back();
    squares += (gap - mean) * (gap - mean);
  }
  return std::sqrt(squares / static_cast<double>(turns.size() - 1)) / mean;
}

}  // namespace

double drape_coefficient(double area, double disc, double specimen) {
  PLIANT_ASSERT(specimen > disc, "a specimen hangs over the disc");
  return (area - disc) / (specimen - disc);
}

std::vector<double> nodes_of(const std::vector<double>& radii, double height) {
  return turns_of_maxima(folds_of(radii, height), radii.size());
}

DrapeFigures fold_figures(const std::vector<double>& radii, double overhang) {
  constexpr double kSmallestFold = 1.0 / 30;
  const std::vector<Extreme> extremes = folds_of(radii, kSmallestFold * overhang);
  DrapeFigures figures;
  figures.nodes = static_cast<int>(extremes.size() / 2);
  if (figures.nodes == 0) return figures;
  for (std::size_t i = 0; i < extremes.size(); i += 2) {
    figures.amplitude += (extremes[i].radius - extremes[i + 1].radius) / 2;
  }
  figures.amplitude /= figures.nodes;
  figures.irregularity = irregularity_of(turns_of_maxima(extremes, radii.size()));
  return figures;
}

}  // namespace pliant
