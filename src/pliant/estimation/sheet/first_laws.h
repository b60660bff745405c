#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "pliant/estimation/fit_settings.h"
#include "pliant/estimation/unknown.h"
#include "pliant/material/material.h"

namespace pliant {

/// Components by name.
using KnownComponents = std::map<std::string, MaterialComponent>;

/// What a search begins with: one stiffness for each component, which may be one that the study
/// fixes, and the measures of a model. Its bending is that of a sheet where a known component
/// bends, else that of hinges.
/// @param known  components whose laws are known, and kept
Material first_sheet_material(const FitSettings& settings, const KnownComponents& known = {});

/// Whether a study asks for a component that a sheet is whole without: in its model, or by its
/// plan.
bool asks_for(const FitSettings& settings, const std::string& component);

/// The components on metrics of triangles and on two strains (sheet_metric.h) that it asks for.
std::vector<std::string> asked_metrics(const FitSettings& settings);

/// The law of a term of two strains where its search begins: nothing of any addend.
ComponentLaw first_pair_law(const std::vector<const AddendKind*>& addends);

/// Gaussian terms of two strains of a cloth that stand for the one that a study asks them of.
/// @param strains  the largest of either
std::vector<std::string> sheet_gaussians(const std::string& pair, int count,
                                         const std::array<double, 2>& strains);

/// Laws of one stiffness that a search for bending may begin at, stiff ones first: soft sheets
/// fold, and take long. What bends diagonally is not far from what bends along the threads.
/// @param material  so far
std::vector<ComponentLaw> first_bending(const Material& material, const ComponentGroup& group);

/// The kind of a group's stiffness where it grows.
CurveKind grown_kind(const FitSettings& settings, const ComponentGroup& group);

/// A curve of a kind through other control points, up to a strain: at equal distances, or by a
/// power of them denser towards rest. At the points it is, or its energy or second derivative is,
/// what it was.
/// @param kind  with control points
ScalarCurve with_points(const ScalarCurve& curve, CurveKind kind, int points, double strain,
                        int power = 1);

/// What a study asks of the law of a group: what it says of the first component that it names.
ComponentModel model_of(const FitSettings& settings, const ComponentGroup& group);

/// Whether a study asks for friction of a group beside its addends, or leaves it to the data.
bool asks_for_friction(const FitSettings& settings, const ComponentGroup& group);

/// Whether the study itself asks for friction of a component of a group.
bool states_friction(const FitSettings& settings, const ComponentGroup& group);

/// Laws with friction of a tenth of the largest stress, spread over a share of the largest strain.
std::vector<ComponentLaw> first_friction(const ComponentLaw& elastic, double strain);

/// A law with the addends of a model, those that remember or the others, at all of their
/// beginnings: of a tenth of the stress at the largest strain, or of all of it where the model has
/// no stiffness beside them.
/// @return nothing where the model has none
std::vector<ComponentLaw> first_addends(const ComponentLaw& law, const ComponentModel& model,
                                        double strain, bool remembering);

/// What to tell of the addends that the study asks for and a fitted law lacks; nothing where it has
/// them all.
std::string missing_addends(const FitSettings& settings, const ComponentGroup& group,
                            const ComponentLaw& law);

}  // namespace pliant
