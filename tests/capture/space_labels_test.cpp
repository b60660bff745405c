// Clips by labels that several cameras see, on pictures that are drawn.
#include "pliant/capture/space_labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/drawn_rig.h"

namespace pliant {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kTag = 8e-3;  // side of a label's black square (m)

/// A label of that middle on white paper, moved.
DrawnSurface label(int code, const Eigen::Vector2d& middle, const Eigen::Vector3d& moved) {
  const Eigen::Vector2d half = Eigen::Vector2d::Constant(kTag / 2);
  const Eigen::Vector2d margin = Eigen::Vector2d::Constant(2e-3);
  DrawnSurface paper = flat_rectangle(
      {middle - half - margin, middle + half + margin}, 0.2e-3,
      [cells = tag_cells(code), from = Eigen::Vector2d(middle - half)](const Eigen::Vector2d& at) {
        const Eigen::Vector2d place = (at - from) / kTag;
        if (place.minCoeff() < 0 || place.maxCoeff() >= 1) return 0.9;
        return 0.1 + 0.8 * static_cast<double>(cells(static_cast<int>((1 - place.y()) * 8),
                                                     static_cast<int>(place.x() * 8)));
      });
  paper.positions.colwise() += moved;
  return paper;
}

/// A white cord along an edge of the label, above it, that moves with it.
DrawnSurface cord_over(const Eigen::Vector2d& middle, const Eigen::Vector3d& moved) {
  const Eigen::Vector2d half(0.35e-3, 8e-3);
  DrawnSurface cord = flat_rectangle({middle - half, middle + half}, 2e-3,
                                     [](const Eigen::Vector2d&) { return 0.9; });
  const Eigen::Vector3d about(middle.x(), middle.y(), 0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ()).matrix();
  cord.positions = (turn * (cord.positions.colwise() - about)).colwise() + about;
  cord.positions.row(0).array() += kTag / 2 - 0.2e-3;
  cord.positions.colwise() += moved;
  return cord;
}

DicClip labelled_clip(const char* name, int code) {
  DicClip clip;
  clip.name = name;
  clip.motion = ClipMotion::labels;
  clip.labels = {code};
  return clip;
}

class SlowSpaceLabels : public testing::Test {
 protected:
  SlowSpaceLabels() : rig_(3, 320, 300, 0.03) {
    rig_.frames.assign(4,
                       [](const Eigen::Vector2d& p) { return Eigen::Vector3d(p.x(), p.y(), 0); });
    rig_.noise = {0.01, 0, 8};
  }

  /// Labels on two clips that move away by a millimetre a frame; from the second frame on a cord
  /// lies over the first, where there is one.
  std::vector<std::string> warnings(bool has_cord) {
    rig_.others = [&](int frame) {
      const double way = 1e-3 * frame;
      std::vector<DrawnSurface> surfaces{label(3, left_, {-way, 0, 0}),
                                         label(4, right_, {way, 0, 0})};
      if (has_cord && frame > 0) surfaces.push_back(cord_over(left_, {-way, 0, 0}));
      return surfaces;
    };
    DicFile dic = rig_.dic();
    dic.clips = {labelled_clip("left", 3), labelled_clip("right", 4)};
    SpaceLabels labels(dic, pictures(0), 1);
    for (int frame = 1; frame < 4; ++frame) {
      const LabelledMotions motions = labels.motions(pictures(frame));
      EXPECT_EQ(motions.missing, "");
      const Eigen::Vector3d middle = rig_.to_rig() * Eigen::Vector3d(right_.x(), right_.y(), 0);
      EXPECT_NEAR((motions.clips.at(1)->apply(middle) - middle).norm(), 1e-3 * frame, 0.02e-3);
    }
    return labels.warnings();
  }

 private:
  std::vector<GreyPicture> pictures(int frame) const {
    std::vector<GreyPicture> pictures;
    for (int c = 0; c < std::ssize(rig_.cameras); ++c) pictures.push_back(rig_.picture(c, frame));
    return pictures;
  }

  test::DrawnRig rig_;
  const Eigen::Vector2d left_{-6e-3, 0.015}, right_{0.036, 0.015};
};

TEST_F(SlowSpaceLabels, AreWarnedOfWhereACordCrossesThem) {
  EXPECT_THAT(warnings(/*has_cord=*/false), IsEmpty());
  const std::vector<std::string> said = warnings(/*has_cord=*/true);
  ASSERT_FALSE(said.empty());
  EXPECT_THAT(said, testing::Each(AllOf(HasSubstr("the label 3 of the clip left"),
                                        HasSubstr("of 3 frames"))));
}

}  // namespace
}  // namespace pliant
