#pragma once

namespace pliant {

/// Strain of discrete shells per curvature: eps = 3 (theta - theta0) / h is 3 kappa where a sheet
/// is a cylinder ([T] 5.2.1, [P] 4.3). With it the moment per width of a sheet is its stress.
inline constexpr double kStrainPerCurvature = 3;

}  // namespace pliant
