#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "schema/documents.h"

namespace pliant::test {

/// What a reader says of a key that it does not know: the keys that it does, in the order of the
/// alphabet and as far as they are not many.
class KnownKeys {
 public:
  explicit KnownKeys(const std::string& refusal)
      : text_(refusal), are_keys_(refusal.find("unknown key") != std::string::npos) {
    const std::size_t cut = text_.find("\", ...");
    lists_ = text_.find(", ...") == std::string::npos || (are_keys_ && cut != std::string::npos);
    if (!lists_ || cut == std::string::npos) return;
    const std::size_t before = text_.rfind('"', cut - 1);
    last_ = text_.substr(before + 1, cut - before - 1);
  }

  /// Whether it speaks of keys, and not of what they have.
  bool are_keys() const { return are_keys_; }

  /// Nothing where the list does not reach so far.
  std::optional<bool> contain(const std::string& key) const {
    if (!lists_ || (last_ && key > *last_)) return std::nullopt;
    return text_.find(key) != std::string::npos;
  }

 private:
  std::string text_;
  bool are_keys_, lists_ = false;
  std::optional<std::string> last_;
};

/// Keys without values that are added to one object.
struct AddedKeys {
  SchemaCase document;
  nlohmann::json::json_pointer object;
  std::vector<std::string> keys;

  NamedDocument together() const {
    SchemaCase copy = document;
    for (const std::string& key : keys) copy.document[object][key] = nullptr;
    return {document.type + object.to_string() + " other keys added", std::move(copy)};
  }

  /// Whether a schema, which refuses the object, names each of them.
  bool are_in(const std::string& verdict) const {
    return verdict.find("must not contain {") != std::string::npos &&
           std::ranges::all_of(keys, [&](const std::string& key) {
             return verdict.find("'" + key + "'") != std::string::npos;
           });
  }
};

}  // namespace pliant::test
