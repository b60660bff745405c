#include <cmath>
#include <iostream>
#include <numbers>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/calibration_file.h"
#include "pliant/io/result_directory.h"

#include "apps/pliant/command.h"
#include "apps/pliant/import_photos.h"

namespace pliant {
namespace {

constexpr const char* kCalibrationFile = "calibration.json";

struct CalibrateArguments {
  std::string rig;
  std::string output;
};

ReadPicture required_picture_reader(const std::string& rig) {
  ReadPicture reader = picture_reader();
  if (reader) return reader;
  throw InputError(
      {rig}, "needs pictures; this program was built without OpenCV, GdkPixbuf or LibTIFF",
      "a build where they are installed (libopencv-imgproc-dev, libgdk-pixbuf-2.0-dev, "
      "libtiff-dev)");
}

std::string camera_line(const RigCalibration& found, int c) {
  const Intrinsics& own = found.bundle.cameras[c].intrinsics;
  const CameraResiduals& residuals = found.cameras[c];
  return fmt::format(
      "{}: focal length {:.1f} +- {:.1f} px, corners of {} pictures met to {:.3f} px RMS{}",
      found.names[c], own(0), found.error(c, 0), residuals.pictures, residuals.rms,
      residuals.left_out > 0 ? fmt::format(" ({} of {} left out)", residuals.left_out,
                                           residuals.corners + residuals.left_out)
                             : "");
}

std::vector<std::string> summary_lines(const RigCalibration& found) {
  std::vector<std::string> lines;
  for (int c = 0; c < std::ssize(found.names); ++c) lines.push_back(camera_line(found, c));
  for (const EpipolarResidual& pair : found.pairs) {
    lines.push_back(fmt::format("{} and {}: {} apart, corners {:.3f} px from epipolar lines, RMS",
                                found.names[pair.first], found.names[pair.second],
                                format_quantity(found.apart(pair), Dimension::length), pair.rms));
  }
  if (found.held_out) {
    lines.push_back(
        fmt::format("{} boards held out in turn: {} corners rigid to {} RMS, size {:+.3f} %",
                    found.held_out->boards, found.held_out->corners,
                    format_quantity(found.held_out->rms, Dimension::length, 3),
                    100 * found.held_out->scale_error));
  }
  if (found.length) {
    lines.push_back(fmt::format("second length: {} stated, {} +- {} measured, {:+.1f} errors apart",
                                format_quantity(found.length->stated, Dimension::length, 5),
                                format_quantity(found.length->measured, Dimension::length, 5),
                                format_quantity(found.length->error, Dimension::length, 2),
                                found.length->errors_apart()));
  }
  if (found.gravity) {
    const Eigen::Vector3d& down = found.gravity->direction;
    lines.push_back(fmt::format("gravity: along [{:.4f}, {:.4f}, {:.4f}], to {:.2f} degrees",
                                down.x(), down.y(), down.z(),
                                found.gravity->error * 180 / std::numbers::pi));
  }
  return lines;
}

void calibrate(const CalibrateArguments& arguments, CommandContext& context) {
  const RigFile rig = read_rig(arguments.rig);
  const ReadPicture reader = required_picture_reader(arguments.rig);
  ResultDirectory results(arguments.output, "calibrate");
  const RigCalibration found =
      calibrate_rig(rig, find_boards_in_pictures(rig, reader, context.run), context.run);
  results.write(kCalibrationFile, calibration_text(found, rig));
  results.write("corners.csv", corners_table(found, rig));
  results.commit();
  for (const std::string& line : summary_lines(found)) context.say(line);
  for (const std::string& warning : found.warnings) {
    context.run.progress.message(Level::warning, warning);
  }
  const auto written = std::filesystem::path(arguments.output) / kCalibrationFile;
  context.say(fmt::format("calibration: {}", written.string()));
  context.print_written_json("calibrate", written);
}

}  // namespace

void add_calibrate(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "calibrate", "Find how cameras see and where they stand, from pictures of boards");
  auto arguments = std::make_shared<CalibrateArguments>();
  command.add_option("RIG", arguments->rig, "rig/1 file: cameras, boards and their pictures")
      ->required();
  command
      .add_option("-o,--output", arguments->output,
                  "Directory for calibration.json and corners.csv (DIR)")
      ->required();
  command.footer(
      "Boards are drawn by `pliant pattern board`. Take 10 to 30 pictures that show the board all\n"
      "over each camera's picture, tilted by 20 to 45 degrees to all sides; several cameras take\n"
      "theirs at the same time. Lay a ruler or a tag of known size beside the board in some: a\n"
      "board that was printed too large cannot tell.\n"
      "  pliant calibrate rig.yaml -o calibration; pliant info calibration/calibration.json");
  registry.on(command, [arguments](CommandContext& context) { calibrate(*arguments, context); });
}

}  // namespace pliant
