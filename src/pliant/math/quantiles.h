#pragma once

namespace pliant {

/// Quantiles of the distributions that intervals and limits are made of (Boost.Math). Degrees of
/// freedom need not be whole; below 1 they count as 1, and infinitely many are allowed.

/// Half width of a two-sided 95 % interval in standard errors: Student's t, 1.96 for infinitely
/// many degrees.
double student_quantile_95(double degrees);

/// The same of a one-sided 95 % limit: 1.645 for infinitely many degrees.
double one_sided_student_quantile_95(double degrees);

/// Chi squared with `degrees` of freedom stays below this with probability `probability`.
/// @param probability  in (0, 1)
double chi_square_quantile(double probability, double degrees);

}  // namespace pliant
