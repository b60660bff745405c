#include "pliant/experiment/experiment_name.h"

#include <algorithm>
#include <cctype>

#include "pliant/base/errors.h"

namespace pliant {

std::string read_experiment_name(const Value& value, std::set<std::string>& taken) {
  const std::string name = value.text();
  // Bytes from 128 on belong to letters beyond ASCII.
  const bool safe =
      !name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) != 0 || c == '-' || c == '_' || c == '.' || c >= 128;
      });
  if (!safe) {
    value.fail(quoted_value(name) + " is no name for an experiment",
               "letters, digits, `-`, `_` and `.`: results are files of that name");
  }
  if (!taken.insert(name).second) {
    value.fail("a second experiment is called " + quoted_value(name), "a name of its own");
  }
  return name;
}

}  // namespace pliant
