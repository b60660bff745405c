#pragma once

#include "pliant/experiment/test_type.h"

namespace pliant {

/// A press (press_type.h) whose force is measured at each depth of the indenter.
const TestType& indentation_type();

}  // namespace pliant
