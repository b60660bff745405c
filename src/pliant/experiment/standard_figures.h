#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

namespace pliant {

/// What a test's standard reports of its readings.
struct StandardFigures {
  std::string key;              ///< of the JSON object
  nlohmann::ordered_json json;  ///< numbers that the rows alone cannot tell are null
  std::string label;            ///< of the texts: what they were taken at
  std::vector<std::string> texts;
};

}  // namespace pliant
