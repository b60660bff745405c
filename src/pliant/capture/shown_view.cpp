#include "pliant/capture/shown_view.h"

#include <algorithm>
#include <cmath>

#include "pliant/capture/coarse_search.h"
#include "pliant/capture/grey_png.h"

namespace pliant {
namespace {

constexpr int kColumns = 480;            // about, of a small picture
constexpr double kScreen = 96 / 0.0254;  // pixels per metre, for programs that ask

}  // namespace

std::vector<ShownView> shown_views(const DicSession& made, const ReadPicture& read_picture) {
  std::vector<ShownView> views;
  for (const MeshView& view : made.views) {
    const GreyPicture whole = read_picture(view.seen.file);
    const int factor = std::max(1, static_cast<int>(std::lround(whole.cols() / kColumns)));
    const GreyPicture small = reduced(whole, factor);
    // The middle of the first pixel of a square is half a square off the square's.
    const Eigen::Matrix2Xd vertices = ((view.seen.pixels.array() - (factor - 1) / 2.0) / factor);
    views.push_back({view.frame, view.camera, grey_png_bytes(small, kScreen),
                     static_cast<int>(small.cols()), static_cast<int>(small.rows()), vertices});
  }
  return views;
}

}  // namespace pliant
