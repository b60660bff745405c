#include "pliant/base/errors.h"

#include <cmath>
#include <cstddef>
#include <utility>

#include <fmt/format.h>

namespace pliant {
namespace {

// Long enough for a path or a list of names, short enough for one line of a terminal's scrollback.
constexpr std::size_t kMaxPartSize = 600;
constexpr std::size_t kMaxValueSize = 60;

/// Size of the well-formed UTF-8 character at the start of `text`, 0 when there is none.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  const std::size_t size = lead < 0x80                   ? 1
                           : lead >= 0xC2 && lead < 0xE0 ? 2
                           : lead >= 0xE0 && lead < 0xF0 ? 3
                           : lead >= 0xF0 && lead < 0xF5 ? 4
                                                         : 0;
  if (size > text.size()) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  return size;
}

bool is_control(std::string_view character) {
  const auto lead = static_cast<unsigned char>(character[0]);
  if (character.size() == 1) return lead < 0x20 || lead == 0x7F;
  return lead == 0xC2 && static_cast<unsigned char>(character[1]) < 0xA0;  // U+0080 to U+009F
}

std::string escaped(std::string_view bytes) {
  if (bytes == "\n") return "\\n";
  if (bytes == "\r") return "\\r";
  if (bytes == "\t") return "\\t";
  std::string result;
  for (const char byte : bytes) {
    result += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  }
  return result;
}

std::string describe(const Location& where, const std::string& problem,
                     const std::string& expected) {
  std::string line;
  if (!where.file.empty()) {
    line += one_line(where.file, kMaxPartSize);
    if (where.line > 0) line += fmt::format(":{}", where.line);
    line += ": ";
  } else if (where.line > 0) {
    line += fmt::format("line {}: ", where.line);
  }
  if (!where.field.empty()) line += one_line(where.field, kMaxPartSize) + ": ";
  line += one_line(problem, kMaxPartSize);
  if (!expected.empty()) line += "; expected " + one_line(expected, kMaxPartSize);
  return line;
}

// What is not known of a search is not told.
std::string told_of(int iterations, double best_residual) {
  std::string told;
  if (iterations > 0) told += fmt::format(" after {} iterations", iterations);
  const bool reached = best_residual > 0 && std::isfinite(best_residual);
  if (reached) told += fmt::format(" (best residual {:.3g})", best_residual);
  return told;
}

}  // namespace

std::string one_line(std::string_view text, std::size_t max_bytes) {
  std::string line;
  while (!text.empty()) {
    const std::size_t size = character_size(text);
    const std::string_view character = text.substr(0, size == 0 ? 1 : size);
    const std::string shown =
        size == 0 || is_control(character) ? escaped(character) : std::string(character);
    if (line.size() + shown.size() > max_bytes) return line + "...";
    line += shown;
    text.remove_prefix(character.size());
  }
  return line;
}

std::string quoted_value(std::string_view value) {
  return '"' + one_line(value, kMaxValueSize) + '"';
}

InputError::InputError(Location where, std::string problem, std::string expected)
    : std::runtime_error(describe(where, problem, expected)),
      where_(std::move(where)),
      problem_(std::move(problem)),
      expected_(std::move(expected)) {}

SolverError::SolverError(std::string what_failed, int iterations, double best_residual)
    : std::runtime_error(one_line(what_failed, kMaxPartSize) + " did not converge" +
                         told_of(iterations, best_residual)),
      iterations_(iterations),
      best_residual_(best_residual) {}

OutputError::OutputError(std::string path, std::string reason)
    : std::runtime_error(fmt::format("{}: cannot be written: {}", one_line(path, kMaxPartSize),
                                     one_line(reason, kMaxPartSize))),
      path_(std::move(path)),
      reason_(std::move(reason)) {}

Interrupted::Interrupted() : std::runtime_error("interrupted") {}

}  // namespace pliant
