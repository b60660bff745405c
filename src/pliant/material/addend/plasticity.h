#pragma once

#include "pliant/material/addend/addend_kind.h"

namespace pliant {

/// An elastic range of a width that stays, beyond which the strain stays too (`PlasticDensity`).
const AddendKind& plasticity();

/// The same, up to a largest plastic strain.
const AddendKind& saturating_plasticity();

}  // namespace pliant
