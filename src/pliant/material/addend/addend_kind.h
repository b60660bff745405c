#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/density/density.h"

namespace pliant {

/// A number of an addend. Bounds, step and starts of a fit are told in units of its data: the
/// largest stress to the power `stress`, times the largest strain to the power `strain`, times how
/// long it took to the power `time`.
struct AddendParameter {
  std::string_view name;     ///< in files and results: "tau"
  std::string_view meaning;  ///< for readers of a report
  int stress = 0;            ///< power of the stress in its unit
  int strain = 0;            ///< power of the strain in its unit
  int time = 0;              ///< power of seconds in its unit
  bool scales = false;       ///< the stress is proportional to all such numbers together
  double smallest = 0;       ///< where it is above 0 no number may be 0; where it is below, numbers
                             ///< may be negative
  double largest = 0;        ///< 0: there is no bound
  double step = 1;           ///< a change that matters
};

/// A law that a component of a material may have beside its stiffness and its friction
/// (docs/extending.md): one entry of the registry (addend_registry.h) is all that files, fits,
/// labs, simulations and reports know of it.
struct AddendKind {
  std::string_view name;         ///< in files
  std::string_view description;  ///< one line for users
  std::vector<AddendParameter> parameters;
  std::vector<std::vector<double>> starts;  ///< where a fit begins, one value a parameter each

  /// The law on one strain of a material point; its parameters in the same order.
  std::unique_ptr<ParametricDensity> (*density)(int strain, const Eigen::VectorXd& values);

  /// Friction stores no energy and has no stiffness at rest: what it has sticks. A law that
  /// remembers and is no friction has an elastic range, as plasticity does.
  bool friction = false;

  /// What flows depends on time: a stress that relaxes, which there is none of where all is at
  /// rest, or friction by the rate. A fit needs to know when each row was measured.
  bool flows = false;

  /// How much the stress may fall per strain while the strain goes on, as Dahl friction does by b
  /// while it returns; null: it never falls.
  double (*fall)(const Eigen::VectorXd& values) = nullptr;
};

/// What the numbers of a component's law count in: stresses and strains have other units.
enum class LawUnits {
  membrane,  ///< N/m, strains without unit
  bending,   ///< N, strains in 1/m
  solid,     ///< Pa, strains without unit
  ratio,     ///< what is stress elsewhere has no unit either: contraction across a pull
};

/// The unit of a parameter.
std::string unit_of(const AddendParameter& parameter, LawUnits units);

/// Whether laws of a kind remember, as friction does.
bool remembers(const AddendKind& kind);

/// The unit of a parameter in the scale of data.
/// @param stress, strain  largest of the data
/// @param seconds         that the data took
double data_unit(const AddendParameter& parameter, double stress, double strain,
                 double seconds = 1);

}  // namespace pliant
