#include "pliant/report/sheet_view.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "pliant/experiment/session/sheet_test.h"
#include "pliant/io/base64.h"
#include "pliant/report/frame_choice.h"
#include "pliant/report/residual_colours.h"
#include "pliant/report/sheet_camera.h"
#include "pliant/report/sheet_picture.h"

namespace pliant::report {
namespace {

using nlohmann::json;

constexpr double kSteps = std::numeric_limits<std::uint16_t>::max();

/// Little-endian, whatever the machine.
template <typename Integer>
void append(std::string& bytes, Integer value) {
  for (std::size_t byte = 0; byte < sizeof value; ++byte) {
    bytes += static_cast<char>((value >> (8 * byte)) & 0xff);
  }
}

/// The box of all coordinates, in steps.
struct Grid {
  Eigen::Vector3d low = Eigen::Vector3d::Constant(std::numeric_limits<double>::max());
  Eigen::Vector3d high = -low;
  double step = 0;  // m

  void take(const Eigen::Matrix3Xd& points) {
    low = low.cwiseMin(points.rowwise().minCoeff());
    high = high.cwiseMax(points.rowwise().maxCoeff());
    step = std::max((high - low).maxCoeff(), 1e-9) / kSteps;
  }
  void append_steps(const Eigen::Matrix3Xd& points, std::string& bytes) const {
    const Eigen::Matrix3Xd steps = ((points.colwise() - low) / step).array().round();
    for (const double value : steps.reshaped()) append(bytes, static_cast<std::uint16_t>(value));
  }
};

std::vector<int> shown_frames(const SheetSession& sheet, int most, int distorted) {
  std::vector<int> frames = evenly_chosen(sheet.frame_count(), most);
  const auto place = std::ranges::lower_bound(frames, distorted);
  if (place == frames.end() || *place != distorted) frames.insert(place, distorted);
  return frames;
}

std::string positions(const Session& session, const std::vector<int>& frames, const Grid& grid) {
  std::string bytes;
  for (const int frame : frames) {
    grid.append_steps(session.frames[static_cast<std::size_t>(frame)].positions, bytes);
  }
  return base64(bytes);
}

std::string indices(const std::vector<int>& values) {
  std::string bytes;
  for (const int value : values) append(bytes, static_cast<std::uint32_t>(value));
  return base64(bytes);
}

std::string triangles(const TriangleMesh& mesh) {
  const Eigen::VectorXi all = mesh.triangles.reshaped();
  return indices({all.begin(), all.end()});
}

json vector(const Eigen::Vector3d& v) {
  json numbers = json::array();
  for (const double value : v) numbers.push_back(std::round(value * 1e6) / 1e6);
  return numbers;
}

/// Of each clip: where it is and how its cords pull (m, N).
json forces(const Session& session, int frame) {
  json all = json::array();
  for (int clip = 0; clip < static_cast<int>(session.clips.size()); ++clip) {
    all.push_back(
        {vector(clip_middle(session, frame, clip)), vector(cord_pull(session, frame, clip))});
  }
  return all;
}

double largest(const SheetSession& sheet, int frame) {
  const std::vector<int> free = free_nodes(sheet.measured, frame);
  if (free.empty()) return 0;
  return position_residual(sheet, frame)(Eigen::all, free).colwise().norm().maxCoeff();
}

json frame_json(const SheetSession& sheet, int frame) {
  return {{"number", frame},
          {"text", fmt::format("RMS of free nodes {:.2g} mm, largest {:.2g} mm",
                               1e3 * rms_distance(sheet, frame), 1e3 * largest(sheet, frame))},
          {"measured", forces(sheet.measured, frame)},
          {"predicted", forces(sheet.predicted, frame)}};
}

}  // namespace

double largest_residual(const SheetSession& sheet) {
  double most = 0;
  for (int frame = 0; frame < sheet.frame_count(); ++frame) {
    most = std::max(most, largest(sheet, frame));
  }
  return most;
}

json sheet_view(const SheetSession& sheet, int most_frames) {
  const int distorted = most_distorted_frame(sheet.measured);
  const std::vector<int> frames = shown_frames(sheet, most_frames, distorted);
  Grid grid;
  json described = json::array();
  for (const int frame : frames) {
    for (const Session* session : {&sheet.measured, &sheet.predicted}) {
      grid.take(session->frames[static_cast<std::size_t>(frame)].positions);
    }
    described.push_back(frame_json(sheet, frame));
  }
  const SheetCamera camera = sheet_camera(sheet.measured);
  return {{"nodes", sheet.measured.rest.vertex_count()},
          {"triangles", triangles(sheet.measured.rest)},
          {"low", vector(grid.low)},
          {"step", grid.step},
          {"measured", positions(sheet.measured, frames, grid)},
          {"predicted", positions(sheet.predicted, frames, grid)},
          {"frames", std::move(described)},
          {"first", std::ranges::find(frames, distorted) - frames.begin()},
          {"frame_count", sheet.frame_count()},
          {"largest_mm", 1e3 * largest_residual(sheet)},
          {"colours", kResidualColours},
          {"magnification", kResidualMagnification},
          {"from", vector(camera.towards)},
          {"up", vector(camera.vertical)}};
}

}  // namespace pliant::report
