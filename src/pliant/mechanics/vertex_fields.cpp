#include "pliant/mechanics/vertex_fields.h"

namespace pliant {
namespace {

struct Mean {
  Eigen::VectorXd sum, weight;

  explicit Mean(int vertices)
      : sum(Eigen::VectorXd::Zero(vertices)), weight(Eigen::VectorXd::Zero(vertices)) {}

  // Gives the values of elements, weighted by their sizes, to their vertices.
  void add(const Eigen::MatrixXi& vertices, const Eigen::VectorXd& sizes,
           const Eigen::VectorXd& values) {
    for (Eigen::Index e = 0; e < vertices.cols(); ++e) {
      for (const int vertex : vertices.col(e)) {
        sum(vertex) += sizes(e) * values(e);
        weight(vertex) += sizes(e);
      }
    }
  }
};

}  // namespace

std::map<std::string, Eigen::VectorXd> vertex_fields(const System& system, const State& state,
                                                     const std::vector<ShownPotential>& shown,
                                                     int first_point, int vertices) {
  std::map<std::string, Mean> means;
  for (const ShownPotential& part : shown) {
    const std::vector<std::string> names = part.fields->field_names();
    const Eigen::MatrixXi elements = part.fields->element_points().array() - first_point;
    const Eigen::VectorXd sizes = part.fields->element_sizes();
    const Eigen::MatrixXd values =
        part.fields->field_values(system.history_of(*part.potential, state));
    for (size_t f = 0; f < names.size(); ++f) {
      Mean& mean = means.try_emplace(names[f], vertices).first->second;
      mean.add(elements, sizes, values.row(static_cast<Eigen::Index>(f)));
    }
  }
  std::map<std::string, Eigen::VectorXd> fields;
  for (const auto& [name, mean] : means) {
    fields[name] = (mean.weight.array() > 0).select(mean.sum.array() / mean.weight.array(), 0);
  }
  return fields;
}

}  // namespace pliant
