#include "pliant/experiment/experiment.h"

namespace pliant {

double Experiment::reference() const {
  if (info_.quantity.kind == "length") return measured_.maxCoeff() - measured_.minCoeff();
  return measured_.cwiseAbs().maxCoeff();
}

}  // namespace pliant
