#include "pliant/io/yaml_text.h"

#include <nlohmann/json.hpp>

namespace pliant {

// JSON's quotes are YAML's.
std::string yaml_text(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace pliant
