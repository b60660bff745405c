#pragma once

#include "pliant/base/errors.h"
#include "pliant/experiment/virtual_test.h"
#include "pliant/material/material.h"

namespace pliant {

/// The material of a specimen's sheet: every parameter varies by itself, as those of strips do.
/// Specimens of one number are one sheet in all tests of a lab.
Material sheet_of(const VirtualSpecimen& specimen);

/// @param where  of the test, for the message
/// @throws InputError for a material without a density, or without a component that sheets need or
///         with one whose stiffness is not positive
void require_whole_sheet(const Material& material, const Location& where);

}  // namespace pliant
