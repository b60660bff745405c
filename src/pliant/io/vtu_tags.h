#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace pliant {

/// The tags of a .vtu file, one after the other. It is no well-formed XML where raw bytes are
/// appended.
class VtuTags {
 public:
  explicit VtuTags(std::string_view text) : rest_(text) {}

  /// The next tag without its brackets; none at the end and where the appended bytes begin.
  std::optional<std::string_view> next();
  /// What stands between the last tag and the one that comes.
  std::string_view text() const { return rest_.substr(0, rest_.find('<')); }
  /// Where the appended bytes begin, its tag is the last one: what follows it.
  std::string_view appended() const { return rest_; }
  std::string_view appended_tag() const { return appended_tag_; }

 private:
  std::size_t end_of_tag() const;

  std::string_view rest_;
  std::string_view appended_tag_;
};

/// The text of an attribute; empty where the tag does not have it.
std::string vtu_attribute(std::string_view tag, const std::string& name);

}  // namespace pliant
