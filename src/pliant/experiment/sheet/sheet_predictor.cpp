#include "pliant/experiment/sheet/sheet_predictor.h"

namespace pliant {

std::optional<std::vector<SheetShape>> SheetPredictor::predict(const Eigen::VectorXd& parameters,
                                                               const std::vector<int>& by,
                                                               int threads, const StopToken& stop) {
  std::vector<SheetShape> shapes;
  for (std::optional<SheetShape>& shape : predict_each(parameters, by, threads, stop)) {
    if (!shape) return std::nullopt;
    shapes.push_back(std::move(*shape));
  }
  return shapes;
}

}  // namespace pliant
