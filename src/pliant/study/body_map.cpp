#include "pliant/study/body_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

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

template <class Elements>
void add_cells(VtkCell cell, const Elements& elements, VtuGrid& grid) {
  if (elements.cols() == 0) return;
  grid.cells.push_back({cell, {elements.data(), elements.data() + elements.size()}});
}

/// What each sample weighs in each cell, at its middle.
std::vector<Eigen::VectorXd> weights_in_cells(const MaterialSamples& samples, const VtuGrid& grid) {
  std::vector<Eigen::VectorXd> weights;
  for (const VtuCells& cells : grid.cells) {
    const std::size_t corners = cells.corners.size() / cells.count();
    for (std::size_t first = 0; first < cells.corners.size(); first += corners) {
      Eigen::Vector3d middle(0, 0, 0);
      for (std::size_t c = first; c < first + corners; ++c) {
        const Point3& corner = grid.points[static_cast<std::size_t>(cells.corners[c])];
        middle += Eigen::Vector3d(corner[0], corner[1], corner[2]) / static_cast<double>(corners);
      }
      weights.push_back(weights_at(samples, middle));
    }
  }
  return weights;
}

}  // namespace

VtuGrid grid_at_rest(const VolumeMesh& body) {
  VtuGrid grid;
  for (const auto& x : body.positions.colwise()) grid.points.push_back({x(0), x(1), x(2)});
  add_cells(VtkCell::tetrahedron, body.tetrahedra, grid);
  add_cells(VtkCell::hexahedron, body.hexahedra, grid);
  return grid;
}

VtuGrid grid_at_rest(const TriangleMesh& sheet) {
  VtuGrid grid;
  for (const auto& place : sheet.rest_corners.colwise()) {
    grid.points.push_back({place(0), place(1), 0});
  }
  std::vector<int> corners(grid.points.size());
  std::iota(corners.begin(), corners.end(), 0);
  grid.cells.push_back({VtkCell::triangle, std::move(corners)});
  return grid;
}

std::string body_map(const StudyResult& result) {
  VtuGrid grid = *result.body;
  const std::vector<Eigen::VectorXd> weights = weights_in_cells(result.material.samples, grid);
  for (const auto& [component, first] : result.material.samples.at.front().components) {
    for (const std::string& number : parameter_names(law_of(first), component)) {
      add_number(result, number, weights, grid);
    }
  }
  return write_vtu(grid, {.encoding = VtuEncoding::base64});
}

}  // namespace pliant
