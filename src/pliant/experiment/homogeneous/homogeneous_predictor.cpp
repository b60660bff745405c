#include "pliant/experiment/homogeneous/homogeneous_predictor.h"

#include <algorithm>
#include <numeric>

#include "pliant/material/solid/metric_values.h"

namespace pliant {
namespace {

/// Of a metric where a point is stretched along its axes.
std::vector<double> values_at(const std::string& metric, const Eigen::Vector3d& stretches) {
  Eigen::Matrix<double, 6, 1> strain = Eigen::Matrix<double, 6, 1>::Zero();
  strain.head<3>() = (stretches.array().square() - 1) / 2;
  return metric_values(metric, strain);
}

}  // namespace

std::optional<std::vector<HomogeneousStress>> homogeneous_stresses(
    const ParametricDensity& law, const std::vector<HomogeneousRow>& rows,
    const std::vector<int>& beginnings, bool incompressible, bool derivatives) {
  std::vector<HomogeneousStress> stresses;
  std::optional<HomogeneousPoint> point;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (std::ranges::binary_search(beginnings, static_cast<int>(row))) {
      point.emplace(law, incompressible, derivatives);
    }
    auto stress = point->move_to(rows[row]);
    if (!stress) return std::nullopt;
    stresses.push_back(std::move(*stress));
  }
  return stresses;
}

HomogeneousPredictor::HomogeneousPredictor(const HomogeneousTest& experiment,
                                           const Material& material)
    : experiment_(experiment) {
  NamedLaw density = solid_density(material);
  parameters_ = std::move(density.names.parameters);
  values_ = density.law->parameters();
  law_ = std::move(density.law);
}

std::optional<std::vector<HomogeneousStress>> HomogeneousPredictor::stresses(
    const Eigen::VectorXd& values, bool derivatives, const Workers& workers) const {
  workers.stop.throw_if_requested();
  const auto law = law_->with_parameters(values);
  return homogeneous_stresses(*law, experiment_.path(), experiment_.beginnings(),
                              experiment_.is_incompressible(), derivatives);
}

bool HomogeneousPredictor::predict(const Eigen::VectorXd& values, const std::vector<int>& by,
                                   const Workers& workers, FrameSink& rows) {
  const auto all = stresses(values, !by.empty(), workers);
  if (!all) return false;
  PredictedFrame predicted;
  predicted.value.resize(experiment_.rows());
  predicted.by.resize(experiment_.rows(), std::ssize(by));
  for (std::size_t row = 0; row < all->size(); ++row) {
    const auto index = static_cast<Eigen::Index>(row);
    predicted.value(index) = (*all)[row].value;
    if (!by.empty()) predicted.by.row(index) = (*all)[row].by(by);
  }
  give_by_frames(experiment_, predicted, rows);
  return true;
}

std::vector<double> HomogeneousPredictor::strains(const std::string& component,
                                                  const Eigen::VectorXd& values,
                                                  const Workers& workers) {
  std::vector<double> result;
  const auto all = stresses(values, /*derivatives=*/false, workers);
  if (!all) return result;
  for (const HomogeneousStress& stress : *all) {
    for (const double value : values_at(component, stress.stretches)) result.push_back(value);
  }
  return result;
}

std::vector<int> HomogeneousPredictor::lost_frames(const Eigen::VectorXd& values,
                                                   const Workers& workers) {
  if (stresses(values, /*derivatives=*/false, workers)) return {};
  std::vector<int> all(experiment_.frames().size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

}  // namespace pliant
