#include "pliant/io/result_name.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {

std::string read_result_name(const Value& value, std::string_view what,
                             std::set<std::string>& taken) {
  const std::string name = value.text();
  // Bytes from 128 on belong to letters beyond ASCII.
  const bool safe =
      !name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.' || c >= 128;
      });
  if (!safe) {
    value.fail(fmt::format("{} is no name for {}", quoted_value(name), what),
               "letters, digits, `-`, `_` and `.`: results are files of that name");
  }
  if (!taken.insert(name).second) {
    value.fail(fmt::format("{} before is called {}", what, quoted_value(name)),
               "a name of its own");
  }
  return name;
}

std::string read_experiment_name(const Value& value, std::set<std::string>& taken) {
  return read_result_name(value, "an experiment", taken);
}

}  // namespace pliant
