#include "pliant/io/token_reader.h"

#include <algorithm>
#include <limits>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"

namespace pliant {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

}  // namespace

// Blanks and comments before the next word.
void TokenReader::skip() {
  while (!rest_.empty()) {
    if (comments_ && rest_.front() == '#') {
      rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    } else if (kBlanks.find(rest_.front()) != std::string_view::npos) {
      line_ += rest_.front() == '\n' ? 1 : 0;
      rest_.remove_prefix(1);
    } else {
      return;
    }
  }
}

std::optional<std::string_view> TokenReader::next() {
  skip();
  if (rest_.empty()) return std::nullopt;
  const std::size_t end = std::min(rest_.find_first_of(kBlanks), rest_.size());
  const std::string_view word = rest_.substr(0, end);
  rest_.remove_prefix(end);
  return word;
}

std::string_view TokenReader::word(const std::string& expected) {
  const auto found = next();
  if (!found) fail("ends too early", expected);
  return *found;
}

double TokenReader::number(const std::string& what) {
  const std::string_view text = word(what);
  const std::optional<double> value = parse_number(text);
  if (!value) fail(quoted_value(text) + " is no number", what);
  return *value;
}

int TokenReader::integer(const std::string& what, int low) {
  const std::string_view text = word(what);
  const std::optional<long> value = parse_integer(text);
  if (!value || *value < low || *value > std::numeric_limits<int>::max()) {
    fail(quoted_value(text) + " is no such number", what);
  }
  return static_cast<int>(*value);
}

std::string TokenReader::quoted(const std::string& what) {
  skip();
  const std::size_t end = rest_.find('"', 1);
  if (rest_.empty() || rest_.front() != '"' || end == std::string_view::npos) {
    fail("is no text in quotes", what);
  }
  const std::string text(rest_.substr(1, end - 1));
  rest_.remove_prefix(end + 1);
  return text;
}

void TokenReader::fail(const std::string& problem, const std::string& expected) const {
  throw InputError({file_, line_, ""}, problem, expected);
}

}  // namespace pliant
