#pragma once

#include <string_view>

namespace pliant {

/// What of a session a fit compares ([T] 3.4.1).
enum class SheetObjective {
  clip_forces,           ///< of all clips that cords pull: stretch
  parallel_clip_forces,  ///< along the clips, where shear shows and stretch does not
  axial_clip_forces,     ///< away from the other clips: strips in a tensile tester
  positions,             ///< of the nodes that are free: bending, which no force is measured in
};

/// `clip-forces`, `parallel-clip-forces`, `axial-clip-forces`, `positions`.
std::string_view name_of(SheetObjective objective);

/// The objective of a name that `name_of` gives.
SheetObjective sheet_objective(std::string_view name);

}  // namespace pliant
