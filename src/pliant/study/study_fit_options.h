#pragma once

#include <string>
#include <vector>

namespace pliant {

/// What a fit does beyond fitting.
struct StudyFitOptions {
  bool compare_friction = false;  ///< rank the parameterisations of [T] Fig. 5.3
  std::vector<std::string>
      profiles;               ///< parameters (names or patterns) whose profile likelihood is wanted
  bool compare_laws = false;  ///< rank further laws of components, e.g. softening
};

}  // namespace pliant
