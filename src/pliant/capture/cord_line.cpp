#include "pliant/capture/cord_line.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace pliant {
namespace {

constexpr double kStep = 2;  // pixels, along the cord

/// A place of the cord in a picture that is off its line.
struct OffPlace {
  double off = 0;              // across the line (pixels)
  Eigen::RowVector4d by_ends;  // pixels / m, of both ends across the cord
};

/// Two directions across a line.
Eigen::Matrix<double, 3, 2> across(const Eigen::Vector3d& direction) {
  Eigen::Matrix<double, 3, 2> axes;
  axes.col(0) = direction.unitOrthogonal();
  axes.col(1) = direction.cross(Eigen::Vector3d(axes.col(0)));
  return axes;
}

/// The middle of the light of a cord about a place: its brightest line lies to the side from which
/// light falls.
/// @param off  of that place (pixels)
std::optional<double> middle_of_cord(const SplinePicture& picture, const CordLook& look,
                                     const Eigen::Vector2d& place, const Eigen::Vector2d& normal,
                                     double off) {
  constexpr double kFine = 0.25;  // pixels
  constexpr int kRounds = 3;
  const int steps = static_cast<int>(look.side / kFine);
  double middle = 0;
  for (int round = 0; round < kRounds; ++round) {
    const auto light = [&](double aside) {
      return look.sign * picture.value(place + (middle + aside) * normal);
    };
    const double left = light(-look.side), right = light(look.side);
    double sum = 0, moment = 0;
    for (int i = -steps; i <= steps; ++i) {
      const double aside = i * kFine;
      const double beside = left + (right - left) * (aside + look.side) / (2 * look.side);
      const double own = std::max(light(aside) - beside, 0.0);
      sum += own;
      moment += own * aside;
    }
    if (!(sum > 0)) return std::nullopt;
    middle += moment / sum;
    if (std::abs(middle) > look.side) return std::nullopt;
  }
  return off + middle;
}

/// Where a cord stands out most beside a place, within a reach (pixels).
std::optional<double> off_line(const SplinePicture& picture, const CordLook& look,
                               const Eigen::Vector2d& place, const Eigen::Vector2d& normal,
                               double reach) {
  constexpr double kFine = 0.5, kFaintest = 0.35;  // pixels; contrasts
  const Eigen::Vector2d margin = (reach + 3 * look.side) * normal;
  if (!picture.contains_beside(place, margin)) return std::nullopt;
  const auto ridge = [&](double off) { return look.ridge(picture, place + off * normal, normal); };
  double best = 0, most = kFaintest;
  for (double off = -reach; off <= reach; off += kFine) {
    const double here = ridge(off);
    if (here > most) {
      most = here;
      best = off;
    }
  }
  if (most == kFaintest) return std::nullopt;
  return middle_of_cord(picture, look, place + best * normal, normal, best);
}

/// What one camera sees of a cord.
struct SeenCord {
  std::vector<OffPlace> places;
  int looked = 0;  // places of the line that the picture shows
};

SeenCord seen_by(const CameraModel& camera, const SplinePicture& picture, const CordLook& look,
                 const CordLine& line, double reach) {
  SeenCord seen;
  const Eigen::Vector3d way = line.length * line.direction;
  const auto first = camera.project(line.from), last = camera.project(line.from + way);
  if (!first || !last) return seen;
  const int count = static_cast<int>((*last - *first).norm() / kStep);
  const Eigen::Matrix<double, 3, 2> axes = across(line.direction);
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.5) / count;
    const auto shown = camera.project_with_derivatives(line.from + share * way);
    if (!shown || !picture.contains(shown->pixel)) continue;
    ++seen.looked;
    const Eigen::Vector2d along = shown->by_point * line.direction;
    const Eigen::Vector2d normal = Eigen::Vector2d(-along.y(), along.x()).normalized();
    const auto off = off_line(picture, look, shown->pixel, normal, reach);
    if (!off) continue;
    const Eigen::RowVector2d by_point = normal.transpose() * shown->by_point * axes;
    OffPlace place{*off, {}};
    place.by_ends << (1 - share) * by_point, share * by_point;
    seen.places.push_back(place);
  }
  return seen;
}

struct EndsFit {
  Eigen::Vector4d shift = Eigen::Vector4d::Zero();  // of both ends (m)
  Eigen::LDLT<Eigen::Matrix4d> normal;
  double miss = 0;  // pixels

  /// Standard deviation of the way from end to end, the larger one (m).
  double error() const {
    // Neighbours see the same pixels: of two only one counts.
    const Eigen::Matrix4d covariance = 2 * miss * miss * normal.solve(Eigen::Matrix4d::Identity());
    Eigen::Matrix<double, 2, 4> turn;
    turn << -Eigen::Matrix2d::Identity(), Eigen::Matrix2d::Identity();
    return std::sqrt((turn * covariance * turn.transpose()).diagonal().maxCoeff());
  }
};

/// Places that miss by much more than most do belong to something else.
EndsFit fit_ends(const std::vector<OffPlace>& places, double reach) {
  EndsFit fit;
  double limit = reach;
  for (int round = 0; round < 4; ++round) {
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    double squares = 0;
    int used = 0;
    for (const OffPlace& place : places) {
      const double miss = place.off - place.by_ends * fit.shift;
      if (round > 0 && std::abs(miss) > limit) continue;
      normal += place.by_ends.transpose() * place.by_ends;
      right += place.by_ends.transpose() * place.off;
      squares += miss * miss;
      ++used;
    }
    fit.miss = std::sqrt(squares / std::max(used, 1));
    fit.shift = fit.normal.compute(normal).solve(right);
    limit = std::max(2.5 * fit.miss, 0.3);
  }
  return fit;
}

}  // namespace

std::optional<CordLine> fitted_cord(const CordViews& views, const CordLook& look,
                                    const CordLine& start) {
  constexpr double kShare = 0.35, kMostMiss = 1;  // of what is looked at; pixels
  constexpr double kMostError = 0.02;             // rad
  constexpr int kFewest = 8;                      // places of a camera that sees it
  constexpr double kReaches[] = {6, 4, 3, 3};     // pixels
  CordLine line = start;
  EndsFit fit;
  for (const double reach : kReaches) {
    std::vector<OffPlace> places;
    int seeing = 0;
    line.seen = 0;
    for (std::size_t c = 0; c < views.cameras.size(); ++c) {
      const SeenCord seen = seen_by(views.cameras[c], views.pictures[c], look, line, reach);
      const auto count = std::ssize(seen.places);
      if (count < kFewest || static_cast<double>(count) < kShare * seen.looked) continue;
      ++seeing;
      line.seen += static_cast<double>(count) / seen.looked;
      places.insert(places.end(), seen.places.begin(), seen.places.end());
    }
    if (seeing < 2) return std::nullopt;
    fit = fit_ends(places, reach);
    if (!fit.shift.allFinite() || fit.normal.info() != Eigen::Success) return std::nullopt;
    const Eigen::Matrix<double, 3, 2> axes = across(line.direction);
    const Eigen::Vector3d way =
        line.length * line.direction + axes * (fit.shift.tail<2>() - fit.shift.head<2>());
    line.from += axes * fit.shift.head<2>();
    line.direction = way.normalized();
  }
  line.miss = fit.miss;
  line.error = fit.error() / line.length;
  if (!(line.miss < kMostMiss && line.error < kMostError)) return std::nullopt;
  return line;
}

}  // namespace pliant
