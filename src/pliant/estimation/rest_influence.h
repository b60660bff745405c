#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/law_fit.h"

namespace pliant {

/// What a fit owes to the strips that may come to rest in several shapes.
struct RestInfluence {
  /// By how much they move each unknown: the root of the sum of the squares of what leaving out one
  /// of them does. Empty where there are none.
  Eigen::VectorXd shift;
  std::vector<std::string> warnings;  ///< what leaving a strip out changes beyond half an error
};

/// A fit, or a better one that is found from a fit without one of the strips that may rest in
/// several shapes: where such a strip falls into the wrong one, others bend to meet it.
LawFit better_by_rests(const ComponentProblem& problem, const LawFit& fit);

/// Fits again without each of the strips that, pushed, would stay in another shape: which of its
/// shapes such a strip was left in is not the law's to say.
/// @param std_error  of each unknown, without this influence
RestInfluence influence_of_rests(const ComponentProblem& problem, const LawFit& fit,
                                 const Eigen::VectorXd& std_error);

}  // namespace pliant
