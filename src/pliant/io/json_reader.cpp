#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/document.h"
#include "pliant/io/document_builder.h"
#include "pliant/io/text_file.h"

namespace pliant {
namespace {

/// An input iterator that tells how far the parser has read.
class TrackingIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  TrackingIterator(const char* at, const char** read_to) : at_(at), read_to_(read_to) {}

  reference operator*() const { return *at_; }
  TrackingIterator& operator++() {
    *read_to_ = ++at_;
    return *this;
  }
  TrackingIterator operator++(int) {
    TrackingIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const TrackingIterator& other) const { return at_ == other.at_; }
  bool operator!=(const TrackingIterator& other) const { return at_ != other.at_; }

 private:
  const char* at_;
  const char** read_to_;
};

/// The line of the character last read, counted on as the parser goes.
class LineCounter {
 public:
  explicit LineCounter(const char* begin) : counted_to_(begin), read_to_(begin) {}

  const char** read_to() { return &read_to_; }

  /// A line feed that was read counts as part of the line it ends: the parser reads one character
  /// past a number.
  int line() {
    if (read_to_ - counted_to_ > 1) {
      const char* last = read_to_ - 1;
      line_ += static_cast<int>(std::count(counted_to_, last, '\n'));
      counted_to_ = last;
    }
    return line_;
  }

 private:
  const char* counted_to_;
  const char* read_to_;
  int line_ = 1;
};

/// "[...] parse error at line 1, column 5: syntax error while parsing value - unexpected ..." ->
/// "syntax error while parsing value - unexpected ...".
std::string problem_of(const std::string& message) {
  const std::size_t column = message.find("column ");
  const std::size_t colon = column == std::string::npos ? column : message.find(": ", column);
  return colon == std::string::npos ? message : message.substr(colon + 2);
}

/// Feeds a DocumentBuilder with the events of nlohmann's parser, which does not recurse.
class JsonHandler : public nlohmann::json_sax<nlohmann::json> {
 public:
  JsonHandler(std::string file, LineCounter& lines) : builder_(std::move(file)), lines_(lines) {}

  bool null() override {
    Node node;
    node.line = lines_.line();
    builder_.value(std::move(node));
    return true;
  }
  bool boolean(bool value) override { return scalar(value ? "true" : "false", false); }
  bool number_integer(number_integer_t value) override {
    return scalar(std::to_string(value), false);
  }
  bool number_unsigned(number_unsigned_t value) override {
    return scalar(std::to_string(value), false);
  }
  bool number_float(number_float_t /*value*/, const string_t& text) override {
    return scalar(text, false);
  }
  bool string(string_t& value) override { return scalar(std::move(value), true); }
  bool binary(binary_t& /*value*/) override { return false; }  // no such thing in JSON text

  bool start_object(std::size_t /*size*/) override { return open(Node::Kind::mapping); }
  bool key(string_t& name) override {
    builder_.key(std::move(name), lines_.line());
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t /*size*/) override { return open(Node::Kind::sequence); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t /*position*/, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int kNumberOverflow = 406;  // the library's number of the only one about values
    if (error.id == kNumberOverflow) {
      throw InputError({builder_.file(), lines_.line(), builder_.path()},
                       quoted_value(token) + " is not a finite number", "a number");
    }
    builder_.fail(lines_.line(), problem_of(error.what()));
  }

  DocumentBuilder& builder() { return builder_; }

 private:
  bool scalar(std::string text, bool in_quotes) {
    Node node;
    node.kind = Node::Kind::scalar;
    node.text = std::move(text);
    node.quoted = in_quotes;
    node.line = lines_.line();
    builder_.value(std::move(node));
    return true;
  }
  bool open(Node::Kind kind) {
    builder_.open(kind, lines_.line());
    return true;
  }
  bool close() {
    builder_.close();
    return true;
  }

  DocumentBuilder builder_;
  LineCounter& lines_;
};

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace

Document parse_json(std::string_view text, std::string file) {
  const char* begin = text.data();
  LineCounter lines(begin);
  JsonHandler handler(std::move(file), lines);
  if (is_blank(text)) handler.builder().fail(0, "the file is empty");
  nlohmann::json::sax_parse(TrackingIterator(begin, lines.read_to()),
                            TrackingIterator(begin + text.size(), lines.read_to()), &handler);
  return std::move(handler.builder()).finish();
}

Document read_json(const std::filesystem::path& path) {
  const std::string file = path.string();
  return parse_json(decode_text(read_text_file(path), {}, file), file);
}

}  // namespace pliant
