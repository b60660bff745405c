#include "pliant/experiment/moved_body/body_setup.h"

#include <cmath>

namespace pliant {
namespace {

constexpr double kTolerance = 1e-9;  // of stiffness times an element's mean side, squared

double mean_side(const VolumeMesh& mesh) { return std::cbrt(element_volumes(mesh).mean()); }

}  // namespace

HeldBody::HeldBody(const BodySetup& setup, const SolidLaw& law)
    : setup_(setup),
      system_(setup.mesh.positions, Eigen::VectorXd::Zero(setup.mesh.node_count())),
      tolerance_(kTolerance * stiffness_at_rest(law).cwiseAbs().maxCoeff() *
                 std::pow(mean_side(setup.mesh), 2)) {
  for (const int node : setup.held) system_.coordinates().prescribe(node);
  for (const int node : setup.moved) system_.coordinates().prescribe(node);
  add_solid(system_, setup.mesh, law);
  system_.finish();
}

Controls HeldBody::controls(const Eigen::Vector3d& shift) const {
  Controls controls;
  for (const int node : setup_.moved) {
    controls.places.push_back({node, setup_.mesh.positions.col(node) + shift});
  }
  return controls;
}

Eigen::MatrixXd HeldBody::moves() const {
  Eigen::MatrixXd moves = Eigen::MatrixXd::Zero(3 * system_.points(), 3);
  for (const int node : setup_.moved) moves.middleRows(3 * node, 3).setIdentity();
  return moves;
}

Eigen::Vector3d HeldBody::force(const Eigen::Matrix3Xd& gradient) const {
  return gradient(Eigen::all, setup_.moved).rowwise().sum();
}

}  // namespace pliant
