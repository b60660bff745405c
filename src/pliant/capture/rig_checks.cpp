#include "pliant/capture/rig_checks.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include "pliant/base/parallel.h"
#include "pliant/capture/triangulation.h"
#include "pliant/math/cross_matrix.h"

namespace pliant {
namespace {

constexpr int kRegionsAcross = 3;

int region_of(const CameraModel& camera, const Eigen::Vector2d& pixel) {
  const auto third = [](double place, int count) {
    return std::clamp(static_cast<int>(kRegionsAcross * (place + 0.5) / count), 0,
                      kRegionsAcross - 1);
  };
  return kRegionsAcross * third(pixel.y(), camera.rows) + third(pixel.x(), camera.columns);
}

double widest_angle(const std::vector<Eigen::Vector3d>& normals) {
  double widest = 0;
  for (const auto& a : normals) {
    for (const auto& b : normals) widest = std::max(widest, std::acos(std::min(1.0, a.dot(b))));
  }
  return widest;
}

// Distance of a straight place from a line through the straight picture, in pixels.
double distance_in_pixels(const Eigen::Vector3d& line, const Eigen::Vector2d& place,
                          const CameraModel& camera) {
  const Eigen::Vector2d focal = camera.intrinsics.head<2>();
  return std::abs(line.dot(place.homogeneous())) / line.head<2>().cwiseQuotient(focal).norm();
}

using PixelByCorner = std::map<std::pair<int, int>, Eigen::Vector2d>;  // placement and corner

std::vector<PixelByCorner> pixels_by_camera(const Bundle& bundle) {
  std::vector<PixelByCorner> result(bundle.cameras.size());
  for (const CornerView& view : bundle.views) {
    for (int i = 0; i < std::ssize(view.corners); ++i) {
      if (view.is_used[i]) {
        result[view.camera][{view.placement, view.corners[i]}] = view.pixels.col(i);
      }
    }
  }
  return result;
}

}  // namespace

std::vector<CameraResiduals> camera_residuals(const Bundle& bundle) {
  struct Sum {
    double squares = 0;
    int corners = 0;
    double rms() const { return std::sqrt(squares / corners); }
  };
  std::vector<CameraResiduals> result(bundle.cameras.size());
  std::vector<std::array<Sum, 9>> sums(bundle.cameras.size());
  std::vector<std::vector<Eigen::Vector3d>> normals(bundle.cameras.size());
  for (const CornerView& view : bundle.views) {
    const CameraModel& camera = bundle.cameras[view.camera];
    CameraResiduals& own = result[view.camera];
    const Eigen::Matrix2Xd residuals = bundle.residuals(view);
    own.pictures += view.used() > 0;
    own.left_out += static_cast<int>(view.corners.size()) - view.used();
    for (int i = 0; i < std::ssize(view.corners); ++i) {
      own.rms_all += residuals.col(i).squaredNorm();
      if (!view.is_used[i]) continue;
      Sum& sum = sums[view.camera][region_of(camera, view.pixels.col(i))];
      sum.squares += residuals.col(i).squaredNorm();
      ++sum.corners;
    }
    normals[view.camera].push_back(
        (camera.pose * bundle.placements[view.placement].pose).matrix().col(2));
  }
  for (int c = 0; c < std::ssize(result); ++c) {
    Sum all;
    for (int r = 0; r < 9; ++r) {
      all.squares += sums[c][r].squares;
      all.corners += sums[c][r].corners;
      if (sums[c][r].corners > 0) result[c].regions[r] = sums[c][r].rms();
    }
    result[c].corners = all.corners;
    result[c].rms = all.corners > 0 ? all.rms() : 0;
    const int seen = all.corners + result[c].left_out;
    result[c].rms_all = seen > 0 ? std::sqrt(result[c].rms_all / seen) : 0;
    result[c].widest_tilt = widest_angle(normals[c]);
  }
  return result;
}

std::vector<EpipolarResidual> epipolar_residuals(const Bundle& bundle) {
  const std::vector<PixelByCorner> pixels = pixels_by_camera(bundle);
  std::vector<EpipolarResidual> result;
  for (int a = 0; a < std::ssize(bundle.cameras); ++a) {
    for (int b = a + 1; b < std::ssize(bundle.cameras); ++b) {
      const CameraModel &first = bundle.cameras[a], &second = bundle.cameras[b];
      const RigidMotion between = second.pose * first.pose.inverse();
      const Eigen::Matrix3d essential = cross_matrix(between.translation) * between.matrix();
      EpipolarResidual pair{a, b, 0, 0};
      double squares = 0;
      for (const auto& [key, pixel] : pixels[a]) {
        const auto other = pixels[b].find(key);
        if (other == pixels[b].end()) continue;
        const auto p = first.straight(pixel), q = second.straight(other->second);
        if (!p || !q) continue;
        const double in_second = distance_in_pixels(essential * p->homogeneous(), *q, second);
        const double in_first =
            distance_in_pixels(essential.transpose() * q->homogeneous(), *p, first);
        squares += (in_first * in_first + in_second * in_second) / 2;
        ++pair.corners;
      }
      if (pair.corners == 0) continue;
      pair.rms = std::sqrt(squares / pair.corners);
      result.push_back(pair);
    }
  }
  return result;
}

namespace {

// The corners of a placed board that two cameras or more see, by the cameras alone.
struct MeasuredBoard {
  std::vector<Eigen::Vector3d> measured, board;
};

MeasuredBoard measure_board(const Bundle& bundle, int placement) {
  std::map<int, std::vector<Sighting>> sightings;
  for (const CornerView& view : bundle.views) {
    if (view.placement != placement) continue;
    for (int i = 0; i < std::ssize(view.corners); ++i) {
      if (!view.is_used[i]) continue;
      sightings[view.corners[i]].push_back(
          {&bundle.cameras[view.camera], view.pixels.col(i), bundle.noise[view.camera]});
    }
  }
  MeasuredBoard result;
  for (const auto& [corner, seen] : sightings) {
    const auto point = triangulate(seen);
    if (!point) continue;
    result.measured.push_back(point->point);
    result.board.push_back(bundle.corner({bundle.placements[placement].board, {}}, corner));
  }
  return result;
}

struct BoardFit {
  double squares = 0, scale = 1;
};

BoardFit fit_board(const MeasuredBoard& points) {
  const auto count = std::ssize(points.board);
  Eigen::Matrix3Xd from(3, count), to(3, count);
  for (int i = 0; i < count; ++i) {
    from.col(i) = points.board[i];
    to.col(i) = points.measured[i];
  }
  const Eigen::Matrix4d rigid = Eigen::umeyama(from, to, false);
  const Eigen::Matrix4d similar = Eigen::umeyama(from, to, true);
  const Eigen::Matrix3Xd missed =
      (rigid.topLeftCorner<3, 3>() * from).colwise() + rigid.topRightCorner<3, 1>().eval();
  return {(missed - to).squaredNorm(), similar.topLeftCorner<3, 3>().col(0).norm()};
}

Bundle without(const Bundle& bundle, const std::vector<bool>& held) {
  Bundle rest = bundle;
  std::erase_if(rest.views, [&](const CornerView& view) { return held[view.placement]; });
  return rest;
}

std::vector<int> placements_of_pairs(const Bundle& bundle) {
  std::vector<std::vector<int>> cameras(bundle.placements.size());
  for (const CornerView& view : bundle.views) {
    if (view.used() > 0) cameras[view.placement].push_back(view.camera);
  }
  std::vector<int> result;
  for (int p = 0; p < std::ssize(cameras); ++p) {
    if (cameras[p].size() >= 2) result.push_back(p);
  }
  return result;
}

struct HeldOutSums {
  double squares = 0, scales = 0;
  int corners = 0, boards = 0;
};

// Calibrates without some placements and measures them.
HeldOutSums measure_held_out(const Bundle& bundle, const std::vector<int>& held,
                             const BundleOptions& options) {
  constexpr int kFewestCorners = 4;
  std::vector<bool> is_held(bundle.placements.size(), false);
  for (const int placement : held) is_held[placement] = true;
  Bundle rest = without(bundle, is_held);
  readjust(rest, options);
  rest.views = bundle.views;
  HeldOutSums sums;
  for (const int placement : held) {
    const MeasuredBoard points = measure_board(rest, placement);
    if (std::ssize(points.board) < kFewestCorners) continue;
    const BoardFit fit = fit_board(points);
    sums.squares += fit.squares;
    sums.scales += fit.scale - 1;
    sums.corners += static_cast<int>(points.board.size());
    ++sums.boards;
  }
  return sums;
}

}  // namespace

std::optional<HeldOutBoards> held_out_boards(const Bundle& bundle, const BundleOptions& options) {
  constexpr int kMostTimes = 9, kFewest = 4;
  const std::vector<int> candidates = placements_of_pairs(bundle);
  const int count = static_cast<int>(candidates.size());
  if (count < kFewest) return std::nullopt;  // what is left would tell the cameras badly
  const int times = std::min(kMostTimes, count);
  std::vector<HeldOutSums> sums(times);
  parallel_for(times, options.threads, [&](int time) {
    std::vector<int> held;
    for (int i = time; i < count; i += times) held.push_back(candidates[i]);
    sums[time] = measure_held_out(bundle, held, options);
  });
  HeldOutBoards result;
  double squares = 0, scales = 0;
  for (const HeldOutSums& sum : sums) {
    squares += sum.squares;
    scales += sum.scales;
    result.corners += sum.corners;
    result.boards += sum.boards;
  }
  if (result.boards == 0) return std::nullopt;
  result.rms = std::sqrt(squares / result.corners);
  result.scale_error = scales / result.boards;
  return result;
}

}  // namespace pliant
