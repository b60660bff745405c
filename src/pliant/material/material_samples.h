#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "pliant/material/material.h"

namespace pliant {

/// Whether a material differs from place to place.
bool is_heterogeneous(const Material& material);

/// Whether it differs in a component.
bool differs_in(const Material& material, const std::string& component);

/// Whether two components differ in their numbers alone.
bool are_alike(const MaterialComponent& a, const MaterialComponent& b);

/// Whether all samples have a component, and differ in its numbers alone.
bool is_alike_everywhere(const Material& material, const std::string& component);

/// What each sample weighs at a place at rest, in sum 1; none where there are no samples.
Eigen::VectorXd weights_at(const MaterialSamples& samples, const Eigen::Vector3d& place);

/// The same of many places, a column each; 0 x 0 where there are no samples.
Eigen::MatrixXd weights_at(const MaterialSamples& samples,
                           const std::vector<Eigen::Vector3d>& places);

/// A number of one of its samples: "samples[2].J.k".
std::string name_in_sample(std::size_t sample, const std::string& number);

/// What a heterogeneous material is at one of its samples: one that is the same everywhere.
Material material_at(const Material& material, std::size_t sample);

/// The components that samples differ in: their means, without errors.
/// @param weights  of each sample
std::map<std::string, MaterialComponent> means_of(const MaterialSamples& samples,
                                                  const Eigen::VectorXd& weights);

/// Gives a heterogeneous material the components that its samples differ in: their means.
void take_means(Material& material);

}  // namespace pliant
