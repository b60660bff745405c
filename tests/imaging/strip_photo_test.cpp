// Strips are drawn into pictures and found there again.

#include "pliant/imaging/strip_photo.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/imaging/refused_photo.h"

#include "imaging/drawn_strip.h"
#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::draw_strips;
using test::DrawnStrip;
using test::elastic_profile;
using test::input_error_of;
using test::TemporaryFolder;
using ::testing::HasSubstr;

constexpr double kScale = 1.0 / 8000;  // m a pixel
constexpr double kWeight = 2;          // N/m^2
constexpr double kLength = 0.09;       // m

std::vector<Eigen::Vector2d> strip() { return elastic_profile(1e-4, kWeight, kLength); }

// Distance of a point from a line.
double distance(const Eigen::Vector2d& point, const std::vector<Eigen::Vector2d>& line) {
  double nearest = 1;
  for (size_t i = 1; i < line.size(); ++i) {
    const Eigen::Vector2d piece = line[i] - line[i - 1];
    const double share = std::clamp(piece.dot(point - line[i - 1]) / piece.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (line[i - 1] + share * piece - point).norm());
  }
  return nearest;
}

class PhotoFolder : public TemporaryFolder {
 public:
  std::filesystem::path photo() const { return path() / "photo.png"; }

  StripTrace trace(StripPhotoOptions options = {}) const {
    options.scale = kScale;
    return trace_strip(photo(), options);
  }
  InputError refusal(const StripPhotoOptions& options = {}) const {
    return input_error_of([&] { trace(options); });
  }
};

struct Look {
  const char* what;
  DrawnStrip drawn;
  double rigidity = 1e-4;     // N m
  double clamp_angle = 0.03;  ///< rad, by which that at the clamp may be missed
};

class TracedStrip : public ::testing::TestWithParam<Look> {};

TEST_P(TracedStrip, LiesOnTheLineThatWasDrawn) {
  const PhotoFolder folder;
  const auto truth = elastic_profile(GetParam().rigidity, kWeight, kLength);
  draw_strips(folder.photo(), {truth}, GetParam().drawn);
  StripPhotoOptions options;
  if (GetParam().drawn.mirrored) options.clamp_side = ClampSide::right;
  const StripTrace trace = folder.trace(options);
  ASSERT_EQ(trace.profile.size(), 31u);
  EXPECT_EQ(trace.profile.front(), Eigen::Vector2d::Zero());
  for (const Eigen::Vector2d& point : trace.profile) {
    // Within a pixel; the free end may lie a little more beyond the line's.
    EXPECT_LT(distance(point, truth), 1.2 * kScale) << point.transpose() / kScale;
  }
  // The clamp's pixel and the free end are known to one pixel each.
  EXPECT_NEAR(trace.length, kLength, 2 * kScale);
  EXPECT_NEAR(trace.thickness, GetParam().drawn.thickness * kScale, 2 * kScale);
  EXPECT_NEAR(trace.clamp_angle, 0, GetParam().clamp_angle);
}

const Look kLooks[] = {
    {"Bright", {}},
    {"Dark", {.strip = 0.1, .background = 0.6}},
    {"ClampOnTheRight", {.mirrored = true}},
    {"WithoutNoise", {.gradient = 0, .noise = 0}},
    {"FaintAndNoisy", {.strip = 0.35, .background = 0.15, .noise = 0.04}},
    {"Thin", {.thickness = 4}},
    {"Thick", {.thickness = 20}},
    {"BentTightly", {}, 2e-6, 0.25},
    {"AlmostStraight", {}, 5e-4},
};

INSTANTIATE_TEST_SUITE_P(Of, TracedStrip, ::testing::ValuesIn(kLooks),
                         [](const auto& look) { return std::string(look.param.what); });

TEST(StripPhoto, KeepsPointsInPixelsOfThePhotograph) {
  const PhotoFolder folder;
  draw_strips(folder.photo(), {strip()}, {.mirrored = true});
  StripPhotoOptions options;
  options.clamp_side = ClampSide::right;
  options.region = PixelRegion{100, 50, 800, 780};
  const StripTrace trace = folder.trace(options);
  EXPECT_NEAR(trace.pixels.front().x(), 899, 1.5);
  EXPECT_NEAR(trace.pixels.front().y(), 120, 1);
  EXPECT_NEAR(trace.pixels.back().x(), 899 - (strip().back().x() / kScale - 1), 1.5);
}

TEST(StripPhoto, BeginsAtTheClampsPixel) {
  const PhotoFolder folder;
  // A table in front of it: what lies left of the clamp's pixel is left out.
  std::vector<Eigen::Vector2d> table;
  for (int i = 0; i < 20; ++i) table.emplace_back(-0.001 * (19 - i), 0.0);
  std::vector<Eigen::Vector2d> whole = table;
  const auto hanging = strip();
  whole.insert(whole.end(), hanging.begin() + 1, hanging.end());
  draw_strips(folder.photo(), {whole}, {.clamp = {150, 120}});
  StripPhotoOptions options;
  options.clamp = Eigen::Vector2d(150, 120);
  const StripTrace trace = folder.trace(options);
  EXPECT_NEAR(trace.length, kLength, 2 * kScale);
  EXPECT_NEAR(trace.pixels.front().x(), 150, 1.5);
}

// Fibres that stick out of the strip, a tenth of its thickness, turn no point away from its middle.
TEST(StripPhoto, IsNotLedAstrayByLooseFibres) {
  const PhotoFolder folder;
  const auto truth = strip();
  std::vector<std::vector<Eigen::Vector2d>> drawn{truth};
  draw_strips(folder.photo(), drawn);
  const StripTrace clean = folder.trace();
  test::draw_fibres(folder.photo(), clean.pixels);
  const StripTrace hairy = folder.trace();
  for (const Eigen::Vector2d& point : hairy.profile) {
    EXPECT_LT(distance(point, truth), kScale) << point.transpose() / kScale;
  }
  EXPECT_NEAR(hairy.length, clean.length, 3 * kScale);
}

/// The points of a line from one share of it to another.
std::vector<Eigen::Vector2d> part_of(const std::vector<Eigen::Vector2d>& line, double from,
                                     double to) {
  const auto at = [&](double share) {
    return line.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(line.size()));
  };
  return {at(from), at(to)};
}

TEST(StripPhoto, JoinsPiecesOfOneLine) {
  const PhotoFolder folder;
  const auto truth = strip();
  draw_strips(folder.photo(),
              {part_of(truth, 0, 0.3), part_of(truth, 0.35, 0.64), part_of(truth, 0.7, 1)});
  const StripTrace trace = folder.trace();
  EXPECT_EQ(trace.gaps, 2);
  EXPECT_NEAR(trace.length, kLength, 2 * kScale);
  for (const Eigen::Vector2d& point : trace.profile) {
    EXPECT_LT(distance(point, truth), 1.2 * kScale) << point.transpose() / kScale;
  }
}

TEST(StripPhoto, JoinsNoPieceThatLiesElsewhere) {
  const PhotoFolder folder;
  const auto truth = strip();
  // Above the end of the strip, and along it.
  std::vector<Eigen::Vector2d> other;
  for (int i = 0; i < 20; ++i) {
    other.emplace_back(truth.back() + Eigen::Vector2d(0.001 * i - 0.01, 0.01));
  }
  draw_strips(folder.photo(), {truth, other});
  const StripTrace trace = folder.trace();
  EXPECT_EQ(trace.gaps, 0);
  EXPECT_NEAR(trace.length, kLength, 2 * kScale);
}

TEST(StripPhoto, IsNotJoinedToWhatLiesAcrossBelowItsEnd) {
  const PhotoFolder folder;
  const auto truth = strip();
  std::vector<Eigen::Vector2d> across;
  for (int i = 0; i <= 20; ++i) across.emplace_back(0.002 + 0.004 * i, truth.back().y() - 0.004);
  draw_strips(folder.photo(), {truth, across});
  StripPhotoOptions options;
  options.clamp = Eigen::Vector2d(0, 120);
  const StripTrace trace = folder.trace(options);
  EXPECT_EQ(trace.gaps, 0);
  EXPECT_NEAR(trace.length, kLength, 2 * kScale);
}

TEST(SlowStripPhoto, OfAStripThatGoesOnBeyondItsEndIsRefused) {
  const PhotoFolder folder;
  const auto truth = strip();
  // Far ahead there is more of it.
  draw_strips(folder.photo(), {part_of(truth, 0, 0.6), part_of(truth, 0.8, 1)});
  EXPECT_THAT(folder.refusal().problem(), HasSubstr("seems to go on beyond where it ends"));
  for (const double share : {0.35, 0.25, 0.15}) {
    draw_strips(folder.photo(), {truth});
    test::draw_shadow(folder.photo(), 250, share);
    EXPECT_THAT(folder.refusal().problem(), HasSubstr("seems to go on beyond where it ends"))
        << share;
  }
}

TEST(StripPhoto, OfNothingIsRefused) {
  const PhotoFolder folder;
  for (const double noise : {0.0, 0.05}) {
    draw_strips(folder.photo(), {}, {.noise = noise});
    const InputError error = folder.refusal();
    EXPECT_EQ(error.where().file, folder.photo().string());
    EXPECT_THAT(error.problem(), HasSubstr("nothing long and thin"));
  }
}

TEST(StripPhoto, OfTwoStripsIsRefusedUnlessOneIsNamed) {
  const PhotoFolder folder;
  draw_strips(folder.photo(), {strip(), strip()}, {.clamp = {-1, 80}}, 200);
  EXPECT_THAT(folder.refusal().problem(), HasSubstr("2 things that could be the strip"));
  StripPhotoOptions options;
  options.clamp = Eigen::Vector2d(0, 280);
  EXPECT_NEAR(folder.trace(options).pixels.front().y(), 280, 1);
  options.clamp = Eigen::Vector2d(0, 500);
  EXPECT_THAT(folder.refusal(options).problem(), HasSubstr("no strip at the clamp's pixel"));
}

TEST(StripPhoto, OfAStripThatLeavesThePictureIsRefused) {
  const PhotoFolder folder;
  draw_strips(folder.photo(), {strip()}, {.width = 300});
  EXPECT_THAT(folder.refusal().problem(), HasSubstr("leaves the picture at its right border"));
  draw_strips(folder.photo(), {strip()}, {.height = 250});
  EXPECT_THAT(folder.refusal().problem(), HasSubstr("leaves the picture at its lower border"));
  draw_strips(folder.photo(), {strip()}, {.width = 300, .mirrored = true});
  StripPhotoOptions options;
  options.clamp_side = ClampSide::right;
  EXPECT_THAT(folder.refusal(options).problem(), HasSubstr("at its left border"));
}

TEST(StripPhoto, WithItsClampOnTheOtherSideIsRefused) {
  const PhotoFolder folder;
  draw_strips(folder.photo(), {strip()}, {.mirrored = true});
  EXPECT_THAT(folder.refusal().problem(), HasSubstr("does not begin at the left border"));
}

TEST(StripPhoto, RegionsAndPixelsLieWithinThePicture) {
  const PhotoFolder folder;
  draw_strips(folder.photo(), {strip()});
  StripPhotoOptions options;
  options.region = PixelRegion{0, 0, 901, 850};
  EXPECT_THAT(folder.refusal(options).problem(), HasSubstr("not within the picture"));
  options.region.reset();
  options.clamp = Eigen::Vector2d(0, 850);
  EXPECT_THAT(folder.refusal(options).problem(), HasSubstr("clamp's pixel is not within"));
}

// A refused photograph comes back paler, with what was seen in it in colours.
TEST(StripPhoto, ThatIsRefusedShowsWhatWasSeen) {
  const PhotoFolder folder;
  draw_strips(folder.photo(), {strip(), strip()}, {.clamp = {-1, 80}, .mirrored = true}, 200);
  StripPhotoOptions options;
  options.scale = kScale;
  options.clamp_side = ClampSide::right;
  options.region = PixelRegion{100, 20, 800, 820};
  std::string picture;
  try {
    trace_strip(folder.photo(), options);
  } catch (const RefusedPhoto& photo) {
    picture = photo.as_seen();
  }
  const Photo seen = read_photo(folder.write("seen.png", picture));
  const Photo taken = read_photo(folder.photo());
  ASSERT_EQ(seen.cols(), 900);
  ASSERT_EQ(seen.rows(), 850);
  const auto is_marked = [&](int x, int y) {
    return std::abs(seen(y, x) - (1 + taken(y, x)) / 2) > 0.1F;
  };
  EXPECT_TRUE(is_marked(885, 80)) << "the first strip";
  EXPECT_TRUE(is_marked(885, 280)) << "the second";
  EXPECT_FALSE(is_marked(885, 180)) << "between them";
  EXPECT_TRUE(is_marked(100, 600)) << "the frame of the region";
}

TEST(StripPhoto, ReadsPicturesAlone) {
  const PhotoFolder folder;
  folder.write("photo.png", "no picture");
  EXPECT_THAT(folder.refusal().problem(), HasSubstr("is no picture"));
}

}  // namespace
}  // namespace pliant
