#pragma once

#include <string>
#include <vector>

#include "pliant/measurement/session.h"

namespace pliant {

/// A question about units, where size, mass per area or the forces that carry it are those of no
/// cloth.
std::vector<std::string> sample_questions(const Session& session);

/// Sentences about what no test bench is like: its gravity, the name of a test that is a slip, and
/// a sheet that nothing holds.
std::vector<std::string> sample_warnings(const Session& session);

}  // namespace pliant
