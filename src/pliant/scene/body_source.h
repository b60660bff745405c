#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "pliant/io/fields.h"

namespace pliant {

/// Where the surface of a body stands: in one mesh file, or in one for each frame of a sequence,
/// all with the same faces.
struct BodySource {
  std::vector<std::filesystem::path> files;  ///< .obj, .ply; in the order of time
  double rate = 0;                           ///< frames a second, from the time 0 on; of a sequence
  double unit = 0;                           ///< m per unit of the coordinates
  std::string up = "z";                      ///< the axis that becomes the world's z
};

/// `{file, unit, up}`.
/// @throws InputError, also for a file that does not exist; its content is not looked at
BodySource read_body_mesh(const Value& value);

/// `{files, first, rate, unit, up}`; `files` has one %d, or %04d, where the number of a frame
/// stands.
/// @throws InputError, also where the numbers of the files that are there have a gap
BodySource read_body_sequence(const Value& value);

}  // namespace pliant
