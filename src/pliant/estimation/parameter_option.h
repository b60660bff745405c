#pragma once

#include <map>
#include <optional>
#include <string>

#include "pliant/base/name_pattern.h"
#include "pliant/estimation/fit_settings.h"

namespace pliant {

/// What `fit.bounds`, `fit.fix` or `fit.priors` of a study say of a parameter: the value of the
/// first pattern that matches its name; an exact name goes before patterns.
template <class T>
std::optional<T> option_for(const std::string& name, const std::map<std::string, T>& options) {
  const auto exact = options.find(name);
  if (exact != options.end()) return exact->second;
  for (const auto& [pattern, value] : options) {
    if (matches(pattern, name)) return value;
  }
  return std::nullopt;
}

}  // namespace pliant
