#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pliant/exchange/u3m_file.h"

namespace pliant {

/// What a U3M file tells about the fabric and the instrument beside its measurements.
struct U3mInfo {
  std::string name;  ///< of the fabric; empty when the file tells none
  /// Key and text, in the order in which they read well.
  std::vector<std::pair<std::string, std::string>> entries;
  /// What the vendor's software fitted (`vendor_...`), kept as text for comparison: nothing is
  /// computed from it.
  std::vector<std::pair<std::string, std::string>> vendor_parameters;
};

/// Takes what is there; a value of an unexpected kind is passed over, since none of it is measured.
/// @param file  one in which `find_physics` finds something
U3mInfo read_u3m_info(const U3mFile& file);

}  // namespace pliant
