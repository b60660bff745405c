#include <numbers>

#include <fmt/format.h>

#include "pliant/base/number_with_error.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/calibration_file.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

std::string board_text(const CalibrationBoard& board) {
  if (const auto* chessboard = std::get_if<Chessboard>(&board.kind)) {
    return fmt::format("chessboard of {} x {} corners {} apart", chessboard->columns,
                       chessboard->rows, format_quantity(chessboard->square, Dimension::length));
  }
  const auto& tags = std::get<TagBoard>(board.kind);
  return fmt::format("{} x {} tags of {}, codes {} to {}", tags.columns, tags.rows,
                     format_quantity(tags.tag, Dimension::length), tags.first_code,
                     tags.first_code + tags.tag_count() - 1);
}

}  // namespace

FileInfo rig_info(const std::filesystem::path& path) {
  const RigFile rig = read_rig(path);
  FileInfo info = begin_info(path, "rig/1");
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    std::size_t pictures = 0;
    for (const RigPictureSet& set : rig.pictures) pictures += set.files[c].size();
    info.json["cameras"].push_back({{"name", rig.cameras[c].name}, {"pictures", pictures}});
    info.lines.push_back(
        labelled("camera " + rig.cameras[c].name, fmt::format("{} pictures of boards", pictures)));
  }
  for (const CalibrationBoard& board : rig.boards) {
    info.json["boards"].push_back(board.name);
    info.lines.push_back(labelled("board " + board.name, board_text(board)));
  }
  const bool has_length = rig.second_length.has_value();
  info.json["second_length"] = has_length ? Json(rig.second_length->length) : Json(nullptr);
  info.lines.push_back(labelled(
      "second length",
      has_length ? format_quantity(rig.second_length->length, Dimension::length) : "none"));
  return info;
}

FileInfo calibration_info(const std::filesystem::path& path) {
  const CalibratedRig rig = read_calibration(path);
  FileInfo info = begin_info(path, "calibration/1");
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const CameraModel& camera = rig.cameras[c];
    const int first = kCameraNumbers * c;
    const double error = std::sqrt(std::max(0.0, rig.covariance(first, first)));
    info.json["cameras"].push_back({{"name", rig.names[c]},
                                    {"columns", camera.columns},
                                    {"rows", camera.rows},
                                    {"focal_length", camera.intrinsics(0)},
                                    {"error", error},
                                    {"rms", rig.rms[c]}});
    const std::string focal_length = error > 0 ? number_with_error(camera.intrinsics(0), error)
                                               : fmt::format("{:.1f}", camera.intrinsics(0));
    info.lines.push_back(
        labelled("camera " + rig.names[c],
                 fmt::format("{} x {}, focal length {} px, corners met to {:.3f} px",
                             camera.columns, camera.rows, focal_length, rig.rms[c])));
    const Eigen::Vector3d centre = camera.centre().array() + 0.0;  // no -0
    info.lines.push_back(labelled(
        "at", fmt::format("[{:.4f}, {:.4f}, {:.4f}] m", centre.x(), centre.y(), centre.z()), 1));
  }
  if (rig.gravity) {
    const Eigen::Vector3d& down = *rig.gravity;
    info.lines.push_back(labelled(
        "gravity along", fmt::format("[{:.4f}, {:.4f}, {:.4f}]", down.x(), down.y(), down.z())));
  }
  info.warnings = rig.warnings;
  info.json["warnings"] = rig.warnings;
  return info;
}

}  // namespace pliant
