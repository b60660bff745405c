#include "pliant/capture/print_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/tag_detector.h"

namespace pliant {
namespace {

constexpr double kStripHeight = 0.014, kStripGap = 0.003;  // m
constexpr double kBesideRuler = 0.042;                     // m, for the arrow
constexpr double kLabelGap = 0.004;                        // m
constexpr double kRounding = 1e-9;                         // m

std::string length_text(double length) { return format_quantity(length, Dimension::length); }

std::string size_text(const Eigen::Vector2d& size) {
  return length_text(size.x()) + " x " + length_text(size.y());
}

/// What a sheet has beside what is inside `room_of`.
Eigen::Vector2d taken_of_sheet() {
  return {2 * kSheetMargin, 2 * kSheetMargin + kStripHeight + kStripGap};
}

/// Where the pattern may be.
SheetBox room_of(const Eigen::Vector2d& sheet) {
  const Eigen::Vector2d size = sheet - taken_of_sheet();
  return {kSheetMargin, kSheetMargin, size.x(), size.y()};
}

SheetBox middle_of(const SheetBox& room, const Eigen::Vector2d& size) {
  return {room.left + (room.width - size.x()) / 2, room.top + (room.height - size.y()) / 2,
          size.x(), size.y()};
}

bool fits(const Eigen::Vector2d& size, const SheetBox& room) {
  return size.x() <= room.width + kRounding && size.y() <= room.height + kRounding;
}

/// How many of a row go into a length, the last without its gap.
int count_in(double length, double size, double gap) {
  return std::max(0, static_cast<int>(std::floor((length + gap + kRounding) / (size + gap))));
}

[[noreturn]] void refuse(const Pattern& pattern, const std::string& what,
                         const Eigen::Vector2d& size, const std::string& else_expected) {
  const SheetBox room = room_of(pattern.sheet);
  throw InputError(
      {"--size"},
      fmt::format("a sheet of {} has {} x {} for {}, which take {}", size_text(pattern.sheet),
                  length_text(std::max(0.0, room.width)), length_text(std::max(0.0, room.height)),
                  what, size_text(size)),
      fmt::format("a sheet of {} or larger{}", size_text(size + taken_of_sheet()), else_expected));
}

/// A size that is so much smaller that everything fits, rounded down to a tenth of a millimetre.
double smaller(double length, const Eigen::Vector2d& size, const SheetBox& room) {
  const double scale = std::min(room.width / size.x(), room.height / size.y());
  return std::floor(length * scale * 1e4 + 1e-6) / 1e4;
}

PrintLayout laid_out(const TagBoard& board, const Pattern& pattern, PrintLayout layout) {
  const SheetBox room = room_of(pattern.sheet);
  const double white = board.tag / kTagCells;
  const Eigen::Vector2d size = board.extent().array() + 2 * white;
  if (!fits(size, room)) {
    const int columns = count_in(room.width - 2 * white, board.tag, board.gap);
    const int rows = count_in(room.height - 2 * white, board.tag, board.gap);
    std::string expected;
    if (columns > 0 && rows > 0) {
      expected = fmt::format(", at most {} columns and {} rows, or tags of {} with a gap of {}",
                             std::min(columns, board.columns), std::min(rows, board.rows),
                             length_text(smaller(board.tag, size, room)),
                             length_text(smaller(board.gap, size, room)));
    }
    refuse(pattern, "the tags", size, expected);
  }
  layout.pattern = middle_of(room, board.extent());
  return layout;
}

PrintLayout laid_out(const Chessboard& board, const Pattern& pattern, PrintLayout layout) {
  const SheetBox room = room_of(pattern.sheet);
  const Eigen::Vector2d size = board.extent();
  if (!fits(size, room)) {
    std::string expected;
    if (room.width > 0 && room.height > 0) {
      expected = fmt::format(", or squares of {}", length_text(smaller(board.square, size, room)));
    }
    refuse(pattern, "the squares", size, expected);
  }
  layout.pattern = middle_of(room, size);
  return layout;
}

PrintLayout laid_out(const ClipCodes& clips, const Pattern& pattern, PrintLayout layout) {
  const SheetBox room = room_of(pattern.sheet);
  const LabelShape label = label_shape(clips);
  const int columns = count_in(room.width, label.width, kLabelGap);
  const int rows = count_in(room.height, label.height, kLabelGap);
  const int count = static_cast<int>(clips.codes.size());
  const int in_row = std::clamp(columns, 1, count), needed = (count + in_row - 1) / in_row;
  const Eigen::Vector2d size = {in_row * (label.width + kLabelGap) - kLabelGap,
                                needed * (label.height + kLabelGap) - kLabelGap};
  if (columns == 0 || needed > rows) {
    const int most = columns * rows;
    refuse(pattern, "the labels", size,
           most > 0 ? fmt::format(", or at most {} codes", most) : std::string());
  }
  layout.pattern = {room.left, room.top, size.x(), size.y()};
  layout.labels_in_row = in_row;
  layout.label_gap = kLabelGap;
  return layout;
}

PrintLayout laid_out(const ClothPattern& cloth, const Pattern& pattern, PrintLayout layout) {
  constexpr double kLeastSide = 10;  // in finest lengths
  const SheetBox room = room_of(pattern.sheet);
  const Eigen::Vector2d size = Eigen::Vector2d::Constant(kLeastSide * cloth.finest);
  if (!fits(size, room)) refuse(pattern, "the noise", size, "");
  layout.pattern = room;
  return layout;
}

}  // namespace

LabelShape label_shape(const ClipCodes& clips) {
  constexpr double kNumberWidth = 0.75;  // in tags
  LabelShape label;
  label.white = clips.tag / kTagCells;
  label.width = 2 * label.white + (1 + kNumberWidth) * clips.tag;
  label.height = label.white + clips.tag / 2 + clips.edge;
  return label;
}

double ruler_of_sheet(const Eigen::Vector2d& sheet) {
  constexpr std::array kLengths{0.100, 0.050, 0.020};
  const double room = sheet.x() - 2 * kSheetMargin - kBesideRuler;
  const auto ruler =
      std::ranges::find_if(kLengths, [&](double length) { return length <= room + kRounding; });
  if (ruler != kLengths.end()) return *ruler;
  throw InputError(
      {"--size"}, length_text(sheet.x()) + " are too narrow for a ruler",
      fmt::format("a sheet {} wide or wider", length_text(sheet.x() - room + kLengths.back())));
}

PrintLayout layout_of(const Pattern& pattern) {
  PrintLayout layout;
  layout.strip = {kSheetMargin, pattern.sheet.y() - kSheetMargin - kStripHeight,
                  pattern.sheet.x() - 2 * kSheetMargin, kStripHeight};
  return std::visit([&](const auto& drawn) { return laid_out(drawn, pattern, layout); },
                    pattern.kind);
}

}  // namespace pliant
