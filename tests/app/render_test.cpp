// Pictures of simulations, as a user asks for them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/run_program.h"
#include "support/simulation_folder.h"

namespace pliant::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::UnorderedElementsAre;

constexpr const char* kList = ".pliant-results.json";

/// Tests of a program that can draw.
class RenderCommand : public ::testing::Test {
 protected:
  void SetUp() override {
    if (run_program({"--help"}).out.find("\n  render ") == std::string::npos) {
      GTEST_SKIP() << "this program was built without pictures";
    }
  }

  /// `pliant render sim -o out --size 64x48 ARGUMENTS...`
  ProgramRun render(const std::vector<std::string>& arguments) const {
    std::vector<std::string> all = {"render",           folder.file("sim"), "-o",
                                    folder.file("out"), "--size",           "64x48"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    return run_program(all);
  }

  std::vector<std::string> pictures() const { return names_in(folder.path() / "out"); }

  const SimulationFolder folder{5};
};
using SlowRenderCommand = RenderCommand;

/// Width and height in the header of a PNG file.
std::pair<int, int> png_size(const std::string& bytes) {
  const auto number_at = [&](size_t place) {
    int value = 0;
    for (size_t i = place; i < place + 4; ++i) {
      value = value * 256 + static_cast<unsigned char>(bytes.at(i));
    }
    return value;
  };
  EXPECT_THAT(bytes, StartsWith("\x89PNG\r\n"));
  return {number_at(16), number_at(20)};
}

TEST_F(RenderCommand, DrawsEveryFrame) {
  const ProgramRun run = render({});
  EXPECT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("5 pictures"));
  EXPECT_THAT(pictures(), UnorderedElementsAre("000000.png", "000001.png", "000002.png",
                                               "000003.png", "000004.png", kList));
  EXPECT_EQ(png_size(content_of(folder.file("out/000003.png"))), std::pair(64, 48));
  EXPECT_NE(content_of(folder.file("out/000003.png")), content_of(folder.file("out/000000.png")));
}

TEST_F(RenderCommand, DrawsTheFramesAskedFor) {
  EXPECT_EQ(render({"--frames", "1:4:2"}).status, 0);
  EXPECT_THAT(pictures(), UnorderedElementsAre("000001.png", "000003.png", kList));
  EXPECT_EQ(render({"--frames", "3:"}).status, 0);
  EXPECT_THAT(pictures(), UnorderedElementsAre("000003.png", "000004.png", kList));
  EXPECT_EQ(render({"--frames", "2"}).status, 0);
  EXPECT_THAT(pictures(), UnorderedElementsAre("000002.png", kList));
}

TEST_F(RenderCommand, DrawsTheSameBitsWhateverElseIsDrawnAndForAnyNumberOfThreads) {
  render({"--threads", "1"});
  const std::string picture = content_of(folder.file("out/000003.png"));
  render({"--frames", "3", "--threads", "3"});
  EXPECT_EQ(content_of(folder.file("out/000003.png")), picture);
}

TEST_F(SlowRenderCommand, TakesEveryOptionOfLooks) {
  const ProgramRun plain = render({"--frames", "2"});
  const std::string picture = content_of(folder.file("out/000002.png"));
  const std::vector<std::vector<std::string>> looks{
      {"--view", "front"},
      {"--view", "left"},
      {"--view", "top"},
      {"--view", "bottom"},
      {"--camera", "1,-3,2", "--target", "0.5,0,0.5", "--field-of-view", "40"},
      {"--field", "strain_weft"},
      {"--field", "strain_weft", "--colour-map", "coolwarm"},
      {"--field", "strain_weft", "--range", "-1:1"},
      {"--colour", "#c08040"},
      {"--mesh-lines"},
      {"--no-ground"},
      {"--cut", "x=0.5"},
      {"--cut", "z = 100 mm"},
      {"--hard-shadow"},
      {"--samples", "5"}};
  for (std::vector<std::string> arguments : looks) {
    const std::string option = arguments.front();
    arguments.insert(arguments.end(), {"--frames", "2"});
    const ProgramRun run = render(arguments);
    EXPECT_EQ(run.status, 0) << option << ": " << run.err;
    EXPECT_NE(content_of(folder.file("out/000002.png")), picture) << option;
  }
}

TEST_F(RenderCommand, ShowsTheBackInAColourOfItsOwn) {
  render({"--frames", "2", "--view", "back"});
  const std::string picture = content_of(folder.file("out/000002.png"));
  render({"--frames", "2", "--view", "back", "--back-colour", "#208040"});
  EXPECT_NE(content_of(folder.file("out/000002.png")), picture);
  render({"--frames", "2", "--view", "back", "--colour", "#208040"});
  EXPECT_NE(content_of(folder.file("out/000002.png")), picture);
}

TEST_F(RenderCommand, PutsFramesOnAContactSheet) {
  EXPECT_EQ(render({"--contact-sheet", "3"}).status, 0);
  EXPECT_THAT(pictures(), UnorderedElementsAre("contact-sheet.png", kList));
  EXPECT_EQ(png_size(content_of(folder.file("out/contact-sheet.png"))), std::pair(128, 96));
}

TEST_F(RenderCommand, PutsSimulationsOnAContactSheetARowEach) {
  std::vector<std::string> arguments{"--contact-sheet", "3"};
  for (const int rows : {2, 3}) {
    arguments.insert(arguments.end(), {"--beside", folder.file("sim")});
    const ProgramRun run = render(arguments);
    EXPECT_EQ(run.status, 0) << run.err;
    EXPECT_EQ(png_size(content_of(folder.file("out/contact-sheet.png"))),
              std::pair(3 * 64, rows * 48));
  }
  EXPECT_EQ(render({"--beside", folder.file("sim")}).status, 2);
  EXPECT_EQ(render({"--contact-sheet", "3", "--beside", folder.file("none")}).status, 2);
}

/// Films, made by a script in place of ffmpeg: it writes its arguments and what it is given.
class RenderMovie : public RenderCommand {
 protected:
  void SetUp() override {
    RenderCommand::SetUp();
    write_ffmpeg("for last; do :; done; echo \"$@\" > \"$last\"; cat >> \"$last\"");
  }
  void write_ffmpeg(const std::string& script) const {
    std::filesystem::permissions(folder.write("bin/ffmpeg", "#!/bin/sh\n" + script + "\n"),
                                 std::filesystem::perms::owner_all);
  }
  ProgramRun film(std::vector<std::string> arguments = {}, bool has_ffmpeg = true) const {
    const std::string path =
        has_ffmpeg ? folder.file("bin") + ":" + std::getenv("PATH") : folder.file("empty");
    arguments.insert(arguments.begin(), {"render", folder.file("sim"), "--size", "63x48", "--movie",
                                         folder.file("film/a.mp4")});
    std::filesystem::create_directory(folder.path() / "film");
    return run_program(arguments, {.in_child = [&] { setenv("PATH", path.c_str(), 1); }});
  }
  std::vector<std::string> films() const { return names_in(folder.path() / "film"); }
};

TEST_F(RenderMovie, GivesFfmpegEveryFrameAtTheSpeedOfReality) {
  const ProgramRun run = film();
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("film of 5 frames, 25 a second"));
  EXPECT_THAT(films(), UnorderedElementsAre("a.mp4"));
  const std::string bytes = content_of(folder.file("film/a.mp4"));
  const size_t begin = bytes.find('\n') + 1;
  EXPECT_THAT(bytes.substr(0, begin), AllOf(HasSubstr("-video_size 63x48"),
                                            HasSubstr("-framerate 25"), HasSubstr("rgb24")));
  EXPECT_EQ(bytes.size() - begin, 5u * 63 * 48 * 3);
}

TEST_F(RenderMovie, ComesBesidePicturesAndAtARateAskedFor) {
  const ProgramRun run = film({"-o", folder.file("out"), "--rate", "50", "--frames", "::2"});
  ASSERT_EQ(run.status, 0) << run.err;
  EXPECT_THAT(run.err, HasSubstr("film of 3 frames, 50 a second, 4 times as fast as in reality"));
  EXPECT_THAT(pictures(), UnorderedElementsAre("000000.png", "000002.png", "000004.png", kList));
}

TEST_F(RenderMovie, SaysSoWhereThereIsNoFfmpegAndLeavesNothing) {
  const ProgramRun run = film({"-o", folder.file("out")}, false);
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: --movie: "), HasSubstr("ffmpeg")));
  EXPECT_TRUE(films().empty());
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

TEST_F(RenderMovie, TellsWhatFfmpegSaidWhereItFailedAndLeavesNothing) {
  write_ffmpeg("for last; do :; done; cat > \"$last\"; echo no encoder here >&2; exit 1");
  const ProgramRun run = film({"-o", folder.file("out")});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("no encoder here")));
  EXPECT_TRUE(films().empty());
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

TEST_F(RenderMovie, RefusesAFolderThatIsNotThere) {
  const ProgramRun run =
      run_program({"render", folder.file("sim"), "--movie", folder.file("none/a.mp4")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), HasSubstr("there is no folder"));
}

TEST_F(RenderCommand, AsksForPicturesOrAFilm) {
  const ProgramRun run = run_program({"render", folder.file("sim")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), AllOf(HasSubstr("-o DIR"), HasSubstr("--movie")));
}

TEST_F(RenderCommand, SaysInJsonWhatItDrew) {
  const ProgramRun run = render({"--frames", "0:1", "--field", "strain_weft", "--json"});
  const nlohmann::json json = nlohmann::json::parse(run.out);
  EXPECT_EQ(json["command"], "render");
  EXPECT_EQ(json["pictures"], (nlohmann::json{"000000.png", "000001.png"}));
  EXPECT_EQ(json["field"]["name"], "strain_weft");
  EXPECT_NEAR(json["field"]["high"].get<double>(), 0.04, 1e-15);
  EXPECT_EQ(json["field"]["percentiles"], false);
}

TEST_F(SlowRenderCommand, RefusesWhatItCannotUseInOneLine) {
  const std::vector<std::pair<std::vector<std::string>, std::string>> wrong{
      {{"--size", "800"}, "--size"},
      {{"--size", "8x8"}, "--size"},
      {{"--size", "1x2x3"}, "--size"},
      {{"--frames", "a:b"}, "--frames"},
      {{"--frames", "7:9"}, "0 to 4"},
      {{"--frames", "::0"}, "--frames"},
      {{"--view", "frnt"},
       "--view: \"frnt\" (did you mean \"front\"?); expected \"front\", \"back\", \"left\", "
       "\"right\", \"top\", \"bottom\", \"three-quarter\" or \"three-quarter-back\""},
      {{"--field", "strain_weft", "--colour-map", "jet"},
       "--colour-map: \"jet\"; expected \"viridis\" or \"coolwarm\""},
      {{"--camera", "1,2"}, "--camera"},
      {{"--camera", "0,0,0"}, "--target"},
      {{"--target", "1,2,3"}, "--camera"},
      {{"--field", "strain"}, "strain_weft"},
      {{"--field", "strain_weft", "--range", "1:1"}, "--range"},
      {{"--colour", "blue"}, "--colour"},
      {{"--back-colour", "blue"}, "--back-colour"},
      {{"--lines", "0 mm"}, "--lines"},
      {{"--lines", "often"}, "--lines"},
      {{"--movie", "film.gif"}, "FILE.mp4"},
      {{"--rate", "25"}, "--movie"},
      {{"--contact-sheet", "0"}, "--contact-sheet"},
      {{"--contact-sheet", "400", "--size", "8000x6000"}, "--contact-sheet"}};
  for (const auto& [arguments, named] : wrong) {
    std::vector<std::string> all = {"render", folder.file("sim"), "-o", folder.file("out")};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const ProgramRun run = run_program(all);
    EXPECT_EQ(run.status, 2) << arguments[0] << ": " << run.err;
    EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr(named)));
    EXPECT_FALSE(std::filesystem::exists(folder.file("out"))) << arguments[0];
  }
}

TEST_F(RenderCommand, NamesTheFileOfABrokenFrameAndLeavesNothing) {
  folder.write("sim/frames/000004.ply", "ply\nformat ascii 1.0\n");
  const ProgramRun run = render({});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("000004.ply")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

TEST_F(RenderCommand, NeverDrawsIntoTheFolderOfTheSimulation) {
  const ProgramRun run = run_program({"render", folder.file("sim"), "-o", folder.file("sim")});
  EXPECT_EQ(run.status, 2);
  EXPECT_THAT(names_in(folder.path() / "sim"), UnorderedElementsAre("simulation.json", "frames"));
}

// The picture would take minutes.
TEST_F(RenderCommand, EndsSoonWhenInterruptedAndLeavesNothing) {
  constexpr double kWait = 0.7;
  const ProgramRun run = run_program({"render", folder.file("sim"), "-o", folder.file("out"),
                                      "--size", "8000x6000", "--samples", "256"},
                                     {.interrupt_after = kWait});
  EXPECT_EQ(run.status, 1) << run.err;
  EXPECT_LT(run.seconds, kWait + 2 * kSanitizerFactor);
  EXPECT_THAT(run.last_line(), AllOf(StartsWith("error: "), HasSubstr("interrupted")));
  EXPECT_FALSE(std::filesystem::exists(folder.file("out")));
}

}  // namespace
}  // namespace pliant::test
