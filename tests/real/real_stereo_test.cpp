// A pair of pictures whose disparities are known; skipped where PLIANT_TEST_DATA does not hold it.
// The lines it prints are those of the documentation.

#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/capture/stereo_rest.h"
#include "pliant/imaging/photo.h"
#include "pliant/io/text_file.h"

#include "real/real_fit.h"

namespace pliant::test {
namespace {

/// The floats of an uncompressed picture, row by row.
Eigen::ArrayXXf disparities(const std::filesystem::path& file, int columns, int rows) {
  const std::string bytes = read_text_file(file);
  Eigen::Array<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values(rows, columns);
  const std::size_t size = sizeof(float) * static_cast<std::size_t>(values.size());
  std::memcpy(values.data(), bytes.data() + bytes.size() - size, size);
  return values;
}

TEST(RealStereo, DisparitiesOfTheConesAreMet) {
  const std::filesystem::path folder = measurement("stereo_middlebury_cones");
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no measurements at " << folder;
  constexpr int kColumns = 450, kRows = 375;
  // Any camera will do for a pair that is rectified: lines of sight lie in rows.
  CameraModel left, right;
  left.intrinsics << 600, 600, kColumns / 2.0, kRows / 2.0, 0, 0, 0, 0, 0;
  left.columns = kColumns;
  left.rows = kRows;
  right = left;
  right.pose.translation.x() = -0.1;
  const std::vector<GreyPicture> pictures{read_photo(folder / "Cones_LEFT.tif"),
                                          read_photo(folder / "Cones_RIGHT.tif")};
  const Eigen::ArrayXXf truth = disparities(folder / "Cones_LEFT_GT.tif", kColumns, kRows);
  const GreyPicture occluded = read_photo(folder / "Occlusion_LEFT.png");
  Quadrilateral all;
  all << 0, kColumns - 1, kColumns - 1, 0, 0, 0, kRows - 1, kRows - 1;
  for (const auto& [radius, least_matched] : {std::pair(4, 0.70), std::pair(7, 0.66)}) {
    const StereoRest rest = match_rest({left, right}, pictures, all, {radius, 3}, {});
    int known = 0, matched = 0, close = 0;
    double squares = 0;
    for (const Eigen::Vector2d& place : places_within(all, 3, radius + 1)) {
      const auto row = static_cast<int>(place.y()), column = static_cast<int>(place.x());
      known += truth(row, column) > 0 && occluded(row, column) > 0.5F;
    }
    for (const RestPoint& point : rest.points) {
      const Eigen::Vector2d place = point.seen[0]->pixel;
      const auto row = static_cast<int>(place.y()), column = static_cast<int>(place.x());
      if (!(truth(row, column) > 0 && occluded(row, column) > 0.5F)) continue;
      ++matched;
      const double off = place.x() - point.seen[1]->pixel.x() - truth(row, column);
      if (std::abs(off) > 1) continue;
      ++close;
      squares += off * off;
    }
    fmt::print(
        "cones, patches of {} px: {:.1f} % of {} places matched, {:.1f} % of them within 1 "
        "px, {:.2f} px RMS of these\n",
        2 * radius + 1, 100.0 * matched / known, known, 100.0 * close / matched,
        std::sqrt(squares / close));
    // Measured are 0.721 and 0.680, 0.988 and 0.979, 0.18 and 0.20 pixels.
    EXPECT_GT(matched, least_matched * known);
    EXPECT_GT(close, 0.97 * matched);
    EXPECT_LT(std::sqrt(squares / close), 0.22);
  }
}

}  // namespace
}  // namespace pliant::test
