#include "pliant/experiment/session/sheet_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "pliant/material/sheet_metric.h"
#include "pliant/material/solid/metric_values.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/mechanics/point_forces.h"

namespace pliant {
namespace {

/// Rounding of an edge's distance (m).
constexpr double kOnEdge = 1e-9;

std::vector<int> clip_of_nodes(const Session& session) {
  std::vector<int> clips(static_cast<std::size_t>(session.rest.vertex_count()), -1);
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    for (const int node : session.clips[c].clamped) {
      clips[static_cast<std::size_t>(node)] = static_cast<int>(c);
    }
  }
  return clips;
}

}  // namespace

std::vector<int> held_nodes(const Session& session, const std::optional<double>& edge) {
  const std::vector<int> clips = clip_of_nodes(session);
  std::vector<int> held;
  for (int node = 0; node < session.rest.vertex_count(); ++node) {
    const bool on_table =
        session.table && edge &&
        session.rest.positions(static_cast<int>(*session.table), node) <= *edge + kOnEdge;
    if (on_table || clips[static_cast<std::size_t>(node)] >= 0) held.push_back(node);
  }
  return held;
}

SheetSystem::SheetSystem(const Session& session, const Material& material,
                         const DensityOptions& options, std::vector<int> held)
    : session_(session),
      held_(std::move(held)),
      system_(session.rest.positions, vertex_masses(session)) {
  const std::vector<int> clips = clip_of_nodes(session);
  for (const int node : held_) {
    system_.coordinates().prescribe(node);
    clip_of_held_.push_back(clips[static_cast<std::size_t>(node)]);
  }
  Cloth cloth = add_cloth(system_, session.rest, material, options);
  shown_ = std::move(cloth.shown);
  warnings_ = std::move(cloth.warnings);
  system_.add(std::make_shared<PointForces>(session.gravity * system_.masses().transpose()));
  system_.finish();
}

std::vector<double> SheetSystem::strains(const std::string& component,
                                         const Eigen::Matrix3Xd& positions) const {
  if (const auto metric = solid_metric_of(component)) return metric_strains(*metric, positions);
  std::vector<double> strains;
  for (const ShownPotential& shown : shown_) {
    const std::vector<std::string> names = shown.fields->field_names();
    const auto found = std::ranges::find(names, "strain." + component);
    if (found == names.end()) continue;
    const auto& potential = dynamic_cast<const HistoryPotential&>(*shown.potential);
    const Eigen::VectorXd history = potential.initial_history({Configuration{positions, {}}});
    const Eigen::RowVectorXd values =
        shown.fields->field_values(history.data()).row(found - names.begin());
    strains.insert(strains.end(), values.begin(), values.end());
  }
  return strains;
}

std::vector<double> SheetSystem::metric_strains(const std::string& metric,
                                                const Eigen::Matrix3Xd& positions) const {
  const std::vector<double> weft = strains("stretch.weft", positions);
  const std::vector<double> warp = strains("stretch.warp", positions);
  const std::vector<double> shear = strains("shear", positions);
  std::vector<double> values;
  for (std::size_t i = 0; i < weft.size(); ++i) {
    Eigen::Matrix<double, 6, 1> strain;
    strain << weft[i], warp[i], 0, 0, 0, shear[i];
    const std::vector<double> own = metric_values(metric, strain);
    values.insert(values.end(), own.begin(), own.end());
  }
  return values;
}

double SheetSystem::tolerance() const {
  constexpr double kOfThesis = 1e-5, kOfWeight = 1e-3;
  const double weight = session_.gravity.norm() * system_.masses().sum() / system_.points();
  return weight > 0 ? std::min(kOfThesis, kOfWeight * weight) : kOfThesis;
}

Eigen::Matrix3Xd SheetSystem::places(int frame) const {
  Eigen::Matrix3Xd places = session_.rest.positions(Eigen::all, held_);
  if (frame < 0) return places;
  const std::vector<Pose>& poses = session_.frames[static_cast<std::size_t>(frame)].poses;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    const int clip = clip_of_held_[i];
    auto place = places.col(static_cast<Eigen::Index>(i));
    if (clip >= 0) place = poses[static_cast<std::size_t>(clip)].apply(place.eval());
  }
  return places;
}

Controls SheetSystem::controls(const Eigen::Matrix3Xd& places) const {
  Controls controls;
  for (std::size_t i = 0; i < held_.size(); ++i) {
    controls.places.push_back({held_[i], places.col(static_cast<Eigen::Index>(i))});
  }
  return controls;
}

Controls SheetSystem::controls(int frame) const { return controls(places(frame)); }

Schedule SheetSystem::schedule() const {
  return [this](double time) {
    const int frame =
        std::clamp(static_cast<int>(std::ceil(time)) - 1, 0, session_.frame_count() - 1);
    const double share = time - frame;
    Eigen::Matrix3Xd now = places(frame);
    if (share < 1) {
      const Eigen::Matrix3Xd before = places(frame - 1);
      now = before + share * (now - before);
    }
    Controls held = controls(now);
    held.time = time;
    return held;
  };
}

Configuration SheetSystem::configuration(int frame, Eigen::Matrix3Xd start) const {
  Configuration at{std::move(start), {}};
  system_.coordinates().apply(controls(frame), at);
  return at;
}

Eigen::Matrix3Xd SheetSystem::clip_forces(const Eigen::Matrix3Xd& gradient) const {
  Eigen::Matrix3Xd forces(3, static_cast<Eigen::Index>(session_.clips.size()));
  for (std::size_t c = 0; c < session_.clips.size(); ++c) {
    const SessionClip& clip = session_.clips[c];
    forces.col(static_cast<Eigen::Index>(c)) =
        gradient(Eigen::all, clip.clamped).rowwise().sum() - clip.mass * session_.gravity;
  }
  return forces;
}

Eigen::MatrixXd SheetSystem::clip_forces_by_parameter(const Eigen::MatrixXd& forces) const {
  Eigen::MatrixXd sums =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(3 * session_.clips.size()), forces.cols());
  for (std::size_t c = 0; c < session_.clips.size(); ++c) {
    for (const int node : session_.clips[c].clamped) {
      sums.middleRows<3>(static_cast<Eigen::Index>(3 * c)) += forces.middleRows<3>(3 * node);
    }
  }
  return sums;
}

Eigen::Matrix3Xd SheetSystem::clip_moments(const Eigen::Matrix3Xd& positions,
                                           const Eigen::Matrix3Xd& gradient) const {
  Eigen::Matrix3Xd moments(3, static_cast<Eigen::Index>(session_.clips.size()));
  moments.setZero();
  for (std::size_t c = 0; c < session_.clips.size(); ++c) {
    const std::vector<int>& clamped = session_.clips[c].clamped;
    const Eigen::Vector3d middle = positions(Eigen::all, clamped).rowwise().mean();
    for (const int node : clamped) {
      const Eigen::Vector3d arm = positions.col(node) - middle, force = gradient.col(node);
      moments.col(static_cast<Eigen::Index>(c)) += arm.cross(force);
    }
  }
  return moments;
}

}  // namespace pliant
