#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "pliant/material/material.h"

namespace pliant {

/// Whether a solid differs from place to place.
bool is_heterogeneous(const Material& material);

/// Whether it differs in a component.
bool differs_in(const Material& material, const std::string& component);

/// Whether two components differ in their numbers alone.
bool are_alike(const MaterialComponent& a, const MaterialComponent& b);

/// What each sample weighs at a place of the body at rest, in sum 1.
Eigen::VectorXd weights_at(const MaterialSamples& samples, const Eigen::Vector3d& place);

/// A number of one of its samples: "samples[2].J.k".
std::string name_in_sample(std::size_t sample, const std::string& number);

/// What a heterogeneous solid is at one of its samples: a solid that is the same everywhere.
Material material_at(const Material& material, std::size_t sample);

/// The components that a heterogeneous solid's samples differ in: their means, without errors.
/// @param weights  of each sample
std::map<std::string, MaterialComponent> means_of(const MaterialSamples& samples,
                                                  const Eigen::VectorXd& weights);

/// Gives a heterogeneous solid the components that its samples differ in: their means.
void take_means(Material& material);

}  // namespace pliant
