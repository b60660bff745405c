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
    {"NoPicture",
     {"--scale", "0.1 mm", "--density", "180 gsm", "--direction", "warp"},
     "strip.png",
     "is no picture"},
};

INSTANTIATE_TEST_SUITE_P(Of, RefusedPhotoImport, ::testing::ValuesIn(kRefused),
                         [](const auto& instance) { return instance.param.what; });

}  // namespace
}  // namespace pliant::test
