#pragma once

#include <initializer_list>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/io/document.h"

namespace pliant {

class Fields;

/// One value of a document, read as what the schema says it is. Each reading function throws an
/// InputError with file, line and dotted path when the value is something else. The document must
/// outlive it.
class Value {
 public:
  /// The root of a document.
  explicit Value(const Document& document);

  Location location() const;
  bool is_null() const { return kind() == Node::Kind::null; }
  bool is_scalar() const { return kind() == Node::Kind::scalar; }
  bool is_sequence() const { return kind() == Node::Kind::sequence; }
  bool is_mapping() const { return kind() == Node::Kind::mapping; }

  /// Any scalar as text.
  /// @param expected  what it should be, for the error
  std::string text(const std::string& expected = "a text") const;
  /// A finite number without unit, in quotes or not (instruments write both).
  double number() const;
  /// A number with a unit of `dimension`, in SI.
  double quantity(Dimension dimension) const;
  /// The same above zero, or not below it.
  double positive_quantity(Dimension dimension) const;
  double quantity_from_zero(Dimension dimension) const;
  /// `true` or `false`.
  bool flag() const;
  /// A whole number in [low, high].
  int integer(int low, int high) const;
  /// One of `allowed`; the error names the nearest of them.
  std::string choice(std::span<const std::string_view> allowed) const;
  std::string choice(std::initializer_list<std::string_view> allowed) const;

  /// The elements of a sequence.
  std::vector<Value> items() const;
  /// The elements of a sequence of numbers.
  std::vector<double> numbers() const;
  /// The fields of a mapping.
  Fields fields() const;

  /// Throws the InputError of this value.
  [[noreturn]] void fail(const std::string& problem, const std::string& expected = {}) const;

 private:
  friend class Fields;
  Value(const Document& document, const Node& node, std::string path);

  Node::Kind kind() const { return missing_ ? Node::Kind::null : node_->kind; }
  const std::string& scalar(const std::string& expected) const;
  /// Fails because the value is of another kind, or not there at all.
  [[noreturn]] void fail_kind(const std::string& expected) const;

  const Document* document_;
  const Node* node_;  // of a missing value: the mapping that lacks it
  std::string path_;
  /// What is said of a value that is not there.
  std::optional<std::string> missing_;
};

/// The fields of a mapping. It remembers which keys were asked for, so that `finish` can refuse
/// those that mean nothing. A key whose value is null counts as not given.
class Fields {
 public:
  Location location() const { return mapping_.location(); }

  /// The value of a key that must be there. Where it is not, reading the value throws, whatever it
  /// is read as: only then is it known what is expected.
  Value require(std::string_view key);
  std::optional<Value> optional(std::string_view key);

  /// The scalars of a mapping of free texts, by their keys; empty where `key` is not given.
  std::map<std::string, std::string> texts(std::string_view key);

  /// Every key and value, also null ones; all count as asked for.
  std::vector<std::pair<std::string, Value>> all();
  /// Every key; none counts as asked for.
  std::vector<std::string> keys() const;

  /// @throws InputError on the first key that was never asked for, with the nearest of those that
  ///         were
  void finish() const;

 private:
  friend class Value;
  explicit Fields(Value mapping) : mapping_(std::move(mapping)) {}

  std::string path_of(std::string_view key) const;
  /// The nearest of the keys that are there and that nobody has asked for, in words.
  std::string did_you_mean_by(std::string_view key) const;

  Value mapping_;
  std::set<std::string, std::less<>> asked_;
};

/// Checks the document's first line, `pliant: TYPE/VERSION`.
/// @throws InputError naming the type or version found
void require_document(Fields& fields, std::string_view type, int version);

/// The document's `pliant:` text, e.g. "study/1"; none when it has none.
std::optional<std::string> document_type(const Document& document);

}  // namespace pliant
