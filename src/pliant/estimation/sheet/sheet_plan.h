#pragma once

#include <string>
#include <vector>

#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/unknown.h"
#include "pliant/experiment/session/sheet_test.h"

namespace pliant {

/// What a stage does with the control points of its curves.
enum class StageKind {
  constant,  ///< one for each
  grow,      ///< of a single group: more of them, while the residual falls
  again,     ///< as many as there are
  hold,      ///< nothing is looked for: what the tests tell here a last fit of everything will tell
  limit,     ///< as many as there are, and limits of energies beside them
  sample,    ///< as many as there are, those that differ from place to place at each sample
  friction,  ///< as many as there are, at equal distances or denser towards rest, and internal
             ///< friction beside them
};

/// One stage of an incremental fit: some curves, to some tests.
struct SheetStage {
  std::vector<ComponentGroup> groups;
  std::vector<const SheetTest*> tests;
  StageKind kind = StageKind::grow;
};

/// The stages of a fit: what the study asks for, else the thesis' plan ([T] 3.4.2) as far as there
/// are tests for it: stretch; shear; bending along weft and warp; diagonal bending on both; then
/// bending, all directions together, and shear, twice more. Bending is constant in all directions
/// first and its curves grow from there: what one direction lacks would bend the curve of another.
/// Springs that bend resist stretch as well: with them stretch is fitted again, too.
///
/// Limits of energies that the model has are fitted with all curves of triangles, before bending or
/// after the stages of a study. Samples come after all other curves, together with those of
/// triangles and what the model lets differ. Last comes friction, of what clips pull and is the
/// same everywhere, where sequences load and unload and the study does not say no: the prediction
/// then follows the loop and not its middle. Friction of bending, where the study states it of a
/// component, comes after that, from what hangs over a table's edge.
///
/// In isotropic variants weft and warp share a curve, which is fitted to the tests of both.
/// @param known  components that other experiments have told: stages leave them as they are
/// @throws InputError where a stage of the study names a test or a term that is not there
std::vector<SheetStage> sheet_plan(const FitSettings& settings,
                                   const std::vector<const SheetTest*>& tests,
                                   const std::vector<std::string>& known = {});

/// Whether the model lets a group of components differ from place to place.
bool may_differ(const FitSettings& settings, const ComponentGroup& group);

/// The tests of a plan, each once, in its order: those of the parts of a fit of everything.
std::vector<const SheetTest*> tests_of(const std::vector<SheetStage>& plan);

/// The components that a plan fits.
std::vector<ComponentGroup> groups_of(const std::vector<SheetStage>& plan);

}  // namespace pliant
