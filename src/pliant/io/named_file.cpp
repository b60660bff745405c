#include "pliant/io/named_file.h"

#include <system_error>

namespace pliant {

std::filesystem::path read_named_file(const Value& value, const std::string& expected) {
  const std::string name = value.text(expected);
  std::filesystem::path file = std::filesystem::path(value.location().file).parent_path() / name;
  std::error_code ignored;
  if (name.empty() || !std::filesystem::exists(file, ignored)) {
    value.fail("the file " + quoted_value(file.string()) + " does not exist",
               expected + ", relative to the document");
  }
  return file;
}

}  // namespace pliant
