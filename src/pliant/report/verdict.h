#pragma once

#include <string>
#include <vector>

#include "pliant/report/results.h"

namespace pliant::report {

/// An experiment counts as reproduced when its RMS error is at most this much of its peak force.
inline constexpr double kReproducedPercent = 5.0;

/// What was estimated but is not determined by the data, grouped by component: `friction of
/// stretch.bias`, or single names where only some of a group are undetermined.
std::vector<std::string> undetermined(const Results& results);

/// The same with the reasons that the fit gives, and whatever else it names.
std::vector<std::string> undetermined_with_reasons(const Results& results);

/// Components none of whose fitted (in an evaluation: compared) data ever unload: they say nothing
/// about friction, whether it was fitted or not.
std::vector<std::string> loading_only_components(const Results& results);

/// The warnings beside the questions: the first of them, which stand on page one, or the others, so
/// that each comes once.
std::vector<std::string> warnings_of(const Results& results, bool on_page_one);

/// The judgement that the numbers allow, in one to four plain sentences.
std::string verdict(const Results& results);

}  // namespace pliant::report
