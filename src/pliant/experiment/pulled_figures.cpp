#include "pliant/experiment/pulled_figures.h"

#include <algorithm>
#include <cmath>

#include "pliant/material/law_path.h"
#include "pliant/math/root.h"

namespace pliant {

double PulledWay::largest_load() const { return load.empty() ? 0 : std::ranges::max(load); }

std::optional<double> PulledWay::extension_at(double wanted) const {
  for (std::size_t i = 1; i < load.size(); ++i) {
    const double a = load[i - 1], b = load[i];
    if ((a - wanted) * (b - wanted) > 0 || a == b) continue;
    return extension[i - 1] + (wanted - a) / (b - a) * (extension[i] - extension[i - 1]);
  }
  return std::nullopt;
}

double PulledWay::work_to(double last) const {
  double sum = 0;
  for (std::size_t i = 1; i < load.size(); ++i) {
    const double from = extension[i - 1], to = extension[i];
    const bool passes = (from - last) * (to - last) < 0;
    const double end = passes ? last : to;
    const double at_end =
        passes ? load[i - 1] + (end - from) / (to - from) * (load[i] - load[i - 1]) : load[i];
    sum += (end - from) * (std::max(load[i - 1], 0.0) + std::max(at_end, 0.0)) / 2;
    if (passes || to == last) break;
  }
  return sum;
}

std::optional<KesTensile> kes_tensile(const PulledCycle& cycle) {
  constexpr double kSameLoad = 0.05;
  const std::optional<double> extension = cycle.out.extension_at(kKesTensileLoad);
  if (!extension || !(*extension > 0)) return std::nullopt;
  KesTensile result;
  result.extension = *extension;
  result.work = cycle.out.work_to(*extension);
  result.linearity = result.work / (kKesTensileLoad * *extension / 2);
  const bool turns_there = cycle.out.largest_load() < (1 + kSameLoad) * kKesTensileLoad;
  const std::optional<double> slack = cycle.back.extension_at(0);
  if (turns_there && slack) {
    const double spent = cycle.out.work_to(cycle.out.extension.back());
    result.resilience = -cycle.back.work_to(*slack) / spent;
  }
  return result;
}

std::optional<ElasticRecovery> elastic_recovery(const PulledCycle& cycle) {
  constexpr double kPretension = 1;  // N/m: 1 cN/cm
  const std::optional<double> permanent = cycle.back.extension_at(kPretension);
  if (!permanent) return std::nullopt;
  const double elongation = std::ranges::max(cycle.out.extension);
  if (!(elongation > 0)) return std::nullopt;
  return ElasticRecovery{elongation, *permanent};
}

double fast_shear_rigidity(double bias_extension) { return 123 / (100 * bias_extension); }

double fast_formability(double e5, double e20, double rigidity) {
  return 1e-6 * (100 * (e20 - e5)) * (1e6 * rigidity) / 14.7;
}

std::optional<PulledCycle> pulled_to(const ComponentLaw& law, MembraneMeasure measure,
                                     double load) {
  constexpr double kStep = 0.01, kFurthest = 3;
  constexpr int kRows = 200;
  const UniaxialGeometry strip{1, 1, measure};
  LawPath path(law, {});
  const auto force = [&](double extension) {
    const double strain = strain_at(strip, 1 + extension);
    return path.stress_at(strain) * force_factor(strip, strain);
  };
  const std::optional<double> end =
      first_root([&](double extension) { return force(extension) - load; }, 0, kStep, kFurthest);
  if (!end) return std::nullopt;
  PulledCycle cycle;
  for (int i = 0; i <= kRows; ++i) {
    cycle.out.extension.push_back(*end * i / kRows);
    cycle.out.load.push_back(force(cycle.out.extension.back()));
  }
  cycle.out.load.back() = load;  // to the last digit
  path.turn_at(strain_at(strip, 1 + *end), {});
  for (int i = kRows; i >= 0; --i) {
    cycle.back.extension.push_back(*end * i / kRows);
    cycle.back.load.push_back(force(cycle.back.extension.back()));
  }
  return cycle;
}

}  // namespace pliant
