#pragma once

#include <cstdlib>

namespace pliant::test {

/// A number that the one who runs the tests asks for in a variable of the environment.
inline int asked_for(const char* variable, int otherwise) {
  const char* number = std::getenv(variable);
  return number ? std::atoi(number) : otherwise;
}

}  // namespace pliant::test
