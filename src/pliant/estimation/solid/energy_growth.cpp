#include "pliant/estimation/solid/energy_growth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace pliant {
namespace {

constexpr double kOneSided = 0.02;  // of the larger side: less is none
constexpr int kMostPoints = 12;     // of one energy

void add_evenly(double end, int count, std::vector<double>& places) {
  for (int i = 1; i <= count; ++i) places.push_back(end * i / count);
}

/// The same energy through other control points.
ScalarCurve through(const ScalarCurve& energy, const std::vector<double>& places) {
  std::vector<double> values;
  for (const double place : places) values.push_back(energy.first_moment(place));
  return ScalarCurve::energy(places, values, energy.even());
}

class EnergyGrowth {
 public:
  EnergyGrowth(SolidProblem& problem, const Material& material) : problem_(problem) {
    for (const auto& [name, component] : material.components) {
      if (!component.stiffness || component.stiffness->kind() != CurveKind::energy) continue;
      data_[name] = &problem.data_of(name);
      points_ += component.stiffness->size();
    }
  }

  int points() const { return points_; }

  std::optional<Material> one_more(const Material& material, LeastSquaresSummary& solution) {
    std::optional<Material> best;
    for (const auto& [name, data] : data_) {
      const int count = material.components.at(name).stiffness->size() + 1;
      if (count > kMostPoints) continue;
      Material own = with_points(material, name, count);
      const LeastSquaresSummary end = problem_.solve(own);
      if (best && !(end.cost < solution.cost)) continue;
      best = std::move(own);
      solution = end;
    }
    return best;
  }

  Material rich(Material material) const {
    for (const auto& [name, data] : data_) material = with_points(material, name, kMostPoints);
    return material;
  }

 private:
  Material with_points(Material material, const std::string& name, int count) const {
    ScalarCurve& energy = *material.components.at(name).stiffness;
    energy = through(energy, energy_places(*data_.at(name), energy.even(), count));
    return material;
  }

  SolidProblem& problem_;
  std::map<std::string, const MetricData*> data_;
  int points_ = 0;
};

}  // namespace

std::vector<double> energy_places(const MetricData& data, bool even, int count) {
  const double low = std::max(-data.low(), 0.0), high = std::max(data.high(), 0.0);
  const double most = std::max(low, high);
  std::vector<double> places;
  if (even || std::min(low, high) < kOneSided * most) {
    add_evenly(even || high >= low ? most : -most, count, places);
  } else {
    const int both = std::max(count, 2);
    const auto share = static_cast<int>(std::lround(both * low / (low + high)));
    const int below = std::clamp(share, 1, both - 1);
    add_evenly(-low, below, places);
    add_evenly(high, both - below, places);
  }
  std::ranges::sort(places);
  return places;
}

ScalarCurve quadratic_energy(double stiffness, const std::vector<double>& places, bool even) {
  std::vector<double> values;
  for (const double place : places) values.push_back(stiffness * place * place / 2);
  return ScalarCurve::energy(places, values, even);
}

GrownSolid grow_energies(SolidProblem& problem, const GrownSolid& from) {
  EnergyGrowth growth(problem, from.material);
  if (growth.points() == 0) return from;
  return grow_points(problem, from, growth.points(), growth.rich(from.material),
                     [&](const Material& material, LeastSquaresSummary& solution) {
                       return growth.one_more(material, solution);
                     });
}

}  // namespace pliant
