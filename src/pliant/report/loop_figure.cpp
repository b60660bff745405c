#include "pliant/report/loop_figure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "pliant/report/drawn_rows.h"
#include "pliant/report/readable_unit.h"

namespace pliant::report {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();  // breaks a line
constexpr std::size_t kMostSmallMarkers = 40;  // of a branch; more run into each other

/// The coordinates of each row as measured, as predicted and without friction.
struct LoopCoordinates {
  QuantityLabel x_label, y_label;
  std::vector<double> x_measured, x_predicted, x_elastic;
  std::vector<double> y_measured, y_predicted, y_elastic;
  bool measured_along_x = false;
};

/// Lengths answer to a load: they lie along x, the load along y, as on a tester's chart.
LoopCoordinates length_against_load(const ResultExperiment& e, const Prediction& p) {
  return {quantity_label(e.quantity),
          quantity_label(p.driver_column),
          p.measured,
          p.predicted,
          p.elastic,
          p.driver,
          p.driver,
          p.driver,
          true};
}

LoopCoordinates quantity_against_strain(const ResultExperiment& e, const Prediction& p,
                                        std::optional<MembraneMeasure> membrane) {
  const ShownStrain shown(e.component, membrane);
  const std::vector<double> x = p.driver.empty() ? shown(p.strain) : p.driver;
  return {p.driver.empty() ? shown.label() : quantity_label(p.driver_column),
          quantity_label(e.quantity),
          x,
          x,
          x,
          p.measured,
          p.predicted,
          p.elastic,
          false};
}

/// Overhangs at one angle all belong to the same strain.
LoopCoordinates overhang_against_reading(const ResultExperiment& e, const Prediction& p) {
  std::vector<double> x;
  for (std::size_t row = 1; row <= p.rows(); ++row) x.push_back(static_cast<double>(row));
  return {{"Reading", ""},
          quantity_label(e.quantity),
          x,
          x,
          x,
          p.measured,
          p.predicted,
          p.elastic,
          false};
}

/// Forces and positions have nothing in common along x but what the material says of them.
LoopCoordinates measured_against_predicted(const Prediction& p) {
  return {{"Material, in units of the noise", ""},
          {"Measured", ""},
          p.predicted,
          p.predicted,
          p.elastic,
          p.measured,
          p.predicted,
          p.elastic,
          false};
}

LoopCoordinates coordinates(const ResultExperiment& e, const Prediction& p,
                            std::optional<MembraneMeasure> membrane) {
  if (e.measures_readings()) return measured_against_predicted(p);
  if (e.measures_overhangs()) return overhang_against_reading(e, p);
  const bool lengths = e.quantity.starts_with("length") && !p.driver.empty();
  return lengths ? length_against_load(e, p) : quantity_against_strain(e, p, membrane);
}

class LoopPlot {
 public:
  LoopPlot(const Prediction& prediction, LoopCoordinates at, std::vector<std::size_t> rows,
           bool compact)
      : prediction_(prediction), at_(std::move(at)), rows_(std::move(rows)), compact_(compact) {}

  void add_measured(const SeriesStyle& style, Branch branch) {
    add_markers(style, [&](std::size_t row) {
      return prediction_.used[row] && prediction_.branch[row] == branch;
    });
  }

  void add_excluded(const SeriesStyle& style) {
    add_markers(style, [&](std::size_t row) { return !prediction_.used[row]; });
  }

  /// Rows that the fit leaves by far, whatever else was drawn of the data.
  void add_outliers(const SeriesStyle& style, const std::vector<std::size_t>& outliers) {
    std::vector<double> x, y;
    for (const std::size_t row : outliers) {
      if (row >= prediction_.rows()) continue;
      x.push_back(at_.x_measured[row]);
      y.push_back(at_.y_measured[row]);
    }
    add(style, x, y);
  }

  void add_predicted(const SeriesStyle& style, Branch branch) {
    const BrokenLine line =
        line_of_branch(prediction_, rows_, branch, at_.x_predicted, at_.y_predicted);
    add(style, line.x, line.y);
  }

  /// Both edges of the band, along both branches.
  void add_band(const SeriesStyle& style) {
    std::vector<double> x, y;
    for (const std::vector<double>* edge : {&prediction_.low, &prediction_.high}) {
      if (edge->empty()) continue;
      for (const Branch branch : {Branch::load, Branch::unload}) {
        const BrokenLine line =
            at_.measured_along_x
                ? line_of_branch(prediction_, rows_, branch, *edge, at_.y_predicted)
                : line_of_branch(prediction_, rows_, branch, at_.x_predicted, *edge);
        if (!x.empty()) {
          x.push_back(kNothing);
          y.push_back(kNothing);
        }
        x.insert(x.end(), line.x.begin(), line.x.end());
        y.insert(y.end(), line.y.begin(), line.y.end());
      }
    }
    add(style, x, y);
  }

  /// The elastic curve has no branches: one line, in the order of what drives it; or, where the
  /// zero of the instrument drifts from pass to pass, pass by pass.
  void add_elastic(const SeriesStyle& style) {
    if (prediction_.elastic.empty()) return;
    std::vector<std::size_t> order = rows_;
    const auto& key = at_.measured_along_x ? at_.y_elastic : at_.x_elastic;
    const auto& value = at_.measured_along_x ? at_.x_elastic : at_.y_elastic;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key[a] < key[b]; });
    if (variation(value, rows_) < variation(value, order)) order = rows_;
    std::vector<double> x, y;
    for (const std::size_t row : order) {
      x.push_back(at_.x_elastic[row]);
      y.push_back(at_.y_elastic[row]);
    }
    add(style, x, y);
  }

  LoopFigure finish() {
    result_.figure.layout = base_layout(compact_);
    set_readable_axis(result_.figure, 'x', at_.x_label, compact_);
    set_readable_axis(result_.figure, 'y', at_.y_label, compact_);
    result_.drawn = compact_ ? markers_ : rows_.size();
    result_.total = prediction_.rows();
    return std::move(result_);
  }

 private:
  // By how much the values go up and down on the way.
  static double variation(const std::vector<double>& values,
                          const std::vector<std::size_t>& order) {
    double sum = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
      sum += std::abs(values[order[i]] - values[order[i - 1]]);
    }
    return sum;
  }

  template <typename Belongs>
  void add_markers(const SeriesStyle& style, Belongs belongs) {
    std::vector<std::size_t> chosen;
    for (const std::size_t row : rows_) {
      if (belongs(row)) chosen.push_back(row);
    }
    const std::size_t step = compact_ ? chosen.size() / kMostSmallMarkers + 1 : 1;
    std::vector<double> x, y;
    for (std::size_t i = 0; i < chosen.size(); i += step) {
      x.push_back(at_.x_measured[chosen[i]]);
      y.push_back(at_.y_measured[chosen[i]]);
    }
    markers_ += x.size();
    add(style, x, y);
  }

  void add(const SeriesStyle& style, const std::vector<double>& x, const std::vector<double>& y) {
    if (x.empty()) return;
    result_.figure.traces.push_back(trace(style, x, y, compact_));
    result_.legend.push_back(style);
  }

  const Prediction& prediction_;
  LoopCoordinates at_;
  std::vector<std::size_t> rows_;
  bool compact_;
  std::size_t markers_ = 0;
  LoopFigure result_;
};

}  // namespace

LoopFigure loop_figure(const ResultExperiment& experiment, const Prediction& prediction,
                       const LoopFigureOptions& options) {
  LoopPlot plot(prediction, coordinates(experiment, prediction, options.membrane),
                rows_to_draw(prediction, prediction.measured, options.budget), options.compact);
  const auto add_predicted = [&] {
    plot.add_predicted(kPredictedLoad, Branch::load);
    plot.add_predicted(kPredictedUnload, Branch::unload);
  };
  if (options.compact) add_predicted();  // below the markers, which hide little of it
  plot.add_measured(kMeasuredLoad, Branch::load);
  plot.add_measured(kMeasuredUnload, Branch::unload);
  if (!options.compact) {
    plot.add_measured(kMeasuredRest, Branch::rest);
    plot.add_excluded(kExcluded);
    plot.add_outliers(kOutlier, experiment.outliers);
    plot.add_elastic(kElastic);
    if (!experiment.measures_readings()) plot.add_band(kBand);
    add_predicted();
  }
  LoopFigure result = plot.finish();
  result.figure.description = "Measured and predicted loops of " + experiment.name;
  result.figure.data_file = experiment.prediction_file;
  return result;
}

}  // namespace pliant::report
