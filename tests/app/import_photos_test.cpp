// What `import` asks for before it looks at photographs.

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/run_program.h"

namespace pliant::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

/// A run of `import` on a file that is called a photograph.
class PhotoImportFolder : public TemporaryFolder {
 public:
  ProgramRun import(const std::vector<std::string>& options) const {
    std::vector<std::string> arguments{"import", write("strip.png", "no picture").string(), "-o",
                                       (path() / "study").string()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments);
  }
};

struct RefusedOptions {
  const char* what;
  std::vector<std::string> options;
  const char* field;
  const char* expected;
};

class RefusedPhotoImport : public ::testing::TestWithParam<RefusedOptions> {};

TEST_P(RefusedPhotoImport, NamesTheOption) {
  const PhotoImportFolder folder;
  const ProgramRun run = folder.import(GetParam().options);
  EXPECT_EQ(run.status, 2);
  if (run.err.find("built without OpenCV") != std::string::npos) GTEST_SKIP() << run.err;
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr(GetParam().field),
                                     HasSubstr(GetParam().expected)));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "study"));
}

const RefusedOptions kRefused[] = {
    {"NoScale", {"--density", "180 gsm", "--direction", "warp"}, "--scale: is missing", "0.11 mm"},
    {"ScaleWithoutUnit",
     {"--scale", "0.11", "--density", "180 gsm", "--direction", "warp"},
     "--scale",
     "has no unit"},
    {"NoDensity", {"--scale", "0.1 mm", "--direction", "warp"}, "--density: is missing", "13.6"},
    {"TwoDensities",
     {"--scale", "0.1 mm", "--direction", "warp", "--density", "1 gsm", "--areal-load", "1 N/m^2"},
     "--density",
     "is given twice"},
    {"NoDirection",
     {"--scale", "0.1 mm", "--density", "180 gsm"},
     "--direction: is missing",
     "warp, weft or bias"},
    {"ClampOfOneNumber",
     {"--scale", "0.1 mm", "--density", "180 gsm", "--direction", "warp", "--clamp", "12"},
     "--clamp",
     "X,Y"},
    {"CropOfThreeNumbers",
     {"--scale", "0.1 mm", "--density", "180 gsm", "--direction", "warp", "--crop", "1,2,3"},
     "--crop",
     "WIDTHxHEIGHT"},
    {"DirectionOfADrape",
     {"--drape", "--scale", "0.1 mm", "--direction", "warp"},
     "--direction: is an option of photographs of strips",
     "without"},
    {"SpecimenOfAStrip",
     {"--scale", "0.1 mm", "--density", "180 gsm", "--direction", "warp", "--specimen", "30 cm"},
     "--specimen: is an option of --drape",
     "without"},
    {"SpecimenThatDoesNotHang",
     {"--drape", "--scale", "0.1 mm", "--specimen", "15 cm"},
     "--specimen: hardly hangs over the disc",
     "198 mm"},
    {"NoScaleOfADrape", {"--drape"}, "--scale: is missing", "draped specimen"},
    {"NoPicture",
     {"--scale", "0.1 mm", "--density", "180 gsm", "--direction", "warp"},
     "strip.png",
     "is no picture"},
};

INSTANTIATE_TEST_SUITE_P(Of, RefusedPhotoImport, ::testing::ValuesIn(kRefused),
                         [](const auto& instance) { return instance.param.what; });

// Two bright bands from the left border, as a PGM picture.
std::string two_bands() {
  constexpr int kWidth = 400, kHeight = 300;
  std::string picture = "P5 400 300 255\n";
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool band = x < 300 && (y / 8 == 10 || y / 8 == 25);
      picture += static_cast<char>(band ? 250 : 30);
    }
  }
  return picture;
}

TEST(PhotoImport, LeavesAPictureOfWhatWasSeenWhereItRefuses) {
  const TemporaryFolder folder;
  const auto photo = folder.write("bands.png", two_bands());
  const auto study = folder.path() / "study";
  std::vector<std::string> arguments{"import", photo.string(), "-o",      study.string(), "--scale",
                                     "0.1 mm", "--density",    "180 gsm", "--direction",  "warp"};
  ProgramRun run = run_program(arguments);
  if (run.err.find("built without OpenCV") != std::string::npos) GTEST_SKIP() << run.err;
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("2 things that could be the strip"));
  EXPECT_THAT(run.err, HasSubstr((study / "bands-seen.png").string() + " shows what was seen"));
  EXPECT_TRUE(std::filesystem::exists(study / "bands-seen.png"));
  EXPECT_FALSE(std::filesystem::exists(study / "study.yaml"));

  // The study takes its place.
  arguments.insert(arguments.end(), {"--clamp", "0,84"});
  run = run_program(arguments);
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists(study / "study.yaml"));
  EXPECT_FALSE(std::filesystem::exists(study / "bands-seen.png"));
}

}  // namespace
}  // namespace pliant::test
