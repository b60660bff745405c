#include "pliant/io/vtu_tags.h"

namespace pliant {

std::optional<std::string_view> VtuTags::next() {
  const std::size_t begin = rest_.find('<');
  if (begin == std::string_view::npos) return std::nullopt;
  rest_.remove_prefix(begin + 1);
  const std::size_t end = end_of_tag();
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view tag = rest_.substr(0, end);
  rest_.remove_prefix(end + 1);
  if (!tag.starts_with("AppendedData")) return tag;
  appended_tag_ = tag;
  return std::nullopt;
}

// A value in quotes may hold the bracket that ends a tag.
std::size_t VtuTags::end_of_tag() const {
  bool quoted = false;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    if (rest_[i] == '"') quoted = !quoted;
    if (rest_[i] == '>' && !quoted) return i;
  }
  return std::string_view::npos;
}

std::string vtu_attribute(std::string_view tag, const std::string& name) {
  const std::string opening = " " + name + "=\"";
  const std::size_t at = tag.find(opening);
  if (at == std::string_view::npos) return "";
  const std::string_view value = tag.substr(at + opening.size());
  return std::string(value.substr(0, value.find('"')));
}

}  // namespace pliant
