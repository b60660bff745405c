#include "pliant/capture/calibration_board.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "pliant/capture/chessboard_corners.h"

namespace pliant {
namespace {

// The corners of a single tag leave no check of it.
constexpr int kFewestTags = 2;

BoardView view_of_tags(int number, const TagBoard& board, const std::map<int, DetectedTag>& tags) {
  BoardView view{number, {}, {}, {}};
  std::vector<const DetectedTag*> seen;
  for (const auto& [code, tag] : tags) {
    if (!board.has(code)) continue;
    for (int i = 0; i < 4; ++i) {
      view.corners.push_back(4 * (code - board.first_code) + i);
    }
    seen.push_back(&tag);
  }
  view.pixels.resize(2, 4 * std::ssize(seen));
  view.of_lines.resizeLike(view.pixels);
  for (int i = 0; i < std::ssize(seen); ++i) {
    view.pixels.middleCols<4>(4 * i) = seen[i]->corners;
    view.of_lines.middleCols<4>(4 * i) = seen[i]->of_lines;
  }
  return view;
}

std::string reason_without_boards(const GreyPicture& picture,
                                  const std::vector<CalibrationBoard>& boards,
                                  const TagsByCode& tags, int of_boards) {
  const bool wants_tags = std::ranges::any_of(
      boards, [](const CalibrationBoard& board) { return !board.is_chessboard(); });
  if (!tags.twice.empty()) return fmt::format("shows code {} twice", *tags.twice.begin());
  if (of_boards == 1) return "shows a single tag of a board";
  if (!tags.once.empty()) {
    return fmt::format("shows tags of no board (code {})", tags.once.begin()->first);
  }
  if (wants_tags && mirrored_codes(picture).size() >= kFewestTags) {
    return "is mirrored: its tags can be read from behind alone";
  }
  return wants_tags ? "shows no board" : "shows no board with all of its corners";
}

}  // namespace

Eigen::Matrix3Xd CalibrationBoard::corners() const {
  Eigen::Matrix3Xd result;
  if (const auto* chessboard = std::get_if<Chessboard>(&kind)) {
    result.resize(3, chessboard->corner_count());
    for (int i = 0; i < result.cols(); ++i) result.col(i) = chessboard->corner(i);
    return result;
  }
  const auto& tags = std::get<TagBoard>(kind);
  result.resize(3, 4 * tags.tag_count());
  for (int i = 0; i < tags.tag_count(); ++i) {
    const auto corners = tags.corners(tags.first_code + i);
    for (int k = 0; k < 4; ++k) result.col(4 * i + k) = corners[k];
  }
  return result;
}

PictureFindings find_boards(const GreyPicture& picture,
                            const std::vector<CalibrationBoard>& boards) {
  PictureFindings findings;
  TagsByCode tags = tags_by_code(detect_tags(picture));
  int most_of_boards = 0;
  for (int b = 0; b < std::ssize(boards); ++b) {
    if (const auto* chessboard = std::get_if<Chessboard>(&boards[b].kind)) {
      const auto corners = chessboard_corners(picture, *chessboard);
      if (!corners) continue;
      BoardView view{b, {}, *corners, {}};
      for (int i = 0; i < corners->cols(); ++i) view.corners.push_back(i);
      findings.boards.push_back(view);
      continue;
    }
    BoardView view = view_of_tags(b, std::get<TagBoard>(boards[b].kind), tags.once);
    const int count = static_cast<int>(view.corners.size() / 4);
    most_of_boards = std::max(most_of_boards, count);
    if (count >= kFewestTags) findings.boards.push_back(std::move(view));
  }
  for (const auto& [code, tag] : tags.once) {
    const bool of_board = std::ranges::any_of(boards, [c = code](const CalibrationBoard& board) {
      const auto* own = std::get_if<TagBoard>(&board.kind);
      return own && own->has(c);
    });
    if (!of_board) findings.other_tags.push_back(tag);
  }
  if (findings.boards.empty()) {
    findings.problem = reason_without_boards(picture, boards, tags, most_of_boards);
  }
  return findings;
}

}  // namespace pliant
