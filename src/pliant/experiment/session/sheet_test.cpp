#include "pliant/experiment/session/sheet_test.h"

#include <algorithm>
#include <map>
#include <utility>

#include <Eigen/SVD>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/session/session_predictor.h"
#include "pliant/experiment/session/session_type.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/geometry/mesh_quality.h"

namespace pliant {
namespace {

/// The direction in which a clip's vertices lie in a line, in a frame.
Eigen::Vector3d direction_of(const Session& session, int frame, int clip) {
  const SessionClip& body = session.clips[static_cast<std::size_t>(clip)];
  const Eigen::Matrix3Xd at = session.rest.positions(Eigen::all, body.clamped);
  // At least three columns, which the decomposition needs of any clip.
  Eigen::Matrix3Xd ways = Eigen::Matrix3Xd::Zero(3, std::max<Eigen::Index>(at.cols(), 3));
  ways.leftCols(at.cols()) = at.colwise() - at.rowwise().mean();
  const Eigen::JacobiSVD<Eigen::Matrix3Xd> svd(ways, Eigen::ComputeThinU);
  const Pose& pose =
      session.frames[static_cast<std::size_t>(frame)].poses[static_cast<std::size_t>(clip)];
  return pose.rotation * svd.matrixU().col(0);
}

/// Away from the middle of all other clips, in a frame.
Eigen::Vector3d away_from_others(const Session& session, int frame, int clip) {
  Eigen::Vector3d others = Eigen::Vector3d::Zero();
  for (int other = 0; other < static_cast<int>(session.clips.size()); ++other) {
    if (other != clip) others += clip_middle(session, frame, other);
  }
  others /= std::max(static_cast<double>(session.clips.size()) - 1, 1.0);
  return (clip_middle(session, frame, clip) - others).normalized();
}

/// @throws InputError where a sheet is not held, or forces are compared along directions that its
///         clips do not have
void require_directions(const Session& session, SheetObjective objective, const std::string& name) {
  if (session.clips.empty() && !session.table) {
    throw InputError({}, fmt::format("nothing holds the sheet of {}", name),
                     "a session with `clips` or a `table`");
  }
  if (objective == SheetObjective::axial_clip_forces && session.clips.size() < 2) {
    throw InputError({}, fmt::format("{} has no second clip to pull away from", name),
                     "two clips at least for axial-clip-forces");
  }
  if (objective != SheetObjective::parallel_clip_forces) return;
  for (const SessionClip& clip : session.clips) {
    if (clip.clamped.size() > 1) continue;
    throw InputError(
        {}, fmt::format("clip {} of {} clamps one vertex and has no direction", clip.name, name),
        "two vertices at least for parallel-clip-forces");
  }
}

bool is_without_force(const SheetTest& test) {
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    if (!test.measured(frame).isZero(0)) return false;
  }
  return true;
}

}  // namespace

SheetObjective usual_objective(const Session& session) {
  if (session.test == "shear") return SheetObjective::parallel_clip_forces;
  for (const SessionFrame& frame : session.frames) {
    for (const auto& cords : frame.cords) {
      if (!cords.empty()) return SheetObjective::clip_forces;
    }
  }
  return SheetObjective::positions;
}

std::vector<std::string> usual_components(std::string_view test) {
  if (test == "stretch-weft") return {"stretch.weft"};
  if (test == "stretch-warp") return {"stretch.warp"};
  if (test == "shear" || test == "bias-extension") return {"shear"};
  if (test == "bend-weft") return {"bend.weft"};
  if (test == "bend-warp") return {"bend.warp"};
  return {};
}

SheetTest::SheetTest(std::string name, Session session, SheetObjective objective,
                     CordFriction friction)
    : session_(std::move(session)), objective_(objective), friction_(friction) {
  info_.name = std::move(name);
  info_.type = session_type().name;
  info_.test = session_type().facts;
  info_.direction = session_.test;
  info_.quantity = objective == SheetObjective::positions
                       ? MeasuredQuantity{"height_mm", "distance", "mm", 1e3}
                       : MeasuredQuantity{"force_N", "force", "N", 1};
  require_directions(session_, objective_, info_.name);
  if (friction_.unknown || friction_.width > 0) cords_ = cord_drags(session_);
  if (friction_.unknown) add_cords();
  for (int frame = 0; frame < frame_count(); ++frame) {
    compared_.push_back(compared_in(frame));
    const Eigen::VectorXd own = measured(frame);
    measured_.conservativeResize(measured_.size() + own.size());
    measured_.tail(own.size()) = own;
  }
  deviation_ = mean_deviation();
  if (rows() == 0) {
    throw InputError(
        {},
        fmt::format("the session of {} has no {} to compare", info_.name,
                    objective_ == SheetObjective::positions ? "free vertices" : "forces of cords"),
        objective_ == SheetObjective::positions ? "vertices that neither clip nor table holds"
                                                : "rows in cords.csv");
  }
  if (objective_ != SheetObjective::positions && is_without_force(*this)) {
    throw InputError({},
                     fmt::format("all forces of cords in the session of {} are zero", info_.name),
                     "forces in newtons, or `objective: positions`");
  }
}

SheetTest SheetTest::without(const std::vector<int>& frames) const {
  Session session = session_;
  for (auto frame = frames.rbegin(); frame != frames.rend(); ++frame) {
    session.frames.erase(session.frames.begin() + *frame);
  }
  SheetTest kept(info_.name, std::move(session), objective_, friction_);
  kept.set_weight(info_.weight);
  return kept;
}

void SheetTest::add_cords() {
  constexpr double kFriction = 0.1;  // N, [T] 3.2.3
  for (const CordDrag& cord : cords_) {
    const std::string& clip = session_.clips[static_cast<std::size_t>(cord.clip)].name;
    NuisanceParameter width;
    width.name = fmt::format("{}.{}.{}.cord_friction", info_.name, clip, cord.cord);
    width.unit = std::string(1, 'N');
    width.upper = kNoBound;
    width.scale = kFriction;
    width.prior = GaussianPrior{0, kFriction};
    width.together = info_.name + "." + clip;
    nuisance_.push_back(std::move(width));
  }
}

SheetTest::Compared SheetTest::compared_in(int frame) const {
  const SessionFrame& now = session_.frames[static_cast<std::size_t>(frame)];
  Compared compared;
  if (objective_ == SheetObjective::positions) {
    std::vector<char> left_out(static_cast<std::size_t>(session_.rest.vertex_count()), 0);
    for (const int node : held_nodes(session_, now.table_edge)) {
      left_out[static_cast<std::size_t>(node)] = 1;
    }
    for (const int node : now.unseen) left_out[static_cast<std::size_t>(node)] = 1;
    for (int node = 0; node < session_.rest.vertex_count(); ++node) {
      if (!left_out[static_cast<std::size_t>(node)]) compared.nodes.push_back(node);
    }
    return compared;
  }
  for (int clip = 0; clip < static_cast<int>(session_.clips.size()); ++clip) {
    if (now.cords[static_cast<std::size_t>(clip)].empty()) continue;
    if (objective_ == SheetObjective::parallel_clip_forces) {
      compared.forces.push_back({clip, direction_of(session_, frame, clip)});
      continue;
    }
    if (objective_ == SheetObjective::axial_clip_forces) {
      compared.forces.push_back({clip, away_from_others(session_, frame, clip)});
      continue;
    }
    for (int axis = 0; axis < 3; ++axis) {
      compared.forces.push_back({clip, Eigen::Vector3d::Unit(axis)});
    }
  }
  return compared;
}

int SheetTest::rows(int frame) const {
  const Compared& compared = compared_[static_cast<std::size_t>(frame)];
  return static_cast<int>(compared.forces.size() + 3 * compared.nodes.size());
}

bool SheetTest::compares_one_axis() const {
  return objective_ == SheetObjective::parallel_clip_forces ||
         objective_ == SheetObjective::axial_clip_forces;
}

// Harmonic, so that rows count 1 on average.
std::optional<double> SheetTest::mean_deviation() const {
  double sum = 0;
  int count = 0;
  for (int frame = 0; frame < frame_count(); ++frame) {
    const Compared& compared = compared_[static_cast<std::size_t>(frame)];
    const auto& deviations = session_.frames[static_cast<std::size_t>(frame)].deviations;
    if (compared.nodes.empty()) continue;
    if (deviations.cols() == 0) return std::nullopt;
    sum += deviations(Eigen::all, compared.nodes).cwiseInverse().sum();
    count += 3 * static_cast<int>(compared.nodes.size());
  }
  if (count == 0) return std::nullopt;
  return count / sum;
}

std::optional<double> SheetTest::stated_noise() const {
  if (deviation_) return deviation_;
  return objective_ == SheetObjective::positions ? session_.noise.position : session_.noise.force;
}

Eigen::VectorXd SheetTest::measured(int frame) const {
  const Compared& compared = compared_[static_cast<std::size_t>(frame)];
  const SessionFrame& now = session_.frames[static_cast<std::size_t>(frame)];
  if (!compared.nodes.empty()) return now.positions(Eigen::all, compared.nodes).reshaped();
  Eigen::VectorXd values(rows(frame));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const ForceRow& row = compared.forces[static_cast<std::size_t>(i)];
    values(i) = row.direction.dot(cord_pull(session_, frame, row.clip));
  }
  return values;
}

Eigen::VectorXd SheetTest::predicted(int frame, const SheetShape& shape) const {
  const Compared& compared = compared_[static_cast<std::size_t>(frame)];
  if (!compared.nodes.empty()) return shape.positions(Eigen::all, compared.nodes).reshaped();
  Eigen::VectorXd values(rows(frame));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const ForceRow& row = compared.forces[static_cast<std::size_t>(i)];
    values(i) = row.direction.dot(shape.clip_forces.col(row.clip));
  }
  return values;
}

Eigen::ArrayXd SheetTest::weights(int frame) const {
  const Compared& compared = compared_[static_cast<std::size_t>(frame)];
  Eigen::ArrayXd weights = Eigen::ArrayXd::Ones(rows(frame));
  if (deviation_ && !compared.nodes.empty()) {
    const auto& deviations = session_.frames[static_cast<std::size_t>(frame)].deviations;
    weights =
        *deviation_ * deviations(Eigen::all, compared.nodes).cwiseInverse().reshaped().array();
  }
  if (!friction_.unknown) return weights;
  for (std::size_t i = 0; i < compared.forces.size(); ++i) {
    const bool in_doubt = std::ranges::any_of(cords_, [&](const CordDrag& cord) {
      return cord.clip == compared.forces[i].clip && !cord.certain[static_cast<std::size_t>(frame)];
    });
    if (in_doubt) weights(static_cast<Eigen::Index>(i)) = 0;
  }
  return weights;
}

Eigen::MatrixXd SheetTest::jacobian(int frame, const SheetShape& shape) const {
  const Compared& compared = compared_[static_cast<std::size_t>(frame)];
  Eigen::MatrixXd values(rows(frame), shape.positions_by_parameter.cols());
  for (std::size_t i = 0; i < compared.nodes.size(); ++i) {
    values.middleRows<3>(static_cast<Eigen::Index>(3 * i)) =
        shape.positions_by_parameter.middleRows<3>(3 * compared.nodes[i]);
  }
  for (std::size_t i = 0; i < compared.forces.size(); ++i) {
    const ForceRow& row = compared.forces[i];
    values.row(static_cast<Eigen::Index>(i)) =
        row.direction.transpose() * shape.clip_forces_by_parameter.middleRows<3>(3 * row.clip);
  }
  return values;
}

std::vector<Frame> SheetTest::frames() const {
  std::vector<Frame> frames;
  int first = 0;
  for (int frame = 0; frame < frame_count(); ++frame) {
    frames.push_back({first, rows(frame), 0});
    first += rows(frame);
  }
  return frames;
}

std::vector<std::vector<int>> SheetTest::series() const {
  std::map<std::pair<int, Eigen::Index>, std::vector<int>> channels;  // by clip or node, and place
  int row = 0;
  for (const Compared& compared : compared_) {
    std::map<int, Eigen::Index> place;
    for (const ForceRow& force : compared.forces) {
      channels[{force.clip, place[force.clip]++}].push_back(row++);
    }
    for (const int node : compared.nodes) {
      for (Eigen::Index axis = 0; axis < 3; ++axis) channels[{node, axis}].push_back(row++);
    }
  }
  std::vector<std::vector<int>> series;
  for (auto& [channel, rows] : channels) series.push_back(std::move(rows));
  return series;
}

double SheetTest::reference() const {
  if (objective_ == SheetObjective::positions) {
    return std::max(session_.sample.width, session_.sample.height);
  }
  return measured_.cwiseAbs().maxCoeff();
}

Eigen::ArrayXd SheetTest::weights() const {
  Eigen::ArrayXd all(rows());
  Eigen::Index first = 0;
  for (int frame = 0; frame < frame_count(); ++frame) {
    all.segment(first, rows(frame)) = weights(frame);
    first += rows(frame);
  }
  return all;
}

Eigen::VectorXd SheetTest::cord_widths(const Eigen::VectorXd& nuisance) const {
  if (friction_.unknown) return nuisance;
  return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(cords_.size()), friction_.width);
}

std::unique_ptr<Predictor> SheetTest::predictor(const Material& material) const {
  return std::make_unique<SessionPredictor>(*this, material);
}

SheetTest sheet_test_of(const ExperimentSpec& spec, Session session) {
  const auto& own = spec_of<SessionSpec>(spec);
  const SheetObjective objective = own.objective.value_or(usual_objective(session));
  if (own.cord_friction.unknown && objective == SheetObjective::positions) {
    throw InputError(
        spec.where,
        fmt::format("positions are compared in {}, which say nothing of the friction of cords",
                    quoted_value(spec.name)),
        "`cord_friction` where forces are compared");
  }
  try {
    SheetTest test(spec.name, std::move(session), objective, own.cord_friction);
    test.set_weight(spec.weight);
    return test;
  } catch (const InputError& error) {
    throw InputError(spec.where, error.problem(), error.expected());
  }
}

Eigen::Vector3d cord_pull(const Session& session, int frame, int clip) {
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (const CordForce& cord :
       session.frames[static_cast<std::size_t>(frame)].cords[static_cast<std::size_t>(clip)]) {
    pull += cord.force;
  }
  return pull;
}

double shortest_edge(const SheetTest& test) {
  return mesh_quality(test.session().rest).shortest_edge;
}

}  // namespace pliant
