#pragma once

#include <string>
#include <vector>

#include "pliant/capture/point_source.h"
#include "pliant/study/imported_study.h"

namespace pliant {

/// Options of `import` for photographs, as typed; empty where they were not.
struct PhotoArguments {
  std::string scale, crop, density, name;  // of both kinds
  std::string clamp_side = "left", clamp, tone = "auto", areal_load, direction, width;  // of strips
  int points = 31;
  bool drape = false;  ///< they are of draped specimens
  std::string specimen, disc, middle;
};

/// @throws InputError for options that are missing or cannot be used, and for pictures that show no
///         strip, or no draped specimen
ImportedStudy import_photo_files(const std::vector<std::string>& files,
                                 const PhotoArguments& arguments);

/// How pictures are read; none where the program was built without.
ReadPicture picture_reader();

}  // namespace pliant
