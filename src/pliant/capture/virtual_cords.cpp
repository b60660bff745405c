#include "pliant/capture/virtual_cords.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/io/csv_writer.h"
#include "pliant/io/yaml_text.h"

namespace pliant {
namespace {

constexpr double kRadius = 0.35e-3, kLength = 60e-3;  // of a cord that is drawn (m)
constexpr double kSlack = 1e-3;                       // N; less draws no line
constexpr double kFrameRate = 0.5;                    // Hz, [T] 3.2.1
constexpr double kLogRate = 20;                       // Hz
constexpr double kStill = 1;                          // s, around a frame

DrawnSurface cord_surface(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) {
  constexpr int kSides = 8;
  constexpr double kWhite = 0.9;
  const Eigen::Vector3d first = direction.unitOrthogonal(), second = direction.cross(first);
  DrawnSurface surface;
  surface.positions.resize(3, 2 * kSides);
  surface.triangles.resize(3, 2 * kSides);
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    const Eigen::Vector3d out = kRadius * (std::cos(angle) * first + std::sin(angle) * second);
    surface.positions.col(2 * i) = from + out;
    surface.positions.col(2 * i + 1) = from + kLength * direction + out;
    const int next = 2 * ((i + 1) % kSides);
    surface.triangles.col(2 * i) << 2 * i, next, 2 * i + 1;
    surface.triangles.col(2 * i + 1) << 2 * i + 1, next, next + 1;
  }
  surface.places = surface.positions.topRows<2>();
  surface.brightness = [](const Eigen::Vector2d&) { return kWhite; };
  return surface;
}

using ShownCord = VirtualCells::ShownCord;

/// As far as a picture shows it.
std::optional<ShownCord> shown_cord(const CameraModel& camera, const CordForce& cord) {
  constexpr double kMargin = 15;  // pixels
  constexpr int kSteps = 60;
  const auto shown = [&](double share) -> std::optional<Eigen::Vector2d> {
    const auto pixel = camera.project(cord.point + share * kLength * cord.force.normalized());
    if (!pixel || pixel->minCoeff() < kMargin || pixel->x() > camera.columns - 1 - kMargin ||
        pixel->y() > camera.rows - 1 - kMargin) {
      return std::nullopt;
    }
    return pixel;
  };
  const auto from = shown(0);
  if (!from) return std::nullopt;
  ShownCord seen{*from, *from};
  for (int i = 1; i < kSteps; ++i) {
    const auto here = shown(static_cast<double>(i) / kSteps);
    if (!here) break;
    seen.to = *here;
  }
  return seen;
}

/// The pull of a name at a clip; null where there is none.
const CordForce* cord_named(const SessionFrame& frame, std::size_t clip, const std::string& name) {
  const auto found = std::ranges::find(frame.cords[clip], name, &CordForce::cord);
  return found == frame.cords[clip].end() ? nullptr : &*found;
}

}  // namespace

std::vector<DrawnSurface> cord_surfaces(const SessionFrame& frame) {
  std::vector<DrawnSurface> surfaces;
  for (const auto& cords : frame.cords) {
    for (const CordForce& cord : cords) {
      if (cord.force.norm() < kSlack) continue;
      surfaces.push_back(cord_surface(cord.point, cord.force.normalized()));
    }
  }
  return surfaces;
}

VirtualCells::VirtualCells(const Session& session, const VirtualCameras& options,
                           const RandomStream& random)
    : session_(session), options_(options), random_(random.split("cells")) {
  constexpr double kTare = 50e-3, kSlope = 0.03;  // N
  if (session.frames.empty()) return;
  RandomStream own = random_.split("calibration");
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    for (const CordForce& cord : session.frames.front().cords[c]) {
      const double tare = 1e-3 * std::round(1e3 * own.uniform(-kTare, kTare));
      const double slope = 1 + 1e-3 * std::round(1e3 * own.uniform(-kSlope, kSlope));
      cells_.push_back({c, cord.cord, tare, slope});
    }
  }
}

std::string VirtualCells::Cell::column(const Session& session) const {
  return session.clips[clip].name + "-" + cord;
}

double VirtualCells::pull(const Cell& cell, int frame) const {
  if (frame < 0 || frame >= session_.frame_count()) return 0;
  const CordForce* cord =
      cord_named(session_.frames[static_cast<std::size_t>(frame)], cell.clip, cell.cord);
  return cord ? cord->force.norm() : 0;
}

// Between two frames the pull goes from one to the next.
double VirtualCells::pull_at(const Cell& cell, double time) const {
  const double picture = (time - options_.log_start) * kFrameRate;
  const double nearest = std::round(picture), off = picture - nearest;
  const double still = kStill * kFrameRate / 2;
  const auto frame = static_cast<int>(nearest) - 1;
  const double here = pull(cell, frame);
  if (std::abs(off) <= still) return here;
  const double next = pull(cell, off > 0 ? frame + 1 : frame - 1);
  return here + (std::abs(off) - still) / (1 - 2 * still) * (next - here);
}

std::string VirtualCells::log() const {
  std::vector<std::string> header{"time_s"};
  for (const Cell& cell : cells_) header.push_back(cell.column(session_) + "_N");
  CsvWriter csv(header);
  RandomStream noise = random_.split("log");
  const double end = options_.log_start + session_.frame_count() / kFrameRate + kStill;
  for (int row = 0; row / kLogRate <= end; ++row) {
    csv.cell(row / kLogRate);
    for (const Cell& cell : cells_) {
      const double read = pull_at(cell, row / kLogRate) / cell.slope + cell.tare;
      csv.cell(read + options_.cell_noise * noise.normal());
    }
    csv.end_row();
  }
  return csv.text();
}

VirtualCells::PointedView VirtualCells::pointed_view(
    const Cell& cell, const std::vector<CameraModel>& cameras) const {
  constexpr double kLongEnough = 25;  // pixels
  for (int f = 0; f < session_.frame_count(); ++f) {
    const CordForce* cord =
        cord_named(session_.frames[static_cast<std::size_t>(f)], cell.clip, cell.cord);
    if (!cord || cord->force.norm() < kSlack) continue;
    PointedView best{f, 0, {Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()}};
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      const auto shown = shown_cord(cameras[c], *cord);
      if (shown && shown->length() > best.shown.length()) best = {f, c, *shown};
    }
    if (best.shown.length() > kLongEnough) return best;
  }
  throw InputError(
      {},
      fmt::format("no camera sees the cord {} of the clip {} pull", cell.cord,
                  session_.clips[cell.clip].name),
      "`cameras` with a larger `picture` or `pixel`, that show what is beside the sheet");
}

std::string VirtualCells::forces_yaml(const std::string& file,
                                      const std::vector<CameraModel>& cameras,
                                      const NamePicture& picture) const {
  constexpr double kPointing = 1.5;  // pixels
  RandomStream pointing = random_.split("pointing");
  std::string text = fmt::format(
      "forces:\n  data: {}\n  rate: {} Hz\n  start: {}\n  still: {} s\n  cells:\n", file,
      kFrameRate, exact_quantity(options_.log_start, Dimension::time), 0.8 * kStill);
  for (const Cell& cell : cells_) {
    const PointedView best = pointed_view(cell, cameras);
    const auto missed = [&](const Eigen::Vector2d& pixel) {
      return fmt::format("[{:.1f}, {:.1f}]", pixel.x() + pointing.uniform(-kPointing, kPointing),
                         pixel.y() + pointing.uniform(-kPointing, kPointing));
    };
    const std::string from = missed(best.shown.from);
    text += fmt::format(
        "    - {{clip: {}, cord: {}, column: {}, tare: {:.0f} mN, slope: {:.3f}, picture: {}, "
        "along: [{}, {}]}}\n",
        session_.clips[cell.clip].name, yaml_text(cell.cord), yaml_text(cell.column(session_)),
        1e3 * cell.tare, cell.slope, picture(best.camera, best.frame), from, missed(best.shown.to));
  }
  return text;
}

}  // namespace pliant
