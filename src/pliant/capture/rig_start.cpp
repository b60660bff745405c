#include "pliant/capture/rig_start.h"

#include <algorithm>
#include <map>
#include <set>

#include <fmt/format.h>

#include "pliant/capture/homography.h"

namespace pliant {
namespace {

// A board at one place: the shot, and which board.
using PlaceKey = std::pair<int, int>;
using PosesInCamera = std::map<PlaceKey, RigidMotion>;  // of boards, in camera axes

struct CameraStart {
  CameraModel camera;  // its pose is not known
  double noise = 1;
  PosesInCamera poses;
  std::map<PlaceKey, int> pictures;
};

Bundle bundle_of_camera(const RigFile& rig, const std::vector<RigPicture>& pictures, int camera) {
  Bundle bundle;
  bundle.cameras.resize(1);
  bundle.noise = {1};
  for (const CalibrationBoard& board : rig.boards) bundle.boards.push_back(board.corners());
  bundle.warps.assign(rig.boards.size(), BoardWarp::Zero());
  for (int i = 0; i < std::ssize(pictures); ++i) {
    const RigPicture& picture = pictures[i];
    if (picture.camera != camera || !picture.left_out.empty()) continue;
    bundle.cameras[0].columns = picture.columns;
    bundle.cameras[0].rows = picture.rows;
    for (const BoardView& view : picture.findings.boards) {
      const int placement = static_cast<int>(bundle.placements.size());
      bundle.placements.push_back({view.board, {}});
      bundle.views.push_back({0, placement, view.corners, view.pixels,
                              std::vector<bool>(view.corners.size(), true), i});
    }
  }
  return bundle;
}

// Focal length and poses by homographies; no distortion yet.
void start_camera(Bundle& bundle) {
  CameraModel& camera = bundle.cameras[0];
  const Eigen::Vector2d principal((camera.columns - 1) / 2.0, (camera.rows - 1) / 2.0);
  std::vector<Eigen::Matrix3d> seen;
  for (const CornerView& view : bundle.views) {
    const Eigen::Matrix3Xd& board = bundle.boards[bundle.placements[view.placement].board];
    Eigen::Matrix2Xd plane(2, std::ssize(view.corners));
    for (int i = 0; i < plane.cols(); ++i) plane.col(i) = board.col(view.corners[i]).head<2>();
    seen.push_back(homography(plane, view.pixels));
  }
  const double usual = 1.5 * std::max(camera.columns, camera.rows);
  const double focal_length = focal_length_of_planes(seen, principal, usual);
  camera.intrinsics << focal_length, focal_length, principal, 0, 0, 0, 0, 0;
  for (int v = 0; v < std::ssize(bundle.views); ++v) {
    bundle.placements[bundle.views[v].placement].pose =
        pose_of_plane(seen[v], focal_length, principal);
  }
}

// Alone, few pictures tell little of a camera; the start needs no more.
FreeIntrinsics free_at_start(const FreeIntrinsics& wanted, int views) {
  constexpr int kEnough = 4;
  FreeIntrinsics free = wanted;
  if (views >= kEnough) return free;
  for (int k = 2; k < kIntrinsics; ++k) free[k] = false;
  free[4] = wanted[4];
  return free;
}

CameraStart start_of_camera(const RigFile& rig, std::vector<RigPicture>& pictures, int camera,
                            const BundleOptions& options) {
  Bundle bundle = bundle_of_camera(rig, pictures, camera);
  start_camera(bundle);
  bundle.free = {free_at_start(rig.cameras[camera].free, static_cast<int>(bundle.views.size()))};
  adjust(bundle, options);
  CameraStart start{bundle.cameras[0], bundle.noise[0], {}, {}};
  for (const CornerView& view : bundle.views) {
    RigPicture& picture = pictures[view.picture];
    if (2 * view.used() < std::ssize(view.corners)) {
      picture.left_out = "shows corners that do not fit the board";
      continue;
    }
    const PlaceKey key{picture.shot, bundle.placements[view.placement].board};
    start.poses[key] = bundle.placements[view.placement].pose;
    start.pictures[key] = view.picture;
  }
  return start;
}

// What a pair of cameras says of where they are to each other.
struct PairStart {
  RigidMotion second_of_first;  // takes points from the first camera's axes to the second's
  std::vector<PlaceKey> agreeing, contradicting;
};

bool agree(const RigidMotion& a, const RigidMotion& b, double distance) {
  constexpr double kAngle = 0.1, kShare = 0.1;  // single pictures are not exact
  const RigidMotion between = a.inverse() * b;
  return between.rotation.norm() < kAngle && between.translation.norm() < kShare * distance;
}

PairStart compare_pair(const CameraStart& first, const CameraStart& second) {
  std::vector<PlaceKey> shared;
  std::vector<RigidMotion> motions;
  std::vector<double> distances;
  for (const auto& [key, pose] : first.poses) {
    const auto other = second.poses.find(key);
    if (other == second.poses.end()) continue;
    shared.push_back(key);
    motions.push_back(other->second * pose.inverse());
    distances.push_back(pose.translation.norm() + other->second.translation.norm());
  }
  PairStart best;
  double least = 0;
  for (int i = 0; i < std::ssize(shared); ++i) {
    PairStart candidate{motions[i], {}, {}};
    double spread = 0;
    for (int k = 0; k < std::ssize(shared); ++k) {
      const bool agrees = agree(motions[i], motions[k], distances[k]);
      (agrees ? candidate.agreeing : candidate.contradicting).push_back(shared[k]);
      if (agrees) spread += (motions[i].inverse() * motions[k]).translation.norm();
    }
    const auto more = std::ssize(candidate.agreeing) - std::ssize(best.agreeing);
    if (more > 0 || (more == 0 && spread < least)) {
      best = std::move(candidate);
      least = spread;
    }
  }
  return best;
}

void refuse_contradicting(const RigFile& rig, int first, int second, const PairStart& pair) {
  const auto all = std::ssize(pair.agreeing) + std::ssize(pair.contradicting);
  if (all < 2 || 2 * std::ssize(pair.agreeing) > all) return;
  throw InputError(
      rig.cameras[second].where,
      fmt::format("its pictures and those of {} contradict each other: at most {} of {} agree on "
                  "where the cameras are",
                  rig.cameras[first].name, pair.agreeing.size(), all),
      "pictures of the same moments in the same order, and cameras that stand still");
}

void leave_out_contradicting(const PairStart& pair, const CameraStart& first, CameraStart& second,
                             std::vector<RigPicture>& pictures) {
  for (const PlaceKey& key : pair.contradicting) {
    RigPicture& picture = pictures[second.pictures.at(key)];
    picture.left_out = fmt::format("does not show the board where {} shows it",
                                   pictures[first.pictures.at(key)].file);
    picture.contradicts = true;
    second.poses.erase(key);
  }
}

// Poses of cameras along the pairs that share most.
std::vector<RigidMotion> connect(const RigFile& rig, std::vector<CameraStart>& starts,
                                 std::vector<RigPicture>& pictures) {
  const int count = static_cast<int>(starts.size());
  std::vector<RigidMotion> poses(count);
  std::set<int> placed{0};
  while (std::ssize(placed) < count) {
    std::pair<int, int> nearest{-1, -1};
    PairStart best;
    for (const int first : placed) {
      for (int second = 0; second < count; ++second) {
        if (placed.contains(second)) continue;
        PairStart pair = compare_pair(starts[first], starts[second]);
        refuse_contradicting(rig, first, second, pair);
        if (pair.agreeing.size() > best.agreeing.size()) {
          best = std::move(pair);
          nearest = {first, second};
        }
      }
    }
    if (nearest.second < 0) {
      int lost = 0;
      while (placed.contains(lost)) ++lost;
      throw InputError(rig.cameras[lost].where,
                       "no board was seen by this camera and one of the others at the same time",
                       "a set in `calibration.pictures` with pictures of both");
    }
    leave_out_contradicting(best, starts[nearest.first], starts[nearest.second], pictures);
    poses[nearest.second] = best.second_of_first * poses[nearest.first];
    placed.insert(nearest.second);
  }
  return poses;
}

void add_views(const std::vector<RigPicture>& pictures, const std::vector<CameraStart>& starts,
               Bundle& bundle) {
  std::map<PlaceKey, int> placements;
  for (int i = 0; i < std::ssize(pictures); ++i) {
    const RigPicture& picture = pictures[i];
    if (!picture.left_out.empty()) continue;
    for (const BoardView& view : picture.findings.boards) {
      const PlaceKey key{picture.shot, view.board};
      const auto pose = starts[picture.camera].poses.find(key);
      if (pose == starts[picture.camera].poses.end()) continue;
      const auto [place, is_new] =
          placements.emplace(key, static_cast<int>(bundle.placements.size()));
      if (is_new) {
        const RigidMotion& camera = bundle.cameras[picture.camera].pose;
        bundle.placements.push_back({view.board, camera.inverse() * pose->second});
      }
      bundle.views.push_back({picture.camera, place->second, view.corners, view.pixels,
                              std::vector<bool>(view.corners.size(), true), i});
    }
  }
}

void require_boards_that_show_up(const RigFile& rig) {
  if (rig.cameras.size() < 2) return;
  for (int b = 0; b < std::ssize(rig.boards); ++b) {
    const auto* chessboard = std::get_if<Chessboard>(&rig.boards[b].kind);
    if (!chessboard || chessboard->shows_up()) continue;
    throw InputError(rig.where_boards[b],
                     fmt::format("a chessboard of {} x {} corners looks the same upside down: two "
                                 "cameras may take its corners for different ones",
                                 chessboard->columns, chessboard->rows),
                     "an odd and an even number, or a board of tags");
  }
}

}  // namespace

Bundle start_of_rig(const RigFile& rig, std::vector<RigPicture>& pictures,
                    const BundleOptions& options) {
  require_boards_that_show_up(rig);
  Bundle bundle;
  std::vector<CameraStart> starts;
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    starts.push_back(start_of_camera(rig, pictures, c, options));
  }
  const std::vector<RigidMotion> poses = connect(rig, starts, pictures);
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    bundle.cameras.push_back(starts[c].camera);
    bundle.cameras.back().pose = poses[c];
    bundle.free.push_back(rig.cameras[c].free);
    bundle.noise.push_back(starts[c].noise);
  }
  for (const CalibrationBoard& board : rig.boards) bundle.boards.push_back(board.corners());
  bundle.warps.assign(rig.boards.size(), BoardWarp::Zero());
  add_views(pictures, starts, bundle);
  return bundle;
}

}  // namespace pliant
