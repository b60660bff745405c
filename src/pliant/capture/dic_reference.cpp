#include "pliant/capture/dic_reference.h"

namespace pliant {

std::filesystem::path path_beside(const Value& value, const char* expected) {
  return std::filesystem::path(value.location().file).parent_path() / value.text(expected);
}

}  // namespace pliant
