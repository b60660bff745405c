#pragma once

#include <vector>

#include "pliant/material/density/density.h"

namespace pliant {

/// Derivatives of eight stencils: column i + j rows holds entry (i, j) of the matrix of that name
/// in SampleDerivatives.
struct LaneDerivatives {
  using Entries = Eigen::Array<double, kLanes, Eigen::Dynamic>;
  Entries stress_by_last, stress_by_history, stress_by_parameter;
  Entries next_by_strain, next_by_last, next_by_history, next_by_parameter;

  LaneDerivatives(const ParametricDensity& density, const Samples& samples, const StepTime& time,
                  int parameters) {
    for (int l = 0; l < kLanes; ++l) {
      SampleDerivatives d(static_cast<int>(samples.strain.cols()), density.history_size(),
                          parameters);
      density.differentiate(samples, time, l, 0, 0, d);
      set(l, d.stress_by_last, stress_by_last);
      set(l, d.stress_by_history, stress_by_history);
      set(l, d.stress_by_parameter, stress_by_parameter);
      set(l, d.next_by_strain, next_by_strain);
      set(l, d.next_by_last, next_by_last);
      set(l, d.next_by_history, next_by_history);
      set(l, d.next_by_parameter, next_by_parameter);
    }
  }

 private:
  static void set(int lane, const Eigen::MatrixXd& matrix, Entries& entries) {
    if (lane == 0) entries.resize(kLanes, matrix.size());
    entries.row(lane) = matrix.reshaped().transpose();
  }
};

/// Adds a matrix, eight times, to the product with a vector, eight times.
template <class Vector, class Result>
void add_product(const LaneDerivatives::Entries& matrix, const Vector& vector, Result& result) {
  const Eigen::Index rows = result.cols();
  for (Eigen::Index j = 0; j < vector.cols(); ++j) {
    for (Eigen::Index i = 0; i < rows; ++i) {
      result.col(i) += matrix.col(i + j * rows) * vector.col(j);
    }
  }
}

/// Adds the columns of the parameters that stand in column `column` of the derivatives.
template <class Result>
void add_own_parameters(const LaneDerivatives::Entries& by_parameter,
                        const std::vector<int>& columns, Eigen::Index column, Result& result) {
  const Eigen::Index rows = result.cols();
  for (std::size_t p = 0; p < columns.size(); ++p) {
    if (columns[p] != column) continue;
    result += by_parameter.middleCols(static_cast<Eigen::Index>(p) * rows, rows);
  }
}

}  // namespace pliant
