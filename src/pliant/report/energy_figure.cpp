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
    "lost", "lost to friction, damping and air", "#555f6b", "2px,3px", nullptr, 1.8};
constexpr SeriesStyle kTotal = {
    "total", "sum of all, change", "#1f2933", "8px,3px,2px,3px", nullptr, 1.6};

struct Series {
  SeriesStyle style;
  std::vector<double> values;
};

std::vector<Series> series_of(const EnergyTable& energy) {
  Series kinetic{kKinetic, energy.kinetic}, stored{kStored, {}}, lost{kLost, energy.work},
      total{kTotal, {}};
  for (std::size_t i = 0; i < energy.rows(); ++i) {
    stored.values.push_back(energy.stored[i] - energy.stored[0]);
    total.values.push_back(energy.kinetic[i] - energy.kinetic[0] + stored.values[i] +
                           energy.work[i]);
  }
  std::vector<Series> series{stored, lost, total};
  // A path of equilibria has no motion.
  const auto moves = [](double value) { return value != 0; };
  if (std::any_of(kinetic.values.begin(), kinetic.values.end(), moves)) {
    series.insert(series.begin(), kinetic);
  }
  return series;
}

std::vector<double> taken(const std::vector<double>& values, const std::set<std::size_t>& rows) {
  std::vector<double> result;
  for (const std::size_t row : rows) result.push_back(values[row]);
  return result;
}

}  // namespace

EnergyFigure energy_figure(const SimulationResults& results) {
  const std::vector<Series> all = series_of(results.energy);
  std::set<std::size_t> rows;
  for (const Series& series : all) {
    const std::vector<std::size_t> drawn = thin_for_drawing(series.values, {}, kBudget);
    rows.insert(drawn.begin(), drawn.end());
  }
  EnergyFigure result;
  const std::vector<double> time = taken(results.energy.time, rows);
  for (const Series& series : all) {
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
