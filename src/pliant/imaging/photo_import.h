#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pliant/imaging/strip_photo.h"
#include "pliant/study/imported_study.h"

namespace pliant {

/// What photographs do not show.
struct PhotoStudyOptions {
  std::string name;       ///< of the fabric
  std::string direction;  ///< of the yarns that are bent: warp, weft, bias
  double density = 0;     ///< kg/m^2, > 0
  double width = 0;       ///< m; 0: not stated
  StripPhotoOptions photo;
};

/// The study of cantilevers in photographs, each a repeat: its table, and each photograph with the
/// profile that was read off it, as NAME-profile.png.
/// @param photos  at least one, all with one camera at one place
/// @throws InputError, RefusedPhoto as `trace_strip`
ImportedStudy import_photos(const std::vector<std::filesystem::path>& photos,
                            const PhotoStudyOptions& options);

}  // namespace pliant
