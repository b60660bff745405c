#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pliant/io/fields.h"

namespace pliant {

/// When pictures that are taken at a rate were taken, counted from the first of them by the numbers
/// in their names: 0, 1, 3 of 001, 002, 004. One after the other where names do not count them:
/// numbers that lack more than one, and more than one for every four pictures, may be times of day,
/// which jump from minute to minute.
std::vector<int> moments_by_names(const std::vector<std::filesystem::path>& files);

/// The first picture that is of another moment than that of another camera at its place; nothing
/// where all go together.
/// @param one, other  as many of each
std::optional<std::size_t> other_moment(const std::vector<std::filesystem::path>& one,
                                        const std::vector<std::filesystem::path>& other);

/// Refuses pictures of one camera that are of other moments than those of another: their counts
/// are equal where each lost another picture.
/// @param value     of the file that names them
/// @param expected  for the error
/// @throws InputError
void require_same_moments(const Value& value, const std::vector<std::filesystem::path>& one,
                          const std::vector<std::filesystem::path>& other, const char* expected);

/// What to say of pictures that lack a number, or nothing.
std::string gap_doubt(const std::vector<std::filesystem::path>& files);

}  // namespace pliant
