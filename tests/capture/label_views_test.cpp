// Labels on jaws tell a single camera where it looks, and how the jaws move.

#include "pliant/capture/label_views.h"

#include <cmath>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/dic_import.h"
#include "pliant/capture/dic_session.h"
#include "pliant/capture/frame_doubts.h"
#include "pliant/capture/local_motion.h"

#include "capture/labelled_camera.h"
#include "capture/labelled_frame.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::LabelledFrame;
using test::LabelledPull;
using test::TemporaryFolder;
using ::testing::HasSubstr;

/// Pictures of pulls, written as empty files that the reader knows by their numbers.
class SlowLabelledCamera : public ::testing::Test {
 protected:
  DicFile describe(const std::vector<LabelledPull>& pulls, const std::string& codes = "[1]",
                   const std::string& test = "stretch-warp", const std::string& more = "") {
    pulls_ = pulls;
    for (std::size_t f = 0; f < pulls.size(); ++f) folder_.write(fmt::format("p/{:03}.png", f), "");
    return read_dic(folder_.write(
        "d.yaml",
        "pliant: dic/1\ntest: " + test +
            "\npictures: p/*.png\n"
            "labels: {tag: 15 mm, edge: 15 mm}\n"
            "sample: {width: 30 mm, height: 90 mm, mass: 1 g}\n"
            "clips: [{name: lower, side: bottom, labels: [0]}, {name: upper, side: top, labels: " +
            codes + "}]\n" + more));
  }

  ReadPicture reader() const {
    return [this](const std::filesystem::path& file) {
      const auto frame = static_cast<std::size_t>(std::stoi(file.stem().string()));
      return pulls_[frame].picture(frame);
    };
  }

  TemporaryFolder folder_;
  std::vector<LabelledPull> pulls_;
};

TEST_F(SlowLabelledCamera, KnowsThePlaneItLooksAt) {
  const LabelledPull pull{.turned = 0.05, .tilted = 0.1};
  const DicFile dic = describe({pull});
  const LabelViews views(dic, pull.picture(0));
  EXPECT_NEAR(*views.lengths()[1], LabelledPull::kHeight, 3e-5);
  EXPECT_FALSE(views.lengths()[0]);
  Eigen::Matrix<double, 2, 4> corners;
  corners << 0, 0.03, 0.03, 0, 0, 0, 0.09, 0.09;
  const Eigen::Matrix2Xd seen =
      (pull.to_picture() * corners.colwise().homogeneous()).colwise().hnormalized();
  EXPECT_LT((views.first().on_plane(seen) - corners).cwiseAbs().maxCoeff(), 5e-5);
  EXPECT_LT((views.first().in_picture(corners) - seen).cwiseAbs().maxCoeff(), 0.5);
  EXPECT_LT(views.first().miss, 0.1);
}

TEST_F(SlowLabelledCamera, SeesAJawTurnAndComeNearer) {
  const LabelledPull rest, now{.strain = 0.05, .nearer = 1e-3, .jaw_turned = 0.02};
  const DicFile dic = describe({rest, now});
  const LabelViews views(dic, rest.picture(0));
  const PlaneView view = *views.of(now.picture(1)).view;
  const Eigen::Vector3d way =
      view.clips[1]->apply({0.015, 0.09, 0}) - Eigen::Vector3d(0.015, 0.09, 0);
  EXPECT_NEAR(way.y(), 0.05 * 0.09, 1e-5);
  EXPECT_NEAR(way.x(), 0, 1e-5);
  EXPECT_NEAR(2 * std::asin(view.clips[1]->rotation.z()), 0.02, 1e-3);
  EXPECT_NEAR(view.nearer, 0.002, 3e-4);
}

// A shutter that reads its rows in 30 ms, and a jaw that moves by 20 mm/s. The upper rows are read
// first: the label on the jaw is seen less high than it is, as if it were further away.
TEST_F(SlowLabelledCamera, SeesAJawWithinWhatItMovesWhileRowsAreRead) {
  constexpr double kMoved = 0.6e-3;
  const LabelledPull rest, now{.rolled = kMoved / LabelledPull::kHeight};
  const DicFile dic = describe({rest, now});
  const PlaneView view = *LabelViews(dic, rest.picture(0)).of(now.picture(1)).view;
  const Eigen::Vector3d middle(0.015, 0.09, 0);
  const double way = (view.clips[1]->apply(middle) - middle).y();
  fmt::print("the jaw is seen {:.3f} mm further, by labels that miss by {:.3f} pixels\n", 1e3 * way,
             view.miss);
  EXPECT_GT(way, 0.1e-3);
  EXPECT_LT(way, kMoved);
  EXPECT_LT(view.miss, 0.1) << "it cannot be told from a label as it is at rest";
}

TEST_F(SlowLabelledCamera, IsNotDeceivedByAJawThatComesNearer) {
  const std::vector<LabelledPull> pulls{
      {},
      {.strain = 0.05, .slip = 1e-4, .nearer = 1e-3},
      {.strain = 0.05, .slip = 1e-4, .turned = 0.03, .tilted = 0.05},
      {.hidden = true},
      {.strain = 0.02, .nearer = -1e-3}};
  const DicFile dic = describe(pulls);
  const DicSession made = make_dic_session(dic, reader());
  ASSERT_EQ(made.left_out.size(), 1u);
  EXPECT_EQ(made.left_out[0].frame, 3);
  EXPECT_THAT(made.left_out[0].why, HasSubstr("no label of the clip lower"));
  EXPECT_EQ(made.session.frame_count(), 4);
  ASSERT_EQ(made.slips.size(), 2u);
  for (const std::size_t f : {0U, 1U, 2U, 4U}) {
    fmt::print("strain {:.4f} % ({}), slip {:.4f} and {:.4f} mm ({}), nearer by {:.3f} %\n",
               100 * made.middle->strain[f], 100 * pulls[f].strain, 1e3 * made.slips[0].slip[f],
               1e3 * made.slips[1].slip[f], 1e3 * pulls[f].slip, 100 * made.nearer[f]);
    EXPECT_NEAR(made.middle->strain[f], pulls[f].strain, 5e-4);
    EXPECT_NEAR(made.middle->lateral_strain[f], pulls[f].narrowing(), 5e-4);
    EXPECT_NEAR(made.slips[0].slip[f], 0, 2e-5);
    EXPECT_NEAR(made.slips[1].slip[f], pulls[f].slip, 2e-5);
  }
  EXPECT_NEAR(made.nearer[1], 0.002, 3e-4);
}

// The jaw moves by 4.5 mm through a picture whose lens bends lengths by 1 % and more.
TEST_F(SlowLabelledCamera, SeesThroughALensThatIsKnown) {
  const std::vector<LabelledPull> pulls{{.k1 = -0.3}, {.strain = 0.05, .nearer = 1e-3, .k1 = -0.3}};
  DicFile dic = describe(pulls);
  const DicSession bent = make_dic_session(dic, reader());
  dic.lens = Lens(pulls[0].camera());
  const DicSession made = make_dic_session(dic, reader());
  fmt::print("strain {:.4f} % of 5; {:.4f} % where the lens is taken for a pinhole\n",
             100 * made.middle->strain[1], 100 * bent.middle->strain[1]);
  EXPECT_NEAR(made.middle->strain[1], 0.05, 5e-4);
  EXPECT_GT(std::abs(bent.middle->strain[1] - 0.05), 1e-3);
}

TEST_F(SlowLabelledCamera, RefusesAFirstPictureWithoutALabel) {
  const DicFile dic = describe({{}}, "[8]");
  const InputError error = test::input_error_of([&] { make_dic_session(dic, reader()); });
  EXPECT_THAT(error.what(),
              HasSubstr("shows the label 8 of the clip upper not at all (labels found: 0, 1)"));
}

/// The upper label once more, in front of the cloth.
GreyPicture with_label_again(GreyPicture picture) {
  constexpr int kSide = 127, kColumn = 117;  // with the white around it
  picture.block(450, kColumn, kSide, kSide) = picture.block(57, kColumn, kSide, kSide).eval();
  return picture;
}

TEST_F(SlowLabelledCamera, RefusesALabelThatIsSeenTwice) {
  const LabelledPull rest;
  const DicFile dic = describe({rest, rest});
  const GreyPicture once = rest.picture(0), twice = with_label_again(once);
  const InputError error = test::input_error_of([&] { LabelViews(dic, twice); });
  EXPECT_THAT(
      error.what(),
      HasSubstr("shows the label 1 of the clip upper more than once (labels found: 0, 1, 1)"));
  EXPECT_EQ(LabelViews(dic, once).of(twice).missing, "shows the label 1 more than once");
}

TEST_F(SlowLabelledCamera, RefusesAMirroredPicture) {
  const LabelledPull rest;
  const DicFile dic = describe({rest});
  const InputError error =
      test::input_error_of([&] { LabelViews(dic, rest.picture(0).rowwise().reverse()); });
  EXPECT_THAT(error.what(), HasSubstr("000.png: is mirrored: its labels can be read from behind"));
}

/// Stretches and shear in the middle of a sheet: C of F^T F in its rest axes.
Eigen::Matrix2d stretch_of_middle(const Session& session, int frame) {
  std::vector<int> middle;
  const Eigen::Vector3d size(session.sample.width, session.sample.height, 0);
  for (int v = 0; v < session.rest.vertex_count(); ++v) {
    const Eigen::Vector3d off = session.rest.positions.col(v) - size / 2;
    if (off.norm() < session.sample.width / 8) middle.push_back(v);
  }
  const auto motion =
      affine_motion(session.rest.positions.topRows<2>()(Eigen::all, middle),
                    session.frames[static_cast<std::size_t>(frame)].positions(Eigen::all, middle));
  return motion->slope.transpose() * motion->slope;
}

// It narrows as yarns do that turn and keep their length, nearly.
TEST_F(SlowLabelledCamera, SeesABiasStripShearItsYarns) {
  folder_.write("log.csv", "force_N\n0\n4\n9\n");
  const DicFile dic =
      describe({{}, {.strain = 0.03, .narrows = 0.9}, {.strain = 0.06, .narrows = 0.9}}, "[1]",
               "bias-extension", "forces: {data: log.csv, on: upper}\n");
  const DicImport imported = import_dic(dic.file, reader(), {});
  const auto write = [&](const std::string& file, const std::string& content) {
    folder_.write("out/" + file, content);
  };
  for (const auto& [file, content] : imported.study.files) write(file, content);
  make_session_files(imported, write);
  EXPECT_THAT(test::content_of(folder_.path() / "out/strip.yaml"), HasSubstr("direction: bias"));
  ASSERT_TRUE(imported.made.middle);
  EXPECT_NEAR(imported.made.middle->strain[2], 0.06, 5e-4);
  EXPECT_NEAR(imported.made.middle->lateral_strain[2], -0.054, 5e-4);
  const Session session = read_session(folder_.path() / "out" / kDicSessionFolder);
  EXPECT_NEAR(session.sample.width, 0.12 / std::sqrt(2.0), 1e-5);
  const Eigen::Matrix2d stretch = stretch_of_middle(session, session.frame_count() - 1);
  const double along = 1.06 * 1.06, across = 0.946 * 0.946;
  EXPECT_NEAR(stretch(0, 0), (along + across) / 2, 2e-3);
  EXPECT_NEAR(stretch(1, 1), (along + across) / 2, 2e-3);
  EXPECT_NEAR(stretch(0, 1), (along - across) / 2, 2e-3);
}

TEST(SlowLabelledFrame, SeesYarnsTurnAndKeepTheirLength) {
  const std::vector<LabelledFrame> frames{{}, {.angle = 0.05}, {.angle = 0.1}};
  const TemporaryFolder folder;
  for (std::size_t f = 0; f < frames.size(); ++f) folder.write(fmt::format("p/{}.png", f), "");
  const DicFile dic = read_dic(folder.write(
      "d.yaml",
      "pliant: dic/1\ntest: shear\npictures: p/*.png\nlabels: {tag: 12 mm, edge: 12 mm}\n"
      "sample: {width: 60 mm, height: 60 mm, mass: 1 g}\n"
      "clips:\n  - {name: bottom, side: bottom, labels: [0]}\n"
      "  - {name: top, side: top, labels: [1]}\n  - {name: left, side: left, labels: [2]}\n"
      "  - {name: right, side: right, labels: [3]}\n"));
  const DicSession made = make_dic_session(dic, [&](const std::filesystem::path& file) {
    const auto frame = static_cast<std::size_t>(std::stoi(file.stem().string()));
    return frames[frame].picture(frame);
  });
  ASSERT_EQ(made.session.frame_count(), 3);
  const Eigen::Matrix2d stretch = stretch_of_middle(made.session, 2);
  EXPECT_NEAR(stretch(0, 1), std::sin(0.1), 1e-3);
  EXPECT_NEAR(stretch(0, 0), 1, 1e-3);
  EXPECT_NEAR(stretch(1, 1), 1, 1e-3);
  // The first bar stays where it is; the others go where yarns of their length lead them.
  const std::vector<Pose>& bars = made.session.frames[2].poses;
  const double height = LabelledFrame::kSide * std::cos(0.1);
  const double way = LabelledFrame::kSide * std::sin(0.1);
  const Eigen::Vector3d top = bars[1].apply({0.03, 0.06, 0});
  EXPECT_LT((top - Eigen::Vector3d(0.03 + way, height, 0)).norm(), 0.05e-3);
  for (const std::size_t bar : {2U, 3U}) {
    EXPECT_NEAR(2 * std::asin(bars[bar].rotation.z()), -0.1, 1e-3);
  }
  EXPECT_FALSE(made.middle) << "it is of two bars that pull";
}

// A camera that stands straight in front, to which labels tell nothing but that they stand still.
TEST_F(SlowLabelledCamera, IsNamedWhereFixedTagsSeeItMove) {
  describe({{}, {.strain = 0.01}, {.strain = 0.01, .turned = 0.002}});
  const DicFile dic = read_dic(folder_.write(
      "fixed.yaml",
      "pliant: dic/1\ntest: stretch-warp\npictures: p/*.png\nscale: 0.15 mm\norigin: [80, 820]\n"
      "sample: {width: 30 mm, height: 90 mm, mass: 1 g}\n"
      "clips: [{name: lower, side: bottom}, {name: upper, side: top}]\nfixed: [0]\n"));
  const std::vector<FrameDoubt> doubts = frame_doubts(make_dic_session(dic, reader()));
  ASSERT_EQ(doubts.size(), 1u);
  EXPECT_EQ(doubts[0].frame, 2);
  // The farthest corner is 453 pixels from the middle of the picture.
  EXPECT_THAT(doubts[0].why, HasSubstr("its picture shows the fixed tag 0 0.9 pixels off"));
}

TEST(LabelFile, TellsWhichLabelsWerePrinted) {
  const TemporaryFolder folder;
  folder.write("p/0.png", "");
  folder.write("labels.yaml",
               "pliant: pattern/1\nclips: {tag: 15 mm, edge: 12 mm, codes: [0, 1]}\n");
  const auto file = [&](int code) {
    return folder.write("d.yaml", fmt::format("pliant: dic/1\ntest: shear\npictures: p/*.png\n"
                                              "labels: labels.yaml\n"
                                              "sample: {{width: 30 mm, height: 90 mm, mass: 1 g}}\n"
                                              "clips: [{{name: a, side: left, labels: [0]}}, "
                                              "{{name: b, side: right, labels: [{}]}}]\n",
                                              code));
  };
  const DicFile dic = read_dic(file(1));
  EXPECT_EQ(dic.labels->edge, 0.012);
  EXPECT_EQ(dic.clips[1].motion, ClipMotion::labels);
  const InputError error = test::input_error_of([&] { read_dic(file(2)); });
  EXPECT_THAT(error.what(), HasSubstr("does not have the label 2 of the clip b"));
}

}  // namespace
}  // namespace pliant
