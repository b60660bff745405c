#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/measurement/session.h"

namespace pliant {

/// Mass per area of the sheet (kg/m^2): the sample's density, else its mass over the area of the
/// rest mesh.
/// Of a strip that states neither it is any number.
double area_density(const Session& session);

/// Whether a session says what its sheet weighs; strips need not.
bool states_density(const Session& session);

/// Mass of each vertex of the rest mesh: a third of its triangles' (kg).
Eigen::VectorXd vertex_masses(const Session& session);

/// What is known to pull at one clip.
struct ClipLoad {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about a given centre (N m)
};

/// The force and moment of a clip's cords and of its own weight, which acts at the middle of its
/// clamped vertices. In equilibrium the clip hands them on to the cloth, of which the vertices that
/// it clamps are a part.
/// @param centre  of the moment, world (m)
ClipLoad clip_load(const Session& session, int frame, int clip, const Eigen::Vector3d& centre);

/// Centre of mass of the sheet, without clips (m).
Eigen::Vector3d sheet_centre(const Session& session, int frame);

/// What is left of all forces on sheet and clips together, of which the pull of the cloth is none:
/// zero in equilibrium.
struct Imbalance {
  Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< N
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< about the centre of the sheet (N m)
  double force_bound = 0;   ///< the session's bound at each cord, all the same way (N)
  double moment_bound = 0;  ///< the same at the cords' distances from the centre (N m)

  bool is_within_bounds() const {
    return force.norm() <= force_bound && moment.norm() <= moment_bound;
  }
};

/// @param session  without a table, whose support is not measured
Imbalance imbalance(const Session& session, int frame);

/// What the cords carry of the weight of sheet and clips; nothing where it is not measured, or too
/// little for the session's bound at each cord to say anything.
std::optional<double> carried_share(const Session& session);

/// Sentences about what the masses and forces of a session do not agree in. Frames without cords
/// are not judged: forces were not measured there.
std::vector<std::string> balance_warnings(const Session& session);

}  // namespace pliant
