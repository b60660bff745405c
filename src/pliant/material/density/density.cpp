#include "pliant/material/density/density.h"

namespace pliant {

Response::Response(int strains)
    : stored(Lane::Zero()),
      work(Lane::Zero()),
      stress(LaneStrains::Zero(kLanes, strains)),
      tangent(LaneTangents::Zero(kLanes, strains * strains)) {}

SampleDerivatives::SampleDerivatives(int strains, int history, int parameters)
    : stress_by_last(Eigen::MatrixXd::Zero(strains, strains)),
      stress_by_history(Eigen::MatrixXd::Zero(strains, history)),
      stress_by_parameter(Eigen::MatrixXd::Zero(strains, parameters)),
      next_by_strain(Eigen::MatrixXd::Zero(history, strains)),
      next_by_last(Eigen::MatrixXd::Zero(history, strains)),
      next_by_history(Eigen::MatrixXd::Zero(history, history)),
      next_by_parameter(Eigen::MatrixXd::Zero(history, parameters)) {}

}  // namespace pliant
