#include <map>
#include <sstream>
#include <utility>

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include "pliant/base/errors.h"
#include "pliant/io/document.h"
#include "pliant/io/document_builder.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

// Documents are written by hand or list a mesh's vertices; measurements stand in CSV files.
constexpr std::size_t kMaxYamlSize = std::size_t{16} << 20;

// A node counts once more for each such part of its text, so that aliases of a long text are
// bounded too.
constexpr std::size_t kTextPerNode = 256;

std::size_t weight_of(const Node& node) {
  std::size_t weight = 1 + node.text.size() / kTextPerNode;
  for (const Node& item : node.items) weight += weight_of(item);
  for (const auto& [key, value] : node.fields) weight += 1 + weight_of(value);
  return weight;
}

/// Whether the quoted text that starts with the quote at `begin` ends within `text`.
bool is_closed(std::string_view text, std::size_t begin) {
  const char quote = text[begin];
  for (std::size_t at = begin + 1; at < text.size(); ++at) {
    if (text[at] == '\\' && quote == '"') {
      ++at;
    } else if (text[at] == quote) {
      const bool doubled = quote == '\'' && at + 1 < text.size() && text[at + 1] == quote;
      if (!doubled) return true;
      ++at;
    }
  }
  return false;
}

int line_of(const YAML::Mark& mark) { return mark.line + 1; }

/// Feeds a DocumentBuilder with the events of yaml-cpp's parser.
class YamlHandler : public YAML::EventHandler {
 public:
  explicit YamlHandler(std::string file) : builder_(std::move(file)) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (builder_.has_root()) {
      builder_.fail(line_of(mark), "a second document in the file", "one document a file");
    }
  }
  void OnDocumentEnd() override {}

  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    if (builder_.expects_key()) builder_.fail(line_of(mark), "a key is missing", "KEY: VALUE");
    Node node;
    node.line = line_of(mark);
    add(std::move(node), anchor);
  }

  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const int line = line_of(mark);
    if (builder_.expects_key()) builder_.fail(line, "an alias as a key", "a name");
    const auto anchored = anchored_.find(anchor);
    if (anchored == anchored_.end()) builder_.fail(line, "an alias inside its own anchor");
    spend(anchored->second.weight, line);
    Node copy = anchored->second.node;
    copy.line = line;
    builder_.value(std::move(copy));
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    const int line = line_of(mark);
    refuse_tag(tag, line);
    const bool quoted = tag == "!";
    if (quoted) last_quote_ = mark;
    if (builder_.expects_key()) {
      if (anchor != 0) builder_.fail(line, "an anchor on a key");
      add_key(value, quoted, line);
      return;
    }
    Node node;
    node.kind = Node::Kind::scalar;
    node.text = value;
    node.quoted = quoted;
    node.line = line;
    add(std::move(node), anchor);
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value /*style*/) override {
    open(Node::Kind::sequence, mark, tag, anchor);
  }
  void OnSequenceEnd() override { close(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value /*style*/) override {
    open(Node::Kind::mapping, mark, tag, anchor);
  }
  void OnMapEnd() override { close(); }

  DocumentBuilder& builder() { return builder_; }

  /// yaml-cpp takes a quoted text that the end of the file cuts off for a complete one.
  void refuse_open_quote(std::string_view text) const {
    const auto begin = static_cast<std::size_t>(last_quote_.pos);
    if (begin >= text.size() || (text[begin] != '"' && text[begin] != '\'')) return;
    if (!is_closed(text, begin)) {
      builder_.fail(line_of(last_quote_), "a quote is opened and never closed");
    }
  }

 private:
  struct Anchored {
    Node node;
    std::size_t weight = 0;
  };

  void refuse_tag(const std::string& tag, int line) const {
    if (tag.empty() || tag == "?" || tag == "!") return;
    builder_.fail(line, "the tag " + quoted_value(tag), "a value without tag");
  }

  void add_key(const std::string& name, bool in_quotes, int line) {
    if (name == "<<" && !in_quotes) {
      builder_.fail(line, "a merge key (<<)", "the fields written out, or KEY: *alias");
    }
    spend(1, line);
    builder_.key(name, line);
  }

  void add(Node node, YAML::anchor_t anchor) {
    spend(1, node.line);
    if (anchor != 0) remember(node, anchor);
    builder_.value(std::move(node));
  }

  void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag,
            YAML::anchor_t anchor) {
    const int line = line_of(mark);
    refuse_tag(tag, line);
    if (builder_.expects_key()) builder_.fail(line, "a list or mapping as a key", "a name");
    spend(1, line);
    builder_.open(kind, line);
    open_anchors_.push_back(anchor);
  }

  void close() {
    const Node* node = builder_.close();
    const YAML::anchor_t anchor = open_anchors_.back();
    open_anchors_.pop_back();
    if (anchor != 0) remember(*node, anchor);
  }

  void remember(const Node& node, YAML::anchor_t anchor) {
    const std::size_t weight = weight_of(node);
    spend(weight, node.line);
    anchored_[anchor] = {node, weight};
  }

  void spend(std::size_t weight, int line) {
    nodes_ += weight;
    if (nodes_ <= kMaxYamlNodes) return;
    builder_.fail(line, "too many values (aliases of aliases grow without bound: an alias bomb)",
                  fmt::format("at most {} values", kMaxYamlNodes));
  }

  DocumentBuilder builder_;
  std::vector<YAML::anchor_t> open_anchors_;
  std::map<YAML::anchor_t, Anchored> anchored_;
  std::size_t nodes_ = 0;
  YAML::Mark last_quote_ = YAML::Mark::null_mark();
};

}  // namespace

Document parse_yaml(std::string_view text, std::string file) {
  YamlHandler handler(std::move(file));
  const DocumentBuilder& builder = handler.builder();
  if (text.size() > kMaxYamlSize) {
    builder.fail(0, "the file is too large",
                 fmt::format("at most {} MiB of YAML", kMaxYamlSize >> 20));
  }
  try {
    std::istringstream stream{std::string(text)};
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(handler)) {
    }
    handler.refuse_open_quote(text);
  } catch (const YAML::Exception& error) {
    builder.fail(error.mark.is_null() ? 0 : line_of(error.mark), error.msg, "YAML");
  }
  if (!builder.has_root()) builder.fail(0, "the file is empty");
  Document document = std::move(handler.builder()).finish();
  if (document.root.kind == Node::Kind::null) builder.fail(0, "the file is empty");
  return document;
}

Document read_yaml(const std::filesystem::path& path) {
  const std::string file = path.string();
  return parse_yaml(decode_text(read_text_file(path, kMaxYamlSize), {}, file), file);
}

}  // namespace pliant
