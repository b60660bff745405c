#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/median.h"
#include "pliant/measurement/session.h"
#include "pliant/measurement/session/balance.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

/// Smallest and largest of some numbers.
struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();

  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool is_empty() const { return low > high; }
  Json json() const { return is_empty() ? Json(nullptr) : Json{{"min", low}, {"max", high}}; }
  std::string text(Dimension dimension, const char* none) const {
    if (is_empty()) return none;
    return fmt::format("{} to {}", format_quantity(low, dimension, kInfoDigits),
                       format_quantity(high, dimension, kInfoDigits));
  }
};

std::string extents_text(const Eigen::Vector2d& extents) {
  return fmt::format("{} x {}", format_quantity(extents.x(), Dimension::length),
                     format_quantity(extents.y(), Dimension::length));
}

void describe_sample(const Session& session, FileInfo& info) {
  const SessionSample& sample = session.sample;
  const double density = area_density(session);
  const double mass = vertex_masses(session).sum();
  info.json["sample"] = {{"id", sample.id},
                         {"width", sample.width},
                         {"height", sample.height},
                         {"mass", mass},
                         {"density", density}};
  const std::string id = sample.id.empty() ? "" : sample.id + ", ";
  info.lines.push_back(labelled(
      "sample", fmt::format("{}{}, {}, {}", id, extents_text({sample.width, sample.height}),
                            format_quantity(mass, Dimension::mass),
                            format_quantity(density, Dimension::area_density))));
}

void describe_mesh(const Session& session, FileInfo& info) {
  const TriangleMesh& mesh = session.rest;
  const Eigen::Vector2d extents =
      mesh.rest_corners.rowwise().maxCoeff() - mesh.rest_corners.rowwise().minCoeff();
  info.json["vertices"] = mesh.vertex_count();
  info.json["triangles"] = mesh.triangle_count();
  info.json["size"] = {extents.x(), extents.y()};
  info.json["rest_area"] = rest_area(mesh);
  info.lines.push_back(
      labelled("mesh", fmt::format("{} vertices, {} triangles, {} at rest", mesh.vertex_count(),
                                   mesh.triangle_count(), extents_text(extents))));
}

Range times_of(const Session& session) {
  Range times;
  for (const SessionFrame& frame : session.frames) {
    if (frame.time) times.add(*frame.time);
  }
  return times;
}

void describe_frames(const Session& session, FileInfo& info) {
  const Range times = times_of(session);
  info.json["frames"] = session.frames.size();
  info.json["time"] = times.json();
  info.lines.push_back(labelled("frames", fmt::format("{}", session.frames.size())));
  info.lines.push_back(labelled("time", times.text(Dimension::time, "not told"), 1));
}

/// Of the positions, where every frame tells them: the median along each axis (m).
void describe_deviations(const Session& session, FileInfo& info) {
  std::array<std::vector<double>, 3> along;
  for (const SessionFrame& frame : session.frames) {
    if (frame.deviations.cols() == 0) return;
    for (std::size_t axis = 0; axis < along.size(); ++axis) {
      for (const double deviation : frame.deviations.row(static_cast<Eigen::Index>(axis))) {
        if (std::isfinite(deviation)) along[axis].push_back(deviation);
      }
    }
  }
  std::vector<std::string> texts;
  for (std::vector<double>& deviations : along) {
    if (deviations.empty()) return;
    const double middle = median(std::move(deviations));
    info.json["position_deviation"].push_back(middle);
    texts.push_back(format_quantity(middle, Dimension::length, 2));
  }
  info.lines.push_back(
      labelled("positions", fmt::format("to {} along x, y, z", fmt::join(texts, ", "))));
}

/// Sizes of the cords' forces, of one clip or of all.
Range forces_of(const Session& session, std::optional<std::size_t> clip = {}) {
  Range forces;
  for (const SessionFrame& frame : session.frames) {
    for (std::size_t c = 0; c < frame.cords.size(); ++c) {
      if (clip && *clip != c) continue;
      for (const CordForce& cord : frame.cords[c]) forces.add(cord.force.norm());
    }
  }
  return forces;
}

void describe_clips(const Session& session, FileInfo& info) {
  info.json["clips"] = Json::array();
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    const SessionClip& clip = session.clips[c];
    const Range forces = forces_of(session, c);
    info.json["clips"].push_back({{"name", clip.name},
                                  {"mass", clip.mass},
                                  {"clamped", clip.clamped.size()},
                                  {"force", forces.json()}});
    info.lines.push_back(
        labelled("clip " + clip.name,
                 fmt::format("{}, {} {}, cords {}", format_quantity(clip.mass, Dimension::mass),
                             clip.clamped.size(), clip.clamped.size() == 1 ? "vertex" : "vertices",
                             forces.text(Dimension::force, "none"))));
  }
  info.json["force"] = forces_of(session).json();
  info.lines.push_back(
      labelled("forces of cords", forces_of(session).text(Dimension::force, "none")));
}

void describe_table(const Session& session, FileInfo& info) {
  info.json["table"] = nullptr;
  if (!session.table) return;
  const char* axis = *session.table == RestAxis::u ? "x" : "y";
  Range edges;
  for (const SessionFrame& frame : session.frames) edges.add(frame.table_edge.value());
  info.json["table"] = {{"axis", axis}, {"edge", edges.json()}};
  info.lines.push_back(labelled(
      "table", fmt::format("edge at {} = {}", axis, edges.text(Dimension::length, "nowhere"))));
}

void describe_imbalance(const Session& session, FileInfo& info) {
  info.json["largest_imbalance"] = nullptr;
  if (session.table) return;  // what the table carries is not known
  int worst = 0;
  for (int f = 1; f < session.frame_count(); ++f) {
    if (imbalance(session, f).force.norm() > imbalance(session, worst).force.norm()) worst = f;
  }
  const Imbalance left = imbalance(session, worst);
  info.json["largest_imbalance"] = {
      {"frame", worst}, {"force", left.force.norm()}, {"moment", left.moment.norm()}};
  info.json["balance_bound"] = session.balance_bound;
  info.lines.push_back(
      labelled("largest imbalance",
               fmt::format("{} and {} N m in frame {}; to be expected of cords: {} each",
                           format_quantity(left.force.norm(), Dimension::force, kInfoDigits),
                           format_number(left.moment.norm(), kInfoDigits), worst,
                           format_quantity(session.balance_bound, Dimension::force))));
}

/// A session is read by its directory.
std::filesystem::path directory_of(const std::filesystem::path& path) {
  if (std::filesystem::is_directory(path)) return path;
  if (path.filename() == "session.yaml") return std::filesystem::absolute(path).parent_path();
  throw InputError({path.string(), 0, ""}, "a session under another name",
                   "session.yaml in a directory of its own");
}

}  // namespace

FileInfo session_info(const std::filesystem::path& path) {
  const Session session = read_session(directory_of(path));
  FileInfo info = begin_info(path, "session/1");
  info.json["test"] = session.test;
  info.lines.push_back(labelled("test", session.test));
  describe_sample(session, info);
  describe_mesh(session, info);
  describe_frames(session, info);
  describe_deviations(session, info);
  describe_clips(session, info);
  describe_table(session, info);
  describe_imbalance(session, info);
  info.warnings = session.questions;
  info.warnings.insert(info.warnings.end(), session.warnings.begin(), session.warnings.end());
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
