#include "pliant/report/energy_figure.h"

#include <algorithm>
#include <set>

#include "pliant/report/thinning.h"

namespace pliant::report {
namespace {

constexpr std::size_t kBudget = 600;  // frames to draw of each series
constexpr PrintSize kPrintSize = {703, 190};

constexpr SeriesStyle kKinetic = {"kinetic", "kinetic", "#00538a", "solid", nullptr, 2.0};
constexpr SeriesStyle kStored = {
    "stored", "stored (elastic and gravity), change", "#b34700", "6px,3px", nullptr, 2.0};
constexpr SeriesStyle kLost = {
    "lost", "lost to friction and damping", "#555f6b", "2px,3px", nullptr, 1.8};
constexpr SeriesStyle kDrag = {"drag", "lost to the air", "#7a4a8c", "1px,4px", nullptr, 1.8};
constexpr SeriesStyle kOutside = {
    "outside", "work of what is moved", "#2e7d4f", "10px,4px", nullptr, 1.8};
constexpr SeriesStyle kTotal = {
    "total", "sum of all, change", "#1f2933", "8px,3px,2px,3px", nullptr, 1.6};

bool has_any(const std::vector<double>& values) {
  return std::any_of(values.begin(), values.end(), [](double value) { return value != 0; });
}

std::vector<EnergySeries> series_of(const EnergyTable& energy) {
  EnergySeries stored{kStored, {}}, lost{kLost, {}}, total{kTotal, {}};
  for (std::size_t i = 0; i < energy.rows(); ++i) {
    stored.values.push_back(energy.stored[i] - energy.stored[0]);
    lost.values.push_back(energy.work[i] - energy.drag[i]);
    total.values.push_back(energy.kinetic[i] - energy.kinetic[0] + stored.values[i] +
                           energy.work[i]);
  }
  std::vector<EnergySeries> series;
  // A path of equilibria has no motion.
  if (has_any(energy.kinetic)) series.push_back({kKinetic, energy.kinetic});
  series.insert(series.end(), {stored, lost});
  if (has_any(energy.drag)) series.push_back({kDrag, energy.drag});
  if (has_any(energy.outside)) series.push_back({kOutside, energy.outside});
  series.push_back(total);
  return series;
}

std::vector<double> taken(const std::vector<double>& values, const std::set<std::size_t>& rows) {
  std::vector<double> result;
  for (const std::size_t row : rows) result.push_back(values[row]);
  return result;
}

}  // namespace

EnergyFigure energy_figure(const SimulationResults& results) {
  EnergyFigure result;
  result.series = series_of(results.energy);
  std::set<std::size_t> rows;
  for (const EnergySeries& series : result.series) {
    const std::vector<std::size_t> drawn = thin_for_drawing(series.values, {}, kBudget);
    rows.insert(drawn.begin(), drawn.end());
  }
  const std::vector<double> time = taken(results.energy.time, rows);
  for (const EnergySeries& series : result.series) {
    result.figure.traces.push_back(trace(series.style, time, taken(series.values, rows)));
    result.legend.push_back(series.style);
  }
  result.figure.layout = base_layout();
  result.figure.layout["xaxis"] = axis({"Time", "s"});
  result.figure.layout["yaxis"] = axis({"Energy", "J"});
  result.figure.description = "Energies over time of " + results.name;
  result.figure.data_file = results.energy_file;
  result.figure.print_size = kPrintSize;
  return result;
}

}  // namespace pliant::report
