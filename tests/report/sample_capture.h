#pragma once

#include "pliant/geometry/regular_grid.h"
#include "pliant/report/capture_report.h"

namespace pliant::testing {

/// A strip that two cameras saw, pulled by two cords, in four frames, of which one was left out and
/// one lies on a table.
inline DicSession sample_capture() {
  DicSession made;
  Session& session = made.session;
  session.sample = {"", 0.04, 0.08, std::nullopt, 0.15};
  session.rest = regular_grid(0.04, 0.08, 3, 5);
  session.noise.position = 3e-6;
  made.spacing = 2e-3;
  made.cameras = {"left", "right & low"};
  for (int f = 0; f < 4; ++f) {
    made.lost.push_back(f);
    made.unseen.push_back(f);
    made.nearer.push_back(0);
    made.qualities.emplace_back();
    if (f == 2) continue;
    SightQuality& quality = made.qualities.back().emplace();
    quality.miss = 0.01 * f;
    quality.share = {1, 0.9 - 0.2 * f};
    quality.matches = {0.002, 0.01 * f, 100, f};
  }
  made.used = {1, 3};
  made.time = {2.4, 4.4, 6.4, 8.4};
  made.slack = {0};
  made.left_out = {{2, "shows the label 3 not at all"}};
  // What pulls up is not all answered in the second of them.
  session.gravity.setZero();
  session.balance_bound = 0.125;
  session.clips = {{"lower", 0, {0, 1, 2}}, {"upper", 0, {12, 13, 14}}};
  for (const double left : {0.0, 0.5}) {
    SessionFrame& frame = session.frames.emplace_back();
    frame.positions = session.rest.positions;
    frame.poses.resize(2);
    frame.cords = {{{"front", {0.02, 0, 0}, {0, -1, 0}}},
                   {{"front", {0.02, 0.08, 0}, {0, 1 + left, 0}}}};
  }
  for (int c = 0; c < 2; ++c) {
    RegionMisses misses(640, 480);
    misses.add({100, 100}, {0.1, -0.05});
    misses.add({400, 300}, {-0.02, 0.01});
    made.misses.push_back(misses);
  }
  return made;
}

/// A grey picture of 4 x 4 pixels, with three of the mesh's vertices in it.
inline ShownView sample_view(const DicSession& made) {
  ShownView view;
  view.frame = 3;
  view.camera = made.cameras[1];
  view.png = "not a picture";
  view.columns = view.rows = 4;
  view.vertices = Eigen::Matrix2Xd::Constant(2, made.session.rest.vertex_count(), NAN);
  view.vertices.col(0) << 0, 0;
  view.vertices.col(1) << 2, 0;
  view.vertices.col(2) << 3, 0.25;
  return view;
}

inline std::string sample_capture_report() {
  const DicSession made = sample_capture();
  return make_capture_report({"pull",
                              made,
                              frame_doubts(made),
                              {"points lie 2 mm apart"},
                              {"no `forces` <told>"},
                              {sample_view(made)}});
}

}  // namespace pliant::testing
