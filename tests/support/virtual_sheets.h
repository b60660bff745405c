#pragma once

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/experiment/session/sheet_equilibria.h"
#include "pliant/experiment/session/sheet_test.h"
#include "pliant/geometry/regular_grid.h"

#include "support/session_sheets.h"

namespace pliant::test {

/// A cloth whose membrane stiffness is the same at all strains, or rises with strain; its bending
/// is that of hinges.
inline Material sheet_cloth(bool stiffens) {
  Material material;
  material.name = "cloth";
  material.density = 0.2;
  material.bending_of = "hinges";
  const auto give = [&](const char* name, double from, double to) {
    material.components[name].stiffness =
        stiffens && from != to ? ScalarCurve::hermite({0, 0.5}, {from, to}, is_even(name))
                               : ScalarCurve::hermite({0}, {from}, is_even(name));
  };
  give("stretch.weft", 80, 480);
  give("stretch.warp", 200, 500);
  give("shear", 8, 24);
  give("bend.weft", 6e-6, 6e-6);
  give("bend.warp", 9e-6, 9e-6);
  give("bend.diagonal", 5e-6, 5e-6);
  return material;
}

inline Session clamped_sheet(const std::string& test, int nodes,
                             const std::vector<std::vector<int>>& clips) {
  Session session;
  session.test = test;
  session.sample = {"", 0.1, 0.1, {}, 0.2};
  session.rest = regular_grid(0.1, 0.1, nodes, nodes);
  for (size_t c = 0; c < clips.size(); ++c) {
    session.clips.push_back({"clip" + std::to_string(c), 0.01, clips[c]});
  }
  return session;
}

/// Two rows of nodes along a side: (axis, low or high).
inline std::vector<int> side(int nodes, int axis, bool high) {
  std::vector<int> found;
  for (int i = 0; i < nodes * nodes; ++i) {
    const int place = axis == 0 ? i % nodes : i / nodes;
    if (high ? place >= nodes - 2 : place <= 1) found.push_back(i);
  }
  return found;
}

/// Nodes of `side` that are not at its ends.
inline std::vector<int> middle_of_side(int nodes, int axis, bool high) {
  std::vector<int> found;
  for (const int i : side(nodes, axis, high)) {
    const int along = axis == 0 ? i / nodes : i % nodes;
    if (along >= 2 && along <= nodes - 3) found.push_back(i);
  }
  return found;
}

/// Fills in positions and, for clips, a cord each from the equilibria of a material.
inline void measure(Session& session, const Material& material) {
  for (SessionFrame& frame : session.frames) {
    if (frame.positions.size() == 0) frame.positions = session.rest.positions;
    frame.cords.assign(session.clips.size(), {CordForce{}});
  }
  SheetEquilibria equilibria(session, material);
  const auto shapes = equilibria.predict(equilibria.parameters(), {}, 2, {});
  ASSERT_TRUE(shapes.has_value()) << session.test;
  for (int f = 0; f < session.frame_count(); ++f) {
    SessionFrame& frame = session.frames[static_cast<size_t>(f)];
    frame.positions = (*shapes)[static_cast<size_t>(f)].positions;
    for (size_t c = 0; c < session.clips.size(); ++c) {
      frame.cords[c].front() = {
          "", clip_middle(session, f, static_cast<int>(c)),
          (*shapes)[static_cast<size_t>(f)].clip_forces.col(static_cast<Eigen::Index>(c))};
    }
  }
}

/// A stretch along weft (axis 0) or warp (1) up to 10 %.
inline Session virtual_stretch(const Material& material, int axis, int nodes, int frames) {
  Session session = clamped_sheet(axis == 0 ? "stretch-weft" : "stretch-warp", nodes,
                                  {side(nodes, axis, false), side(nodes, axis, true)});
  for (int f = 0; f < frames; ++f) {
    SessionFrame frame;
    const double pull = 0.0005 + 0.0045 * f / (frames - 1);
    for (const double sign : {-1.0, 1.0}) {
      Pose pose;
      pose.translation(axis) = sign * pull;
      frame.poses.push_back(pose);
    }
    frame.positions = session.rest.positions;
    frame.positions.row(axis).array() +=
        2 * pull / 0.1 * (session.rest.positions.row(axis).array() - 0.05);
    session.frames.push_back(frame);
  }
  measure(session, material);
  return session;
}

/// A picture frame, sheared by up to 0.3 rad and a little stretched.
inline Session virtual_shear(const Material& material, int nodes, int frames) {
  Session session =
      clamped_sheet("shear", nodes,
                    {middle_of_side(nodes, 0, false), middle_of_side(nodes, 0, true),
                     middle_of_side(nodes, 1, false), middle_of_side(nodes, 1, true)});
  const Eigen::Vector3d centre(0.05, 0.05, 0);
  for (int f = 0; f < frames; ++f) {
    SessionFrame frame;
    const double half = 0.15 * f / (frames - 1);
    Eigen::Matrix2d shear;
    shear << std::cos(half), std::sin(half), std::sin(half), std::cos(half);
    shear *= 1.01;
    for (int c = 0; c < 4; ++c) {
      // Sides 0 and 1 run along v, the others along u; each turns with its own direction.
      const double turn = c < 2 ? -half : half;
      Pose pose;
      pose.rotation = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
      const auto& clamped = session.clips[static_cast<size_t>(c)].clamped;
      const Eigen::Vector3d middle = session.rest.positions(Eigen::all, clamped).rowwise().mean();
      Eigen::Vector3d place = centre;
      place.head<2>() += shear * (middle - centre).head<2>();
      pose.translation = place - pose.rotation * middle;
      frame.poses.push_back(pose);
    }
    frame.positions = session.rest.positions;
    for (auto point : frame.positions.colwise()) {
      point.head<2>() = centre.head<2>() + shear * (point - centre).head<2>();
    }
    session.frames.push_back(frame);
  }
  measure(session, material);
  return session;
}

/// Pushed over a table's edge along weft (axis 0) or warp (1), 20 to 60 mm.
inline Session virtual_bend(const Material& material, int axis, int nodes, int frames) {
  Session session = clamped_sheet(axis == 0 ? "bend-weft" : "bend-warp", nodes, {});
  session.table = axis == 0 ? RestAxis::u : RestAxis::v;
  for (int f = 0; f < frames; ++f) {
    SessionFrame frame;
    frame.table_edge = 0.08 - 0.04 * f / (frames - 1);
    session.frames.push_back(frame);
  }
  measure(session, material);
  return session;
}

}  // namespace pliant::test
