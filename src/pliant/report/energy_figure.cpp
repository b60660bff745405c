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

std::vector<EnergySeries> series_of(const std::vector<EnergyRow>& rows) {
  EnergySeries kinetic{kKinetic, {}}, stored{kStored, {}}, lost{kLost, {}}, drag{kDrag, {}},
      outside{kOutside, {}}, total{kTotal, {}};
  for (const EnergyRow& row : rows) {
    kinetic.values.push_back(row.kinetic);
    stored.values.push_back(row.stored - rows[0].stored);
    lost.values.push_back(row.work - row.drag);
    drag.values.push_back(row.drag);
    outside.values.push_back(row.outside);
    total.values.push_back(row.total() - rows[0].kinetic - rows[0].stored);
  }
  std::vector<EnergySeries> series;
  // A path of equilibria has no motion.
  if (has_any(kinetic.values)) series.push_back(kinetic);
  series.insert(series.end(), {stored, lost});
  if (has_any(drag.values)) series.push_back(drag);
  if (has_any(outside.values)) series.push_back(outside);
  series.push_back(total);
  return series;
}

std::vector<double> times_of(const std::vector<EnergyRow>& rows) {
  std::vector<double> times;
  for (const EnergyRow& row : rows) times.push_back(row.time);
  return times;
}

std::vector<double> taken(const std::vector<double>& values, const std::set<std::size_t>& rows) {
  std::vector<double> result;
  for (const std::size_t row : rows) result.push_back(values[row]);
  return result;
}

}  // namespace

EnergyFigure energy_figure(const SimulationResult& simulation, const std::vector<EnergyRow>& rows) {
  EnergyFigure result;
  result.series = series_of(rows);
  std::set<std::size_t> shown;
  for (const EnergySeries& series : result.series) {
    const std::vector<std::size_t> drawn = thin_for_drawing(series.values, {}, kBudget);
    shown.insert(drawn.begin(), drawn.end());
  }
  const std::vector<double> time = taken(times_of(rows), shown);
  for (const EnergySeries& series : result.series) {
    result.figure.traces.push_back(trace(series.style, time, taken(series.values, shown)));
    result.legend.push_back(series.style);
  }
  result.figure.layout = base_layout();
  result.figure.layout["xaxis"] = axis({"Time", "s"});
  result.figure.layout["yaxis"] = axis({"Energy", "J"});
  result.figure.description = "Energies over time of " + simulation.name;
  result.figure.data_file = simulation.energy;
  result.figure.print_size = kPrintSize;
  return result;
}

}  // namespace pliant::report
