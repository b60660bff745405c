#include "pliant/experiment/session/sheet_predictor.h"

namespace pliant {

SheetShape between(SheetShape first, const SheetShape& second, double share) {
  const auto mix = [&](auto& value, const auto& other) { value += share * (other - value); };
  mix(first.positions, second.positions);
  mix(first.clip_forces, second.clip_forces);
  mix(first.clip_moments, second.clip_moments);
  if (first.positions_by_parameter.size() == 0) return first;
  mix(first.positions_by_parameter, second.positions_by_parameter);
  mix(first.clip_forces_by_parameter, second.clip_forces_by_parameter);
  return first;
}

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
