#include "apps/pliant/pattern_options.h"

#include <algorithm>
#include <array>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/print_layout.h"
#include "pliant/capture/tag_detector.h"

namespace pliant {
namespace {

struct KindOption {
  const char* name;
  std::vector<std::string> kinds;
};

/// Options that not every kind has.
const std::vector<KindOption>& kind_options() {
  static const std::vector<KindOption> options{
      {"--columns", {"board", "chessboard"}},
      {"--rows", {"board", "chessboard"}},
      {"--tag", {"board", "clips"}},
      {"--gap", {"board"}},
      {"--first-code", {"board"}},
      {"--square", {"chessboard"}},
      {"--codes", {"clips"}},
      {"--edge", {"clips"}},
      {"--camera", {"cloth"}},
  };
  return options;
}

void require_options_of_kind(const std::string& kind, const CLI::App& command) {
  const auto is_of_kind = [&](const KindOption& option) {
    return std::ranges::find(option.kinds, kind) != option.kinds.end();
  };
  std::vector<std::string> own;
  for (const KindOption& option : kind_options()) {
    if (is_of_kind(option)) own.emplace_back(option.name);
  }
  for (const KindOption& option : kind_options()) {
    if (is_of_kind(option) || command.count(option.name) == 0) continue;
    throw InputError({option.name}, fmt::format("is no option of `{}`", kind),
                     fmt::format("{} of `{}`", fmt::join(own, ", "), kind));
  }
}

double length_of(const std::string& option, const std::string& text) {
  try {
    const double length = parse_quantity(text, Dimension::length);
    if (length > 0) return length;
  } catch (const QuantityError& error) {
    throw InputError({option}, error.problem(), error.expected());
  }
  throw InputError({option}, quoted_value(text) + " is not positive", "a length above 0");
}

double length_or(const std::string& option, const std::string& text, double otherwise) {
  return text.empty() ? otherwise : length_of(option, text);
}

Eigen::Vector2d size_of(const std::string& text) {
  const std::size_t at = text.find('x');
  if (at == std::string::npos) {
    throw InputError({"--size"}, quoted_value(text) + " is no size",
                     "WIDTH x HEIGHT, e.g. \"200 mm x 280 mm\"");
  }
  return {length_of("--size", std::string(trimmed(text.substr(0, at)))),
          length_of("--size", std::string(trimmed(text.substr(at + 1))))};
}

[[noreturn]] void refuse_codes(const std::string& problem) {
  throw InputError({"--codes"}, problem,
                   fmt::format("codes from 0 to {}, e.g. 1-8 or 0,3,10-12", kTagCodes - 1));
}

/// "1-8" or "0,3,10-12".
std::vector<int> codes_of(const std::string& text) {
  std::vector<int> codes;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::string_view item = trimmed(std::string_view(text).substr(begin, end - begin));
    const std::size_t dash = item.find('-');
    const auto first = parse_integer(trimmed(item.substr(0, dash)));
    const auto last =
        dash == std::string_view::npos ? first : parse_integer(trimmed(item.substr(dash + 1)));
    if (!first || !last || *last < *first || *last >= kTagCodes) refuse_codes(quoted_value(item));
    for (long code = *first; code <= *last; ++code) {
      if (std::ranges::find(codes, code) != codes.end()) {
        refuse_codes(fmt::format("{} is there twice", code));
      }
      codes.push_back(static_cast<int>(code));
    }
    begin = end + 1;
  }
  return codes;
}

TagBoard board_of(const PatternArguments& arguments) {
  TagBoard board;
  board.columns = arguments.columns.value_or(board.columns);
  board.rows = arguments.rows.value_or(board.rows);
  board.first_code = arguments.first_code.value_or(0);
  board.tag = length_or("--tag", arguments.tag, board.tag);
  board.gap = length_or("--gap", arguments.gap, board.tag / 4);
  const double least = board.tag / kTagCells;
  constexpr double kRounding = 1e-9;  // m
  if (board.gap < least - kRounding) {
    throw InputError({"--gap"},
                     fmt::format("{} are less than the white that tags of {} need",
                                 format_quantity(board.gap, Dimension::length),
                                 format_quantity(board.tag, Dimension::length)),
                     fmt::format("{} or more", format_quantity(least, Dimension::length)));
  }
  const int last = board.first_code + board.tag_count() - 1;
  if (last >= kTagCodes) {
    throw InputError({arguments.first_code ? "--first-code" : "--rows"},
                     fmt::format("{} tags from code {} need codes up to {}", board.tag_count(),
                                 board.first_code, last),
                     fmt::format("codes up to {}, the last of tag36h11", kTagCodes - 1));
  }
  return board;
}

Chessboard chessboard_of(const PatternArguments& arguments) {
  Chessboard board;
  board.columns = arguments.columns.value_or(board.columns);
  board.rows = arguments.rows.value_or(board.rows);
  board.square = length_or("--square", arguments.square, board.square);
  if (board.columns < 2 || board.rows < 2) {
    throw InputError({board.rows < 2 ? "--rows" : "--columns"}, "one line of corners is no board",
                     "2 or more inner corners");
  }
  if (!board.shows_up()) {
    throw InputError(
        {"--columns"},
        fmt::format("{} x {} inner corners look the same upside down", board.columns, board.rows),
        "an odd and an even number of columns and rows");
  }
  return board;
}

ClipCodes clips_of(const PatternArguments& arguments) {
  ClipCodes clips;
  clips.tag = length_or("--tag", arguments.tag, clips.tag);
  clips.edge = length_or("--edge", arguments.edge, clips.tag);
  clips.codes = codes_of(arguments.codes.empty() ? "0-7" : arguments.codes);
  const double least = (0.5 + 1.0 / kTagCells) * clips.tag;
  if (clips.edge < least) {
    throw InputError({"--edge"},
                     fmt::format("{} from a tag's middle leave no white below it",
                                 format_quantity(clips.edge, Dimension::length)),
                     fmt::format("{} or more", format_quantity(least, Dimension::length)));
  }
  return clips;
}

ClothPattern cloth_of(const PatternArguments& arguments, std::uint64_t seed) {
  constexpr double kFinest = 4;  // in pixels of the camera
  ClothPattern cloth;
  cloth.seed = seed;
  cloth.camera = length_or("--camera", arguments.camera, cloth.camera);
  cloth.finest = kFinest * cloth.camera;
  cloth.dpi = arguments.dpi;
  return cloth;
}

bool is_held(const Pattern& pattern) {
  try {
    layout_of(pattern);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

/// Where no sheet was asked for: A4, lying where only that holds the pattern.
/// @throws InputError where the sheet does not hold it
void choose_sheet(const std::string& size, Pattern& pattern) {
  if (!size.empty()) {
    pattern.sheet = size_of(size);
  } else if (!is_held(pattern)) {
    Pattern lying = pattern;
    lying.sheet.reverseInPlace();
    if (is_held(lying)) pattern = lying;
  }
  pattern.ruler = ruler_of_sheet(pattern.sheet);
  layout_of(pattern);
}

}  // namespace

void add_pattern_options(CLI::App& command, PatternArguments& arguments) {
  const auto add = [&](const char* group, const char* name, auto& value, const char* description) {
    return command.add_option(name, value, description)->group(group);
  };
  constexpr const char* kSheet = "Sheet";
  add(kSheet, "--size", arguments.size,
      "Of the sheet, e.g. \"200 mm x 280 mm\" (default: A4, upright or lying)");
  add(kSheet, "--dpi", arguments.dpi, "Dots per inch of a PNG, and of the noise for cloth")
      ->check(CLI::Range(36.0, 4800.0))
      ->capture_default_str();
  constexpr const char* kBoards = "board, chessboard";
  add(kBoards, "--columns", arguments.columns,
      "Tags in a row (default: 6), or inner corners, which are one less than squares (default: 9)")
      ->check(CLI::Range(1, 200));
  add(kBoards, "--rows", arguments.rows,
      "Rows of tags (default: 8) or of inner corners (default: 6)")
      ->check(CLI::Range(1, 200));
  add(kBoards, "--gap", arguments.gap,
      "board: between black squares (default: a quarter of a tag)");
  add(kBoards, "--first-code", arguments.first_code,
      "board: code of the upper left tag (default: 0)")
      ->check(CLI::Range(0, kTagCodes - 1));
  add(kBoards, "--square", arguments.square, "chessboard: side of a square (default: 20 mm)");
  constexpr const char* kTags = "board, clips";
  add(kTags, "--tag", arguments.tag,
      "Side of a tag's black square (default: 20 mm of boards, 15 mm of clips)");
  add(kTags, "--codes", arguments.codes,
      "clips: of the labels, e.g. 1-8 or 0,3,10-12 (default: 0-7)");
  add(kTags, "--edge", arguments.edge,
      "clips: from a tag's middle to the line of the clip's edge (default: as long as the tag)");
  add("cloth", "--camera", arguments.camera,
      "Length of the camera's pixel on the cloth (default: 0.25 mm); speckles are four of it");
}

Pattern pattern_of(const PatternArguments& arguments, const CLI::App& command, std::uint64_t seed) {
  require_options_of_kind(arguments.kind, command);
  Pattern pattern;
  if (arguments.kind == "board") pattern.kind = board_of(arguments);
  if (arguments.kind == "chessboard") pattern.kind = chessboard_of(arguments);
  if (arguments.kind == "clips") pattern.kind = clips_of(arguments);
  if (arguments.kind == "cloth") pattern.kind = cloth_of(arguments, seed);
  choose_sheet(arguments.size, pattern);
  return pattern;
}

}  // namespace pliant
