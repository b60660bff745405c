#pragma once

#include <filesystem>
#include <string>

#include "pliant/base/errors.h"
#include "pliant/io/fields.h"

namespace pliant {

/// Another document that a dic/1 file names.
struct DicReference {
  std::filesystem::path file;
  std::string name;  ///< of what is meant in it; empty: all, or the only one
  Location where;
};

/// A path of a document, which is relative to it.
/// @param expected  what it should be, for the error
std::filesystem::path path_beside(const Value& value, const char* expected);

inline constexpr const char* kExpectedCalibration = "the calibration.json of `pliant calibrate`";

}  // namespace pliant
