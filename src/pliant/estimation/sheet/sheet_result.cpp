#include "pliant/estimation/sheet/sheet_result.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/experiment/session/sheet_system.h"
#include "pliant/measurement/session/fold_error.h"
#include "pliant/measurement/session/frame_measures.h"
#include "pliant/measurement/session/middle_line.h"

namespace pliant {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Rows of an experiment's table.
struct Rows {
  std::vector<std::string> frame, what, axis;
  std::vector<double> strain, measured, predicted;
  std::vector<char> used;

  /// @param found  NaN in a frame without equilibrium
  void add(int at, std::string named, std::string along, double travel, double seen, double found) {
    frame.push_back(std::to_string(at));
    what.push_back(std::move(named));
    axis.push_back(std::move(along));
    strain.push_back(travel);
    measured.push_back(seen);
    predicted.push_back(found);
    used.push_back(std::isnan(found) ? 0 : 1);
  }
};

/// Between the clips of a strip at rest (m).
double gauge_length(const Session& session) {
  return (rest_middle(session, 1) - rest_middle(session, 0)).norm();
}

/// How far a test has gone, as a strain.
double relative_travel(const SheetTest& test, int frame) {
  const Session& session = test.session();
  const bool strip =
      test.objective() == SheetObjective::axial_clip_forces && session.clips.size() == 2;
  const double side = std::max(session.sample.width, session.sample.height);
  return travel(session, frame) / (strip ? gauge_length(session) : side);
}

/// Free nodes that were seen along the middle of a sheet that hangs over a table, or of any other
/// along weft.
std::vector<int> middle_nodes(const Session& session, int frame) {
  const int along = session.table ? static_cast<int>(*session.table) : 0;
  const SessionFrame& now = session.frames[static_cast<std::size_t>(frame)];
  const std::vector<int> held = held_nodes(session, now.table_edge);
  std::vector<int> nodes;
  for (const int node : middle_line(session.rest, along)) {
    if (std::ranges::binary_search(held, node)) continue;
    if (!std::ranges::binary_search(now.unseen, node)) nodes.push_back(node);
  }
  return nodes;
}

void add_heights(const SheetTest& test, int frame, const std::optional<SheetShape>& shape,
                 Rows& rows) {
  const Session& session = test.session();
  const int along = session.table ? static_cast<int>(*session.table) : 0;
  for (const int node : middle_nodes(session, frame)) {
    const double place = 1e3 * session.rest.positions(along, node);
    rows.add(frame, fmt::format("{:.4g} mm", place), "z", relative_travel(test, frame),
             session.frames[static_cast<std::size_t>(frame)].positions(2, node),
             shape ? shape->positions(2, node) : kNone);
  }
}

void add_forces(const SheetTest& test, int frame, const std::optional<SheetShape>& shape,
                Rows& rows) {
  const Session& session = test.session();
  const Eigen::VectorXd seen = test.measured(frame);
  const Eigen::VectorXd found =
      shape ? test.predicted(frame, *shape) : Eigen::VectorXd::Constant(seen.size(), kNone);
  const bool parallel = test.objective() == SheetObjective::parallel_clip_forces;
  const char* own_axis = parallel ? "parallel" : "axial";
  Eigen::Index row = 0;
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    if (session.frames[static_cast<std::size_t>(frame)].cords[c].empty()) continue;
    for (const char* axis : {"x", "y", "z"}) {
      rows.add(frame, session.clips[c].name, test.compares_one_axis() ? own_axis : axis,
               relative_travel(test, frame), seen(row), found(row));
      ++row;
      if (test.compares_one_axis()) break;
    }
  }
}

/// 1 where the clips go on, -1 where they return.
std::vector<int> directions(const std::vector<double>& travels) {
  std::vector<int> direction(travels.size(), 1);
  for (std::size_t i = 0; i < travels.size(); ++i) {
    std::size_t before = i;
    while (before > 0 && travels[before] == travels[i]) --before;
    if (travels[before] != travels[i]) direction[i] = travels[before] < travels[i] ? 1 : -1;
  }
  return direction;
}

/// Where a force has a moment, but for the part of it along the force, from where it has none (m).
/// @param longest  a force that is next to nothing would have to be anywhere
Eigen::Vector3d arm_of(const Eigen::Vector3d& force, const Eigen::Vector3d& moment,
                       double longest) {
  constexpr double kNoForce = 1e-12;  // N
  if (force.norm() < kNoForce) return Eigen::Vector3d::Zero();
  const Eigen::Vector3d arm = force.cross(moment) / force.squaredNorm();
  return arm * (longest / std::max(arm.norm(), longest));
}

std::vector<int> found_frames(const FrameShapes& shapes) {
  std::vector<int> frames;
  for (std::size_t f = 0; f < shapes.size(); ++f) {
    if (shapes[f]) frames.push_back(static_cast<int>(f));
  }
  return frames;
}

}  // namespace

Session predicted_session(const Session& measured, const FrameShapes& shapes) {
  const std::vector<int> found = found_frames(shapes);
  const double diagonal = std::hypot(measured.sample.width, measured.sample.height);
  Session predicted = with_frames(measured, found);
  for (int f = 0; f < predicted.frame_count(); ++f) {
    const SheetShape& shape = *shapes[static_cast<std::size_t>(found[static_cast<std::size_t>(f)])];
    SessionFrame& frame = predicted.frames[static_cast<std::size_t>(f)];
    frame.positions = shape.positions;
    frame.unseen.clear();
    for (std::size_t c = 0; c < frame.cords.size(); ++c) {
      if (frame.cords[c].empty()) continue;
      const auto clip = static_cast<Eigen::Index>(c);
      const Eigen::Vector3d middle = clip_middle(predicted, f, static_cast<int>(c));
      const Eigen::Vector3d force = shape.clip_forces.col(clip),
                            moment = shape.clip_moments.col(clip);
      const Eigen::Vector3d point = measured.kind == SessionKind::strip
                                        ? frame.cords[c].front().point
                                        : middle + arm_of(force, moment, diagonal);
      frame.cords[c] = {{"", point, force}};
    }
  }
  return predicted;
}

ExperimentResult compare_sheet(const SheetTest& test, const FrameShapes& shapes) {
  const Session& session = test.session();
  ExperimentResult result;
  result.name = test.name();
  result.type = test.info().type;
  result.direction = session.test;
  result.quantity = test.info().quantity;
  Rows rows;
  double squares = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    const std::optional<SheetShape>& shape = shapes[static_cast<std::size_t>(frame)];
    const int compared = test.compared(frame);
    if (shape) {
      squares += (test.predicted(frame, *shape) - test.measured(frame)).squaredNorm();
      result.points += compared;
    } else {
      result.excluded += compared;
    }
    if (test.objective() == SheetObjective::positions)
      add_heights(test, frame, shape, rows);
    else
      add_forces(test, frame, shape, rows);
  }
  const auto as_vector = [](const std::vector<double>& values) -> Eigen::VectorXd {
    return Eigen::Map<const Eigen::VectorXd>(values.data(),
                                             static_cast<Eigen::Index>(values.size()));
  };
  result.measured = as_vector(rows.measured);
  result.predicted = as_vector(rows.predicted);
  // Errors are distances and forces in space, as in [T] Tables A.1-A.4.
  result.rms = std::sqrt(squares / std::max(result.points, 1));
  const bool positions = test.objective() == SheetObjective::positions;
  const double side = std::max(session.sample.width, session.sample.height);
  result.peak_force = positions ? 0 : result.measured.cwiseAbs().maxCoeff();
  result.rms_percent = 100 * result.rms / (positions ? side : std::max(result.peak_force, 1e-12));
  result.specimens = {session.sample.id.empty() ? "1" : session.sample.id};
  result.noise = result.rms;
  result.noise_source = "from the residuals";
  result.columns = {
      {"frame", rows.frame}, {positions ? "place" : "clip", rows.what}, {"axis", rows.axis}};
  result.strain = rows.strain;
  result.strain_range = {*std::ranges::min_element(rows.strain),
                         *std::ranges::max_element(rows.strain)};
  result.direction_of_row = directions(rows.strain);
  result.specimen_of_row.assign(rows.frame.size(), 0);
  result.used = rows.used;
  result.sheet = SheetComparison{session, predicted_session(session, shapes), found_frames(shapes)};
  if (session.kind == SessionKind::sheet) {
    result.folds = fold_error(with_frames(session, result.sheet->frames), result.sheet->predicted);
  }
  return result;
}

}  // namespace pliant
