#pragma once

#include <stdexcept>
#include <string>

namespace pliant {

/// A bug in the program: a broken precondition or invariant, never the user's input.
class AssertionError : public std::logic_error {
 public:
  AssertionError(const char* file, int line, const char* condition, const std::string& message);
};

[[noreturn]] void assertion_failed(const char* file, int line, const char* condition,
                                   const std::string& message);

}  // namespace pliant

/// Throws AssertionError when `condition` does not hold, in every build type.
#define PLIANT_ASSERT(condition, message)                                    \
  do {                                                                       \
    if (!(condition)) {                                                      \
      ::pliant::assertion_failed(__FILE__, __LINE__, #condition, (message)); \
    }                                                                        \
  } while (false)
