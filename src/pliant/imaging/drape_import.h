#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "pliant/imaging/drape_photo.h"
#include "pliant/study/imported_study.h"

namespace pliant {

/// What photographs of draped specimens do not show.
struct DrapeStudyOptions {
  std::string name;                    ///< of the fabric
  std::optional<double> density = {};  ///< kg/m^2, > 0
  double specimen = 0.3;               ///< diameter (m), at least `least_specimen`
  DrapePhotoOptions photo;
};

/// The study of a drape test in photographs, each a repeat: its table, the outlines, their picture,
/// and each photograph with the outline that was read off it, as NAME-outline.png.
/// @param photos  at least one, all with one camera at one place
/// @throws InputError, RefusedPhoto as `trace_drape`; InputError for a silhouette that is larger
///         than the flat specimen
ImportedStudy import_drape_photos(const std::vector<std::filesystem::path>& photos,
                                  const DrapeStudyOptions& options);

}  // namespace pliant
