#include "pliant/render/simulation_pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "io/input_error_of.h"
#include "support/simulation_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::SimulationFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

PictureOptions small_pictures() {
  PictureOptions options;
  options.size = {120, 90};
  options.quality.samples = 4;
  options.view = ViewDirection::front;
  return options;
}

TEST(SimulationFrames, AreReadWithTheirTimesAndUnits) {
  const SimulationFolder folder(3);
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  ASSERT_EQ(simulation.frames.size(), 3u);
  EXPECT_EQ(simulation.frames[2].index, 2);
  EXPECT_DOUBLE_EQ(simulation.frames[2].time, 0.08);
  EXPECT_EQ(simulation.units.at("strain_weft"), "1");
  EXPECT_EQ(simulation.file_of(simulation.frames[2]),
            folder.path() / "sim" / "frames" / "000002.ply");
}

TEST(SimulationFrames, HaveTrianglesAndFields) {
  const SimulationFolder folder(3);
  const FrameMesh mesh = read_frame(folder.path() / "sim/frames/000001.ply");
  EXPECT_EQ(mesh.positions.col(2), Eigen::Vector3d(1, 0, 1 - 1.0 / 3));
  Eigen::Matrix3Xi fan(3, 2);
  fan << 0, 0, 1, 2, 2, 3;
  EXPECT_EQ(mesh.triangles, fan);
  EXPECT_EQ(mesh.fields.at("strain_weft"), Eigen::Vector4d(0, 0.01, 0.01, 0));
}

TEST(SimulationFrames, ThatMakeNoSenseAreRefusedWithTheirLine) {
  const SimulationFolder folder(1);
  const auto error_for = [&](const std::string& frames) {
    folder.write_summary(frames);
    return input_error_of([&] { read_simulation_frames(folder.path() / "sim"); });
  };
  for (const char* frames : {"", "{\"index\": 0}", "{\"index\": -1, \"time\": 0}",
                             "{\"index\": 0, \"time\": \"now\"}", "7"}) {
    EXPECT_EQ(error_for(frames).where().line, 2) << frames;
  }
  EXPECT_EQ(error_for("{\"index\": 1, \"time\": 0}, {\"index\": 1, \"time\": 1}").where().field,
            "frames[1].index");
  EXPECT_EQ(error_for("{\"index\": 1, \"time\": 0}, {\"index\": 2, \"time\": 0}").where().field,
            "frames[1].time");
}

TEST(SimulationFrames, OfAFolderWithoutResultsAreRefused) {
  const SimulationFolder folder(1);
  EXPECT_THAT(input_error_of([&] { read_simulation_frames(folder.path() / "none"); }).problem(),
              HasSubstr("no directory"));
  EXPECT_THAT(input_error_of([&] { read_simulation_frames(folder.path()); }).where().file,
              HasSubstr("simulation.json"));
}

TEST(Pictures, HaveOneCameraThatContainsEveryVertexOfEveryFrame) {
  const SimulationFolder folder(4);
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  for (const ViewDirection view : {ViewDirection::front, ViewDirection::right,
                                   ViewDirection::bottom, ViewDirection::three_quarter}) {
    PictureOptions options = small_pictures();
    options.view = view;
    const PictureSetting setting = setting_of(simulation, options, LegendPlace::in_picture, {});
    for (const SimulationFrame& frame : simulation.frames) {
      const FrameMesh mesh = read_frame(simulation.file_of(frame));
      for (const auto& vertex : mesh.positions.colwise()) {
        const Eigen::Vector2d place = project(setting.camera, options.size.aspect(), vertex);
        EXPECT_TRUE((place.array() > 0).all() && (place.array() < 1).all());
      }
    }
  }
}

TEST(Pictures, ShareTheRangeOfTheirFieldOverAllFrames) {
  const SimulationFolder folder(4);
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  PictureOptions options = small_pictures();
  options.field = "strain_weft";
  ColourScale scale = setting_of(simulation, options, LegendPlace::beside, {}).legend->scale;
  EXPECT_EQ(scale.low, 0);
  EXPECT_DOUBLE_EQ(scale.high, 0.03);
  options.colour_map = ColourMap::coolwarm;
  scale = setting_of(simulation, options, LegendPlace::beside, {}).legend->scale;
  EXPECT_DOUBLE_EQ(scale.low, -0.03);
  EXPECT_DOUBLE_EQ(scale.high, 0.03);
  options.range = {0.5, 2};
  scale = setting_of(simulation, options, LegendPlace::beside, {}).legend->scale;
  EXPECT_THAT((std::vector<double>{scale.low, scale.high}), ElementsAre(0.5, 2));
}

TEST(Pictures, HaveZeroInTheMiddleOfAFieldWithBothSigns) {
  const SimulationFolder folder(2);
  const std::string file = "sim/frames/000000.ply";
  std::string ply = test::content_of(folder.file(file));
  ply.replace(ply.find("0 0 0 0\n1"), 7, "0 0 0 -0.2");
  folder.write(file, ply);
  PictureOptions options = small_pictures();
  options.field = "strain_weft";
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  const auto scale = [&] {
    return setting_of(simulation, options, LegendPlace::beside, {}).legend->scale;
  };
  EXPECT_EQ(scale().map, ColourMap::coolwarm);
  EXPECT_EQ(scale().low, -0.2);
  EXPECT_EQ(scale().high, 0.2);
  options.range = {-0.2, 0.01};
  EXPECT_EQ(scale().map, ColourMap::viridis);
  options.range = {-1, 1};
  EXPECT_EQ(scale().map, ColourMap::coolwarm);
  options.range.reset();
  options.colour_map = ColourMap::viridis;
  EXPECT_EQ(scale().low, -0.2);
  EXPECT_EQ(scale().high, 0.01);
}

TEST(Pictures, HaveOneSideOfColoursForAFieldOfOneSign) {
  const SimulationFolder folder(2);
  PictureOptions options = small_pictures();
  options.field = "strain_weft";
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  const FieldLegend legend = *setting_of(simulation, options, LegendPlace::beside, {}).legend;
  EXPECT_EQ(legend.scale.map, ColourMap::viridis);
  EXPECT_FALSE(legend.percentiles);
}

TEST(Pictures, LeaveWhatIsNoNumberOutOfTheRange) {
  const SimulationFolder folder(2);
  const std::string file = "sim/frames/000000.ply";
  std::string ply = test::content_of(folder.file(file));
  ply.replace(ply.find("0 0 0 0\n1"), 7, "0 0 0 inf");
  folder.write(file, ply);
  PictureOptions options = small_pictures();
  options.field = "strain_weft";
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  const ColourScale scale = setting_of(simulation, options, LegendPlace::beside, {}).legend->scale;
  EXPECT_EQ(scale.low, 0);
  EXPECT_DOUBLE_EQ(scale.high, 0.01);
}

TEST(Pictures, KeepTheClothClearOfTheColourBar) {
  const SimulationFolder folder(2);
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  PictureOptions options = small_pictures();
  options.size = {400, 300};
  options.field = "strain_weft";
  const PictureSetting setting = setting_of(simulation, options, LegendPlace::in_picture, {});
  const Eigen::Vector2d right = project(setting.camera, options.size.aspect(), {1, 0, 1});
  const int bar = colour_bar_width(*setting.legend, label_style(300));
  EXPECT_LT(right.x() * 400, 400 - bar);
}

TEST(Pictures, OfAnUnknownFieldNameTheFieldsThereAre) {
  const SimulationFolder folder(2);
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  PictureOptions options = small_pictures();
  options.field = "strain_wfet";
  const InputError error =
      input_error_of([&] { setting_of(simulation, options, LegendPlace::beside, {}); });
  EXPECT_THAT(error.problem(), HasSubstr("strain_wfet"));
  EXPECT_THAT(error.expected(), HasSubstr("strain_weft"));
}

/// The square of the folder with its rest plane, of which simulation.json tells.
void add_cloth(const SimulationFolder& folder, const std::string& faces) {
  folder.write("sim/cloth.obj",
               "v 0 0 0\nv 1 0 0\nv 1 0 1\nv 0 0 1\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n" + faces);
  folder.write("sim/simulation.json",
               "{\"pliant\": \"simulation/1\", \"mesh\": \"cloth.obj\",\n"
               " \"frames\": [{\"index\": 0, \"time\": 0}]}\n");
}

TEST(Pictures, HaveLinesOnTheClothWhereItsRestShapeIsKnown) {
  const SimulationFolder folder(1);
  const auto setting = [&](const PictureOptions& options) {
    return setting_of(read_simulation_frames(folder.path() / "sim"), options,
                      LegendPlace::in_picture, {});
  };
  EXPECT_FALSE(setting(small_pictures()).lines);
  add_cloth(folder, "f 1/1 2/2 3/3\nf 1/1 3/3 4/4\n");
  PictureOptions options = small_pictures();
  ASSERT_TRUE(setting(options).lines);
  EXPECT_DOUBLE_EQ(setting(options).lines->spacing, 0.1);
  EXPECT_EQ(setting(options).lines->rest_corners.col(2), Eigen::Vector2d(1, 1));
  EXPECT_DOUBLE_EQ(setting(options).scale_bar->lines.value(), 0.1);
  options.line_spacing = 0.25;
  EXPECT_DOUBLE_EQ(setting(options).lines->spacing, 0.25);
  options.lines = false;
  EXPECT_FALSE(setting(options).lines);
}

TEST(Pictures, OfFramesThatAreAnotherMeshThanTheClothAreRefused) {
  const SimulationFolder folder(1);
  add_cloth(folder, "f 1/1 2/2 3/3\n");
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  const PictureOptions options = small_pictures();
  const PictureSetting setting = setting_of(simulation, options, LegendPlace::in_picture, {});
  const InputError error = input_error_of(
      [&] { frame_picture(simulation, simulation.frames[0], setting, options, {}); });
  EXPECT_THAT(error.problem(), HasSubstr("has 2 triangles"));
  EXPECT_THAT(error.expected(), HasSubstr("cloth.obj"));
}

TEST(Pictures, OfAClothWithoutRestPlaneAreRefused) {
  const SimulationFolder folder(1);
  add_cloth(folder, "f 1 2 3\nf 1 3 4\n");
  EXPECT_THAT(input_error_of([&] { read_cloth(folder.path() / "sim/cloth.obj"); }).problem(),
              HasSubstr("rest plane"));
}

// The square is 1 m wide and seen from the front, at the depth that the bar is for.
TEST(Pictures, HaveAScaleBarThatIsTrueInTheMiddleOfWhatIsShown) {
  const SimulationFolder folder(2);
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  const PictureOptions options = small_pictures();
  const PictureSetting setting = setting_of(simulation, options, LegendPlace::in_picture, {});
  const auto across = [&](double x) {
    return project(setting.camera, options.size.aspect(), {x, 0, 0.5}).x();
  };
  ASSERT_TRUE(setting.scale_bar);
  EXPECT_NEAR(setting.scale_bar->share, (across(1) - across(0)) * setting.scale_bar->length, 1e-9);
  EXPECT_DOUBLE_EQ(setting.scale_bar->length, 0.2);
}

TEST(ScaleBar, IsAsLongInThePictureAsItSays) {
  Image image(400, 300);
  draw_scale_bar(image, {0.05, 0.25});
  const float margin = 1.6F * label_style(300).cap_height;
  const int row = static_cast<int>(300 - margin);
  int dark = 0;
  for (int x = 0; x < static_cast<int>(margin) + 104; ++x) dark += image.at(x, row)[0] < 128;
  EXPECT_NEAR(dark, 100, 2);  // the ends are round
}

// Two plates beside the square, of which each stands in one frame.
TEST(Pictures, ShowObstaclesWhereTheyAreInEachFrame) {
  const SimulationFolder folder(2);
  for (const int frame : {0, 1}) {
    folder.write(fmt::format("sim/obstacles/{:06}.obj", frame),
                 fmt::format("v {0} 0 0\nv {1} 0 0\nv {1} 0 1\nv {0} 0 1\nf 1 2 3\nf 1 3 4\n",
                             2 + frame, 3 + frame));
  }
  const auto told_of = [&](const char* obstacles) {
    folder.write("sim/simulation.json",
                 fmt::format("{{\"pliant\": \"simulation/1\", \"obstacles\": {},\n \"frames\": "
                             "[{{\"index\": 0, \"time\": 0}}, {{\"index\": 1, \"time\": 1}}]}}\n",
                             obstacles));
    return read_simulation_frames(folder.path() / "sim");
  };
  const PictureOptions options = small_pictures();
  const SimulationFrames with = told_of("\"obstacles\""), without = told_of("null");
  const PictureSetting setting = setting_of(with, options, LegendPlace::in_picture, {});
  const auto pixel = [&](const SimulationFrames& simulation, size_t frame, double x) {
    const Image picture = frame_picture(simulation, simulation.frames[frame], setting, options, {});
    const Eigen::Vector2d place = project(setting.camera, options.size.aspect(), {x, 0, 0.5});
    EXPECT_TRUE((place.array() > 0).all() && (place.array() < 1).all()) << "it is in the picture";
    return picture.at(static_cast<int>(place.x() * picture.width()),
                      static_cast<int>(place.y() * picture.height()));
  };
  for (const double x : {2.5, 3.5}) {
    const size_t stands = x < 3 ? 0 : 1, is_gone = 1 - stands;
    EXPECT_NE(pixel(with, stands, x), pixel(without, stands, x)) << x;
    EXPECT_EQ(pixel(with, is_gone, x), pixel(without, is_gone, x)) << x;
  }
}

// The grey of obstacles is a little warm, also in shade; cloth is blue and the ground is neutral.
bool is_of_obstacle(const Pixel& pixel) { return pixel[0] > pixel[2] && pixel[0] - pixel[2] <= 12; }
bool is_of_cloth(const Pixel& pixel) { return pixel[2] > pixel[0] + 12; }

// A plate behind the square or before it, from the middle of it to half a metre beside it.
TEST(Pictures, ShowObstaclesInTheirColourWhereNothingHidesThem) {
  const SimulationFolder folder(1);
  folder.write_summary(R"({"index": 0, "time": 0})", R"(, "obstacles": "obstacles.obj")");
  for (const double y : {1.0, -1.0}) {
    folder.write("sim/obstacles.obj",
                 fmt::format("v 0.5 {0} 0\nv 1.5 {0} 0\nv 1.5 {0} 1\nv 0.5 {0} 1\nf 1 2 3 4\n", y));
    const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
    const PictureOptions options = small_pictures();
    const PictureSetting setting = setting_of(simulation, options, LegendPlace::in_picture, {});
    const Image picture = frame_picture(simulation, simulation.frames[0], setting, options, {});
    const auto pixel = [&](double x, double depth) {
      const Eigen::Vector2d place = project(setting.camera, options.size.aspect(), {x, depth, 0.5});
      return picture.at(static_cast<int>(place.x() * picture.width()),
                        static_cast<int>(place.y() * picture.height()));
    };
    const bool hides = y < 0;
    EXPECT_TRUE(is_of_obstacle(pixel(1.4, y))) << y;
    EXPECT_TRUE(is_of_cloth(pixel(0.1, 0))) << y;
    EXPECT_EQ(is_of_obstacle(pixel(0.6, y)), hides) << y;
    EXPECT_EQ(is_of_cloth(pixel(0.9, 0)), !hides) << y;
  }
}

TEST(Pictures, HaveTheSizeAskedForAndASheetHasRoomForAll) {
  const SimulationFolder folder(4);
  const SimulationFrames simulation = read_simulation_frames(folder.path() / "sim");
  PictureOptions options = small_pictures();
  const PictureSetting setting = setting_of(simulation, options, LegendPlace::in_picture, {});
  const Image picture = frame_picture(simulation, simulation.frames[1], setting, options, {});
  EXPECT_EQ(picture.width(), 120);
  EXPECT_EQ(picture.height(), 90);
  const Image sheet = sheet_picture({{&simulation, simulation.frames}}, setting, options, {});
  EXPECT_EQ(sheet.width(), 240);
  EXPECT_EQ(sheet.height(), 180);
}

}  // namespace
}  // namespace pliant
