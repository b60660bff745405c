#pragma once

#include <string>
#include <vector>

#include "pliant/study/imported_study.h"

namespace pliant {

/// Options of `import` for photographs, as typed; empty where they were not.
struct PhotoArguments {
  std::string scale, clamp_side = "left", clamp, crop, tone = "auto";
  std::string density, areal_load, direction, width, name;
  int points = 31;
};

/// @throws InputError for options that are missing or cannot be used, and for pictures that show no
///         strip
ImportedStudy import_photo_files(const std::vector<std::string>& files,
                                 const PhotoArguments& arguments);

}  // namespace pliant
