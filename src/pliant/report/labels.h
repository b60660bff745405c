#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/material/material.h"

namespace pliant::report {

/// A quantity as an axis or a table names it.
struct QuantityLabel {
  std::string name;  ///< `Force`
  std::string unit;  ///< `N`

  std::string with_unit() const { return unit.empty() ? name : name + " (" + unit + ")"; }
};

/// The label of a column such as `force_N`, `length_mm` or `force_N_per_m`.
QuantityLabel quantity_label(std::string_view column);

/// How a reader sees the strain of a component: stretch as engineering extension and shear strain
/// in per cent, bending as curvature.
class ShownStrain {
 public:
  /// @param measure  of the membrane strains; not known: stretch is shown as it stands
  ShownStrain(std::string_view component, std::optional<MembraneMeasure> measure);

  const QuantityLabel& label() const { return label_; }
  double operator()(double strain) const;
  std::vector<double> operator()(std::span<const double> strains) const;

  /// Whether the strains of the files are others than those shown, so that a curve's axis has both.
  bool is_of_green_strain() const { return green_; }

 private:
  QuantityLabel label_;
  double factor_ = 100;
  bool green_ = false;
};

/// The name of such strains within a sentence: `extension`, `curvature`.
std::string strain_name(std::string_view component, std::optional<MembraneMeasure> measure);

/// `0 to 30 %` of what is shown, and `0 to 35 %` of Green strain where that is another.
struct StrainRangeTexts {
  std::string shown, green;
};
StrainRangeTexts strain_range_texts(std::string_view component,
                                    std::optional<MembraneMeasure> measure, double low,
                                    double high);

/// `extension 0 to 30 % (Green strain 0 to 35 %)`
std::string strain_range_text(std::string_view component, std::optional<MembraneMeasure> measure,
                              double low, double high);

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
