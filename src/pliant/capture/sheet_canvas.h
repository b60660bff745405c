#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "pliant/capture/print_layout.h"

namespace pliant {

/// What a drawing is written as.
enum class SheetFormat { pdf, svg, png };

/// A white sheet to draw on in black, in its true size. Places are in metres from its upper left
/// corner, y downwards. The same program writes the same bytes on every machine: it uses no fonts.
class SheetCanvas {
 public:
  /// @param size  width and height (m)
  /// @param dpi   pixels per inch: of a PNG, and of pictures within PDF and SVG
  SheetCanvas(SheetFormat format, const Eigen::Vector2d& size, double dpi);
  ~SheetCanvas();
  SheetCanvas(const SheetCanvas&) = delete;
  SheetCanvas& operator=(const SheetCanvas&) = delete;

  /// Side of a pixel (m).
  double pixel() const { return 0.0254 / dpi_; }

  /// Boxes as one shape: those that touch show no seam.
  void fill(const std::vector<SheetBox>& boxes);
  /// A corner after the other, closed.
  void fill_polygon(const std::vector<Eigen::Vector2d>& corners);
  /// @param width  of the line, from `from` to `to` (m)
  /// @param dash   of its dashes and gaps (m); 0: a whole line
  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, double dash = 0);
  /// @param place       left end of the base line
  /// @param cap_height  of capitals and digits (m)
  void text(std::string_view text, const Eigen::Vector2d& place, double cap_height);
  /// Grey levels, 0 black, row by row, of pixels of the sheet's own grid.
  /// @param left, top      of the first pixel (pixels)
  /// @param columns, rows  pixels
  void picture(std::span<const std::uint8_t> levels, int left, int top, int columns, int rows);

  /// Ends the drawing: the bytes of its file.
  std::string bytes();

 private:
  struct Surface;

  SheetFormat format_;
  double dpi_;
  std::string written_;  // by the surface, which keeps its address
  std::unique_ptr<Surface> surface_;
};

/// Pixels of a PNG of a sheet: as many as cover it.
Eigen::Vector2i pixels_of_sheet(const Eigen::Vector2d& size, double dpi);

}  // namespace pliant
