#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "pliant/io/document.h"

namespace pliant {

/// Makes the tree of a document from a parser's events, with the checks that YAML and JSON share:
/// depth, duplicate keys, NUL characters.
class DocumentBuilder {
 public:
  explicit DocumentBuilder(std::string file) { document_.file = std::move(file); }

  const std::string& file() const { return document_.file; }

  /// Whether the next scalar is a key of the open mapping.
  bool expects_key() const;
  void key(std::string name, int line);
  /// Adds a complete value: a scalar, a null or a copied subtree.
  void value(Node node);
  /// Opens a sequence or a mapping.
  void open(Node::Kind kind, int line);
  /// Closes the innermost one and returns it where it now stands in the tree; the pointer is good
  /// until the next event.
  const Node* close();

  /// Dotted path of the value that comes next, e.g. "components.shear.stiffness.value[2]".
  std::string path() const;

  /// Depth of the open sequences and mappings.
  int depth() const { return static_cast<int>(open_.size()); }
  bool has_root() const { return has_root_; }

  /// The document; none of its values may be open.
  Document finish() &&;

  [[noreturn]] void fail(int line, const std::string& problem,
                         const std::string& expected = {}) const;

 private:
  struct OpenNode {
    Node node;
    bool key_given = false;
    std::string key;
    int key_line = 0;
    std::unordered_map<std::string, int> key_lines;
  };

  void attach(Node node);

  Document document_;
  bool has_root_ = false;
  std::vector<OpenNode> open_;
};

}  // namespace pliant
