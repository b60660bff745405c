#include "pliant/mechanics/solid_field.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/material/density/blended_density.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/positive_stiffness.h"
#include "pliant/math/gaussian_weights.h"

namespace pliant {
namespace {

bool are_alike(const Material& a, const Material& b) {
  return std::ranges::equal(a.components, b.components, [](const auto& one, const auto& other) {
    return one.first == other.first && are_alike(one.second, other.second);
  });
}

Eigen::Index points_of(const SolidLaw& law) { return law.of_points->parameters().size(); }

void append_names(const SolidLaw& law, std::size_t sample, Eigen::Index first, Eigen::Index count,
                  std::vector<std::string>& names) {
  for (Eigen::Index p = first; p < first + count; ++p) {
    names.push_back(name_in_sample(sample, law.parameters[static_cast<std::size_t>(p)]));
  }
}

}  // namespace

Eigen::VectorXd SolidField::weights_at(const Eigen::Vector3d& place) const {
  Eigen::VectorXd squares(std::ssize(samples));
  for (Eigen::Index k = 0; k < squares.size(); ++k) {
    squares(k) = (place - samples[static_cast<std::size_t>(k)].place).squaredNorm();
  }
  return gaussian_weights(squares, width);
}

double SolidField::density_at(const Eigen::Vector3d& place) const {
  const Eigen::VectorXd weights = weights_at(place);
  double density = 0;
  for (Eigen::Index k = 0; k < weights.size(); ++k) {
    density += weights(k) * samples[static_cast<std::size_t>(k)].material.density;
  }
  return density;
}

bool are_alike(const std::vector<MaterialSample>& samples) {
  return std::ranges::all_of(samples, [&](const MaterialSample& sample) {
    return are_alike(samples.front().material, sample.material);
  });
}

SolidField solid_field(const Material& material) {
  SolidField field;
  field.width = material.samples.width;
  for (std::size_t k = 0; k < material.samples.at.size(); ++k) {
    field.samples.push_back(
        {material.samples.at[k].place, held_beyond_range(material_at(material, k))});
  }
  return field;
}

SolidLaw solid_law(const SolidField& field, const DensityOptions& options) {
  PLIANT_ASSERT(!field.samples.empty(), "a field has samples");
  std::vector<SolidLaw> laws;
  for (const MaterialSample& sample : field.samples) {
    laws.push_back(solid_law(sample.material, options));
  }
  const bool alike = are_alike(field.samples);
  BlendedDensity::Laws of_points, of_volume;
  for (const SolidLaw& law : laws) {
    of_points.push_back(law.of_points);
    if (law.of_volume) of_volume.push_back(law.of_volume);
  }
  PLIANT_ASSERT(of_volume.empty() || of_volume.size() == laws.size(),
                "all samples resist volume, or none");
  SolidLaw blended;
  blended.point_fields = laws.front().point_fields;
  blended.volume_fields = laws.front().volume_fields;
  blended.of_points = std::make_shared<BlendedDensity>(std::move(of_points), alike);
  for (std::size_t k = 0; k < laws.size(); ++k)
    append_names(laws[k], k, 0, points_of(laws[k]), blended.parameters);
  if (!of_volume.empty()) {
    blended.of_volume = std::make_shared<BlendedDensity>(std::move(of_volume), alike);
    for (std::size_t k = 0; k < laws.size(); ++k) {
      const Eigen::Index own = points_of(laws[k]);
      append_names(laws[k], k, own, std::ssize(laws[k].parameters) - own, blended.parameters);
    }
  }
  blended.weights = [field](const Eigen::Vector3d& place) { return field.weights_at(place); };
  return blended;
}

}  // namespace pliant
