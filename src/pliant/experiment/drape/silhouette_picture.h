#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/experiment/drape/draped_sheet.h"

namespace pliant {

/// A silhouette and what it is called below the picture.
struct NamedSilhouette {
  std::string name;
  const DrapedSheet& sheet;
};

/// Silhouettes of a specimen over each other, seen from above, with the disc and the flat
/// specimen around them, to scale: an SVG document.
/// @param title  above the picture
std::string silhouette_picture(const std::string& title, const std::vector<NamedSilhouette>& draped,
                               const DrapeSetup& setup);

}  // namespace pliant
