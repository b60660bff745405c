#include "pliant/capture/rig_calibration.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/capture/rig_start.h"
#include "pliant/capture/tag_edges.h"

namespace pliant {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
// What boards that lie nearly alike tell of a focal length is what their noise and bend make of it.
constexpr double kLeastTilt = 10 * kDegree;
// A rig of which a focal length is known worse measures lengths and depths no better.
constexpr double kWorstFocalLength = 0.02, kDoubtfulFocalLength = 0.003;
constexpr double kDoubtfulLength = 3, kWrongLength = 4;  // errors apart
constexpr double kWrongScale = 0.005;                    // and by as much

// Pictures most of whose corners were left out tell of another board, or of a moved one.
bool leave_out_bad_views(RigCalibration& result) {
  Bundle& bundle = result.bundle;
  bool any = false;
  for (const CornerView& view : bundle.views) {
    if (2 * view.used() >= std::ssize(view.corners)) continue;
    RigPicture& picture = result.pictures[view.picture];
    picture.left_out = "shows corners that do not fit the other pictures";
    picture.contradicts = true;
    any = true;
  }
  std::erase_if(bundle.views,
                [&](const CornerView& view) { return 2 * view.used() < std::ssize(view.corners); });
  return any;
}

/// Corners of tags as the lenses show them, which a first adjustment knows well enough.
void correct_by_lenses(RigCalibration& result) {
  for (CornerView& view : result.bundle.views) {
    const int board = result.bundle.placements[view.placement].board;
    const auto& boards = result.pictures[view.picture].findings.boards;
    const Eigen::Matrix2Xd& of_lines =
        std::ranges::find(boards, board, &BoardView::board)->of_lines;
    for (Eigen::Index i = 0; i < of_lines.cols(); i += 4) {
      view.pixels.middleCols<4>(i) =
          corners_by_lens(of_lines.middleCols<4>(i), result.bundle.cameras[view.camera]);
    }
  }
}

void require_tilts(const RigFile& rig, const RigCalibration& result) {
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const double focal_length = result.bundle.cameras[c].intrinsics(0);
    const double error = result.covariance.is_determined ? result.error(c, 0) / focal_length : 1;
    const double tilt = result.cameras[c].widest_tilt / kDegree;
    if (error < kWorstFocalLength && tilt * kDegree > kLeastTilt) continue;
    if (!result.covariance.is_determined && tilt * kDegree > kLeastTilt) continue;
    throw InputError(
        rig.cameras[c].where,
        fmt::format(
            "its pictures do not tell its focal length: the boards differ in tilt by {:.1f} "
            "degrees",
            tilt),
        "pictures of the board tilted by 20 to 45 degrees to the left, right, up and down");
  }
  if (result.covariance.is_determined) return;
  throw InputError({rig.file, 0, "calibration.pictures"}, "do not tell all of the cameras",
                   "more pictures, with boards in several tilts all over each picture; or fewer "
                   "numbers of `distortion`");
}

void warn_of_tilts(const RigFile& rig, RigCalibration& result) {
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const double share = result.error(c, 0) / result.bundle.cameras[c].intrinsics(0);
    if (share < kDoubtfulFocalLength) continue;
    result.warnings.push_back(fmt::format(
        "{}: its focal length is known to {:.1f} % only: more pictures with the board tilted by 20 "
        "to 45 degrees tell more",
        rig.cameras[c].name, 100 * share));
  }
}

void warn_of_regions(const RigFile& rig, RigCalibration& result) {
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const auto& regions = result.cameras[c].regions;
    const auto empty =
        std::ranges::count(regions, false, [](const auto& rms) { return rms.has_value(); });
    if (empty == 0) continue;
    result.warnings.push_back(
        fmt::format("{}: no corner of a board was seen in {} of 9 regions of its picture: its "
                    "distortion there is a guess",
                    rig.cameras[c].name, empty));
  }
}

/// A camera that was moved or refocused meanwhile fits none of its pictures well, or not all.
void warn_of_contradictions(const RigFile& rig, RigCalibration& result) {
  constexpr double kMostLeftOut = 0.05, kMostMiss = 1;  // of the corners; pixels
  constexpr std::ptrdiff_t kMostPictures = 1;           // that may be of another moment
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const CameraResiduals& own = result.cameras[c];
    const auto pictures = std::ranges::count_if(result.pictures, [&](const RigPicture& picture) {
      return picture.camera == c && picture.contradicts;
    });
    const double left_out = static_cast<double>(own.left_out) / (own.corners + own.left_out);
    if (pictures <= kMostPictures && left_out < kMostLeftOut && own.rms < kMostMiss) continue;
    result.warnings.push_back(fmt::format(
        "{}: its pictures do not go together: {} of them and {:.0f} % of the corners in the others "
        "had to be left out, and what is left is missed by {:.2g} pixels: was it moved, refocused "
        "or stabilised meanwhile, are pictures of other moments, or is the board bent?",
        rig.cameras[c].name, pictures, 100 * left_out, own.rms));
  }
}

/// @throws InputError where two cameras have taken the same pictures
void require_places(const RigFile& rig, const RigCalibration& result) {
  constexpr double kNearest = 1e-3;  // m
  for (const EpipolarResidual& pair : result.pairs) {
    const double apart = result.apart(pair);
    if (apart > kNearest) continue;
    throw InputError(rig.cameras[pair.second].where,
                     fmt::format("stands where {} does, {} apart", rig.cameras[pair.first].name,
                                 format_quantity(apart, Dimension::length, 2)),
                     "pictures of its own, from another place");
  }
}

/// @throws InputError where the boards tell another length than the user
void require_length(const SecondLength& stated, const LengthCheck& length) {
  const double ratio = length.measured / length.stated;
  if (std::abs(length.errors_apart()) <= kWrongLength || std::abs(ratio - 1) <= kWrongScale) return;
  throw InputError(
      stated.where,
      fmt::format("is stated as {} and comes out as {} by the boards, {:.4f} times that and {:.0f} "
                  "errors apart",
                  format_quantity(length.stated, Dimension::length, 5),
                  format_quantity(length.measured, Dimension::length, 5), ratio,
                  std::abs(length.errors_apart())),
      fmt::format("boards as large as their files say (printed at 100 %, by a ruler), and the "
                  "length as it is: {:.2g} % and {:.0f} errors apart at most",
                  100 * kWrongScale, kWrongLength));
}

void warn_of_length(const RigFile& rig, RigCalibration& result) {
  if (!rig.second_length) {
    result.warnings.emplace_back(
        "no second known length (`second_length`): if the board was printed larger or smaller than "
        "it says, every measure is wrong by that, and nothing here can show it");
    return;
  }
  const LengthCheck& length = *result.length;
  if (std::abs(length.errors_apart()) < kDoubtfulLength) return;
  result.warnings.push_back(
      fmt::format("SCALE: the second length is stated as {} and comes out as {}, {:+.2f} %, {:.0f} "
                  "errors apart: "
                  "the board or the length is not what its file says",
                  format_quantity(length.stated, Dimension::length, 5),
                  format_quantity(length.measured, Dimension::length, 5),
                  100 * (length.measured / length.stated - 1), std::abs(length.errors_apart())));
}

void warn_of_pictures(RigCalibration& result) {
  for (const RigPicture& picture : result.pictures) {
    if (picture.left_out.empty()) continue;
    result.warnings.push_back(fmt::format("{} is left out: {}", picture.file, picture.left_out));
  }
}

}  // namespace

double RigCalibration::error(int camera, int number) const {
  const auto i = kCameraNumbers * camera + number;
  return std::sqrt(covariance.cameras(i, i));
}

double RigCalibration::apart(const EpipolarResidual& pair) const {
  return (bundle.cameras[pair.first].centre() - bundle.cameras[pair.second].centre()).norm();
}

RigCalibration calibrate_rig(const RigFile& rig, std::vector<RigPicture> pictures,
                             const RunContext& context) {
  constexpr int kSteps = 4;
  ProgressTask task(context.progress, "adjustment of the cameras", kSteps);
  const BundleOptions options{.warp = rig.warp, .threads = context.threads, .stop = context.stop};
  RigCalibration result;
  for (const RigCameraFile& camera : rig.cameras) result.names.push_back(camera.name);
  result.pictures = std::move(pictures);
  result.bundle = start_of_rig(rig, result.pictures, options);
  task.advance(1);
  adjust(result.bundle, options);
  correct_by_lenses(result);
  adjust(result.bundle, options);
  if (leave_out_bad_views(result)) adjust(result.bundle, options);
  task.advance(2);
  result.covariance = covariance_of(result.bundle, options);
  result.cameras = camera_residuals(result.bundle);
  require_tilts(rig, result);
  result.pairs = epipolar_residuals(result.bundle);
  require_places(rig, result);
  task.advance(3);
  result.held_out = held_out_boards(result.bundle, options);
  if (rig.second_length) {
    result.length =
        check_length(*rig.second_length, result.bundle, result.pictures, result.covariance);
    require_length(*rig.second_length, *result.length);
  }
  result.gravity = gravity_of(rig.gravity, result.bundle, result.pictures, result.covariance);
  warn_of_pictures(result);
  warn_of_contradictions(rig, result);
  warn_of_tilts(rig, result);
  warn_of_regions(rig, result);
  warn_of_length(rig, result);
  return result;
}

}  // namespace pliant
