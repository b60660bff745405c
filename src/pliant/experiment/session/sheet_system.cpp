#include "pliant/experiment/session/sheet_system.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

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

std::vector<int> clips_of(const Session& session, const std::vector<int>& held) {
  const std::vector<int> clips = clip_of_nodes(session);
  std::vector<int> result;
  for (const int node : held) result.push_back(clips[static_cast<std::size_t>(node)]);
  return result;
}

// Where held nodes are in a frame: clamped ones where the pose of their clip puts them, those on
// the table where they rest (m, one column a node of `held`).
Eigen::Matrix3Xd held_positions(const Session& session, int frame, const std::vector<int>& held,
                                const std::vector<int>& clip_of_held) {
  const std::vector<Pose>& poses = session.frames[static_cast<std::size_t>(frame)].poses;
  Eigen::Matrix3Xd positions = session.rest.positions(Eigen::all, held);
  for (std::size_t i = 0; i < held.size(); ++i) {
    const int clip = clip_of_held[i];
    auto place = positions.col(static_cast<Eigen::Index>(i));
    if (clip >= 0) place = poses[static_cast<std::size_t>(clip)].apply(place.eval());
  }
  return positions;
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

System::Drive held_drive(const Session& session, const std::vector<int>& held) {
  return [&session, &held, clips = clips_of(session, held)](double time, Configuration& at) {
    const int frame =
        std::clamp(static_cast<int>(std::ceil(time)) - 1, 0, session.frame_count() - 1);
    const double share = time - frame;
    Eigen::Matrix3Xd places = held_positions(session, frame, held, clips);
    if (share < 1) {
      const Eigen::Matrix3Xd before =
          frame == 0 ? Eigen::Matrix3Xd(session.rest.positions(Eigen::all, held))
                     : held_positions(session, frame - 1, held, clips);
      places = before + share * (places - before);
    }
    at.positions(Eigen::all, held) = places;
  };
}

SheetSystem::SheetSystem(const Session& session, const Material& material,
                         const DensityOptions& options, std::vector<int> held)
    : session_(session),
      held_(std::move(held)),
      clip_of_held_(clips_of(session, held_)),
      system_(session.rest.positions, vertex_masses(session)) {
  for (const int node : held_) system_.coordinates().prescribe(node);
  Cloth cloth = add_cloth(system_, session.rest, material, options, parameters_);
  shown_ = std::move(cloth.shown);
  warnings_ = std::move(cloth.warnings);
  system_.add(std::make_shared<PointForces>(session.gravity * system_.masses().transpose()));
  system_.finish();
}

std::vector<double> SheetSystem::strains(const std::string& component,
                                         const Eigen::Matrix3Xd& positions) const {
  std::vector<double> strains;
  for (const ShownPotential& shown : shown_) {
    const std::vector<std::string> names = shown.fields->field_names();
    const auto found = std::ranges::find(names, "strain." + component);
    if (found == names.end()) continue;
    const auto& potential = dynamic_cast<const HistoryPotential&>(*shown.potential);
    const Eigen::VectorXd history = potential.initial_history({positions, {}});
    const Eigen::RowVectorXd values =
        shown.fields->field_values(history.data()).row(found - names.begin());
    strains.insert(strains.end(), values.begin(), values.end());
  }
  return strains;
}

double SheetSystem::tolerance() const {
  constexpr double kOfThesis = 1e-5, kOfWeight = 1e-3;
  const double weight = session_.gravity.norm() * system_.masses().sum() / system_.points();
  return weight > 0 ? std::min(kOfThesis, kOfWeight * weight) : kOfThesis;
}

Configuration SheetSystem::configuration(int frame, Eigen::Matrix3Xd start) const {
  Configuration at{std::move(start), {}};
  at.positions(Eigen::all, held_) = held_positions(session_, frame, held_, clip_of_held_);
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
