// How long captures take, and how much memory: rows of docs/results.md, as the program does them.

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/capture/printed_board.h"
#include "pliant/capture/wavelet_noise.h"
#include "pliant/io/text_file.h"

#include "app/picture_png.h"
#include "app/seen_session.h"
#include "capture/texture.h"
#include "support/asked_for.h"

namespace pliant::test {
namespace {

namespace fs = std::filesystem;

/// Draws what cameras see of a sheet of 100 mm whose picture frame is sheared.
/// @param cameras  of the lab
/// @return the folder of the pictures
fs::path drawn_shear(const TemporaryFolder& folder, const std::string& cameras, int frames) {
  folder.write("lab.yaml",
               fmt::format("pliant: lab/1\nmaterial: {}/examples/assumed-cloth.json\n"
                           "cameras: {{{}}}\nexperiments:\n"
                           "  - {{name: shear, type: session, test: shear, frames: {}}}\n",
                           PLIANT_SOURCE_DIR, cameras, frames));
  const ProgramRun run = run_on(folder.path(), {"lab", "lab.yaml"}, "lab");
  EXPECT_EQ(run.status, 0) << run.err;
  return folder.path() / "lab" / "shear-seen";
}

ProgramRun run_calibration(const fs::path& seen) {
  ProgramRun run = run_on(seen, {"calibrate", "rig.yaml"}, "calibration");
  EXPECT_EQ(run.status, 0) << run.err;
  return run;
}

ProgramRun run_import(const fs::path& file, int frames) {
  const std::string out = fmt::format("{}-{}", file.string(), frames);
  ProgramRun run = run_program({"import", "--dic", file.string(), "-o", out, "--quiet"});
  EXPECT_EQ(run.status, 0) << run.err;
  return run;
}

void print_cost(const std::string& what, const ProgramRun& run) {
  fmt::print("{}: {:.1f} s, {} MB\n", what, run.seconds, run.peak_memory_kb / 1024);
}

TEST(SlowCaptureSpeed, OfACalibrationByThirtyPicturesOfFourCameras) {
  if (!makes_figures()) GTEST_SKIP() << "makes a row of docs/results.md: PLIANT_FIGURES=1";
  const TemporaryFolder folder;
  print_cost("calibrate, four cameras of 1280 x 1024 pixels, 30 pictures each",
             run_calibration(drawn_shear(folder, "boards: 30", 3)));
}

/// The same few pictures again and again, whose squares move there and back.
/// @param from  the first number that there is no picture of
void repeat_pictures(const fs::path& seen, int drawn, int from, int frames) {
  for (const auto& camera : fs::directory_iterator(seen / "pictures")) {
    const auto picture = [&](int number) {
      return camera.path() / fmt::format("{:03}.png", number);
    };
    for (int f = from; f <= frames; ++f) {
      fs::create_hard_link(picture((f - 1) % drawn + 1), picture(f));
    }
  }
}

// Without forces, of which there are few.
TEST(SlowCaptureSpeed, OfTwoHundredFramesOfFourCameras) {
  if (!makes_figures()) GTEST_SKIP() << "makes a row of docs/results.md: PLIANT_FIGURES=1";
  constexpr int kDrawn = 3;
  const TemporaryFolder folder;
  const fs::path seen = drawn_shear(folder, "boards: 8", kDrawn);
  run_calibration(seen);
  std::string text = read_text_file(seen / "capture.yaml");
  text.resize(text.find("forces:"));
  text.insert(text.find("  corners: "), "  step: 4\n");
  const fs::path file = folder.write("lab/shear-seen/long.yaml", text + "mesh: 1 mm\n");
  int from = kDrawn + 1;
  for (const int frames : {20, 200}) {
    repeat_pictures(seen, kDrawn, from, frames);
    from = frames + 1;
    print_cost(fmt::format("import of four cameras, {} frames", frames), run_import(file, frames));
  }
}

/// A strip of half the picture's width and length between two labels, straight before a camera.
class StripPictures {
 public:
  StripPictures(int columns, int rows) : columns_(columns), rows_(rows), tag_(columns / 64 * 8) {
    const auto levels = noise_levels(ClothPattern(), columns, rows, kPixel);
    cloth_ = Eigen::Map<
                 const Eigen::Array<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
                 levels.data(), rows, columns)
                 .cast<float>() /
             255;
  }

  /// @param pulled  pixels by which the upper label has gone up, and the strip's end with it
  GreyPicture picture(int pulled, std::uint64_t seed) const {
    GreyPicture picture = GreyPicture::Constant(rows_, columns_, 0.9F);
    const int left = columns_ / 4, top = rows_ / 4, high = rows_ / 2;
    // Rows are nearest ones: steps of half a pixel cost what a smooth stretch does.
    for (int row = -pulled; row < high; ++row) {
      const auto from =
          std::lround(high - static_cast<double>(high) * (high - row) / (high + pulled));
      picture.row(top + row).segment(left, columns_ / 2) =
          cloth_.row(top + from).segment(left, columns_ / 2);
    }
    draw_label(1, top - pulled - tag_, /*on_its_head=*/false, picture);
    draw_label(0, top + high + tag_, /*on_its_head=*/true, picture);
    RandomStream random(seed);
    add_noise(picture, 0.01, random);
    return picture;
  }

  std::string dic() const {
    const auto length = [](int pixels) { return fmt::format("{:.4f} mm", 1e3 * kPixel * pixels); };
    return fmt::format(
        "pliant: dic/1\ntest: stretch-warp\nsample: {{width: {}, height: {}, mass: 1 g}}\n"
        "pictures: p/*.png\nlabels: {{tag: {}, edge: {}}}\n"
        "clips: [{{name: lower, side: bottom, labels: [0]}}, "
        "{{name: upper, side: top, labels: [1]}}]\n",
        length(columns_ / 2), length(rows_ / 2), length(tag_), length(tag_));
  }

 private:
  static constexpr double kPixel = 0.25e-3;  // m

  /// @param middle  row of its middle
  void draw_label(int code, int middle, bool on_its_head, GreyPicture& picture) const {
    const PrintedBoard tag({1, 1, 1.0 * tag_, tag_ / 8.0, code});
    const int top = middle - tag_ / 2, left = columns_ / 2 - tag_ / 2;
    for (int row = 0; row < tag_; ++row) {
      for (int column = 0; column < tag_; ++column) {
        const Eigen::Vector2d place(column + 0.5, tag_ - row - 0.5);  // from its lower left corner
        const double light =
            tag.at(on_its_head ? Eigen::Vector2d(Eigen::Vector2d::Constant(tag_) - place) : place);
        picture(top + row, left + column) = static_cast<float>(0.1 + 0.8 * light);
      }
    }
  }

  int columns_, rows_, tag_;  // pixels; tags' sides are whole cells
  GreyPicture cloth_;
};

TEST(SlowCaptureSpeed, OfOneCameraWithLabels) {
  if (!makes_figures()) GTEST_SKIP() << "makes a row of docs/results.md: PLIANT_FIGURES=1";
  constexpr int kFew = 2, kMany = 6;
  for (const auto& [columns, rows] :
       {std::pair(1024, 1280), std::pair(1224, 1632), std::pair(3000, 4000)}) {
    const StripPictures strip(columns, rows);
    const TemporaryFolder folder;
    const fs::path file = folder.write("pull.yaml", strip.dic());
    std::vector<ProgramRun> runs;
    for (int f = 0; f < kMany; ++f) {
      folder.write(fmt::format("p/{}.png", f),
                   png_of(strip.picture(rows / 200 * f, static_cast<std::uint64_t>(f))));
      if (f + 1 == kFew || f + 1 == kMany) runs.push_back(run_import(file, f + 1));
    }
    fmt::print("import of one camera, {} x {} pixels: {:.2f} s a frame ({:.1f} s of {}), {} MB\n",
               columns, rows, (runs[1].seconds - runs[0].seconds) / (kMany - kFew), runs[1].seconds,
               kMany, runs[1].peak_memory_kb / 1024);
  }
}

}  // namespace
}  // namespace pliant::test
