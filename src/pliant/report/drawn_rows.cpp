#include "pliant/report/drawn_rows.h"

#include <limits>

#include "pliant/report/thinning.h"

namespace pliant::report {

std::vector<std::size_t> reversal_rows(const Prediction& prediction) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 1; row < prediction.rows(); ++row) {
    if (prediction.branch[row] == prediction.branch[row - 1] &&
        prediction.specimen[row] == prediction.specimen[row - 1]) {
      continue;
    }
    if (rows.empty() || rows.back() != row - 1) rows.push_back(row - 1);
    rows.push_back(row);
  }
  return rows;
}

std::vector<std::size_t> rows_to_draw(const Prediction& prediction, std::span<const double> values,
                                      std::size_t budget) {
  return thin_for_drawing(values, reversal_rows(prediction), budget);
}

BrokenLine line_of_branch(const Prediction& prediction, std::span<const std::size_t> rows,
                          Branch branch, std::span<const double> x, std::span<const double> y) {
  constexpr double kGap = std::numeric_limits<double>::quiet_NaN();
  BrokenLine line;
  bool drawing = false;
  const auto add = [&](double px, double py) {
    line.x.push_back(px);
    line.y.push_back(py);
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const std::size_t row = rows[i];
    const bool same_specimen =
        i > 0 && prediction.specimen[row] == prediction.specimen[rows[i - 1]];
    if (prediction.branch[row] != branch) {
      drawing = false;
      continue;
    }
    if (!drawing || !same_specimen) {
      if (!line.x.empty()) add(kGap, kGap);
      if (same_specimen) add(x[rows[i - 1]], y[rows[i - 1]]);
    }
    add(x[row], y[row]);
    drawing = true;
  }
  return line;
}

}  // namespace pliant::report
