#include "pliant/capture/shown_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "pliant/capture/grey_png.h"
#include "pliant/capture/patch_tracker.h"

namespace pliant {
namespace {

constexpr int kColumns = 480;            // about, of a small picture
constexpr double kScreen = 96 / 0.0254;  // pixels per metre, for programs that ask

std::string png_of(const GreyPicture& picture) {
  std::vector<std::uint8_t> levels;
  levels.reserve(static_cast<std::size_t>(picture.size()));
  for (const float value : picture.reshaped<Eigen::RowMajor>()) {
    levels.push_back(static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F))));
  }
  return grey_png_bytes(levels, static_cast<int>(picture.cols()), static_cast<int>(picture.rows()),
                        kScreen);
}

}  // namespace

std::vector<ShownView> shown_views(const DicSession& made, const ReadPicture& read_picture) {
  std::vector<ShownView> views;
  for (const MeshView& view : made.views) {
    const GreyPicture whole = read_picture(view.seen.file);
    const int factor = std::max(1, static_cast<int>(std::lround(whole.cols() / kColumns)));
    const GreyPicture small = reduced(whole, factor);
    // The middle of the first pixel of a square is half a square off the square's.
    const Eigen::Matrix2Xd vertices = ((view.seen.pixels.array() - (factor - 1) / 2.0) / factor);
    views.push_back({view.frame, view.camera, png_of(small), static_cast<int>(small.cols()),
                     static_cast<int>(small.rows()), vertices});
  }
  return views;
}

}  // namespace pliant
