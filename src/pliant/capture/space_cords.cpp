#include "pliant/capture/space_cords.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"
#include "pliant/capture/clip_motion.h"
#include "pliant/capture/cord_search.h"

namespace pliant {
namespace {

constexpr double kFarthestTurn = 2.6;  // rad
constexpr double kWellSeen = 0.8;      // of it, by each camera

/// Whether what was found is what was looked for, and not a line beside it.
bool is_fastened(const CordLine& line, const Eigen::Vector3d& fastened) {
  constexpr double kLoose = 2e-3;  // m
  return (line.from - fastened).norm() < kLoose;
}

/// Beyond what pointing at one cord twice differs by, within what two cords of a clip do.
bool are_one_cord(const CordLine& a, const CordLine& b) {
  constexpr double kApart = 1e-3, kTurned = 0.02;  // m, rad
  return (a.from - b.from).norm() < kApart && a.direction.cross(b.direction).norm() < kTurned;
}

/// A cord that has hardly turned is where it was; otherwise it is looked for all around.
std::optional<CordLine> followed(const CordViews& views, const CordLook& look,
                                 const CordLine& last) {
  auto line = fitted_cord(views, look, last);
  if (line && !is_fastened(*line, last.from)) line.reset();
  const auto cameras = static_cast<double>(views.cameras.size());
  if (line && line->seen > kWellSeen * cameras) return line;
  const auto elsewhere = found_cord(views, look, last, kFarthestTurn);
  if (!elsewhere || !is_fastened(*elsewhere, last.from)) return line;
  return line && line->seen >= elsewhere->seen ? line : elsewhere;
}

}  // namespace

SpaceCords::SpaceCords(const DicFile& dic, const Eigen::Isometry3d& to_rig,
                       const Eigen::Matrix3Xd& rest, int threads)
    : dic_(dic), to_rig_(to_rig), threads_(threads) {
  for (const DicCell& cell : dic.forces->cells) {
    Cord cord;
    cord.clip = dic.clip_number(cell.clip);
    const Eigen::Vector2d middle = held_cloth(dic, dic.clips[cord.clip]).center();
    Eigen::Index nearest = 0;
    (rest.colwise() - to_rig * Eigen::Vector3d(middle.x(), middle.y(), 0))
        .colwise()
        .squaredNorm()
        .minCoeff(&nearest);
    cord.beside = rest.col(nearest);
    cords_.push_back(cord);
  }
}

void SpaceCords::require_free(int frame, const std::string& why) const {
  for (const DicCell& cell : dic_.forces->cells) {
    if (cell.frame != frame) continue;
    throw InputError(cell.where_picture, "is of a moment that " + why,
                     "a picture of a frame in which all clips are seen");
  }
}

FrameCords SpaceCords::follow(int frame, const std::vector<GreyPicture>& pictures,
                              const std::vector<std::optional<Pose>>& clips) {
  const bool is_early = std::ranges::none_of(
      dic_.forces->cells, [&](const DicCell& cell) { return cell.frame <= frame; });
  if (is_early) return {std::vector<std::optional<CordLine>>(cords_.size()), {}};
  std::vector<std::optional<SplinePicture>> made(pictures.size());
  parallel_for(static_cast<int>(pictures.size()), threads_, [&](int c) {
    const auto camera = static_cast<std::size_t>(c);
    made[camera].emplace(pictures[camera]);
  });
  std::vector<SplinePicture> splines;
  for (auto& spline : made) splines.push_back(*std::move(spline));
  const CordViews views{dic_.views->cameras, splines};
  FrameCords found;
  with_threads(threads_, [&] {
    for (std::size_t i = 0; i < cords_.size(); ++i) {
      const DicCell& cell = dic_.forces->cells[i];
      Cord& cord = cords_[i];
      found.lines.emplace_back();
      if (frame < cell.frame) continue;
      const Pose& pose = *clips[cord.clip];
      if (frame == cell.frame) {
        point_at(cell, cord, views, pose);
        found.lines.back() = cord.last;
        continue;
      }
      CordLine start = *cord.last;
      start.from = pose.apply(cord.fastened);
      found.lines.back() = followed(views, cord.look, start);
      if (found.lines.back()) {
        cord.last = found.lines.back();
        // Each line passes where it is fastened: lines of different directions tell it better than
        // the user has.
        cord.fastened = pose.local(cord.last->from);
      } else if (found.missing.empty()) {
        found.missing = fmt::format("shows the cord {} of the clip {} to less than two cameras",
                                    cell.cord, cell.clip);
      }
    }
  });
  require_own_cords(frame, found.lines);
  return found;
}

void SpaceCords::require_own_cords(int frame,
                                   const std::vector<std::optional<CordLine>>& lines) const {
  const std::vector<DicCell>& cells = dic_.forces->cells;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (std::max(cells[i].frame, cells[j].frame) != frame) continue;
      if (!lines[i] || !lines[j] || !are_one_cord(*lines[i], *lines[j])) continue;
      throw InputError(cells[i].where,
                       fmt::format("points to the cord of another cell, the cord {} of the clip {}",
                                   cells[j].cord, cells[j].clip),
                       "a cord of its own for each cell");
    }
  }
}

void SpaceCords::point_at(const DicCell& cell, Cord& cord, const CordViews& views,
                          const Pose& pose) const {
  const auto pointed = look_of_cord(views.pictures[cell.camera], cell.from, cell.to);
  if (!pointed) {
    throw InputError(cell.where, "points to no cord",
                     "two pixels of a straight line that is brighter or darker than what is on "
                     "both its sides, a cord in a picture in which it is pulled");
  }
  const Eigen::Hyperplane<double, 3> fastened(
      Eigen::Vector3d(pose.rotation * to_rig_.linear().col(2)), pose.apply(cord.beside));
  cord.last = pointed_cord(views, cell.camera, *pointed, fastened);
  if (!cord.last) {
    throw InputError(cell.where,
                     fmt::format("points to a cord that no other camera than {} sees",
                                 dic_.views->names[cell.camera]),
                     "a cord that two cameras see, from where it is fastened to the clip");
  }
  cord.look = pointed->look;
  cord.fastened = pose.local(cord.last->from);
}

}  // namespace pliant
