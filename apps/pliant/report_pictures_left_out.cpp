// Reports on simulations by a program that was built without Embree or libpng; CMake takes this
// file in place of report_pictures.cpp then.

#include "apps/pliant/report_pictures.h"

namespace pliant {

SimulationPictures report_pictures(const std::filesystem::path&, ViewDirection, const RunContext&) {
  return {.missing = "No pictures: this program was built without Embree 3 or libpng."};
}

}  // namespace pliant
