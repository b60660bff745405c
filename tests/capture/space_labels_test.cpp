// Clips by labels that several cameras see, on pictures that are drawn.
#include "pliant/capture/space_labels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/drawn_label.h"
#include "capture/drawn_rig.h"
#include "io/input_error_of.h"

namespace pliant {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A white cord along an edge of the label, above it, that moves with it.
DrawnSurface cord_over(const Eigen::Vector2d& middle, const Eigen::Vector3d& moved) {
  const Eigen::Vector2d half(0.35e-3, 8e-3);
  DrawnSurface cord = flat_rectangle({middle - half, middle + half}, 2e-3,
                                     [](const Eigen::Vector2d&) { return 0.9; });
  const Eigen::Vector3d about(middle.x(), middle.y(), 0);
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.02, Eigen::Vector3d::UnitZ()).matrix();
  cord.positions = (turn * (cord.positions.colwise() - about)).colwise() + about;
  cord.positions.row(0).array() += test::kDrawnTag / 2 - 0.2e-3;
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

  /// Labels on two clips that move away by a millimetre a frame.
  std::vector<DrawnSurface> labels(int frame) const {
    const double way = 1e-3 * frame;
    return {test::drawn_label(3, left_, {-way, 0, 0}), test::drawn_label(4, right_, {way, 0, 0})};
  }

  DicFile dic() const {
    DicFile dic = rig_.dic();
    dic.clips = {labelled_clip("left", 3), labelled_clip("right", 4)};
    return dic;
  }

  std::vector<GreyPicture> pictures(int frame) const {
    std::vector<GreyPicture> pictures;
    for (int c = 0; c < std::ssize(rig_.cameras); ++c) pictures.push_back(rig_.picture(c, frame));
    return pictures;
  }

  std::vector<TagsByCode> tags(int frame) const {
    return detect_tags(pictures(frame), rig_.cameras, 1);
  }

  void expect_ways(SpaceLabels& labels, int frame) const {
    const LabelledMotions motions = labels.motions(tags(frame));
    EXPECT_EQ(motions.missing, "");
    const Eigen::Vector3d middle = rig_.to_rig() * Eigen::Vector3d(right_.x(), right_.y(), 0);
    EXPECT_NEAR((motions.clips.at(1)->apply(middle) - middle).norm(), 1e-3 * frame, 0.02e-3);
  }

  test::DrawnRig rig_;
  const Eigen::Vector2d left_{-6e-3, 0.015}, right_{0.036, 0.015};
};

TEST_F(SlowSpaceLabels, AreWarnedOfWhereACordCrossesThem) {
  for (const bool has_cord : {false, true}) {
    // From the second frame on it lies over the first.
    rig_.others = [&](int frame) {
      std::vector<DrawnSurface> surfaces = labels(frame);
      if (has_cord && frame > 0) surfaces.push_back(cord_over(left_, {-1e-3 * frame, 0, 0}));
      return surfaces;
    };
    const DicFile dic = this->dic();
    SpaceLabels labels(dic, pictures(0), tags(0));
    for (int frame = 1; frame < 4; ++frame) expect_ways(labels, frame);
    const std::vector<std::string> said = labels.warnings();
    EXPECT_EQ(said.empty(), !has_cord);
    EXPECT_THAT(said, testing::Each(AllOf(HasSubstr("the label 3 of the clip left"),
                                          HasSubstr("of 3 frames"))));
  }
}

// The other two tell where the clips are, since the picture moves across their lines of sight.
TEST_F(SlowSpaceLabels, TellTheCameraThatWasMovedMeanwhile) {
  rig_.others = [&](int frame) { return labels(frame); };
  const DicFile dic = this->dic();
  SpaceLabels labels(dic, pictures(0), tags(0));
  expect_ways(labels, 1);
  rig_.cameras[1].pose.rotation += Eigen::Vector3d(0.0012, 0.0016, 0);  // 4 pixels
  for (int frame = 2; frame < 4; ++frame) expect_ways(labels, frame);
  EXPECT_THAT(labels.warnings(), ElementsAre(AllOf(StartsWith("camera1 sees most labels elsewhere"),
                                                   HasSubstr("moved, refocused or stabilised"))));
}

TEST_F(SlowSpaceLabels, AreRefusedWhereACodeIsSeenTwice) {
  int twice_from = 1;
  rig_.others = [&](int frame) {
    std::vector<DrawnSurface> surfaces = labels(frame);
    if (frame >= twice_from) surfaces.push_back(test::drawn_label(3, {0.015, 0.042}));
    return surfaces;
  };
  const DicFile dic = this->dic();
  SpaceLabels labels(dic, pictures(0), tags(0));
  EXPECT_EQ(labels.motions(tags(1)).missing,
            "shows the label 3 of the clip left more than once to camera0");
  twice_from = 0;
  const InputError error = test::input_error_of([&] { SpaceLabels(dic, pictures(0), tags(0)); });
  EXPECT_THAT(error.what(), HasSubstr("shows the label 3 of the clip left more than once"));
}

TEST_F(SlowSpaceLabels, AreRefusedInAMirroredPicture) {
  rig_.others = [&](int frame) { return labels(frame); };
  const DicFile dic = this->dic();
  std::vector<GreyPicture> first = pictures(0);
  first[2] = first[2].rowwise().reverse().eval();
  const InputError error =
      test::input_error_of([&] { SpaceLabels(dic, first, detect_tags(first, rig_.cameras, 1)); });
  EXPECT_THAT(error.what(), HasSubstr("2/0: is mirrored"));
}

}  // namespace
}  // namespace pliant
