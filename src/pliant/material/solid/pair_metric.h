#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "pliant/material/solid/metric_jet.h"

namespace pliant {

/// A scalar of two components x, y of the Green strain that is zero where either is: what an addend
/// of several strains depends on ([T] 4.2.2). All of an energy that one strain tells alone belongs
/// to the addends of that strain.
///
/// - The bilinear one is x y: Eq. 4.3's cross term is lambda times it.
/// - A Gaussian one has a place (x0, y0) and widths (v, w): with
///   phi = exp(-(x - x0)^2 / (2 v^2) - (y - y0)^2 / (2 w^2)) it is
///   phi(x, y) - phi(x, 0) - phi(0, y) + phi(0, 0), the product of g(x - x0) - g(x0) along either
///   strain.
///
/// Its name says all of that: "green.xx*green.yy", "green.xx*green.yy@0.1/0.05~0.04/0.03".
struct PairMetric {
  struct Bump {
    std::array<double, 2> place;
    std::array<double, 2> width;  ///< > 0
  };

  std::array<int, 2> strains{};  ///< columns of the Green strain (`kSolidStrains`), in their order
  std::optional<Bump> bump = {};

  MetricJet jet(const LaneView& strain) const;
  /// Of the strain metrics it is of: "green.xx".
  std::array<std::string, 2> of() const;
  std::string name() const;
};

/// @return nothing for a name of another form
std::optional<PairMetric> find_pair_metric(std::string_view name);

/// What such names look like, for messages.
inline constexpr const char* kPairForm = "green.xx*green.yy, green.xx*green.yy@X/Y~V/W";

}  // namespace pliant
