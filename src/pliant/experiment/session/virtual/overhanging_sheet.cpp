#include "pliant/experiment/session/virtual/overhanging_sheet.h"

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/session/make_predictor.h"
#include "pliant/solver/elastica/strip_release.h"

namespace pliant {
namespace {

/// The law of the bending alone, without friction.
ComponentLaw elastic_law(const Material& material, const std::string& component) {
  ComponentLaw law = *law_of(material, component);
  law.friction_law = FrictionLaw::none;
  return law;
}

/// Vertices beyond the edge along the profile of a strip that hangs from it: where the search for
/// the sheet's own shape begins.
Eigen::Matrix3Xd hanging_shape(const Session& session, const ComponentLaw& law, double weight,
                               double edge) {
  const auto axis = static_cast<int>(*session.table);
  Eigen::Matrix3Xd positions = session.rest.positions;
  const double length = positions.row(axis).maxCoeff() - edge;
  const Elastica strip(length);
  StripHistory history = strip.rested(law);
  const auto shape = released(strip, law, weight, {}, /*with_derivatives=*/false, history);
  if (!shape) return positions;
  const StripProfile profile = strip.profile({}, *shape);
  for (auto position : positions.colwise()) {
    const double beyond = position(axis) - edge;
    if (beyond <= 0) continue;
    const Eigen::Vector2d at = profile.at(beyond).position;
    position(axis) = edge + at.x();
    position.z() = at.y();
  }
  return positions;
}

}  // namespace

void push_over_edge(const Material& material, const VirtualSession& options,
                    const SessionWork& work, Session& session) {
  const bool weft = options.test == "bend-weft";
  const std::string component = weft ? "bend.weft" : "bend.warp";
  session.table = weft ? RestAxis::u : RestAxis::v;
  const double length = weft ? options.width : options.height;
  const ComponentLaw law = elastic_law(material, component);
  for (int f = 0; f < options.frames; ++f) {
    work.stop.throw_if_requested();
    SessionFrame frame;
    frame.table_edge = length - options.amplitude * (f + 1) / options.frames;
    frame.positions =
        hanging_shape(session, law, material.density * session.gravity.norm(), *frame.table_edge);
    session.frames.push_back(std::move(frame));
  }

  const std::unique_ptr<SheetPredictor> sheet = make_predictor(session, material);
  const auto shapes = sheet->predict(sheet->parameters(), {}, 1, work.stop);
  if (!shapes) {
    throw SolverError(
        fmt::format("virtual session {}: the sheet over the edge of the table", work.name), 0, 0);
  }
  session.warnings.insert(session.warnings.end(), sheet->warnings().begin(),
                          sheet->warnings().end());
  for (std::size_t f = 0; f < session.frames.size(); ++f) {
    session.frames[f].positions = (*shapes)[f].positions;
  }
  work.done(options.frames);
}

}  // namespace pliant
