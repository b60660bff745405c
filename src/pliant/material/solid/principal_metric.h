#pragma once

#include <span>
#include <string_view>

namespace pliant {

/// A value and its first two derivatives.
struct ScalarJet {
  double value = 0;
  double first = 0;
  double second = 0;
};

/// Three scalars of a deformed point of a solid, one a principal stretch, on each of which the same
/// law acts ([Ogden1972]). They are functions of the logarithm of the stretch.
struct PrincipalMetric {
  std::string_view name;     ///< of components of materials: "stretch"
  std::string_view meaning;  ///< for readers
  bool isochoric = false;    ///< of stretches over J^(1/3)
  ScalarJet (*of_log)(double log_stretch);
};

std::span<const PrincipalMetric> principal_metrics();

/// @return null for an unknown name
const PrincipalMetric* find_principal_metric(std::string_view name);

}  // namespace pliant
