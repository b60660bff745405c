#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/capture/pattern.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

std::string length_text(double length) { return format_quantity(length, Dimension::length); }

void describe(const TagBoard& board, FileInfo& info) {
  info.json["columns"] = board.columns;
  info.json["rows"] = board.rows;
  info.json["tag"] = board.tag;
  info.json["gap"] = board.gap;
  info.json["first_code"] = board.first_code;
  info.lines.push_back(
      labelled("board", fmt::format("{} x {} tags, codes {} to {}", board.columns, board.rows,
                                    board.first_code, board.first_code + board.tag_count() - 1)));
  info.lines.push_back(
      labelled("tag", fmt::format("{}, {} apart", length_text(board.tag), length_text(board.gap))));
}

void describe(const Chessboard& board, FileInfo& info) {
  info.json["columns"] = board.columns;
  info.json["rows"] = board.rows;
  info.json["square"] = board.square;
  info.lines.push_back(
      labelled("chessboard", fmt::format("{} x {} inner corners, square {}", board.columns,
                                         board.rows, length_text(board.square))));
  if (board.shows_up()) return;
  info.warnings.push_back(
      "the board looks the same upside down: one of columns and rows should "
      "be odd and the other even");
  info.json["warnings"] = info.warnings;
}

void describe(const ClipCodes& clips, FileInfo& info) {
  info.json["tag"] = clips.tag;
  info.json["edge"] = clips.edge;
  info.json["codes"] = clips.codes;
  info.lines.push_back(labelled(
      "clips", fmt::format("{} labels, tag {}, edge {} below its middle", clips.codes.size(),
                           length_text(clips.tag), length_text(clips.edge))));
}

void describe(const ClothPattern& cloth, FileInfo& info) {
  info.json["seed"] = cloth.seed;
  info.json["camera"] = cloth.camera;
  info.json["finest"] = cloth.finest;
  info.json["octaves"] = cloth.octaves;
  info.json["dpi"] = cloth.dpi;
  info.lines.push_back(labelled(
      "cloth", fmt::format("noise of {} octaves, the finest {}, for pixels of {}", cloth.octaves,
                           length_text(cloth.finest), length_text(cloth.camera))));
}

}  // namespace

FileInfo pattern_info(const std::filesystem::path& path) {
  const Pattern pattern = read_pattern(path);
  FileInfo info = begin_info(path, "pattern/1");
  info.json["kind"] = kind_name(pattern);
  std::visit([&](const auto& drawn) { describe(drawn, info); }, pattern.kind);
  info.json["ruler"] = pattern.ruler;
  if (pattern.measured_ruler) info.json["measured_ruler"] = *pattern.measured_ruler;
  info.lines.push_back(labelled(
      "ruler",
      fmt::format("{}, {}", length_text(pattern.ruler),
                  pattern.measured_ruler ? length_text(*pattern.measured_ruler) + " on the print"
                                         : std::string("not measured on the print"))));
  return info;
}

}  // namespace pliant
