#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "pliant/material/component_density.h"

namespace pliant {

struct NamedLaw {
  std::shared_ptr<Sum> law;
  AddedNames names;  ///< of its parameters and of its history, in their order
};

/// The law of several components of a material: a sum of theirs, in which those that a limit of the
/// material is about stand together below it ([T] Eqs. 4.1, 4.5). Of a component that differs from
/// place to place it is that of its samples, blended by their weights (Eq. 4.4); numbers of these
/// are called "samples[2].J.k".
class ComponentSum {
 public:
  /// Puts the law of a component where it acts: on a metric, a sum of strains.
  using Place = std::function<std::shared_ptr<const ParametricDensity>(std::shared_ptr<Sum>)>;

  /// @param material  outlives it
  explicit ComponentSum(const Material& material);

  /// Adds the law of a component, which has a stiffness. What differs from place to place remembers
  /// nothing.
  /// @param strain  which it acts on, of the law that `place` puts on the strains of a point
  void add(const std::string& component, int strain, const DensityOptions& options,
           const Place& place = {});

  /// What limits are about comes last.
  NamedLaw finish() &&;

 private:
  struct Limited {
    std::shared_ptr<Sum> law = std::make_shared<Sum>();
    std::vector<std::string> parameters;
    int components = 0;
  };

  AddedNames add_law(const std::string& component, int strain, const DensityOptions& options,
                     LawPart part, Sum& sum) const;
  AddedNames add_blended(const std::string& component, int strain, const DensityOptions& options,
                         LawPart part, Sum& sum) const;
  void add_part(const std::string& component, int strain, const DensityOptions& options,
                LawPart part, const Place& place, Sum& sum, AddedNames& names) const;

  const Material& material_;
  NamedLaw all_{std::make_shared<Sum>(), {}};
  std::vector<Limited> limited_;  // by limit of the material
};

}  // namespace pliant
