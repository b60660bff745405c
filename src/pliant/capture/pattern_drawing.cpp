#include "pliant/capture/pattern_drawing.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/tag_detector.h"
#include "pliant/capture/wavelet_noise.h"
#include "pliant/geometry/stroke_font.h"

namespace pliant {
namespace {

using Place = Eigen::Vector2d;

constexpr double kFineLine = 0.15e-3, kBoldLine = 0.4e-3;  // m
constexpr double kTextHeight = 2.2e-3;                     // of capitals (m)

std::string length_text(double length) { return format_quantity(length, Dimension::length); }

double width_of(const std::string& text, double cap_height) {
  return text_width(text, static_cast<float>(cap_height));
}

/// @param left, top  of the black square
void draw_tag(SheetCanvas& canvas, int code, double left, double top, double tag) {
  const GreyPicture cells = tag_cells(code);
  const double cell = tag / kTagCells;
  std::vector<SheetBox> black;
  for (int row = 0; row < kTagCells; ++row) {
    for (int column = 0; column < kTagCells; ++column) {
      if (cells(row, column) > 0.5F) continue;
      black.push_back({left + column * cell, top + row * cell, cell, cell});
    }
  }
  canvas.fill(black);
}

void draw(const TagBoard& board, const PrintLayout& layout, SheetCanvas& canvas) {
  for (int code = board.first_code; board.has(code); ++code) {
    const Eigen::Vector3d upper_left = board.corners(code)[3];
    draw_tag(canvas, code, layout.pattern.left + upper_left.x(),
             layout.pattern.bottom() - upper_left.y(), board.tag);
  }
}

void draw(const Chessboard& board, const PrintLayout& layout, SheetCanvas& canvas) {
  std::vector<SheetBox> black;
  for (int row = 0; row <= board.rows; ++row) {
    for (int column = row % 2; column <= board.columns; column += 2) {
      black.push_back({layout.pattern.left + column * board.square,
                       layout.pattern.top + row * board.square, board.square, board.square});
    }
  }
  canvas.fill(black);
}

/// A tag, its number, and where to cut; the lower side is the line of the clip's edge.
/// @param left, top  of the label
void draw_label(const ClipCodes& clips, int code, double left, double top, SheetCanvas& canvas) {
  constexpr double kNumberHeight = 0.25;                                  // in tags
  constexpr double kDash = 1e-3, kNoteHeight = 1.6e-3, kNoteRoom = 3e-3;  // m
  const LabelShape label = label_shape(clips);
  const double right = left + label.width, bottom = top + label.height;
  draw_tag(canvas, code, left + label.white, top + label.white, clips.tag);
  const double beside = left + 2 * label.white + clips.tag;
  const double height = kNumberHeight * clips.tag;
  canvas.text(fmt::format("{}", code),
              {beside + label.white / 2, top + label.white + (clips.tag + height) / 2}, height);
  canvas.line({left, top}, {right, top}, kFineLine, kDash);
  canvas.line({left, top}, {left, bottom}, kFineLine, kDash);
  canvas.line({right, top}, {right, bottom}, kFineLine, kDash);
  canvas.line({left, bottom}, {right, bottom}, kBoldLine);
  const std::string note = "edge of the clip";
  const bool room = clips.edge - clips.tag / 2 - label.white > kNoteRoom &&
                    width_of(note, kNoteHeight) < label.width - 2 * label.white;
  if (room) canvas.text(note, {left + label.white, bottom - 0.8 * kNoteHeight}, kNoteHeight);
}

void draw(const ClipCodes& clips, const PrintLayout& layout, SheetCanvas& canvas) {
  const LabelShape label = label_shape(clips);
  for (int i = 0; i < static_cast<int>(clips.codes.size()); ++i) {
    const int row = i / layout.labels_in_row, column = i % layout.labels_in_row;
    draw_label(clips, clips.codes[i],
               layout.pattern.left + column * (label.width + layout.label_gap),
               layout.pattern.top + row * (label.height + layout.label_gap), canvas);
  }
}

/// On whole pixels of the sheet, so that a picture of it shows each as it is.
void draw(const ClothPattern& cloth, const PrintLayout& layout, SheetCanvas& canvas) {
  const double pixel = canvas.pixel();
  const SheetBox& box = layout.pattern;
  const int left = static_cast<int>(std::ceil(box.left / pixel));
  const int top = static_cast<int>(std::ceil(box.top / pixel));
  const int columns = static_cast<int>(std::floor(box.right() / pixel)) - left;
  const int rows = static_cast<int>(std::floor(box.bottom() / pixel)) - top;
  canvas.picture(noise_levels(cloth, columns, rows, pixel), left, top, columns, rows);
}

std::string caption(const TagBoard& board) {
  return fmt::format("tag36h11 {} to {}, tag {}, gap {}", board.first_code,
                     board.first_code + board.tag_count() - 1, length_text(board.tag),
                     length_text(board.gap));
}

std::string caption(const Chessboard& board) {
  return fmt::format("{} x {} inner corners, square {}", board.columns, board.rows,
                     length_text(board.square));
}

std::string caption(const ClipCodes& clips) {
  return fmt::format("tag36h11, tag {}, edge {}", length_text(clips.tag), length_text(clips.edge));
}

std::string caption(const ClothPattern& cloth) {
  return fmt::format("seed {}, finest {}", cloth.seed, length_text(cloth.finest));
}

/// Millimetres, longer lines at fives and tens, and numbers below tens.
/// @param start  of its line
void draw_ruler(const Place& start, double length, SheetCanvas& canvas) {
  constexpr double kTick = 1.8e-3, kOfFive = 2.8e-3, kOfTen = 4e-3, kBelow = 1e-3;  // m
  constexpr double kNumberHeight = 1.8e-3;
  canvas.line(start, start + Place(length, 0), kFineLine);
  const int ticks = static_cast<int>(std::lround(1e3 * length));
  for (int i = 0; i <= ticks; ++i) {
    const Place at = start + Place(1e-3 * i, 0);
    const double height = i % 10 == 0 ? kOfTen : i % 5 == 0 ? kOfFive : kTick;
    canvas.line(at, at - Place(0, height), kFineLine);
    if (i % 10 != 0) continue;
    const std::string number = fmt::format("{}{}", i, i == ticks ? " mm" : "");
    const double half = width_of(fmt::format("{}", i), kNumberHeight) / 2;
    canvas.text(number, at + Place(-half, kBelow + kNumberHeight), kNumberHeight);
  }
}

/// To the right, with its word.
/// @param start  of the arrow
void draw_weft_arrow(const Place& start, SheetCanvas& canvas) {
  constexpr double kLength = 18e-3, kHead = 3.5e-3, kHalfHead = 1.4e-3, kGap = 2e-3;  // m
  constexpr double kWordHeight = 3e-3;
  const Place end = start + Place(kLength, 0), neck = end - Place(kHead, 0);
  canvas.line(start, neck, kBoldLine);
  canvas.fill_polygon({end, neck - Place(0, kHalfHead), neck + Place(0, kHalfHead)});
  canvas.text("weft", end + Place(kGap, kWordHeight / 2), kWordHeight);
}

void draw_strip(const Pattern& pattern, const PrintLayout& layout, SheetCanvas& canvas) {
  constexpr double kStart = 1e-3, kLine = 6e-3, kBeside = 11e-3, kArrow = 3e-3;  // m
  const Place start(layout.strip.left + kStart, layout.strip.top + kLine);
  draw_ruler(start, pattern.ruler, canvas);
  Place beside = start + Place(pattern.ruler + kBeside, 0);
  if (std::holds_alternative<ClothPattern>(pattern.kind)) {
    draw_weft_arrow(beside - Place(0, kArrow), canvas);
    beside += Place(0, 2 * kTextHeight);
  }
  const std::string text =
      std::visit([](const auto& drawn) { return caption(drawn); }, pattern.kind);
  if (beside.x() + width_of(text, kTextHeight) > layout.strip.right()) return;
  canvas.text(text, beside, kTextHeight);
}

void require_pixels(const Pattern& pattern, double dpi) {
  const double most = kMostSheetPixels * 0.0254 / pattern.sheet.maxCoeff();
  if (dpi > most) {
    throw InputError({"--dpi"},
                     fmt::format("{} on a sheet of {} x {} are too many pixels", format_number(dpi),
                                 length_text(pattern.sheet.x()), length_text(pattern.sheet.y())),
                     fmt::format("at most {}", std::floor(most)));
  }
  const auto* const cloth = std::get_if<ClothPattern>(&pattern.kind);
  const double least = cloth ? kLeastNoisePixels * 0.0254 / cloth->finest : 0;
  if (dpi < least) {
    throw InputError({"--dpi"},
                     fmt::format("{} are too few for features of {}", format_number(dpi),
                                 length_text(cloth->finest)),
                     fmt::format("at least {}", std::ceil(least)));
  }
}

}  // namespace

std::string draw_pattern(const Pattern& pattern, SheetFormat format, double dpi) {
  const auto* const cloth = std::get_if<ClothPattern>(&pattern.kind);
  if (cloth) dpi = cloth->dpi;
  const PrintLayout layout = layout_of(pattern);
  if (cloth || format == SheetFormat::png) require_pixels(pattern, dpi);
  SheetCanvas canvas(format, pattern.sheet, dpi);
  std::visit([&](const auto& drawn) { draw(drawn, layout, canvas); }, pattern.kind);
  draw_strip(pattern, layout, canvas);
  return canvas.bytes();
}

}  // namespace pliant
