#pragma once

#include <array>
#include <functional>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/component_law.h"
#include "pliant/material/cylinder_rigidity.h"
#include "pliant/material/grid_bending.h"
#include "pliant/material/material.h"

namespace pliant {

/// Laws of the components of bending, in the order weft, warp, diagonal.
using BendingLaws = std::array<ComponentLaw, 3>;

/// Curvature up to which slipping friction of hinges is made that of their sheet (1/m): amid the 20
/// to 200 /m at which strips are measured and cloth folds.
inline constexpr double kSlipCurvature = 70;

/// What remembers, on the scales of strain of hinges: a law sigma(strain) becomes s sigma(strain /
/// s).
/// - Friction: s = slip. Of Dahl friction a and tau are multiplied; its initial slope a / tau, and
///   b, which is homogeneous of degree two like elasticity, stay.
/// - Elastic ranges of other addends: s = 1 / factor. The law of hinges, multiplied by the factor,
///   then yields at the stress of the sheet's.
/// Addends follow by the units of their numbers.
/// @param factor  of elasticity
ComponentLaw with_hinge_strains(ComponentLaw law, double factor, double slip);
MaterialComponent with_hinge_strains(MaterialComponent component, double factor, double slip);

/// The law of hinges: the same, and the whole law multiplied.
ComponentLaw hinge_law(const ComponentLaw& sheet, double factor, double slip);

/// The hinges of a mesh that are bent from flat to `kSlipCurvature` under a law; bends are those
/// over the curvature.
using BentShape = std::function<std::vector<BentHinge>(const HingeStress& stress)>;

/// The scale of strain of the friction of hinges, relative to the sheet's (docs/bending.md).
///
/// Friction that sticks is a stiffness: as one it is right with the factors f of elasticity.
/// Friction that slips is homogeneous of degree one: what it takes on a way of strain E is a E,
/// less what it needs to build up, a tau tanh(E / tau) on a closed loop. With phi = f slip, hinges
/// of phi a, f b and tau phi / f lose on loops to `kSlipCurvature`, in the shape to which they bend
/// under their whole law, what their sheet loses along weft, along warp and at 45 degrees.
///
/// Of a component with several branches of friction all slip together. Where friction differs by
/// the side that of positive strain decides.
/// @param factors            of elasticity, by component
/// @param direction_weights  of squared relative errors
/// @return 1 for components whose a is zero
BendingVector hinge_slip(const BendingLaws& sheet, const BendingVector& factors,
                         const Eigen::Vector4d& direction_weights, const BentShape& shape);

}  // namespace pliant
