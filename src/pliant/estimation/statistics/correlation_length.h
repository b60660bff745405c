#pragma once

#include <vector>

namespace pliant {

/// A residual after the other, as one specimen's run gave them.
using ResidualSeries = std::vector<double>;

/// How many rows of an experiment count as one because their residuals go together: 1 + 2 sum of
/// the autocorrelations, at least 1 ([denHaan1997]: the spectrum at frequency zero of an
/// autoregression whose order BIC chooses).
///
/// A fit takes slow motion out of its residuals, which makes them look less correlated than the
/// noise was: each autocorrelation is raised by what the leverage says was taken (Kendall's bias,
/// [Kendall1954]). Where that leaves no row to spare, and for fewer than 8 spare rows, there is
/// nothing more to tell: L is at most rows / (leverage + 5), or 1.
/// @param series    of mean zero about the fit; they share one correlation and are not joined
/// @param leverage  of all rows of the series together (about the unknowns that they tell)
double correlation_length(const std::vector<ResidualSeries>& series, double leverage);

}  // namespace pliant
