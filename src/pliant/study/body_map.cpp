#include "pliant/study/body_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "pliant/io/vtu.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

constexpr double kCounts = 0.01;  // of all weights

/// Where a number of each sample stands among the parameters of a fit.
std::vector<std::size_t> places_of(const StudyResult& result, const std::string& number) {
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < result.material.samples.at.size(); ++k) {
    const auto found =
        std::ranges::find(result.parameters, name_in_sample(k, number), &ParameterEstimate::name);
    if (found == result.parameters.end()) return {};
    places.push_back(static_cast<std::size_t>(found - result.parameters.begin()));
  }
  return places;
}

/// One field of values and one of their errors.
void add_number(const StudyResult& result, const std::string& number,
                const std::vector<Eigen::VectorXd>& weights, VtuGrid& grid) {
  const std::vector<std::size_t> places = places_of(result, number);
  if (places.empty()) return;
  VtuArray value{number, 1, {}}, error{number + ".std_error", 1, {}};
  for (const Eigen::VectorXd& own : weights) {
    double sum = 0, variance = 0;
    for (std::size_t k = 0; k < places.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      const ParameterEstimate& estimate = result.parameters[places[k]];
      sum += own(i) * estimate.value;
      if (!estimate.std_error && !estimate.fixed && own(i) > kCounts) {
        variance = std::numeric_limits<double>::quiet_NaN();
      }
      for (std::size_t j = 0; j < places.size(); ++j) {
        variance += own(i) * own(static_cast<Eigen::Index>(j)) *
                    result.covariance(static_cast<Eigen::Index>(places[k]),
                                      static_cast<Eigen::Index>(places[j]));
      }
    }
    value.values.push_back(sum);
    error.values.push_back(std::sqrt(variance));
  }
  grid.cell_data.push_back(std::move(value));
  grid.cell_data.push_back(std::move(error));
}

template <int Nodes>
void add_cells(VtkCell cell, const Eigen::Matrix<int, Nodes, Eigen::Dynamic>& elements,
               VtuGrid& grid) {
  if (elements.cols() == 0) return;
  grid.cells.push_back({cell, {elements.data(), elements.data() + elements.size()}});
}

}  // namespace

std::string body_map(const StudyResult& result) {
  const VolumeMesh& mesh = *result.body;
  VtuGrid grid;
  for (const auto& x : mesh.positions.colwise()) grid.points.push_back({x(0), x(1), x(2)});
  add_cells(VtkCell::tetrahedron, mesh.tetrahedra, grid);
  add_cells(VtkCell::hexahedron, mesh.hexahedra, grid);
  std::vector<Eigen::VectorXd> weights;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const Eigen::Vector3d middle = mesh.positions(Eigen::all, mesh.nodes_of(e)).rowwise().mean();
    weights.push_back(weights_at(result.material.samples, middle));
  }
  for (const auto& [component, first] : result.material.samples.at.front().components) {
    for (const std::string& number : parameter_names(law_of(first), component)) {
      add_number(result, number, weights, grid);
    }
  }
  return write_vtu(grid, {.encoding = VtuEncoding::base64});
}

}  // namespace pliant
