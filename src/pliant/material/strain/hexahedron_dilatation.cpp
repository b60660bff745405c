#include "pliant/material/strain/hexahedron_dilatation.h"

#include <Eigen/Geometry>

#include "pliant/geometry/hexahedron_shape.h"

namespace pliant {

HexahedronDilatation::Strain HexahedronDilatation::strain(const Rest& rest,
                                                          const Positions& positions) {
  return Strain(hexahedron_sizes(positions).sum() / rest.volume - 1);
}

// d det F / d F is the matrix of cofactors, whose columns are cross products of those of F.
HexahedronDilatation::Gradient HexahedronDilatation::gradient(const Rest& rest,
                                                              const Positions& positions) {
  Positions sum = Positions::Zero();
  for (const auto& weights : hexahedron_gradients()) {
    const Eigen::Matrix3d f = positions * weights;
    Eigen::Matrix3d cofactors;
    cofactors << f.col(1).cross(f.col(2)), f.col(2).cross(f.col(0)), f.col(0).cross(f.col(1));
    sum += cofactors * weights.transpose();
  }
  return sum.reshaped().transpose() / rest.volume;
}

// d2 det F / (d x_i d x_j) = -[u]x with u = F (g_i x g_j), g_i being the row of node i.
HexahedronDilatation::Hessian HexahedronDilatation::weighted_hessian(const Rest& rest,
                                                                     const Positions& positions,
                                                                     const Strain& y) {
  Hessian result = Hessian::Zero();
  for (const auto& weights : hexahedron_gradients()) {
    const Eigen::Matrix3d f = y(0) / rest.volume * (positions * weights);
    for (int i = 0; i < 8; ++i) {
      for (int j = i + 1; j < 8; ++j) {
        const Eigen::Vector3d u =
            f * weights.row(i).transpose().cross(weights.row(j).transpose()).eval();
        Eigen::Matrix3d block;
        block << 0, u.z(), -u.y(), -u.z(), 0, u.x(), u.y(), -u.x(), 0;
        result.block<3, 3>(3 * i, 3 * j) += block;
        result.block<3, 3>(3 * j, 3 * i) += block.transpose();
      }
    }
  }
  return result;
}

}  // namespace pliant
