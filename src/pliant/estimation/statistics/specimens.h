#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// One unknown fitted to each specimen alone.
struct SpecimenFits {
  std::vector<double> value;
  std::vector<double> variance;  ///< of the fit's own noise, >= 0
};

/// How much the material varies from one specimen to the next, and how well its mean is known.
struct SpecimenSpread {
  double between_sd = 0;  ///< without the fits' own noise; 0 where that explains all
  double mean = 0;        ///< weighed by 1 / (between_sd^2 + variance)
  double mean_sd = 0;     ///< standard error of a joint fit over specimens
  double degrees = 1;     ///< of freedom of mean_sd: specimens - 1
};

/// Random effects over specimens: between_sd^2 is where the weighed squares about the mean come to
/// their expectation, specimens - 1 ([Paule1982]), and mean_sd^2 is the weighed scatter itself,
/// sum w (x - mean)^2 / ((m - 1) sum w) ([Hartung2001]), never below between_sd^2 / m. It is raised
/// by m sum a^2 / (sum a)^2, a = 1 / variance: a joint fit weighs specimens by their noise alone.
///
/// For specimens that are equally well measured that is exact, however much they differ. The moment
/// estimator of DerSimonian and Laird with a normal interval ([DerSimonian1986]) covers 70 to 92 %
/// for 2 to 10 of them (docs/estimation.md).
/// @return nothing for fewer than two specimens
std::optional<SpecimenSpread> specimen_spread(const SpecimenFits& fits);

/// A standard error of the fabric's mean from the joint fit of all specimens and from their spread:
/// the one with the wider interval.
struct MeanError {
  double sd = 0;
  double degrees = 1;
  double half_width = 0;  ///< of the 95 % interval
};
MeanError fabric_mean_error(double joint_sd, double joint_degrees,
                            const std::optional<SpecimenSpread>& spread);

}  // namespace pliant
