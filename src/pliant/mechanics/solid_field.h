#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/mechanics/solid.h"

namespace pliant {

/// A material at a place of a body at rest.
struct MaterialSample {
  Eigen::Vector3d place;  ///< m
  Material material;      ///< of kind solid; it remembers nothing and has no limits
};

/// A heterogeneous solid ([T] 4.2.4): at each point the energies of its samples, each times a
/// normalised Gaussian of its distance.
struct SolidField {
  std::vector<MaterialSample> samples;  ///< at least one
  double width = 0;                     ///< standard deviation of the Gaussians (m)

  /// Of sum 1.
  Eigen::VectorXd weights_at(const Eigen::Vector3d& place) const;
  /// Mass per volume at a place (kg/m^3).
  double density_at(const Eigen::Vector3d& place) const;
};

/// That of a heterogeneous solid.
SolidField solid_field(const Material& material);

/// Whether materials differ in their numbers alone.
bool are_alike(const std::vector<MaterialSample>& samples);

/// The law of a heterogeneous solid; parameters of its samples are called "samples[2].J.k".
SolidLaw solid_law(const SolidField& field, const DensityOptions& options = {});

}  // namespace pliant
