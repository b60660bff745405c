#pragma once

#include <span>
#include <string_view>

#include "pliant/io/fields.h"
#include "pliant/material/addend/addend_kind.h"

namespace pliant {

/// All kinds of addends that there are.
std::span<const AddendKind* const> addend_kinds();

/// @return null for an unknown name
const AddendKind* find_addend_kind(std::string_view name);

/// The kind that a file names.
/// @throws InputError for an unknown name
const AddendKind& read_addend_kind(const Value& value);

}  // namespace pliant
