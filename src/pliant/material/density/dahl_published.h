#pragma once

#include "pliant/material/density/dahl.h"

namespace pliant {

/// The papers' approximation of the friction stress along one monotone stretch ([T] Eq. 5.3), which
/// drops the offset b tau. The papers' stretches keep to one side of zero strain; here a stretch
/// may cross it, its two sides joined there. Kept as the reference of the published estimator.
FrictionStress published_friction_stress(const DahlParameters& dahl, double strain,
                                         const FrictionState& from);

/// Eq. 5.3 started from a saturated anchor, sigma_0 = -s sigma_max(anchor) ([T] Eq. 5.4).
/// @param direction  sign of the strain rate since the anchor, 1 or -1
/// @return the stress with its derivatives; `from_strain` is that w.r.t. the anchor's strain
FrictionStress anchored_friction_stress(const DahlParameters& dahl, double strain, double anchor,
                                        int direction);

}  // namespace pliant
