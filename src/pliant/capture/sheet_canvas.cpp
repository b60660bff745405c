#include "pliant/capture/sheet_canvas.h"

#include <cmath>

#include <cairo-pdf.h>
#include <cairo-svg.h>
#include <cairo.h>

#include "pliant/base/assert.h"
#include "pliant/capture/grey_png.h"
#include "pliant/geometry/stroke_font.h"

namespace pliant {
namespace {

// Of a drawing a unit is a millimetre: Cairo keeps places to a 256th of a unit of the file.
constexpr double kUnits = 1e3;  // in a metre
constexpr double kPoints = 72 / 25.4, kMillimetresAnInch = 25.4;

cairo_status_t append(void* text, const unsigned char* data, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(data), length);
  return CAIRO_STATUS_SUCCESS;
}

cairo_surface_t* surface_of(SheetFormat format, const Eigen::Vector2d& size, double dpi,
                            std::string& written) {
  const Eigen::Vector2d units = kUnits * size;
  if (format == SheetFormat::pdf) {
    cairo_surface_t* pdf = cairo_pdf_surface_create_for_stream(
        append, &written, kPoints * units.x(), kPoints * units.y());
    // The same drawing gives the same bytes on another day.
    cairo_pdf_surface_set_metadata(pdf, CAIRO_PDF_METADATA_CREATE_DATE, nullptr);
    return pdf;
  }
  if (format == SheetFormat::svg) {
    cairo_surface_t* svg =
        cairo_svg_surface_create_for_stream(append, &written, units.x(), units.y());
    cairo_svg_surface_set_document_unit(svg, CAIRO_SVG_UNIT_MM);
    return svg;
  }
  const Eigen::Vector2i pixels = pixels_of_sheet(size, dpi);
  return cairo_image_surface_create(CAIRO_FORMAT_RGB24, pixels.x(), pixels.y());
}

double scale_of(SheetFormat format, double dpi) {
  if (format == SheetFormat::pdf) return kPoints;
  return format == SheetFormat::svg ? 1 : dpi / kMillimetresAnInch;
}

/// Grey levels as Cairo has pictures: a word a pixel.
cairo_surface_t* image_of(std::span<const std::uint8_t> levels, int columns, int rows) {
  cairo_surface_t* image = cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows);
  PLIANT_ASSERT(cairo_surface_status(image) == CAIRO_STATUS_SUCCESS, "a picture");
  unsigned char* const data = cairo_image_surface_get_data(image);
  const int stride = cairo_image_surface_get_stride(image);
  auto level = levels.begin();
  for (int row = 0; row < rows; ++row) {
    auto* const words =
        reinterpret_cast<std::uint32_t*>(data + static_cast<std::ptrdiff_t>(row) * stride);
    for (int column = 0; column < columns; ++column) words[column] = 0x010101U * *level++;
  }
  cairo_surface_mark_dirty(image);
  return image;
}

/// An SVG takes the bytes of a PNG over as they are: in place of colours, grey levels.
void attach_png(cairo_surface_t* image, std::string bytes) {
  auto* const kept = new std::string(std::move(bytes));
  cairo_surface_set_mime_data(
      image, CAIRO_MIME_TYPE_PNG, reinterpret_cast<const unsigned char*>(kept->data()),
      kept->size(), [](void* text) { delete static_cast<std::string*>(text); }, kept);
}

std::vector<std::uint8_t> levels_of(cairo_surface_t* image) {
  cairo_surface_flush(image);
  const int columns = cairo_image_surface_get_width(image);
  const int rows = cairo_image_surface_get_height(image);
  const unsigned char* const data = cairo_image_surface_get_data(image);
  const int stride = cairo_image_surface_get_stride(image);
  std::vector<std::uint8_t> levels;
  levels.reserve(static_cast<std::size_t>(columns) * rows);
  for (int row = 0; row < rows; ++row) {
    const auto* const words =
        reinterpret_cast<const std::uint32_t*>(data + static_cast<std::ptrdiff_t>(row) * stride);
    for (int column = 0; column < columns; ++column) {
      levels.push_back(static_cast<std::uint8_t>(words[column] & 0xffU));
    }
  }
  return levels;
}

}  // namespace

struct SheetCanvas::Surface {
  cairo_surface_t* sheet;
  cairo_t* pen;

  explicit Surface(cairo_surface_t* made) : sheet(made), pen(cairo_create(made)) {}
  ~Surface() {
    cairo_destroy(pen);
    cairo_surface_destroy(sheet);
  }
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;
};

SheetCanvas::SheetCanvas(SheetFormat format, const Eigen::Vector2d& size, double dpi)
    : format_(format),
      dpi_(dpi),
      surface_(std::make_unique<Surface>(surface_of(format, size, dpi, written_))) {
  cairo_t* const pen = surface_->pen;
  const double scale = scale_of(format, dpi);
  cairo_set_source_rgb(pen, 1, 1, 1);
  cairo_paint(pen);
  cairo_set_source_rgb(pen, 0, 0, 0);
  cairo_scale(pen, scale, scale);
  cairo_set_line_join(pen, CAIRO_LINE_JOIN_ROUND);
}

SheetCanvas::~SheetCanvas() = default;

void SheetCanvas::fill(const std::vector<SheetBox>& boxes) {
  for (const SheetBox& box : boxes) {
    cairo_rectangle(surface_->pen, kUnits * box.left, kUnits * box.top, kUnits * box.width,
                    kUnits * box.height);
  }
  cairo_fill(surface_->pen);
}

void SheetCanvas::fill_polygon(const std::vector<Eigen::Vector2d>& corners) {
  for (const Eigen::Vector2d& corner : corners) {
    cairo_line_to(surface_->pen, kUnits * corner.x(), kUnits * corner.y());
  }
  cairo_close_path(surface_->pen);
  cairo_fill(surface_->pen);
}

void SheetCanvas::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
                       double dash) {
  cairo_t* const pen = surface_->pen;
  const double dashes = kUnits * dash;
  cairo_set_dash(pen, &dashes, dash > 0 ? 1 : 0, 0);
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_width(pen, kUnits * width);
  cairo_move_to(pen, kUnits * from.x(), kUnits * from.y());
  cairo_line_to(pen, kUnits * to.x(), kUnits * to.y());
  cairo_stroke(pen);
}

void SheetCanvas::text(std::string_view text, const Eigen::Vector2d& place, double cap_height) {
  constexpr double kStroke = 0.12;  // in heights of capitals
  cairo_t* const pen = surface_->pen;
  cairo_set_dash(pen, nullptr, 0, 0);
  cairo_set_line_cap(pen, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_width(pen, kUnits * kStroke * cap_height);
  const Eigen::Vector2d start = kUnits * place;
  const auto height = static_cast<float>(kUnits * cap_height);
  for (const Segment& segment : text_segments(text, height)) {
    cairo_move_to(pen, start.x() + segment.from.x(), start.y() - segment.from.y());
    cairo_line_to(pen, start.x() + segment.to.x(), start.y() - segment.to.y());
  }
  cairo_stroke(pen);
}

void SheetCanvas::picture(std::span<const std::uint8_t> levels, int left, int top, int columns,
                          int rows) {
  cairo_t* const pen = surface_->pen;
  const double pixel = kUnits * this->pixel();
  cairo_surface_t* const image = image_of(levels, columns, rows);
  if (format_ == SheetFormat::svg) {
    attach_png(image, grey_png_bytes(levels, columns, rows, 1 / this->pixel()));
  }
  cairo_save(pen);
  cairo_scale(pen, pixel, pixel);
  cairo_set_source_surface(pen, image, left, top);
  cairo_pattern_set_filter(cairo_get_source(pen), CAIRO_FILTER_NEAREST);
  cairo_paint(pen);
  cairo_restore(pen);
  cairo_surface_destroy(image);
}

std::string SheetCanvas::bytes() {
  if (format_ == SheetFormat::png) {
    const std::vector<std::uint8_t> levels = levels_of(surface_->sheet);
    return grey_png_bytes(levels, cairo_image_surface_get_width(surface_->sheet),
                          cairo_image_surface_get_height(surface_->sheet), 1 / pixel());
  }
  cairo_surface_finish(surface_->sheet);
  PLIANT_ASSERT(cairo_surface_status(surface_->sheet) == CAIRO_STATUS_SUCCESS, "a drawing");
  return written_;
}

Eigen::Vector2i pixels_of_sheet(const Eigen::Vector2d& size, double dpi) {
  constexpr double kRounding = 1e-6;  // pixels
  const Eigen::Vector2d pixels = size * dpi / 0.0254;
  return (pixels.array() - kRounding).ceil().cast<int>();
}

}  // namespace pliant
