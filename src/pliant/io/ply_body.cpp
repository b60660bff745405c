#include "pliant/io/ply_body.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <system_error>

#include <fmt/format.h>

#include "pliant/io/byte_order.h"

namespace pliant {
namespace {

class AsciiBody : public PlyBody {
 public:
  AsciiBody(std::string_view bytes, int line, const std::string& file)
      : rest_(bytes), line_(line), file_(file) {}

  void begin_row(const PlyElement& element, std::size_t row) override {
    element_ = &element;
    row_ = row;
    const std::size_t end = rest_.find('\n');
    line_text_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++line_;
  }

  double next(PlyType type) override {
    const std::string_view text = next_word();
    if (text.empty()) fail("the line has too few numbers", "one for each property");
    switch (type) {
      case PlyType::int8:
        return parse<std::int8_t>(text, type);
      case PlyType::uint8:
        return parse<std::uint8_t>(text, type);
      case PlyType::int16:
        return parse<std::int16_t>(text, type);
      case PlyType::uint16:
        return parse<std::uint16_t>(text, type);
      case PlyType::int32:
        return parse<std::int32_t>(text, type);
      case PlyType::uint32:
        return parse<std::uint32_t>(text, type);
      case PlyType::float32:
        return parse<float>(text, type);
      case PlyType::float64:
        break;
    }
    return parse<double>(text, type);
  }

  void end_row() override {
    const std::string_view text = next_word();
    if (!text.empty()) fail(quoted_value(text) + " is more than the header says", {});
  }

  std::size_t max_count(PlyType) const override { return line_text_.size(); }
  int next_line() const override { return line_ + 1; }
  std::size_t bytes_left() const override {
    return rest_.find_first_not_of(" \t\r\n") == std::string_view::npos ? 0 : rest_.size();
  }

  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const override {
    throw InputError(ply_row_location(file_, line_, element_->name, row_), problem, expected);
  }

 private:
  std::string_view next_word() {
    constexpr std::string_view kBlanks = " \t\r";
    const std::size_t begin = std::min(line_text_.find_first_not_of(kBlanks), line_text_.size());
    line_text_.remove_prefix(begin);
    const std::size_t end = std::min(line_text_.find_first_of(kBlanks), line_text_.size());
    const std::string_view word = line_text_.substr(0, end);
    line_text_.remove_prefix(end);
    return word;
  }

  template <typename T>
  double parse(std::string_view text, PlyType type) const {
    T value{};
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
    const char* begin = text.data() + (plus ? 1 : 0);
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end) {
      fail(fmt::format("{} is no {}", quoted_value(text), name_of(type)), {});
    }
    return static_cast<double>(value);
  }

  std::string_view rest_;
  std::string_view line_text_;
  int line_;
  const std::string& file_;
  const PlyElement* element_ = nullptr;
  std::size_t row_ = 0;
};

class BinaryBody : public PlyBody {
 public:
  BinaryBody(std::string_view bytes, ByteOrder order, const std::string& file)
      : rest_(bytes), order_(order), file_(file) {}

  void begin_row(const PlyElement& element, std::size_t row) override {
    element_ = &element;
    row_ = row;
  }

  double next(PlyType type) override {
    switch (type) {
      case PlyType::int8:
        return take<std::int8_t>();
      case PlyType::uint8:
        return take<std::uint8_t>();
      case PlyType::int16:
        return take<std::int16_t>();
      case PlyType::uint16:
        return take<std::uint16_t>();
      case PlyType::int32:
        return take<std::int32_t>();
      case PlyType::uint32:
        return take<std::uint32_t>();
      case PlyType::float32:
        return static_cast<double>(take<float>());
      case PlyType::float64:
        break;
    }
    return take<double>();
  }

  void end_row() override {}
  std::size_t max_count(PlyType type) const override { return rest_.size() / size_of(type); }
  int next_line() const override { return 0; }
  std::size_t bytes_left() const override { return rest_.size(); }

  [[noreturn]] void fail(const std::string& problem, const std::string& expected) const override {
    throw InputError(ply_row_location(file_, 0, element_->name, row_), problem, expected);
  }

 private:
  template <typename T>
  T take() {
    if (rest_.size() < sizeof(T)) fail("the file ends here", {});
    const T value = load_number<T>(rest_.data(), order_);
    rest_.remove_prefix(sizeof(T));
    return value;
  }

  std::string_view rest_;
  ByteOrder order_;
  const std::string& file_;
  const PlyElement* element_ = nullptr;
  std::size_t row_ = 0;
};

}  // namespace

Location ply_row_location(const std::string& file, int line, const std::string& element,
                          std::size_t row) {
  return {file, line, fmt::format("{} {}", element, row)};
}

std::unique_ptr<PlyBody> make_ply_body(std::string_view bytes, const PlyHeader& header,
                                       const std::string& file) {
  const std::string_view body = bytes.substr(header.size);
  if (header.format == PlyFormat::ascii) {
    return std::make_unique<AsciiBody>(body, header.lines, file);
  }
  const bool little = header.format == PlyFormat::binary_little_endian;
  return std::make_unique<BinaryBody>(body, little ? ByteOrder::little : ByteOrder::big, file);
}

}  // namespace pliant
