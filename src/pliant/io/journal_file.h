#pragma once

#include <filesystem>
#include <string>

#include "pliant/base/journal.h"

namespace pliant {

/// The bytes of a journal, all numbers to the bit: a line with the type and a digest of the rest,
/// then CBOR (RFC 8949).
std::string journal_bytes(const Journal::Content& content);

/// Whether a file begins as journals do.
bool is_journal(const std::filesystem::path& file);

/// @throws InputError for a file that is no journal, or damaged
Journal::Content read_journal(const std::filesystem::path& file);

}  // namespace pliant
