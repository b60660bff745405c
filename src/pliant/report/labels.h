#pragma once

#include <string>
#include <string_view>

namespace pliant::report {

/// A quantity as an axis or a table names it.
struct QuantityLabel {
  std::string name;  ///< `Force`
  std::string unit;  ///< `N`

  std::string with_unit() const { return unit.empty() ? name : name + " (" + unit + ")"; }
};

/// The label of a column such as `force_N`, `length_mm` or `force_N_per_m`.
QuantityLabel quantity_label(std::string_view column);

/// How the strain of a component is shown: membrane strains in per cent, those of
/// bending as curvatures.
struct StrainScale {
  QuantityLabel label;
  double factor = 1.0;  ///< from the numbers in the files to the ones shown
};
StrainScale strain_scale(std::string_view component);

/// `strain 0 to 35 %`
std::string strain_range_text(std::string_view component, double low, double high);

/// The label of the stress that works on that strain.
QuantityLabel stress_label(std::string_view component);

/// `stretch.warp` -> `Warp stretch`; names it does not know come back as they are.
std::string component_title(std::string_view component);

/// What a parameter means, from the end of its name (`friction.tau`), in plain words.
std::string parameter_meaning(std::string_view parameter);
/// Whether a number is one of friction: the component's, or of an addend that remembers.
bool is_of_friction(std::string_view parameter);

/// A parameter of sheets in words, whatever follows its name: `stretch.weft.k[0] (why)` ->
/// `stiffness of stretch.weft at zero strain (why)`; other texts come back as they are.
std::string parameter_in_words(std::string_view text);

/// The unit as users write it: `1` (dimensionless) becomes empty.
std::string shown_unit(std::string_view unit);

}  // namespace pliant::report
