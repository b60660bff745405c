#include <array>
#include <charconv>
#include <system_error>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/capture/pattern.h"
#include "pliant/capture/tag_detector.h"
#include "pliant/io/fields.h"

namespace pliant {
namespace {

constexpr int kMostInARow = 200;

double read_length(const Value& value, double scale) {
  return scale * value.positive_quantity(Dimension::length);
}

void read_family(Fields& fields) {
  if (const auto v = fields.optional("family")) v->choice({"tag36h11"});
}

TagBoard read_board(const Value& value, double scale) {
  Fields fields = value.fields();
  read_family(fields);
  TagBoard board;
  board.columns = fields.require("columns").integer(1, kMostInARow);
  const Value rows = fields.require("rows");
  board.rows = rows.integer(1, kMostInARow);
  board.tag = read_length(fields.require("tag"), scale);
  board.gap = read_length(fields.require("gap"), scale);
  if (auto v = fields.optional("first_code")) board.first_code = v->integer(0, kTagCodes - 1);
  fields.finish();
  if (board.first_code + board.tag_count() > kTagCodes) {
    rows.fail(fmt::format("asks for codes up to {}", board.first_code + board.tag_count() - 1),
              fmt::format("codes up to {}, the last of tag36h11", kTagCodes - 1));
  }
  return board;
}

Chessboard read_chessboard(const Value& value, double scale) {
  constexpr int kLeast = 2;
  Fields fields = value.fields();
  Chessboard board;
  board.columns = fields.require("columns").integer(kLeast, kMostInARow);
  board.rows = fields.require("rows").integer(kLeast, kMostInARow);
  board.square = read_length(fields.require("square"), scale);
  fields.finish();
  return board;
}

ClipCodes read_clips(const Value& value, double scale) {
  Fields fields = value.fields();
  read_family(fields);
  ClipCodes clips;
  clips.tag = read_length(fields.require("tag"), scale);
  const Value edge = fields.require("edge");
  clips.edge = read_length(edge, scale);
  if (clips.edge < clips.tag / 2) {
    edge.fail("is within the tag", fmt::format("{} or more, half of the tag",
                                               format_quantity(clips.tag / 2, Dimension::length)));
  }
  const Value codes = fields.require("codes");
  for (const Value& item : codes.items()) {
    const int code = item.integer(0, kTagCodes - 1);
    if (clips.has(code)) item.fail(fmt::format("{} stands here twice", code), "a code for each");
    clips.codes.push_back(code);
  }
  if (clips.codes.empty()) codes.fail("names no code", "the codes of the labels");
  fields.finish();
  return clips;
}

std::uint64_t read_seed(const Value& value) {
  const std::string text = value.text("a whole number");
  const char* const end = text.data() + text.size();
  std::uint64_t seed = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, seed);
  if (error != std::errc() || rest != end) value.fail("is no seed", "a whole number from 0");
  return seed;
}

ClothPattern read_cloth(const Value& value, double scale) {
  constexpr int kMostOctaves = 12;
  Fields fields = value.fields();
  ClothPattern cloth;
  if (auto v = fields.optional("seed")) cloth.seed = read_seed(*v);
  cloth.camera = read_length(fields.require("camera"), 1);
  cloth.finest = read_length(fields.require("finest"), scale);
  cloth.octaves = fields.require("octaves").integer(1, kMostOctaves);
  const Value dpi = fields.require("dpi");
  cloth.dpi = dpi.number();
  if (cloth.dpi <= 0) dpi.fail("is not positive", "dots per inch, e.g. 600");
  fields.finish();
  return cloth;
}

void read_ruler(const Value& value, Pattern& pattern) {
  Fields fields = value.fields();
  pattern.ruler = fields.require("drawn").positive_quantity(Dimension::length);
  if (const auto v = fields.optional("measured")) {
    constexpr double kMostStretch = 2;  // of a printer that was told to fill the page
    pattern.measured_ruler = v->positive_quantity(Dimension::length);
    const double scale = *pattern.measured_ruler / pattern.ruler;
    if (scale > kMostStretch || scale < 1 / kMostStretch) {
      v->fail("is not near what was drawn", "the ruler's length on the print, from end to end");
    }
  }
  fields.finish();
}

void read_sheet(const Value& value, Pattern& pattern) {
  Fields fields = value.fields();
  pattern.sheet.x() = fields.require("width").positive_quantity(Dimension::length);
  pattern.sheet.y() = fields.require("height").positive_quantity(Dimension::length);
  fields.finish();
}

/// What exactly one of the four keys tells.
void read_kind(Fields& fields, double scale, Pattern& pattern) {
  constexpr std::array kKinds{"board", "chessboard", "clips", "cloth"};
  std::optional<std::string> found;
  for (const char* name : kKinds) {
    const auto value = fields.optional(name);
    if (!value) continue;
    if (found) value->fail(fmt::format("stands beside `{}`", *found), "one of them");
    found = name;
    if (*found == "board") pattern.kind = read_board(*value, scale);
    if (*found == "chessboard") pattern.kind = read_chessboard(*value, scale);
    if (*found == "clips") pattern.kind = read_clips(*value, scale);
    if (*found == "cloth") pattern.kind = read_cloth(*value, scale);
  }
  if (found) return;
  const Location where = fields.location();
  throw InputError({where.file, where.line}, "says nothing that was drawn",
                   "`board`, `chessboard`, `clips` or `cloth`");
}

std::string length_text(double length) {
  return format_number(1e3 * length, 9) + " mm";  // a picometre: 20 mm are not 20.000000000000004
}

std::string text_of(const TagBoard& board) {
  return fmt::format(
      "{{family: tag36h11, columns: {}, rows: {}, tag: {}, gap: {}, first_code: {}}}",
      board.columns, board.rows, length_text(board.tag), length_text(board.gap), board.first_code);
}

std::string text_of(const Chessboard& board) {
  return fmt::format("{{columns: {}, rows: {}, square: {}}}  # columns and rows of inner corners",
                     board.columns, board.rows, length_text(board.square));
}

std::string text_of(const ClipCodes& clips) {
  return fmt::format("{{family: tag36h11, tag: {}, edge: {}, codes: [{}]}}", length_text(clips.tag),
                     length_text(clips.edge), fmt::join(clips.codes, ", "));
}

std::string text_of(const ClothPattern& cloth) {
  return fmt::format("{{seed: {}, camera: {}, finest: {}, octaves: {}, dpi: {}}}", cloth.seed,
                     length_text(cloth.camera), length_text(cloth.finest), cloth.octaves,
                     format_number(cloth.dpi));
}

}  // namespace

Pattern read_pattern(const std::filesystem::path& path) { return pattern_of(read_yaml(path)); }

Pattern pattern_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "pattern", 1);
  Pattern pattern;
  pattern.file = document.file;
  if (const auto v = fields.optional("sheet")) read_sheet(*v, pattern);
  if (const auto v = fields.optional("ruler")) read_ruler(*v, pattern);
  const double scale = pattern.measured_ruler.value_or(pattern.ruler) / pattern.ruler;
  read_kind(fields, scale, pattern);
  fields.finish();
  return pattern;
}

std::string pattern_text(const Pattern& pattern) {
  const std::string kind =
      std::visit([](const auto& drawn) { return text_of(drawn); }, pattern.kind);
  return fmt::format(
      "# What was drawn. Lay a steel ruler beside the printed one: where it is not {0}, write "
      "what\n"
      "# it is into `ruler`, as `measured: 99.6 mm`.\n"
      "pliant: pattern/1\n"
      "{1}: {2}\n"
      "sheet: {{width: {3}, height: {4}}}\n"
      "ruler: {{drawn: {0}}}\n",
      length_text(pattern.ruler), kind_name(pattern), kind, length_text(pattern.sheet.x()),
      length_text(pattern.sheet.y()));
}

std::string kind_name(const Pattern& pattern) {
  constexpr std::array kNames{"board", "chessboard", "clips", "cloth"};
  return kNames.at(pattern.kind.index());
}

}  // namespace pliant
