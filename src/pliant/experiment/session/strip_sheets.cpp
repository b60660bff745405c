#include "pliant/experiment/session/strip_sheets.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/tensile/tensile_cycles.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/measurement/session/frame_measures.h"

namespace pliant {
namespace {

constexpr int kFrames = 120;           // about as many are kept of a strip's rows
constexpr int kCells = 6;              // on the shorter side of a strip
constexpr double kSlackForce = 0.005;  // of the peak: less is none

/// A row of the tester.
struct Row {
  double length = 0;    ///< of the strip between the clips (m)
  double distance = 0;  ///< of the clips (m), more or less than that where it is slack
  double force = 0;     ///< that the strip carries (N)
  int direction = 1;    ///< 1 while the clamps part
  bool used = true;
};

/// The rows of a specimen, what its clamps add to their distance taken off.
std::vector<Row> rows_of(const TensileCycles& cycles, int specimen, double force_offset,
                         const Clamps& clamps) {
  const MeasuredPath& path = cycles.path();
  const Eigen::VectorXd lengths = cycles.loop(cycles.measured())->abscissa;
  std::vector<Row> rows;
  double largest = 0;
  for (std::size_t i = 0; i < path.force.size(); ++i) {
    if (path.specimen[i] != specimen) continue;
    const double force = path.force[i] - force_offset;
    largest = std::max(largest, force);
    const double length =
        lengths(static_cast<Eigen::Index>(i)) - clamps.compliance * force - clamps.slip * largest;
    rows.push_back({length, length, force, path.direction[i], cycles.info().used[i] != 0});
  }
  return rows;
}

/// Lengths of the strip itself: at least the gauge length, and where its force has gone on the way
/// back at least what it had then, until the clamps have come there again.
void take_up_slack(std::vector<Row>& rows, double gauge_length) {
  const double peak = std::ranges::max(rows, {}, &Row::force).force;
  double least = gauge_length;
  bool slack = true;
  for (Row& row : rows) {
    const bool pulls = row.force > kSlackForce * peak;
    if (row.direction < 0 && !slack && !pulls) {
      least = std::max(row.length, gauge_length);
      slack = true;
    } else if (slack && row.length > least) {
      slack = false;
      least = gauge_length;
    }
    row.length = std::max(row.length, least);
  }
}

std::vector<Row> thinned(const std::vector<Row>& rows) {
  double way = 0;
  for (std::size_t i = 1; i < rows.size(); ++i)
    way += std::abs(rows[i].length - rows[i - 1].length);
  std::vector<Row> kept{rows.front()};
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool turns = i + 1 == rows.size() || rows[i + 1].direction != rows[i].direction;
    const double gone = std::abs(rows[i].length - kept.back().length);
    if (gone >= way / kFrames || (turns && gone > 0)) kept.push_back(rows[i]);
  }
  return kept;
}

/// The strip's axis in the rest plane, from weft (rad).
double angle_of(const ExperimentSpec& spec) {
  const auto& oblique = spec_of<TensileCyclesSpec>(spec).oblique_angle;
  if (oblique) return *oblique;
  if (spec.direction == "weft") return 0;
  return spec.direction == "warp" ? std::numbers::pi / 2 : std::numbers::pi / 4;
}

const char* test_of(const std::string& direction) {
  if (direction == "weft") return "stretch-weft";
  return direction == "warp" ? "stretch-warp" : "bias-extension";
}

Session strip_at_rest(const ExperimentSpec& spec, const ModelOptions& model, double area_density) {
  const double edge =
      model.mesh_factor *
      model.mesh_edge.value_or(std::min(spec.test->length, spec.test->width) / kCells);
  const auto nodes = [&](double side) {
    return std::max(static_cast<int>(std::lround(side / edge)), 2) + 1;
  };
  const int along = nodes(spec.test->length), across = nodes(spec.test->width);
  const TriangleMesh grid = regular_grid(spec.test->length, spec.test->width, along, across);
  const Eigen::Rotation2Dd turn(angle_of(spec));
  const Eigen::Matrix2Xd corners = turn.toRotationMatrix() * grid.positions.topRows<2>();

  Session session;
  session.kind = SessionKind::strip;
  session.test = test_of(spec.direction);
  session.gravity.setZero();
  session.rest = flat_mesh(corners, grid.triangles);
  const Eigen::Vector2d extent = corners.rowwise().maxCoeff() - corners.rowwise().minCoeff();
  session.sample = {"", extent.x(), extent.y(), std::nullopt, std::nullopt};
  if (area_density > 0) session.sample.density = area_density;
  session.clips = {{"fixed", 0, {}}, {"moving", 0, {}}};
  for (int j = 0; j < across; ++j) {
    session.clips[0].clamped.push_back(j * along);
    session.clips[1].clamped.push_back(j * along + along - 1);
  }
  return session;
}

SessionFrame frame_of(const Session& session, const ExperimentSpec& spec, const Row& row) {
  const double angle = angle_of(spec);
  const Eigen::Vector3d along(std::cos(angle), std::sin(angle), 0);
  const double stretch = row.length / spec.test->length;
  SessionFrame frame;
  frame.positions =
      session.rest.positions + (stretch - 1) * along * (along.transpose() * session.rest.positions);
  frame.poses.resize(2);
  frame.poses[1].translation = (row.length - spec.test->length) * along;
  frame.cords.resize(2);
  if (row.used) {
    const Eigen::Vector3d end = rest_middle(session, 0) + row.distance * along;
    frame.cords[1] = {{"tester", end, row.force * along}};
  }
  return frame;
}

}  // namespace

StripSheets sheets_of_strips(const ExperimentSpec& spec, const DataRows& data,
                             const ModelOptions& model, double area_density) {
  if (needs_grid(model)) {
    throw InputError(spec.where, "strips are no sheets of springs: springs lie along weft and warp",
                     "membrane: stvk or soft-constraint, and bending: discrete-shells");
  }
  const Clamps& clamps = spec_of<TensileCyclesSpec>(spec).clamps;
  if (!clamps.slip_is_known || !clamps.compliance_is_known) {
    throw InputError(spec.where,
                     "asks for what clamps add to a pull, which fits of sheets do not look for",
                     "numbers for `slip` and `compliance`, or strips in one dimension");
  }
  const TensileCycles cycles(spec, data, {area_density, model.membrane});
  StripSheets sheets;
  sheets.warnings = cycles.info().warnings;
  sheets.questions = cycles.info().questions;
  sheets.handled = spec.told;
  const Eigen::VectorXd offsets = cycles.force_offsets();
  for (int s = 0; s < static_cast<int>(offsets.size()); ++s) {
    std::vector<Row> rows = rows_of(cycles, s, offsets(s), clamps);
    const std::size_t measured = rows.size();
    take_up_slack(rows, spec.test->length);
    Session session = strip_at_rest(spec, model, area_density);
    for (const Row& row : thinned(rows)) {
      session.frames.push_back(frame_of(session, spec, row));
    }
    const std::string& specimen = cycles.info().specimens[static_cast<std::size_t>(s)];
    session.sample.id = specimen;
    sheets.handled.push_back(
        fmt::format("fitted as a sheet of {} triangles to {} of its {} rows, the force offset of "
                    "{:.4g} N taken off",
                    session.rest.triangle_count(), session.frame_count(), measured, offsets(s)));
    sheets.tests.emplace_back(offsets.size() == 1 ? spec.name : spec.name + "." + specimen,
                              std::move(session), SheetObjective::axial_clip_forces);
    sheets.tests.back().set_weight(spec.weight);
  }
  sheets.handled.emplace_back(
      "where the force has gone the strip keeps its length until the clamps come back to it; it "
      "begins at the gauge length, free of friction");
  return sheets;
}

}  // namespace pliant
