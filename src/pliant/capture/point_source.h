#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/run_context.h"
#include "pliant/capture/cord_line.h"
#include "pliant/capture/dic_file.h"
#include "pliant/capture/match_check.h"
#include "pliant/capture/region_misses.h"
#include "pliant/capture/spline_picture.h"
#include "pliant/geometry/pose.h"

namespace pliant {

/// How well cameras saw a frame.
struct SightQuality {
  double agreeing = 1;  ///< share of the points on which all cameras that see them agree
  /// Median by which cameras disagree, or by which labels miss the view of one (pixels a
  /// coordinate); nothing of one camera without labels.
  std::optional<double> miss;
  std::vector<double> share;  ///< of the patches of each camera: found, in agreement with others
  MatchQuality matches;
  std::string moved = {};  ///< what fixed tags say against one of its cameras; empty: nothing
  std::string doubt = {};  ///< what speaks against one of its pictures; likewise
};

/// Where a picture shows some points.
struct PointsInPicture {
  std::filesystem::path file;
  Eigen::Matrix2Xd pixels;  ///< one column a point; NaN of those that are not known or not shown
};

/// The points of a sheet that were seen in a frame: where they are at rest, and where by now.
struct PointFrame {
  Eigen::Matrix3Xd rest;   ///< m, one column a point
  Eigen::Matrix3Xd moved;  ///< m
  /// Standard deviations of `moved` along the axes (m), those of the apparatus among them; empty
  /// where the source does not know them.
  Eigen::Matrix3Xd deviations;
  /// Sides of the squares of the sample whose means the points are (m); 0 where that is not known.
  Eigen::VectorXd patches;
  int lost = 0;  ///< points that were not found
  /// How each clip has moved since the first frame, where labels on it tell; empty without labels.
  std::vector<std::optional<Pose>> clips;
  /// Where the cord of each cell is, nothing before it was pointed at; empty without cells.
  std::vector<std::optional<CordLine>> cords = {};
  std::optional<SightQuality> quality = {};  ///< where there are pictures
  double nearer = 0;     ///< by what share of its distance a clip has come, see PlaneView
  std::string left_out;  ///< why the frame cannot be used; it has no points then

  int count() const { return static_cast<int>(rest.cols()); }
};

/// Of a frame: fewer tell nothing.
inline constexpr int kFewestPoints = 10;

/// Where the points of each frame come from. The first frame is at rest.
class PointSource {
 public:
  virtual ~PointSource() = default;
  /// Whether points have three coordinates.
  virtual bool in_space() const = 0;
  /// Side of the squares of the sample whose means the points are at rest (m); 0 where that is not
  /// known.
  virtual double patch() const { return 0; }
  /// @param frame  that of the call before, or the one after it
  /// @throws InputError
  virtual PointFrame read(int frame) = 0;
  /// In the axes of the points (m/s^2), where the source knows it.
  virtual std::optional<Eigen::Vector3d> gravity() const { return std::nullopt; }
  /// Names of the cameras, where there are pictures.
  virtual std::vector<std::string> cameras() const { return {}; }
  /// What is where in the pictures of the frame that was read last, by camera.
  /// @param points  3 x points, in the axes of the points; NaN where they are not known
  virtual std::vector<PointsInPicture> in_pictures(const Eigen::Matrix3Xd& /*points*/) const {
    return {};
  }
  /// Of each of several cameras, over all frames.
  virtual std::vector<RegionMisses> misses() const { return {}; }
  /// What is worth telling of how the points were found, a sentence each.
  virtual std::vector<std::string> notes() const { return {}; }
  /// What speaks against the points.
  virtual std::vector<std::string> warnings() const { return {}; }
};

/// Reads a picture as brightness, 0 to 1.
using ReadPicture = std::function<GreyPicture(const std::filesystem::path&)>;

/// The tables of a dic/1 file, or the points that are tracked in its pictures.
/// @param dic  outlives the source
/// @throws InputError
std::unique_ptr<PointSource> point_source(const DicFile& dic, const ReadPicture& read_picture,
                                          const RunContext& context);

}  // namespace pliant
