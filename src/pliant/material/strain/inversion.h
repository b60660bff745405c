#pragma once

#include <Eigen/Core>

namespace pliant {

/// How far a deformation gradient may go on a straight way before it turns inside out.
///
/// det (F + s dF) is a cubic of the share s of the way.
/// @param from  F where the way begins, det F > 0
/// @param way   dF of all of the way
/// @param kept  in [0, 1): the share of det F that is to be left everywhere on it
/// @return the largest share of the way, in [0, 1], up to which that holds; 0 where det F is not
///         above 0 to begin with
double share_before_inversion(const Eigen::Matrix3d& from, const Eigen::Matrix3d& way, double kept);

/// The nearest positive semidefinite matrix to a symmetric one.
Eigen::Matrix3d positive_part(const Eigen::Matrix3d& symmetric);

}  // namespace pliant
