#include "pliant/io/document_builder.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"

namespace pliant {
namespace {

int depth_of(const Node& node) {
  int depth = 0;
  for (const Node& item : node.items) depth = std::max(depth, depth_of(item));
  for (const auto& [key, value] : node.fields) depth = std::max(depth, depth_of(value));
  const bool leaf = node.kind == Node::Kind::null || node.kind == Node::Kind::scalar;
  return leaf ? 0 : depth + 1;
}

bool holds_nul(const std::string& text) { return text.find('\0') != std::string::npos; }

}  // namespace

bool DocumentBuilder::expects_key() const {
  return !open_.empty() && open_.back().node.kind == Node::Kind::mapping && !open_.back().key_given;
}

void DocumentBuilder::key(std::string name, int line) {
  PLIANT_ASSERT(expects_key(), "a key stands in a mapping");
  if (holds_nul(name)) fail(line, "a NUL character in a key");
  OpenNode& mapping = open_.back();
  const auto [earlier, is_new] = mapping.key_lines.emplace(name, line);
  if (!is_new) {
    throw InputError({file(), line, std::move(name)},
                     fmt::format("given twice (first in line {})", earlier->second));
  }
  mapping.key = std::move(name);
  mapping.key_line = line;
  mapping.key_given = true;
}

void DocumentBuilder::value(Node node) {
  PLIANT_ASSERT(!expects_key(), "a value of a mapping follows its key");
  if (holds_nul(node.text)) fail(node.line, "a NUL character in a text");
  if (depth() + depth_of(node) > kMaxDocumentDepth) {
    fail(node.line, "nested too deeply", fmt::format("at most {} levels", kMaxDocumentDepth));
  }
  attach(std::move(node));
}

void DocumentBuilder::open(Node::Kind kind, int line) {
  if (depth() >= kMaxDocumentDepth) {
    fail(line, "nested too deeply", fmt::format("at most {} levels", kMaxDocumentDepth));
  }
  OpenNode& opened = open_.emplace_back();
  opened.node.kind = kind;
  opened.node.line = line;
}

const Node* DocumentBuilder::close() {
  PLIANT_ASSERT(!open_.empty() && !open_.back().key_given, "nothing to close");
  Node node = std::move(open_.back().node);
  open_.pop_back();
  attach(std::move(node));
  if (open_.empty()) return &document_.root;
  const Node& parent = open_.back().node;
  return parent.kind == Node::Kind::sequence ? &parent.items.back() : &parent.fields.back().value;
}

void DocumentBuilder::attach(Node node) {
  if (open_.empty()) {
    PLIANT_ASSERT(!has_root_, "a document has one root");
    document_.root = std::move(node);
    has_root_ = true;
    return;
  }
  OpenNode& parent = open_.back();
  if (parent.node.kind == Node::Kind::sequence) {
    parent.node.items.push_back(std::move(node));
    return;
  }
  node.line = parent.key_line;
  parent.node.fields.push_back({std::move(parent.key), std::move(node)});
  parent.key_given = false;
}

std::string DocumentBuilder::path() const {
  std::string path;
  for (const OpenNode& open : open_) {
    if (open.node.kind == Node::Kind::sequence) {
      path += fmt::format("[{}]", open.node.items.size());
    } else if (open.key_given) {
      path += (path.empty() ? "" : ".") + open.key;
    }
  }
  return path;
}

Document DocumentBuilder::finish() && {
  PLIANT_ASSERT(open_.empty() && has_root_, "the document is complete");
  return std::move(document_);
}

void DocumentBuilder::fail(int line, const std::string& problem,
                           const std::string& expected) const {
  throw InputError({file(), line, {}}, problem, expected);
}

}  // namespace pliant
