#include "pliant/report/sheet_figures.h"

#include <algorithm>

#include "pliant/measurement/session/middle_line.h"
#include "pliant/report/force_curve.h"
#include "pliant/report/frame_choice.h"

namespace pliant::report {
namespace {

constexpr int kProfiles = 4;

Figure empty_figure(const QuantityLabel& x, const QuantityLabel& y, bool compact) {
  Figure figure;
  figure.layout = base_layout(compact);
  figure.layout["xaxis"] = axis(x, compact);
  figure.layout["yaxis"] = axis(y, compact);
  return figure;
}

int profile_axis(const Session& session) {
  return session.table ? static_cast<int>(*session.table) : 0;
}

/// The nodes along the middle of the sheet at rest, in their order.
std::vector<int> middle_nodes(const Session& session) {
  const int along = profile_axis(session);
  const Eigen::Matrix3Xd& rest = session.rest.positions;
  std::vector<int> nodes = middle_line(session.rest, along);
  std::ranges::sort(nodes, {}, [&](int node) { return rest(along, node); });
  return nodes;
}

void add_profile(const Session& session, int frame, const std::vector<int>& nodes,
                 const SeriesStyle& style, bool compact, Figure& figure) {
  const int along = profile_axis(session);
  const auto& positions = session.frames[static_cast<std::size_t>(frame)].positions;
  std::vector<double> x, z;
  for (const int node : nodes) {
    x.push_back(1e3 * positions(along, node));
    z.push_back(1e3 * positions(2, node));
  }
  figure.traces.push_back(trace(style, x, z, compact));
}

void add_curves(const std::vector<ForceCurve>& curves, const SeriesStyle& style, bool compact,
                Figure& figure) {
  for (const ForceCurve& curve : curves) {
    figure.traces.push_back(trace(style, curve.displacement, curve.force, compact));
    if (!curve.clip.empty()) figure.traces.back()["name"] = curve.clip + ", " + style.name;
  }
}

}  // namespace

Figure sheet_force_figure(const SheetSession& sheet, bool compact) {
  const std::vector<ForceCurve> measured = force_curves(sheet.measured);
  const std::vector<ForceCurve> predicted = force_curves(sheet.predicted);
  // The name of a force is longer than a small figure is high.
  const QuantityLabel& force = measured.front().of;
  const QuantityLabel shown = compact ? QuantityLabel{force.unit, ""} : force;
  Figure figure = empty_figure(measured.front().over, shown, compact);
  add_curves(predicted, kPredictedSheet, compact, figure);
  add_curves(measured, kMeasuredSheet, compact, figure);
  figure.description =
      force.name + " against " + measured.front().over.name + ", " + sheet.measured.test;
  return figure;
}

Figure sheet_profile_figure(const SheetSession& sheet, bool compact) {
  Figure figure = empty_figure({"Along the sheet", "mm"}, {"Height", "mm"}, compact);
  const std::vector<int> nodes = middle_nodes(sheet.measured);
  for (const int frame : evenly_chosen(sheet.frame_count(), kProfiles)) {
    add_profile(sheet.predicted, frame, nodes, kPredictedSheet, compact, figure);
    add_profile(sheet.measured, frame, nodes, kMeasuredSheet, compact, figure);
  }
  figure.layout["yaxis"]["scaleanchor"] = "x";
  figure.description = "Profiles of " + sheet.measured.test;
  return figure;
}

Figure sheet_figure(const SheetSession& sheet, bool compact) {
  return sheet.measured.clips.empty() ? sheet_profile_figure(sheet, compact)
                                      : sheet_force_figure(sheet, compact);
}

}  // namespace pliant::report
