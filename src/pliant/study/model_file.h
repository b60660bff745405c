#pragma once

#include "pliant/experiment/model_options.h"
#include "pliant/io/fields.h"

namespace pliant {

/// Reads `model:` of a study.
/// @param kind  of what the experiments measure
/// @throws InputError
ModelOptions read_model(Fields& study, MaterialKind kind);

}  // namespace pliant
