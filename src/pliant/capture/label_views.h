#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "pliant/capture/dic_file.h"
#include "pliant/capture/plane_fit.h"
#include "pliant/capture/plane_view.h"
#include "pliant/capture/spline_picture.h"

namespace pliant {

/// What a picture shows of labels.
struct SeenLabels {
  std::optional<PlaneView> view;
  std::string missing;  ///< what it lacks where there is no view, e.g. "shows no label 3"
};

/// Views of a flat sample whose clips carry labels (`pliant pattern clips`).
///
/// The labels lie in the plane of the sample and are of known size: a homography from the plane to
/// the picture and the place of each label in the plane are fitted to their corners. Labels far
/// from each other tell by their sizes how the plane is tilted. The first picture tells where the
/// labels are, and so where the sample is; after it a clip is rigid, and moves in the plane. The
/// first clip with labels stays where it is: the camera may move. A clip that comes nearer to the
/// camera tilts the plane, and stretches nothing.
///
/// Plane coordinates are those of the sample: u and v from its corner, which lies at the edges of
/// the clips and half way between the labels across, or where the file says.
class LabelViews {
 public:
  /// @param dic    outlives the views; names labels
  /// @param first  picture, brightness 0 to 1
  /// @throws InputError where it does not show each label once
  LabelViews(const DicFile& dic, const GreyPicture& first);

  const PlaneView& first() const { return first_; }
  /// From edge to edge of the clips at opposite sides, along weft and warp, as the labels tell it
  /// (m); nothing where one side has no labels.
  const std::array<std::optional<double>, 2>& lengths() const { return lengths_; }

  /// The view of a picture that shows a label of each clip that has some, and none twice.
  SeenLabels of(const GreyPicture& picture) const;

 private:
  struct Label {
    std::size_t clip;
    int code;
    Eigen::Matrix<double, 2, 4> corners;  // at rest (m)
  };

  void place_sample(const PlaneFit& fit);

  const DicFile& dic_;
  Lens lens_;
  std::vector<Label> labels_;
  std::vector<std::size_t> carriers_;  // the clips with labels
  PlaneView first_;
  std::array<std::optional<double>, 2> lengths_;
};

}  // namespace pliant
