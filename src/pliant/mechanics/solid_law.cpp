#include <algorithm>
#include <iterator>

#include "pliant/material/solid/solid_density.h"
#include "pliant/mechanics/solid_potentials.h"

namespace pliant {
namespace {

constexpr const char* kVolume = "J";

// The response of a law where it is at rest and remembers nothing.
Response response_at_rest(const ParametricDensity& law, int strains, Eigen::Index of_samples) {
  using Lanes = Eigen::Array<double, kLanes, Eigen::Dynamic>;
  const Lanes zeros = Lanes::Zero(kLanes, strains + law.history_size());
  const Lanes weights =
      Lanes::Constant(kLanes, of_samples, 1 / std::max(static_cast<double>(of_samples), 1.0));
  const LaneView strain(zeros.data(), kLanes, strains);
  Response response(strains);
  law.add({strain, strain, strain, LaneView(zeros.data(), kLanes, law.history_size()),
           LaneView(weights.data(), kLanes, of_samples)},
          {}, response);
  return response;
}

// A limit of the volume and of other components together is one of the points.
bool has_limit_with_others(const Material& material) {
  return std::ranges::any_of(material.limits, [](const EnergyLimit& limit) {
    return limit.of.size() > 1 && std::ranges::find(limit.of, kVolume) != limit.of.end();
  });
}

}  // namespace

SolidLaw solid_law(const Material& material, const DensityOptions& options) {
  Material of_points = material;
  const bool has_volume = !has_limit_with_others(material) &&
                          of_points.components.erase(kVolume) > 0 &&
                          material.components.at(kVolume).stiffness.has_value();
  if (has_volume) {
    for (SampledComponents& sample : of_points.samples.at) sample.components.erase(kVolume);
  }
  NamedLaw density = solid_density(of_points, options);
  SolidLaw law;
  law.of_points = density.law;
  law.samples = material.samples;
  law.parameters = std::move(density.names.parameters);
  law.point_fields = {"strain.green.xx", "strain.green.yy", "strain.green.zz",
                      "strain.green.yz", "strain.green.xz", "strain.green.xy"};
  std::ranges::move(density.names.history, std::back_inserter(law.point_fields));
  if (!has_volume) return law;
  ComponentSum sum(material);
  sum.add(kVolume, /*strain=*/0, options);
  NamedLaw of_volume = std::move(sum).finish();
  law.of_volume = std::move(of_volume.law);
  law.volume_fields = {"strain.J"};
  std::ranges::move(of_volume.names.parameters, std::back_inserter(law.parameters));
  std::ranges::move(of_volume.names.history, std::back_inserter(law.volume_fields));
  return law;
}

Eigen::Matrix<double, 6, 6> stiffness_at_rest(const SolidLaw& law) {
  const Eigen::Index samples = std::ssize(law.samples.at);
  const Response of_points = response_at_rest(*law.of_points, 6, samples);
  Eigen::Matrix<double, 6, 6> stiffness;
  for (int k = 0; k < 36; ++k) stiffness(k) = of_points.tangent(0, k);
  if (law.of_volume) {
    // J - 1 is the trace of E there.
    stiffness.topLeftCorner<3, 3>().array() +=
        response_at_rest(*law.of_volume, 1, samples).tangent(0, 0);
  }
  return stiffness;
}

}  // namespace pliant
