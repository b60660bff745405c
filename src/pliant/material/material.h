#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/component_law.h"
#include "pliant/material/density/dahl.h"
#include "pliant/material/number_error.h"
#include "pliant/material/sheet_metric.h"
#include "pliant/math/scalar_curve.h"

namespace pliant {

/// Whether a component's numbers were measured, assumed, or do not exist. What was not measured is
/// not zero.
enum class ComponentStatus { measured, assumed, unmeasured };

std::string_view name_of(ComponentStatus status);

/// What a material is of.
enum class MaterialKind {
  cloth,  ///< stresses per width, components of the sheet
  solid,  ///< stresses per area; components are metrics of the Green strain (solid/metric.h)
};

std::string_view name_of(MaterialKind kind);

/// How the membrane strain is measured from a triangle's deformation.
enum class MembraneMeasure {
  stvk,             ///< Green-Lagrange ([T] Eq. 3.3)
  soft_constraint,  ///< |w| - 1 ([T] Eq. 3.4)
  spring,           ///< l / l0 - 1 ([T] Eq. 3.1)
};

std::string_view name_of(MembraneMeasure measure);

/// The measure of a name that `name_of` gives.
MembraneMeasure membrane_measure(std::string_view name);

/// Dahl friction that may differ between positive and negative strain ([P] 4.1).
struct ComponentFriction {
  DahlParameters positive;
  std::optional<DahlParameters> negative;  ///< as `positive` when absent
};

/// One strain component of a material.
struct MaterialComponent {
  std::optional<ScalarCurve> stiffness;  ///< absent: nothing is known of the component; of the kind
                                         ///< `none` where addends alone carry it
  std::optional<ComponentFriction> friction;
  ComponentStatus status = ComponentStatus::measured;
  std::optional<std::pair<double, double>> range;  ///< strains the data covered
  std::vector<Addend> addends = {};
  std::map<std::string, NumberError> errors = {};  ///< of a fit, by number: "k[0]", "friction.a"
};

/// The most that the elastic energy of some components together may come to ([T] Eq. 4.5).
struct EnergyLimit {
  std::vector<std::string> of;  ///< components, in the order of `component_names`
  double energy = 0;            ///< psi_max > 0: J/m^3 of solids, J/m^2 of cloth
  std::map<std::string, NumberError> errors = {};  ///< of a fit: "energy"
};

/// A limit among the parameters of a material: "J.limit", "trace+J.limit".
std::string limit_name(const std::vector<std::string>& components);

/// What a heterogeneous solid is made of at a place of its body at rest.
struct SampledComponents {
  Eigen::Vector3d place;  ///< m
  std::map<std::string, MaterialComponent> components;
};

/// How a solid differs from place to place ([T] 4.2.4): at each point the energies of its samples
/// add, each times a Gaussian of its distance, all weights of sum 1.
struct MaterialSamples {
  std::vector<SampledComponents> at;  ///< empty: the solid is the same everywhere
  double width = 0;                   ///< standard deviation of the Gaussians (m)
};

/// A material: the content of a material/1 file (docs/formats/material.md).
struct Material {
  std::string name;
  double density = 0;  ///< kg/m^2, of solids kg/m^3; 0 = not known
  MembraneMeasure membrane = MembraneMeasure::stvk;
  std::string bending = "discrete-shells";
  std::string bending_of = "sheet";  ///< sheet, or hinges of the mesh `bending_mesh`
  std::string bending_mesh;
  std::map<std::string, MaterialComponent> components;
  std::vector<EnergyLimit> limits = {};  ///< of which no two share a component
  std::optional<double> damping_fraction;
  std::map<std::string, std::string> info;
  std::map<std::string, std::string> provenance;
  MaterialKind kind = MaterialKind::cloth;
  /// Of a heterogeneous solid, whose `components` are the means of its samples'; these differ from
  /// them in numbers alone, remember nothing and have no limits.
  MaterialSamples samples = {};
};

/// Whether a component is one of bending (its curve is a function of |strain| and has other units).
bool is_bending(std::string_view component);

/// Whether a component says how much narrower cloth becomes across a pull. Its strain is that of
/// the pull, its stress 1 - width / width at rest.
bool is_contraction(std::string_view component);

/// The units of a component's numbers.
LawUnits units_of(std::string_view component);

/// Whether a component's curves are functions of |strain|: shear and bending.
bool is_even(std::string_view component);

/// The names a cloth component may have: stretch.weft, stretch.warp, stretch.bias, shear, those of
/// `sheet_metrics`, bend.weft, ..., contraction.weft, ...
const std::vector<std::string>& cloth_component_names();

/// Those of a solid: the metrics of the Green strain.
const std::vector<std::string>& solid_component_names();

/// Those of a kind of material.
const std::vector<std::string>& component_names(MaterialKind kind);

/// The name of a term of two strains, "green.xx*green.yy" of solids, "stretch.weft*shear" of cloth,
/// as materials write it.
/// @return nothing for names of other components
std::optional<std::string> pair_term_name(std::string_view component, MaterialKind kind);

/// Whether a component is such a term.
bool is_pair_term(std::string_view component, MaterialKind kind);

/// The components that a material has, in their order: those of `component_names`, then terms of
/// two strains.
std::vector<std::string> ordered_components(
    const std::map<std::string, MaterialComponent>& components, MaterialKind kind);

/// The solid that has the components of a cloth's triangles on its metrics (sheet_metric.h): per
/// volume what the cloth has per area, where it keeps its thickness.
Material of_constant_thickness(const Material& cloth);

/// Those of the components of a kind of material whose energies a limit may be about: of cloth all
/// that act on triangles.
std::vector<std::string> limitable_components(MaterialKind kind);

/// The one-dimensional law of a component whose stiffness is given; friction is that of positive
/// strain.
ComponentLaw law_of(const MaterialComponent& component);

/// Gives a component a law; friction with constant alpha, which materials do not have, is left out.
void set_law(MaterialComponent& component, const ComponentLaw& law);

/// The same component with its stress multiplied: stiffness, friction and addends. What was known
/// of the errors of its numbers is not that of the new ones.
MaterialComponent scaled(MaterialComponent component, double factor);

/// The law of a component of a material.
/// @return nothing when the component is absent or unmeasured; friction is that of positive strain
std::optional<ComponentLaw> law_of(const Material& material, const std::string& component);

}  // namespace pliant
