// From what `init` writes over pictures of one camera and a tester's log to a law, by the program.

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/text_file.h"

#include "app/picture_png.h"
#include "app/run_program.h"
#include "capture/labelled_camera.h"

namespace pliant::test {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr double kStiffness = 400;  // N/m

TEST(SlowLabelledImport, OfPicturesByAHandHeldCameraGivesTheLaw) {
  const TemporaryFolder folder;
  const auto made = folder.path() / "made";
  ASSERT_EQ(run_program({"init", "capture", "-o", made.string()}).status, 0);
  std::string log = "force_N\n";
  for (int f = 0; f < 9; ++f) {
    LabelledPull pull{.strain = 0.01 * f};
    pull.slip = 2e-5 * f;
    pull.nearer = 1e-4 * f;
    pull.turned = 0.003 * (f % 3);
    pull.tilted = 0.004 * (f % 2);
    const double green = pull.strain + pull.strain * pull.strain / 2;
    const double force = kStiffness * LabelledPull::kWidth * green * (1 + pull.strain);
    log += fmt::format("{:.5f}\n", force);
    folder.write(fmt::format("made/pictures/{:03}.png", f),
                 png_of(pull.picture(static_cast<std::uint64_t>(f))));
  }
  folder.write("made/tester.csv", log);
  std::string text = read_text_file(made / "pull.yaml");
  const auto replace = [&](std::string_view what, std::string_view by) {
    ASSERT_NE(text.find(what), std::string::npos) << what;
    text.replace(text.find(what), what.size(), by);
  };
  replace("width: 50 mm, height: 100 mm", "width: 30 mm, height: 90 mm");
  replace("*.jpg", "*.png");
  const auto file = folder.write("made/pull.yaml", text);
  const auto out = folder.path() / "imported";
  const ProgramRun run = run_program({"import", "--dic", file.string(), "-o", out.string()});
  ASSERT_EQ(run.status, 0) << run.err;
  fmt::print("{}", run.err);
  EXPECT_THAT(run.err, HasSubstr("the clips' edges are 90"));
  EXPECT_THAT(run.err, HasSubstr("cloth has left the clip upper by 16"));
  EXPECT_THAT(run.err, HasSubstr("nearer"));
  const ProgramRun fit = run_program(
      {"fit", (out / "strip.yaml").string(), "-o", (folder.path() / "fit").string(), "--json"});
  ASSERT_EQ(fit.status, 0) << fit.err;
  const json result = json::parse(fit.out);
  const json& stiffness = result["parameters"][0];
  fmt::print("{} = {} +- {}\n", stiffness["name"].dump(), stiffness["value"].dump(),
             stiffness["std_error"].dump());
  EXPECT_NEAR(stiffness["value"], kStiffness, 0.01 * kStiffness);
}

}  // namespace
}  // namespace pliant::test
