#pragma once

#include <functional>
#include <optional>

namespace pliant {

/// The root of a continuous function inside a bracket ([Alefeld1995], algorithm 748, of
/// Boost.Math).
/// @param f          f(low) and f(high) have opposite signs, or one of them is zero
/// @return a point within a few rounding errors of the root
double root_in_bracket(const std::function<double(double)>& f, double low, double high);

/// The first sign change met when walking from `from` in steps of `step` (either sign) up to
/// `limit`. Roots closer together than the step may be overlooked in pairs.
/// @return nothing when there is none before `limit`
std::optional<double> first_root(const std::function<double(double)>& f, double from, double step,
                                 double limit);

}  // namespace pliant
