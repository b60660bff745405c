#include "pliant/capture/repeating_texture.h"

#include <algorithm>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/base/parallel.h"
#include "pliant/capture/median.h"
#include "pliant/capture/reference_patch.h"
#include "pliant/capture/scattered.h"

namespace pliant {
namespace {

constexpr int kRadius = 10;  // of squares: smaller ones are like others by chance
constexpr int kReach = 60;
constexpr int kSide = 2 * kReach + 1;

using Correlations = Eigen::Array<float, kSide, kSide, Eigen::RowMajor>;

/// Of a square with those around it, by how far these are away.
Correlations correlations(const GreyPicture& picture, const Eigen::Vector2i& place) {
  constexpr int kPixels = 2 * kRadius + 1;
  const auto within = [&](const Eigen::Vector2i& middle) {
    return middle.minCoeff() >= kRadius && middle.x() + kRadius < picture.cols() &&
           middle.y() + kRadius < picture.rows();
  };
  const auto square = [&](const Eigen::Vector2i& middle) {
    GreyPicture values =
        picture.block(middle.y() - kRadius, middle.x() - kRadius, kPixels, kPixels);
    values -= values.mean();
    return values;
  };
  Correlations all = Correlations::Constant(-1);
  if (!within(place)) return all;
  const GreyPicture own = square(place);
  for (int y = -kReach; y <= kReach; ++y) {
    for (int x = -kReach; x <= kReach; ++x) {
      const Eigen::Vector2i there = place + Eigen::Vector2i(x, y);
      if (!within(there)) continue;
      const GreyPicture other = square(there);
      const float norms = own.matrix().norm() * other.matrix().norm();
      if (norms > 0) all(y + kReach, x + kReach) = (own * other).sum() / norms;
    }
  }
  return all;
}

/// The most alike place that is more alike than all around it, the square itself left out.
TextureRepeat most_alike(const Correlations& all) {
  TextureRepeat best;
  for (int y = 1; y + 1 < kSide; ++y) {
    for (int x = 1; x + 1 < kSide; ++x) {
      const float here = all(y, x);
      const Eigen::Vector2d away(x - kReach, y - kReach);
      if (away.isZero() || here <= best.correlation) continue;
      if (here >= all.block<3, 3>(y - 1, x - 1).maxCoeff()) best = {away.norm(), here};
    }
  }
  return best;
}

}  // namespace

std::optional<TextureRepeat> texture_repeat(const GreyPicture& picture,
                                            const Eigen::Matrix2Xd& places, int threads) {
  constexpr int kSquares = 24;
  const std::vector<int> chosen = scattered(static_cast<int>(places.cols()), kSquares);
  std::vector<TextureRepeat> found(chosen.size());
  with_threads(threads, [&] {
    parallel_for(static_cast<int>(chosen.size()), [&](int i) {
      const Eigen::Vector2d place = places.col(chosen[static_cast<std::size_t>(i)]);
      found[static_cast<std::size_t>(i)] =
          most_alike(correlations(picture, place.array().round().cast<int>()));
    });
  });
  std::vector<double> away, correlation;
  for (const TextureRepeat& repeat : found) {
    away.push_back(repeat.away);
    correlation.push_back(repeat.correlation);
  }
  const TextureRepeat repeat{median(std::move(away)), median(std::move(correlation))};
  return repeat.correlation > kAlike ? std::optional(repeat) : std::nullopt;
}

std::vector<std::string> repeat_warnings(const GreyPicture& picture, const Eigen::Matrix2Xd& places,
                                         int threads) {
  const auto repeat = texture_repeat(picture, places, threads);
  if (!repeat) return {};
  return {fmt::format(
      "the cloth's own pattern repeats: its squares are as good as the same {:.0f} pixels away "
      "(correlation {:.2f}), and may be mistaken for each other without a trace; an irregular "
      "print on it, as of `pliant pattern cloth`, cannot",
      repeat->away, repeat->correlation)};
}

}  // namespace pliant
