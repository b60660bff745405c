#include "pliant/mechanics/element_strains.h"

#include <numeric>

#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/material/strain/trilinear_hexahedron.h"

namespace pliant {

std::vector<GreenStrainVector> point_strains(const VolumeMesh& mesh,
                                             const Eigen::Matrix3Xd& positions) {
  std::vector<GreenStrainVector> strains;
  for (const auto& nodes : mesh.tetrahedra.colwise()) {
    const LinearTetrahedron::Positions rest = mesh.positions(Eigen::all, nodes);
    const LinearTetrahedron::Positions now = positions(Eigen::all, nodes);
    strains.push_back(LinearTetrahedron::strain(tetrahedron_rest(rest), now));
  }
  for (const auto& nodes : mesh.hexahedra.colwise()) {
    const TrilinearHexahedron::Positions rest = mesh.positions(Eigen::all, nodes);
    const TrilinearHexahedron::Positions now = positions(Eigen::all, nodes);
    for (const HexahedronPoint& point : hexahedron_points(rest)) {
      strains.push_back(TrilinearHexahedron::strain(point.rest, now));
    }
  }
  return strains;
}

std::vector<GreenStrainVector> element_strains(const VolumeMesh& mesh,
                                               const Eigen::Matrix3Xd& positions) {
  constexpr int kPoints = 8;  // of a hexahedron
  const std::vector<GreenStrainVector> points = point_strains(mesh, positions);
  const auto tetrahedra = points.begin() + mesh.tetrahedron_count();
  std::vector<GreenStrainVector> strains(points.begin(), tetrahedra);
  for (auto point = tetrahedra; point != points.end(); point += kPoints) {
    strains.push_back(
        std::accumulate(point, point + kPoints, GreenStrainVector(GreenStrainVector::Zero())) /
        kPoints);
  }
  return strains;
}

std::vector<double> volume_strains(const VolumeMesh& mesh, const Eigen::Matrix3Xd& positions) {
  VolumeMesh now = mesh;
  now.positions = positions;
  std::vector<double> strains;
  VolumeMesh tetrahedra;
  tetrahedra.positions = mesh.positions;
  tetrahedra.tetrahedra = mesh.tetrahedra;
  const Eigen::VectorXd rest_of_nodes = node_volumes(tetrahedra);
  tetrahedra.positions = positions;
  const Eigen::VectorXd of_nodes = node_volumes(tetrahedra);
  for (int node = 0; node < mesh.node_count(); ++node) {
    if (rest_of_nodes(node) > 0) strains.push_back(of_nodes(node) / rest_of_nodes(node) - 1);
  }
  const Eigen::VectorXd rest = element_volumes(mesh), volumes = element_volumes(now);
  for (int e = mesh.tetrahedron_count(); e < mesh.element_count(); ++e) {
    strains.push_back(volumes(e) / rest(e) - 1);
  }
  return strains;
}

}  // namespace pliant
