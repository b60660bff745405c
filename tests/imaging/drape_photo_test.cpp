// Silhouettes are drawn into pictures and found there again.

#include "pliant/imaging/drape_photo.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>
#include <random>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/drape/drape_figures.h"
#include "pliant/imaging/drape_import.h"
#include "pliant/imaging/refused_photo.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using ::testing::HasSubstr;

/// A specimen of six folds on its disc, and how a photograph of it looks.
struct DrawnDrape {
  double radius = 0.115, fold = 0.015;  ///< m: the outline is radius + fold cos(6 angle)
  double scale = 5e-4;                  ///< m a pixel
  int width = 800, height = 700;        ///< pixels
  Eigen::Vector2d middle{430, 330};     ///< pixel
  Eigen::Array3d cloth{60, 70, 140};    ///< red, green and blue
  bool shaded = false;                  ///< a shadow below it, a lamp's spot beside it
  bool frayed = false;                  ///< fibres stick out, and background shows through a hole
  bool with_sheet = false;              ///< another thing at the right border

  double outline(double angle) const { return radius + fold * std::cos(6 * angle); }
  double area() const { return std::numbers::pi * (radius * radius + fold * fold / 2); }
};

bool is_cloth(const DrawnDrape& drawn, const Eigen::Vector2d& from_middle) {
  const double distance = from_middle.norm();
  if (drawn.frayed) {
    const bool in_hole = (from_middle - Eigen::Vector2d(0.04, 0.02)).norm() < 0.004;
    const bool on_fibre = std::abs(from_middle.y() - 0.01) < 0.0007 && from_middle.x() < 0 &&
                          distance < drawn.radius + 0.04;
    if (in_hole) return false;
    if (on_fibre) return true;
  }
  return distance < drawn.outline(std::atan2(from_middle.y(), from_middle.x()));
}

Eigen::Array3d colour_at(const DrawnDrape& drawn, int x, int y) {
  const Eigen::Vector2d from_middle =
      drawn.scale * Eigen::Vector2d(x - drawn.middle.x(), drawn.middle.y() - y);
  if (is_cloth(drawn, from_middle)) return drawn.cloth;
  if (drawn.with_sheet && x > 0.95 * drawn.width) return {40, 40, 40};
  const double corner = 0.5 * x / drawn.width + 0.5 * y / drawn.height;
  Eigen::Array3d colour = Eigen::Array3d(225, 215, 200) - 40 * corner;
  if (!drawn.shaded) return colour;
  const double below = (from_middle - Eigen::Vector2d(0.02, -0.09)).norm() / 0.08;
  const double beside = (from_middle - Eigen::Vector2d(-0.15, 0)).norm() / 0.05;
  colour -= 25 * std::exp(-below * below);
  return colour + Eigen::Array3d(10, 10, 0) * std::exp(-beside * beside);
}

/// A PPM picture, with some noise.
std::string picture_of(const DrawnDrape& drawn, bool with_cloth = true) {
  std::mt19937 random(3);
  std::string picture =
      "P6\n" + std::to_string(drawn.width) + " " + std::to_string(drawn.height) + "\n255\n";
  for (int y = 0; y < drawn.height; ++y) {
    for (int x = 0; x < drawn.width; ++x) {
      const int far = 10 * drawn.width;
      DrawnDrape here = drawn;
      if (!with_cloth) here.middle = {far, far};
      const Eigen::Array3d colour = colour_at(here, x, y);
      const double grain = static_cast<double>(random() % 7) - 3;
      for (int k = 0; k < 3; ++k) {
        picture += static_cast<char>(std::clamp(colour(k) + grain, 0.0, 255.0));
      }
    }
  }
  return picture;
}

class DrapePhotoFolder : public TemporaryFolder {
 public:
  explicit DrapePhotoFolder(const DrawnDrape& drawn = {}, bool with_cloth = true)
      : photo_(write("photo.png", picture_of(drawn, with_cloth))), scale_(drawn.scale) {}

  const std::filesystem::path& photo() const { return photo_; }
  DrapeTrace trace(DrapePhotoOptions options = {}) const {
    options.scale = scale_;
    return trace_drape(photo_, options);
  }
  InputError refusal(const DrapePhotoOptions& options = {}) const {
    return input_error_of([&] { trace(options); });
  }

 private:
  std::filesystem::path photo_;
  double scale_;
};

struct Look {
  const char* what;
  DrawnDrape drawn;
};

class DrapePhoto : public ::testing::TestWithParam<Look> {};

TEST_P(DrapePhoto, ShowsTheSilhouetteThatWasDrawn) {
  const DrawnDrape& drawn = GetParam().drawn;
  const DrapeTrace trace = DrapePhotoFolder(drawn).trace();
  EXPECT_NEAR(trace.silhouette.area, drawn.area(), 0.007 * drawn.area());
  EXPECT_LT((trace.middle - drawn.middle).norm() * drawn.scale, 0.002);
  for (int i = 0; i < kSilhouetteAngles; i += 15) {
    const double angle = 2 * std::numbers::pi * i / kSilhouetteAngles;
    EXPECT_NEAR(trace.silhouette.radii[static_cast<std::size_t>(i)], drawn.outline(angle), 0.003)
        << i;
  }
  const DrapeFigures figures = fold_figures(trace.silhouette.radii, 0.06);
  EXPECT_EQ(figures.nodes, 6);
  EXPECT_NEAR(figures.amplitude, drawn.fold, 0.1 * drawn.fold);
}

const Look kLooks[] = {
    {"Dark", {}},
    {"PaleInShadow", {.cloth = {170, 200, 205}, .shaded = true}},
    {"Frayed", {.frayed = true}},
    {"BesideAnotherThing", {.with_sheet = true}},
    {"Large", {.scale = 1.6e-4, .width = 2500, .height = 2200, .middle = {1300, 1050}}},
};

INSTANTIATE_TEST_SUITE_P(Of, DrapePhoto, ::testing::ValuesIn(kLooks),
                         [](const auto& instance) { return instance.param.what; });

TEST(DrapePhotoRegion, IsAllThatIsLookedAt) {
  const DrapePhotoFolder folder;
  const DrapeTrace all = folder.trace();
  const DrapeTrace part = folder.trace({.region = PixelRegion{120, 40, 640, 600}});
  EXPECT_NEAR(part.silhouette.area, all.silhouette.area, 0.002 * all.silhouette.area);
  EXPECT_LT((part.middle - all.middle).norm(), 2);
  EXPECT_THAT(folder.refusal({.region = PixelRegion{700, 0, 200, 200}}).problem(),
              HasSubstr("is not within the picture"));
}

TEST(DrapePhotoMiddle, IsWhereItIsSaidToBe) {
  const DrawnDrape drawn;
  const Eigen::Vector2d said = drawn.middle + Eigen::Vector2d(20, 0);  // 1 cm to the right
  const DrapeTrace trace = DrapePhotoFolder(drawn).trace({.middle = said});
  EXPECT_EQ(trace.middle, said);
  EXPECT_NEAR(trace.silhouette.radii[0], drawn.outline(0) - 0.01, 0.001);
  EXPECT_NEAR(trace.silhouette.radii[360], drawn.outline(0) + 0.01, 0.001);
}

TEST(SlowDrapePhotoRefused, WhereNoSpecimenIsSeen) {
  EXPECT_THAT(DrapePhotoFolder({}, /*with_cloth=*/false).refusal().problem(),
              HasSubstr("nothing large that stands out"));
  DrawnDrape cut;
  cut.middle = {150, 330};
  EXPECT_THAT(DrapePhotoFolder(cut).refusal().problem(), HasSubstr("cut by the border"));
  EXPECT_THROW(DrapePhotoFolder(cut).trace(), RefusedPhoto);
}

TEST(DrapePhotoRefused, WhereTheMiddleIsBesideTheSilhouette) {
  for (const Eigen::Vector2d& middle : {Eigen::Vector2d(20, 20), Eigen::Vector2d(-300, 5e6)}) {
    EXPECT_THAT(DrapePhotoFolder().refusal({.middle = middle}).problem(),
                HasSubstr("not within the silhouette"));
  }
}

TEST(DrapePhotoRefused, WhereThePictureIsTiny) {
  EXPECT_THAT(DrapePhotoFolder().refusal({.region = PixelRegion{400, 300, 20, 20}}).problem(),
              HasSubstr("too small"));
  EXPECT_THROW(DrapePhotoFolder().trace({.region = PixelRegion{400, 300, 1, 1}}), RefusedPhoto);
}

TEST(DrapePhotoRefused, WhereTheDiscWouldStickOut) {
  const InputError error = DrapePhotoFolder().refusal({.disc = 0.24});
  EXPECT_THAT(error.problem(), HasSubstr("the disc below it 240 mm"));
  EXPECT_THAT(error.expected(), HasSubstr("scale"));
}

TEST(DrapeImport, IsAStudyOfEachPhotographAsARepeat) {
  const DrawnDrape drawn;
  const DrapePhotoFolder folder(drawn);
  const auto other = folder.write("other.png", picture_of({.fold = 0.005}));
  DrapeStudyOptions options{.name = "poplin", .density = 0.12, .photo = {.scale = drawn.scale}};
  const ImportedStudy study = import_drape_photos({folder.photo(), other}, options);
  EXPECT_THAT(study.study_yaml, HasSubstr("type: drape"));
  EXPECT_THAT(study.study_yaml, HasSubstr("specimen: 300 mm"));
  EXPECT_THAT(study.study_yaml, HasSubstr("density: 120 g/m^2"));
  const double disc = std::numbers::pi * 0.09 * 0.09, flat = std::numbers::pi * 0.15 * 0.15;
  EXPECT_THAT(study.notes.front(),
              HasSubstr("drape coefficient " + std::to_string(static_cast<int>(
                                                   100 * (drawn.area() - disc) / (flat - disc)))));
  std::vector<std::string> names;
  for (const auto& [name, content] : study.files) names.push_back(name);
  EXPECT_THAT(names,
              ::testing::UnorderedElementsAre("photo-outline.png", "other-outline.png", "drape.csv",
                                              "silhouettes.csv", "silhouettes.svg"));
  EXPECT_THAT(study.warnings, ::testing::IsEmpty());
}

TEST(DrapeImport, RefusesASilhouetteThatIsLargerThanTheFlatSpecimen) {
  const DrawnDrape drawn;
  const DrapePhotoFolder folder(drawn);
  const InputError error = input_error_of([&] {
    import_drape_photos({folder.photo()},
                        {.name = "a", .specimen = 0.2, .photo = {.scale = drawn.scale}});
  });
  EXPECT_THAT(error.problem(), HasSubstr("the flat specimen 314 cm^2"));
}

}  // namespace
}  // namespace pliant
