#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/judgement.h"

namespace pliant {

/// What was estimated but is not determined by the data, grouped by component: `friction of
/// stretch.bias`, or single names where only some of a group are undetermined. Then the friction of
/// components whose data never unload, whether it was looked for or not.
std::vector<std::string> undetermined(const StudyResult& result, bool evaluation);

/// The same with the reasons that the fit gives, and whatever else it names.
std::vector<std::string> undetermined_with_reasons(const StudyResult& result, bool evaluation);

/// The judgement that the numbers allow, in one to four plain sentences.
std::string verdict(const StudyResult& result, const Acceptance& accept, bool evaluation);

}  // namespace pliant
