#pragma once

#include "pliant/material/addend/addend_kind.h"

namespace pliant {

/// A further branch of Dahl friction ([T] Eq. 5.2), beside the component's own: knits need two.
const AddendKind& dahl_branch();

}  // namespace pliant
