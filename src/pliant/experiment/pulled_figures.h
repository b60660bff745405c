#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pliant/experiment/uniaxial_geometry.h"
#include "pliant/material/component_law.h"

namespace pliant {

/// One way of a pull: extension (1) and force per width (N/m) row by row.
struct PulledWay {
  std::vector<double> extension, load;

  double largest_load() const;
  /// Extension at which the load is first reached, out or back; nothing where it is not.
  std::optional<double> extension_at(double load) const;
  /// Work per area of what pulls (N/m), from the first row to an extension.
  double work_to(double extension) const;
};

/// A pull and its way back, which may be empty.
struct PulledCycle {
  PulledWay out, back;
};

inline constexpr double kGramForcePerCm = 0.980665;               ///< N/m
inline constexpr double kKesTensileLoad = 500 * kGramForcePerCm;  ///< N/m, where KES-FB1 turns
inline constexpr double kFastLoads[] = {5 * kGramForcePerCm, 20 * kGramForcePerCm,
                                        100 * kGramForcePerCm};  ///< N/m, of FAST-3

/// What the tensile test of the Kawabata system (KES-FB1) prints of a pull to 500 gf/cm and back.
struct KesTensile {
  double extension = 0;              ///< EMT (1)
  double linearity = 0;              ///< LT: work over that of a straight line to the same point
  double work = 0;                   ///< WT (J/m^2)
  std::optional<double> resilience;  ///< RT: share of the work that comes back; nothing where the
                                     ///< pull turns elsewhere than within 5 % of 500 gf/cm
};

/// @return nothing where the pull does not come to 500 gf/cm
std::optional<KesTensile> kes_tensile(const PulledCycle& cycle);

/// What ISO 20932-1 tells of a cycle to a force and back, without a pause.
struct ElasticRecovery {
  double elongation = 0;  ///< at the largest force, over the gauge length
  double permanent = 0;   ///< where the force has fallen to a pretension of 1 cN/cm
  double recovery() const { return 1 - permanent / elongation; }
};

/// @return nothing where the force does not come back to the pretension
std::optional<ElasticRecovery> elastic_recovery(const PulledCycle& cycle);

/// Shear rigidity by FAST (N/m): 123 over the extension in % along the bias at 5 gf/cm.
double fast_shear_rigidity(double bias_extension);

/// Formability by FAST (m^2), (E20 - E5) B / 14.7 in its units: %, uN m, mm^2.
double fast_formability(double e5, double e20, double rigidity);

/// A law's strip, pulled from rest to a force per width and back until it carries none.
/// @return nothing where it does not come to the force within an extension of 300 %
std::optional<PulledCycle> pulled_to(const ComponentLaw& law, MembraneMeasure measure, double load);

}  // namespace pliant
