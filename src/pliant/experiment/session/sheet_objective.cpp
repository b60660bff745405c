#include "pliant/experiment/session/sheet_objective.h"

#include "pliant/base/assert.h"

namespace pliant {

std::string_view name_of(SheetObjective objective) {
  switch (objective) {
    case SheetObjective::clip_forces:
      return "clip-forces";
    case SheetObjective::parallel_clip_forces:
      return "parallel-clip-forces";
    case SheetObjective::axial_clip_forces:
      return "axial-clip-forces";
    case SheetObjective::positions:
      return "positions";
  }
  return "";
}

SheetObjective sheet_objective(std::string_view name) {
  for (const SheetObjective objective :
       {SheetObjective::clip_forces, SheetObjective::parallel_clip_forces,
        SheetObjective::axial_clip_forces}) {
    if (name == name_of(objective)) return objective;
  }
  PLIANT_ASSERT(name == name_of(SheetObjective::positions), "an objective has a name");
  return SheetObjective::positions;
}

}  // namespace pliant
