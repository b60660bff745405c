#pragma once

#include "pliant/experiment/session/virtual/options.h"
#include "pliant/io/fields.h"
#include "pliant/material/material.h"

namespace pliant {

/// Reads what an experiment of the type session has in a lab/1 file beside its name and type.
/// @throws InputError
VirtualSession read_virtual_session(Fields& fields);

/// @param where  of the experiment
/// @throws InputError where a sheet of the material cannot be simulated in a session
void require_sheet_material(const Material& material, const VirtualSession& options,
                            const Location& where);

}  // namespace pliant
