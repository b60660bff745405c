#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/sheet/first_laws.h"
#include "pliant/estimation/sheet/sheet_plan.h"
#include "pliant/estimation/sheet/sheet_problem.h"

namespace pliant {

/// A material fitted to full-field sessions, stage by stage ([T] 3.4).
struct SheetFit {
  Material material;    ///< complete: components without test are guesses
  CordFrictions cords;  ///< of the tests whose cords are unknown
  std::vector<ComponentGroup> groups;
  std::vector<SheetStage> plan;                           ///< as it was carried out
  std::vector<std::shared_ptr<const SheetTest>> thinned;  ///< tests of the plan without the frames
                                                          ///< that have no equilibrium
  std::vector<FitStage> stages;
  std::vector<StartRecord> starts;
  std::vector<std::string> warnings;
  std::map<std::string, double> strains;  ///< largest of the fitted sheets, by component
  EquilibriumWork work;  ///< seconds: of this run alone, where it went on from another
  bool converged = true;
};

/// The largest strain of a group in the fitted sheets, as far as it is known.
double largest_strain(const SheetFit& fit, const ComponentGroup& group);

/// Fits the stages of a plan one after the other.
///
/// The curve of a group grows from one control point by equal distances over the strains of the
/// fitted sheet until the residual falls by less than 1 % ([T] 3.4.2), or by less than noise may
/// make a point earn (BIC). The thesis takes the strains
/// of the measured shapes, in which noise shows as strain of small triangles.
///
/// Unknown friction of cords is fitted along in stages of friction, and in elastic ones that
/// compare forces where none follows. Beside it the cloth has friction only where that makes the
/// residual fall by half, or by 1 % and more than its three parameters are worth with as many
/// control points as the curve is worth without it.
///
/// Up to a quarter of the frames of a test between clips is left out, where they have no
/// equilibrium with the first stiffnesses. A stage whose sheets have no equilibria at all is left
/// out with a warning, and the fit counts as not converged.
/// @param start  null, or a material of the study's model whose curves are the first ones
/// @param known  laws that stay as they are
/// @throws SolverError where no stage is left
SheetFit fit_sheets(const FitSettings& settings, std::vector<SheetStage> plan,
                    const RunContext& context, const Material* start = nullptr,
                    const KnownComponents& known = {});

}  // namespace pliant
