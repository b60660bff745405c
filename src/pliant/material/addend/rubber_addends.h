#pragma once

#include "pliant/material/addend/addend_kind.h"

namespace pliant {

// Energies in closed form (`rubber_energies.h`) as laws of components.

const AddendKind& linear_addend();
const AddendKind& polynomial_addend();
const AddendKind& ogden_addend();
const AddendKind& arruda_boyce_addend();
const AddendKind& exponential_addend();

}  // namespace pliant
