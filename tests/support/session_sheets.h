#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "pliant/geometry/regular_grid.h"
#include "pliant/measurement/session.h"

#include "io/temporary_folder.h"

namespace pliant::test {

/// Vertices whose rest coordinate (0: u, 1: v) is `at`.
inline std::vector<int> vertices_at(const TriangleMesh& rest, int axis, double at) {
  std::vector<int> vertices;
  for (int i = 0; i < rest.vertex_count(); ++i) {
    if (std::abs(rest.positions(axis, i) - at) < 1e-9) vertices.push_back(i);
  }
  return vertices;
}

inline Eigen::Matrix3Xd posed(const Pose& pose, Eigen::Matrix3Xd points) {
  for (auto point : points.colwise()) point = pose.apply(point);
  return points;
}

/// A stretch of 100 mm x 100 mm of cloth, 3.1 g, along weft between two clips of 10.1 g with two
/// cords each; in frame f it is 10 f % longer, pulled by 4 f N and turned by 0.3 f rad about the
/// vertical. Cords carry the weights: forces and moments are in balance.
inline Session stretch_session(int nodes = 9, int frames = 3) {
  Session session;
  session.test = "stretch-weft";
  session.info = {{"operator", "KL"}};
  session.sample = {"12", 0.1, 0.1, 0.0031, {}};
  session.rest = regular_grid(0.1, 0.1, nodes, nodes);
  session.clips = {{"left", 0.0101, vertices_at(session.rest, 0, 0)},
                   {"right", 0.0101, vertices_at(session.rest, 0, 0.1)}};
  const double weight = (0.0031 + 2 * 0.0101) * kStandardGravity;
  for (int f = 0; f < frames; ++f) {
    const Pose turn{Eigen::Quaterniond(Eigen::AngleAxisd(0.3 * f, Eigen::Vector3d::UnitZ())),
                    Eigen::Vector3d::Zero()};
    SessionFrame frame;
    frame.positions = session.rest.positions;
    frame.positions.row(0).array() += 0.1 * f * (session.rest.positions.row(0).array() - 0.05);
    frame.positions = posed(turn, frame.positions);
    for (const double side : {-1.0, 1.0}) {
      const Eigen::Vector3d shift(side * 0.005 * f, 0, 0);
      frame.poses.push_back({turn.rotation, turn.apply(shift)});
      std::vector<CordForce> cords;
      for (const double v : {0.0, 0.1}) {
        const Eigen::Vector3d point = Eigen::Vector3d(0.05 + side * 0.05, v, 0) + shift;
        const Eigen::Vector3d force(side * 2 * f, 0, weight / 4);
        cords.push_back({v == 0 ? "front" : "back", turn.apply(point), turn.apply(force)});
      }
      frame.cords.push_back(cords);
    }
    frame.time = 2.0 * f;
    session.frames.push_back(frame);
  }
  return session;
}

/// A sheet of 100 mm x 100 mm, 310 g/m^2, that is pushed over the edge of a table, which it leaves
/// downwards at 45 degrees: the edge is at 78, 68, ... mm along warp.
inline Session bend_session(int frames = 3) {
  Session session;
  session.test = "bend-warp";
  session.sample = {"", 0.1, 0.1, {}, 0.31};
  session.rest = regular_grid(0.1, 0.1, 6, 11);
  session.table = RestAxis::v;
  for (int f = 0; f < frames; ++f) {
    SessionFrame frame;
    frame.table_edge = 0.078 - 0.01 * f;
    frame.positions = session.rest.positions;
    for (auto point : frame.positions.colwise()) {
      const double beyond = point.y() - *frame.table_edge;
      if (beyond > 0) point += beyond * Eigen::Vector3d(0, std::sqrt(0.5) - 1, -std::sqrt(0.5));
    }
    session.frames.push_back(frame);
  }
  return session;
}

/// A session's directory, to be edited and read.
class SessionFolder {
 public:
  explicit SessionFolder(const Session& session) {
    for (const auto& [name, content] : session_files(session)) folder_.write(name, content);
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string content(const std::string& name) const { return content_of(path() / name); }
  void write(const std::string& name, std::string_view content) const {
    folder_.write(name, content);
  }
  void remove(const std::string& name) const { std::filesystem::remove(path() / name); }

  /// Replaces the first place of a text in a file.
  void edit(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = content(name);
    text.replace(text.find(from), from.size(), to);
    write(name, text);
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace pliant::test
