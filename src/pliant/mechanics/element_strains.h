#pragma once

#include <vector>

#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// (E11, E22, E33, 2 E23, 2 E13, 2 E12)
using GreenStrainVector = Eigen::Matrix<double, 6, 1>;

/// Green strain of each element of a deformed mesh; of a hexahedron the mean of its points.
std::vector<GreenStrainVector> element_strains(const VolumeMesh& mesh,
                                               const Eigen::Matrix3Xd& positions);

/// Green strain at the points of all elements that laws act on: one of a tetrahedron, eight of a
/// hexahedron.
std::vector<GreenStrainVector> point_strains(const VolumeMesh& mesh,
                                             const Eigen::Matrix3Xd& positions);

/// V / V0 - 1 of each node of tetrahedra, of what it has of the volumes around it, and of each
/// hexahedron: what the law of volumes of a solid acts on.
std::vector<double> volume_strains(const VolumeMesh& mesh, const Eigen::Matrix3Xd& positions);

}  // namespace pliant
