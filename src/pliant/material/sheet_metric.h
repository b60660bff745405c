#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace pliant {

struct PairMetric;

/// The component of a cloth that acts on the sum of its strains along weft and warp: what one
/// thread resists where the other is stretched.
inline constexpr const char* kCoupling = "coupling";

/// The component of a cloth that stiffens it whichever way it is strained, and with that what it
/// resists one strain with where it has another one: a law of the sum of squares of both principal
/// strains ([T] 4.4).
inline constexpr const char* kCrossModal = "cross-modal";

/// A scalar of the strains of a sheet on which a component of a cloth may act beside its stretches,
/// shear and bending: the metric of a solid (solid/metric.h) that keeps its thickness, E_zz = E_yz
/// = E_xz = 0 (in_plane.h). A sheet is whole without any.
struct SheetMetric {
  std::string_view name;      ///< of components of materials: "coupling", "area"
  std::string_view meaning;   ///< what a number of it is called: "change of area 3 %"
  std::string_view of_solid;  ///< the name of the metric of a solid
  /// Whether any strains of threads will do, or only Green's (`MembraneMeasure::stvk`).
  bool of_any_strain = false;
};

std::span<const SheetMetric> sheet_metrics();

/// @return null for an unknown name
const SheetMetric* find_sheet_metric(std::string_view name);

/// The metric of a solid that a component of a cloth acts on: "green.xx+yy" of "coupling", and of
/// terms of two strains (solid/pair_metric.h) "green.xx*green.xy" of "stretch.weft*shear".
/// @return nothing for stretches, shear and bending, and for unknown names
std::optional<std::string> solid_metric_of(std::string_view cloth_component);

/// The component of the Green strain that a stretch or shear is: "green.xx" of "stretch.weft";
/// empty for others.
std::string green_strain_of(std::string_view component);

/// The name of a term of two strains of a cloth, "stretch.weft*shear", as materials write it.
/// @return nothing for names of other components
std::optional<std::string> sheet_pair_name(std::string_view component);

/// The name of that of a solid's term.
/// @throws AssertionError for strains that sheets do not have
std::string sheet_term_of(const PairMetric& of_solid);

/// Both strains of such a term: "stretch.weft" and "shear".
std::array<std::string, 2> strains_of_sheet_pair(std::string_view component);

/// Whether a component of a cloth is such a term.
bool is_sheet_pair(std::string_view component);

/// What names of such terms look like, for messages.
inline constexpr const char* kSheetPairForm =
    "stretch.weft*stretch.warp, stretch.weft*shear@X/Y~V/W";

}  // namespace pliant
