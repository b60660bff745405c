#pragma once

#include <span>
#include <string_view>

#include "pliant/material/solid/metric_jet.h"

namespace pliant {

/// A scalar that a deformed point of a solid shows, zero at rest: what an addend of an additive
/// energy depends on ([T] Eq. 4.1). It knows no material. Functions of the Green strain, hence
/// objective.
struct StrainMetric {
  std::string_view name;     ///< of components of materials: "green.xx", "I1-bar"
  std::string_view meaning;  ///< for readers
  /// Where all are 0: an even curve may stand for a law (shear strains: the sign is that of an
  /// axis).
  bool even = false;
  bool never_negative = false;
  /// Value and derivatives at eight Green strains (six columns).
  MetricJet (*jet)(const LaneView& strain);
};

/// All metrics of one scalar; those of the three principal stretches are apart
/// (principal_metric.h).
std::span<const StrainMetric> strain_metrics();

/// @return null for an unknown name
const StrainMetric* find_strain_metric(std::string_view name);

}  // namespace pliant
