#include "pliant/mechanics/vertex_fields.h"

namespace pliant {
namespace {

struct Mean {
  Eigen::VectorXd sum, weight;
};

}  // namespace

std::map<std::string, Eigen::VectorXd> vertex_fields(const System& system, const State& state,
                                                     const std::vector<ShownPotential>& shown,
                                                     int first_point, int vertices) {
  std::map<std::string, Mean> means;
  for (const ShownPotential& part : shown) {
    const std::vector<std::string> names = part.fields->field_names();
    const Eigen::MatrixXi points = part.fields->element_points();
    const Eigen::VectorXd sizes = part.fields->element_sizes();
    const Eigen::MatrixXd values =
        part.fields->field_values(system.history_of(*part.potential, state));
    for (size_t f = 0; f < names.size(); ++f) {
      Mean& mean = means[names[f]];
      if (mean.sum.size() == 0)
        mean = {Eigen::VectorXd::Zero(vertices), Eigen::VectorXd::Zero(vertices)};
      for (Eigen::Index e = 0; e < points.cols(); ++e) {
        for (Eigen::Index i = 0; i < points.rows(); ++i) {
          const int vertex = points(i, e) - first_point;
          mean.sum(vertex) += sizes(e) * values(static_cast<Eigen::Index>(f), e);
          mean.weight(vertex) += sizes(e);
        }
      }
    }
  }
  std::map<std::string, Eigen::VectorXd> fields;
  for (const auto& [name, mean] : means) {
    fields[name] = (mean.weight.array() > 0).select(mean.sum.array() / mean.weight.array(), 0);
  }
  return fields;
}

}  // namespace pliant
