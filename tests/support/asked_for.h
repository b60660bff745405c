#pragma once

#include <cstdlib>

namespace pliant::test {

/// A number that the one who runs the tests asks for in a variable of the environment.
inline int asked_for(const char* variable, int otherwise) {
  const char* number = std::getenv(variable);
  return number ? std::atoi(number) : otherwise;
}

/// Whether whole tables are wanted (PLIANT_FIGURES=1), or the part of them that tests are run with.
inline bool makes_figures() { return asked_for("PLIANT_FIGURES", 0) != 0; }

}  // namespace pliant::test
