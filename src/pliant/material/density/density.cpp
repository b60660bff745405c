#include "pliant/material/density/density.h"

#include <Eigen/Eigenvalues>

namespace pliant {

Response::Response(int strains)
    : stored(Lane::Zero()),
      work(Lane::Zero()),
      stress(LaneStrains::Zero(kLanes, strains)),
      tangent(LaneTangents::Zero(kLanes, strains * strains)) {}

void make_tangent_convex(Response& response, int strains) {
  bool diagonal = true;
  for (int k = 0; k < strains * strains; ++k) {
    if (k % (strains + 1) == 0) continue;
    diagonal = diagonal && (response.tangent.col(k) == 0).all();
  }
  if (diagonal) {
    response.tangent = response.tangent.max(0);
    return;
  }
  for (int l = 0; l < kLanes; ++l) {
    Eigen::MatrixXd tangent(strains, strains);
    for (int k = 0; k < tangent.size(); ++k) tangent(k) = response.tangent(l, k);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(tangent);
    tangent = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
              eigen.eigenvectors().transpose();
    for (int k = 0; k < tangent.size(); ++k) response.tangent(l, k) = tangent(k);
  }
}

SampleDerivatives::SampleDerivatives(int strains, int history, int parameters)
    : stored_by_parameter(Eigen::VectorXd::Zero(parameters)),
      stress_by_last(Eigen::MatrixXd::Zero(strains, strains)),
      stress_by_history(Eigen::MatrixXd::Zero(strains, history)),
      stress_by_parameter(Eigen::MatrixXd::Zero(strains, parameters)),
      next_by_strain(Eigen::MatrixXd::Zero(history, strains)),
      next_by_last(Eigen::MatrixXd::Zero(history, strains)),
      next_by_history(Eigen::MatrixXd::Zero(history, history)),
      next_by_parameter(Eigen::MatrixXd::Zero(history, parameters)) {}

void Density::add_stored(const Samples& samples, Lane& stored) const {
  Response response(static_cast<int>(samples.strain.cols()));
  add(samples, {}, response);
  stored += response.stored;
}

}  // namespace pliant
