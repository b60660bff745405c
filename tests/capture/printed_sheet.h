#pragma once

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <png.h>

#include "pliant/capture/spline_picture.h"

#include "io/temporary_folder.h"

namespace pliant::test {

/// Brightness, 0 to 1, of bytes row by row.
inline GreyPicture picture_of(const unsigned char* levels, int columns, int rows) {
  GreyPicture picture(rows, columns);
  for (Eigen::Index i = 0; i < picture.size(); ++i) {
    picture.data()[i] = static_cast<float>(levels[i]) / 255;
  }
  return picture;
}

/// A PNG as libpng reads it.
inline GreyPicture read_png(const std::string& bytes) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()) == 0) return {};
  header.format = PNG_FORMAT_GRAY;
  std::vector<unsigned char> levels(PNG_IMAGE_SIZE(header));
  png_image_finish_read(&header, nullptr, levels.data(), 0, nullptr);
  return picture_of(levels.data(), static_cast<int>(header.width), static_cast<int>(header.height));
}

inline bool can_turn_pdf_to_pixels() { return std::system("pdftoppm -v >/dev/null 2>&1") == 0; }

/// A page of a PDF as poppler draws it; empty where it does not.
inline GreyPicture pixels_of_pdf(const std::string& pdf, int dpi) {
  const TemporaryFolder folder;
  const std::string file = folder.write("page.pdf", pdf).string();
  const std::string command = fmt::format("pdftoppm -r {} -gray -singlefile '{}' '{}/page'", dpi,
                                          file, folder.path().string());
  if (std::system(command.c_str()) != 0) return {};
  const std::string text = content_of(folder.path() / "page.pgm");
  int columns = 0, rows = 0, header = 0;
  if (std::sscanf(text.c_str(), "P5 %d %d 255%n", &columns, &rows, &header) != 2) return {};
  return picture_of(reinterpret_cast<const unsigned char*>(text.data()) + header + 1, columns,
                    rows);
}

/// A stretch of dark pixels: where it begins and ends (pixels).
struct DarkRun {
  double begin, end;

  double middle() const { return (begin + end) / 2; }
  double length() const { return end - begin; }
};

/// The dark stretches of a row between two columns, to parts of a pixel by the grey at their ends.
inline std::vector<DarkRun> dark_runs(const GreyPicture& picture, Eigen::Index row,
                                      Eigen::Index from, Eigen::Index to) {
  std::vector<DarkRun> runs;
  bool dark = false;
  for (Eigen::Index c = from + 1; c < to; ++c) {
    const float before = picture(row, c - 1), here = picture(row, c);
    const bool is_dark = here < 0.5F;
    if (is_dark == dark) continue;
    const double edge = static_cast<double>(c) - 1 + (before - 0.5) / (before - here);
    if (is_dark) {
      runs.push_back({edge, edge});
    } else if (!runs.empty()) {
      runs.back().end = edge;
    }
    dark = is_dark;
  }
  return runs;
}

}  // namespace pliant::test
