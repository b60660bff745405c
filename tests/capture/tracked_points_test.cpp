#include "pliant/capture/tracked_points.h"

#include <cmath>
#include <map>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/capture/dic_import.h"

#include "capture/texture.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::TemporaryFolder;
using test::Texture;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;

constexpr int kColumns = 240, kRows = 320;
constexpr double kPixel = 0.1e-3;

/// Pictures of a camera that are made when they are asked for.
class Camera {
 public:
  /// Where a place of the picture at rest is in a frame (pixels), told backwards.
  using Back = std::function<Eigen::Vector2d(const Eigen::Vector2d&)>;

  explicit Camera(double noise = 0) : noise_(noise) {}

  void add(const Back& back) { backs_.push_back(back); }
  void add_picture(GreyPicture picture) {
    made_[static_cast<int>(backs_.size())] = std::move(picture);
    backs_.emplace_back();
  }

  /// Writes empty files, which the reader knows by their numbers, and what describes them.
  DicFile describe(const TemporaryFolder& folder, const std::string& more = "") const {
    for (std::size_t f = 0; f < backs_.size(); ++f) folder.write(fmt::format("p/{:03}.png", f), "");
    return read_dic(folder.write("d.yaml",
                                 "pliant: dic/1\ntest: stretch-warp\npictures: p/*.png\n"
                                 "scale: 0.1 mm\norigin: [20, 300]\n"
                                 "sample: {width: 20 mm, height: 28 mm, mass: 1 g}\n"
                                 "clips: [{name: a, side: bottom}, {name: b, side: top}]\n" +
                                     more));
  }

  ReadPicture reader() const {
    return [this](const std::filesystem::path& file) {
      const int frame = std::stoi(file.stem().string());
      if (const auto made = made_.find(frame); made != made_.end()) return made->second;
      GreyPicture picture =
          texture_.picture(kColumns, kRows, backs_[static_cast<std::size_t>(frame)]);
      RandomStream random(static_cast<std::uint64_t>(frame));
      test::add_noise(picture, noise_, random);
      return picture;
    };
  }

 private:
  Texture texture_{9};
  double noise_;
  std::vector<Back> backs_;
  std::map<int, GreyPicture> made_;
};

Eigen::Vector2d same(const Eigen::Vector2d& place) { return place; }

/// A stretch of rows about the bottom of the sample, told backwards.
Camera::Back stretched(double by) {
  return [by](const Eigen::Vector2d& place) -> Eigen::Vector2d {
    return {place.x(), 300 - (300 - place.y()) / (1 + by)};
  };
}

/// Largest error of the points of a frame (pixels).
double largest_error(const PointFrame& frame, double by) {
  double largest = 0;
  for (int i = 0; i < frame.count(); ++i) {
    const Eigen::Vector2d rest = frame.rest.col(i).head<2>() / kPixel;
    const Eigen::Vector2d expected(rest.x(), 300 - (1 + by) * (300 - rest.y()));
    largest = std::max(largest, (frame.moved.col(i).head<2>() / kPixel - expected).norm());
  }
  return largest;
}

TEST(TrackedPoints, FollowAStretchFromFrameToFrame) {
  Camera camera;
  camera.add(same);
  for (int f = 1; f <= 3; ++f) camera.add(stretched(0.02 * f));
  const TemporaryFolder folder;
  const DicFile dic = camera.describe(folder);
  TrackedPoints points(dic, camera.reader(), {});
  for (int f = 0; f < 4; ++f) {
    const PointFrame frame = points.read(f);
    EXPECT_EQ(frame.count() + frame.lost, 19 * 27) << f;
    // A few at the upper edge leave the picture.
    EXPECT_LT(frame.lost, 3 * 19) << f;
    EXPECT_LT(largest_error(frame, 0.02 * f), 0.02) << f;
  }
}

TEST(SlowTrackedPoints, ComeBackToWhereTheyWere) {
  Camera camera(2);
  camera.add(same);
  for (int f = 1; f <= 6; ++f) camera.add(stretched(f <= 3 ? 0.02 * f : 0.02 * (6 - f)));
  const TemporaryFolder folder;
  const DicFile dic = camera.describe(folder);
  TrackedPoints points(dic, camera.reader(), {});
  double sum = 0;
  for (int f = 0; f <= 6; ++f) {
    const PointFrame frame = points.read(f);
    if (f == 6) sum = (frame.moved - frame.rest).squaredNorm() / frame.count() / 2;
  }
  EXPECT_LT(std::sqrt(sum) / kPixel, 0.02);  // the noise of one match
}

// The sample jumps by 60 pixels between two pictures, out of the picture in part, and back.
TEST(TrackedPoints, AreFoundAgainAfterAJump) {
  Camera camera;
  const Eigen::Vector2d jump(12, -58);
  camera.add(same);
  camera.add([&](const Eigen::Vector2d& place) -> Eigen::Vector2d { return place - jump; });
  camera.add(same);
  const TemporaryFolder folder;
  const DicFile dic = camera.describe(folder);
  TrackedPoints points(dic, camera.reader(), {});
  const int all = points.read(0).count();
  const PointFrame frame = points.read(1);
  EXPECT_GT(frame.count(), 18 * 20);  // the upper fifth has left the picture
  EXPECT_LT(frame.count(), all - 19 * 3);
  for (int i = 0; i < frame.count(); ++i) {
    const Eigen::Vector3d by = (frame.moved.col(i) - frame.rest.col(i)) / kPixel;
    EXPECT_LT((by.head<2>() - jump).norm(), 0.02);
  }
  const PointFrame back = points.read(2);
  EXPECT_EQ(back.count(), all);
  EXPECT_LT(largest_error(back, 0), 0.02);
}

// A hand before the sample hides a part of it for one picture.
TEST(TrackedPoints, AreLostBehindSomethingAndFoundAgain) {
  Camera camera;
  camera.add(same);
  GreyPicture hidden = Texture(9).picture(kColumns, kRows, stretched(0.02));
  hidden.block(100, 60, 80, 90) = Texture(33).picture(90, 80, same);
  camera.add_picture(hidden);
  camera.add(stretched(0.03));
  const TemporaryFolder folder;
  const DicFile dic = camera.describe(folder);
  TrackedPoints points(dic, camera.reader(), {});
  EXPECT_EQ(points.read(0).lost, 0);
  const PointFrame behind = points.read(1);
  EXPECT_GT(behind.lost, 50);
  EXPECT_LT(behind.lost, 150);  // some 110 touch it, 18 have left the picture
  EXPECT_LT(largest_error(behind, 0.02), 0.1);
  const PointFrame again = points.read(2);
  EXPECT_LT(again.lost, 25);
  EXPECT_LT(largest_error(again, 0.03), 0.02);
}

// It shines through, little to much, and shows another way than the cloth goes.
TEST(TrackedPoints, AreNotMisledWhereSomethingShinesOnTheSample) {
  const GreyPicture shine = Texture(33).picture(90, 80, same);
  for (const float share : {0.3F, 0.5F, 0.8F}) {
    Camera camera(2);
    camera.add(same);
    GreyPicture picture = Texture(9).picture(kColumns, kRows, stretched(0.02));
    picture.block(100, 60, 80, 90) *= 1 - share;
    picture.block(100, 60, 80, 90) += share * shine;
    RandomStream random(1);
    test::add_noise(picture, 2, random);
    camera.add_picture(picture);
    const TemporaryFolder folder;
    const DicFile dic = camera.describe(folder);
    TrackedPoints points(dic, camera.reader(), {});
    const PointFrame frame = points.read(1);
    EXPECT_GT(frame.lost, 30) << share;  // some 40 lie wholly within
    EXPECT_GT(frame.count(), 300) << share;
    EXPECT_LT(largest_error(frame, 0.02), 0.3) << share;
  }
}

GreyPicture blank() { return GreyPicture::Constant(kRows, kColumns, 90); }

TEST(TrackedPoints, AreFoundAgainAfterThePictureShowedNone) {
  Camera camera;
  camera.add(same);
  camera.add_picture(blank());
  camera.add(stretched(0.02));
  const TemporaryFolder folder;
  const DicFile dic = camera.describe(folder);
  TrackedPoints points(dic, camera.reader(), {});
  EXPECT_THAT(points.read(1).left_out, HasSubstr("hardly a square"));
  const PointFrame again = points.read(2);
  EXPECT_LT(again.lost, 25);
  EXPECT_LT(largest_error(again, 0.02), 0.02);
}

/// Threads seven pixels apart, which have moved.
GreyPicture weave(const Eigen::Vector2d& by, std::uint64_t seed) {
  GreyPicture picture = test::drawn(
      kColumns, kRows, [&](const Eigen::Vector2d& place) { return test::weave_at(place - by, 7); });
  RandomStream random(seed);
  test::add_noise(picture, 2, random);
  return picture;
}

TEST(TrackedPoints, OfAWeaveAreFollowedInSmallSteps) {
  Camera camera;
  for (int f = 0; f < 5; ++f) camera.add_picture(weave(f * Eigen::Vector2d(2, -1), f + 1));
  const TemporaryFolder folder;
  const DicFile dic = camera.describe(folder);
  TrackedPoints points(dic, camera.reader(), {});
  for (int f = 1; f < 5; ++f) {
    const PointFrame frame = points.read(f);
    EXPECT_GT(frame.count(), 18 * 26) << f;
    const Eigen::Matrix3Xd by = (frame.moved - frame.rest) / kPixel;
    const Eigen::Vector3d expected = f * Eigen::Vector3d(2, -1, 0);
    EXPECT_LT((by.colwise() - expected).colwise().norm().maxCoeff(), 0.1) << f;
  }
}

// A second place is as much like each square: none is guessed.
TEST(TrackedPoints, OfAWeaveAreNotFoundAgain) {
  Camera camera;
  camera.add_picture(weave({0, 0}, 1));
  camera.add_picture(weave({2, -1}, 2));
  camera.add_picture(blank());
  camera.add_picture(weave({3, -2}, 3));
  const TemporaryFolder folder;
  camera.describe(folder);
  const DicImport made = import_dic(folder.path() / "d.yaml", camera.reader(), {});
  EXPECT_THAT(made.study.warnings, Contains(HasSubstr("the cloth's own pattern repeats")));
  EXPECT_THAT(made.study.notes,
              Contains(AllOf(HasSubstr("2 frames are left out: frame 2 shows hardly a square"),
                             HasSubstr("frame 3 shows hardly a square"))));
}

TEST(TrackedPoints, AreTheSameOnAnyNumberOfThreads) {
  Camera camera(1);
  camera.add(same);
  camera.add(stretched(0.04));
  const TemporaryFolder folder;
  const DicFile dic = camera.describe(folder);
  RunContext two;
  two.threads = 2;
  TrackedPoints alone(dic, camera.reader(), {}), together(dic, camera.reader(), two);
  EXPECT_EQ(alone.read(1).moved, together.read(1).moved);
}

std::string refused(const Camera& camera, const std::string& more = "") {
  const TemporaryFolder folder;
  return test::input_error_of([&] {
           const DicFile dic = camera.describe(folder, more);
           TrackedPoints points(dic, camera.reader(), {});
           for (int f = 0; f < dic.frame_count(); ++f) points.read(f);
         })
      .what();
}

TEST(TrackedPoints, RefuseASampleWithoutTexture) {
  Camera camera;
  camera.add_picture(blank());
  EXPECT_THAT(refused(camera), HasSubstr("have no texture to be found again"));
}

TEST(TrackedPoints, RefuseASampleBeyondThePicture) {
  Camera camera;
  camera.add(same);
  EXPECT_THAT(refused(camera, "weft: -x\n"), HasSubstr("a sample within the first picture"));
}

TEST(TrackedPoints, RefusePicturesOfAnotherSize) {
  Camera camera;
  camera.add(same);
  camera.add_picture(GreyPicture::Constant(kRows, kColumns - 2, 90));
  EXPECT_THAT(refused(camera), HasSubstr("is 238 x 320 pixels, and the first picture 240 x 320"));
}

TEST(TrackedPoints, RefuseAnEvenPatch) {
  const TemporaryFolder folder;
  folder.write("p/0.png", "");
  const auto file = folder.write("d.yaml",
                                 "pliant: dic/1\ntest: t\npictures: {files: p/*.png, patch: 20}\n"
                                 "sample: {width: 1 mm, height: 1 mm, mass: 1 g}\n");
  EXPECT_THAT(test::input_error_of([&] { read_dic(file); }).what(), HasSubstr("patch: is even"));
}

}  // namespace
}  // namespace pliant
