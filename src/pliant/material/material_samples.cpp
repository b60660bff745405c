#include "pliant/material/material_samples.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/math/gaussian_weights.h"

namespace pliant {
namespace {

bool are_alike(const ScalarCurve& a, const ScalarCurve& b) {
  return a.kind() == b.kind() && a.knots() == b.knots() && a.even() == b.even();
}

}  // namespace

bool is_heterogeneous(const Material& material) { return !material.samples.at.empty(); }

bool differs_in(const Material& material, const std::string& component) {
  return std::ranges::any_of(material.samples.at, [&](const SampledComponents& sample) {
    return sample.components.contains(component);
  });
}

bool are_alike(const MaterialComponent& a, const MaterialComponent& b) {
  if (a.stiffness.has_value() != b.stiffness.has_value()) return false;
  if (a.stiffness && !are_alike(*a.stiffness, *b.stiffness)) return false;
  return std::ranges::equal(a.addends, b.addends, [](const Addend& one, const Addend& other) {
    return &one.kind() == &other.kind();
  });
}

bool is_alike_everywhere(const Material& material, const std::string& component) {
  const auto& first = material.samples.at.front().components;
  const auto own = first.find(component);
  return own != first.end() &&
         std::ranges::all_of(material.samples.at, [&](const SampledComponents& sample) {
           const auto other = sample.components.find(component);
           return other != sample.components.end() && are_alike(own->second, other->second);
         });
}

Eigen::VectorXd weights_at(const MaterialSamples& samples, const Eigen::Vector3d& place) {
  Eigen::VectorXd squares(std::ssize(samples.at));
  for (Eigen::Index k = 0; k < squares.size(); ++k) {
    squares(k) = (place - samples.at[static_cast<std::size_t>(k)].place).squaredNorm();
  }
  return gaussian_weights(squares, samples.width);
}

Eigen::MatrixXd weights_at(const MaterialSamples& samples,
                           const std::vector<Eigen::Vector3d>& places) {
  if (samples.at.empty()) return {};
  Eigen::MatrixXd weights(std::ssize(samples.at), std::ssize(places));
  for (std::size_t i = 0; i < places.size(); ++i) {
    weights.col(static_cast<Eigen::Index>(i)) = weights_at(samples, places[i]);
  }
  return weights;
}

std::string name_in_sample(std::size_t sample, const std::string& number) {
  return fmt::format("samples[{}].{}", sample, number);
}

Material material_at(const Material& material, std::size_t sample) {
  Material at = material;
  std::erase_if(at.components, [&](const auto& own) { return differs_in(material, own.first); });
  for (const auto& [name, component] : material.samples.at[sample].components) {
    at.components[name] = component;
  }
  at.samples = {};
  return at;
}

std::map<std::string, MaterialComponent> means_of(const MaterialSamples& samples,
                                                  const Eigen::VectorXd& weights) {
  std::map<std::string, MaterialComponent> means = samples.at.front().components;
  for (auto& [name, mean] : means) {
    mean.errors.clear();
    const ComponentLaw law = law_of(mean);
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(law.parameter_count());
    for (std::size_t k = 0; k < samples.at.size(); ++k) {
      sum += weights(static_cast<Eigen::Index>(k)) *
             law_of(samples.at[k].components.at(name)).parameters();
    }
    set_law(mean, law.with_parameters(sum / weights.sum()));
  }
  return means;
}

void take_means(Material& material) {
  const Eigen::VectorXd alike = Eigen::VectorXd::Ones(std::ssize(material.samples.at));
  for (auto& [name, mean] : means_of(material.samples, alike)) material.components[name] = mean;
}

}  // namespace pliant
