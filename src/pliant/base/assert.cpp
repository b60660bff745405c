#include "pliant/base/assert.h"

#include <fmt/format.h>

namespace pliant {

AssertionError::AssertionError(const char* file, int line, const char* condition,
                               const std::string& message)
    : std::logic_error(
          fmt::format("{}:{}: internal error: {} ({} is false)", file, line, message, condition)) {}

void assertion_failed(const char* file, int line, const char* condition,
                      const std::string& message) {
  throw AssertionError(file, line, condition, message);
}

}  // namespace pliant
