#pragma once

#include <string>

namespace pliant::test {

/// A study with one experiment; the experiment stands on line 4, `more` from line 5 on.
inline std::string with_experiment(const std::string& experiment, const std::string& more = "") {
  return "pliant: study/1\nname: jersey\nexperiments:\n  - " + experiment + "\n" + more;
}

inline constexpr const char* kWeightsEntry =
    "{name: w, type: hanging-weights, direction: warp, data: w.csv, length: 1 m, width: 1 m}";

inline std::string study_with_more(const std::string& more) {
  return with_experiment(kWeightsEntry, more);
}

}  // namespace pliant::test
