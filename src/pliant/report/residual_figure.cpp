#include "pliant/report/residual_figure.h"

#include <vector>

#include "pliant/report/drawn_rows.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/readable_unit.h"

namespace pliant::report {
namespace {

struct Abscissa {
  QuantityLabel label;
  std::vector<double> values;
};

Abscissa against_strain(const ResultExperiment& experiment, const Prediction& prediction,
                        std::optional<MembraneMeasure> membrane) {
  const ShownStrain shown(experiment.component, membrane);
  return {shown.label(), shown(prediction.strain)};
}

Abscissa against_time(const Prediction& prediction) {
  if (!prediction.time.empty()) return {{"Time", "s"}, prediction.time};
  Abscissa abscissa{{"Row", ""}, {}};
  for (std::size_t row = 0; row < prediction.rows(); ++row) {
    abscissa.values.push_back(static_cast<double>(row + 1));
  }
  return abscissa;
}

}  // namespace

Figure residual_figure(const ResultExperiment& experiment, const Prediction& prediction,
                       ResidualAbscissa abscissa, std::optional<MembraneMeasure> membrane,
                       std::size_t budget) {
  const bool by_strain = abscissa == ResidualAbscissa::strain;
  const Abscissa x =
      by_strain ? against_strain(experiment, prediction, membrane) : against_time(prediction);
  std::vector<double> residuals;
  for (std::size_t row = 0; row < prediction.rows(); ++row) {
    // A row that was not used must not use up the budget as an extreme.
    residuals.push_back(prediction.used[row] ? prediction.measured[row] - prediction.predicted[row]
                                             : 0.0);
  }
  const std::vector<std::size_t> rows = rows_to_draw(prediction, residuals, budget);
  Figure figure;
  const auto add = [&](const SeriesStyle& style, Branch branch) {
    std::vector<double> xs, ys;
    for (const std::size_t row : rows) {
      if (!prediction.used[row] || prediction.branch[row] != branch) continue;
      xs.push_back(x.values[row]);
      ys.push_back(residuals[row]);
    }
    if (!xs.empty()) figure.traces.push_back(trace(style, xs, ys));
  };
  add(kMeasuredLoad, Branch::load);
  add(kMeasuredUnload, Branch::unload);
  add(kMeasuredRest, Branch::rest);
  std::vector<double> outlier_xs, outlier_ys;
  for (const std::size_t row : experiment.outliers) {
    if (row >= prediction.rows()) continue;
    outlier_xs.push_back(x.values[row]);
    outlier_ys.push_back(residuals[row]);
  }
  if (!outlier_xs.empty()) figure.traces.push_back(trace(kOutlier, outlier_xs, outlier_ys));
  figure.layout = base_layout();
  figure.layout["xaxis"] = axis(x.label, /*compact=*/true);
  set_readable_axis(figure, 'y', {"Residual", quantity_label(experiment.quantity).unit},
                    /*compact=*/true);
  figure.layout["yaxis"]["nticks"] = 6;
  figure.description = std::string("Measured minus predicted against ") +
                       (by_strain ? "strain" : "time") + ", " + experiment.name;
  figure.data_file = experiment.prediction_file;
  return figure;
}

}  // namespace pliant::report
