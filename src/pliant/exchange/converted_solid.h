#pragma once

#include <string>
#include <vector>

#include "pliant/exchange/standard_law.h"
#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// What is written for another tool, in SI units.
struct SolidToConvert {
  const Material& material;
  std::string file;                  ///< of the material, for errors
  StandardLaw law;                   ///< of the material
  const VolumeMesh* mesh = nullptr;  ///< null: the material alone
};

/// A file for another tool, and what of the material and of the mesh is not in it.
struct ConvertedSolid {
  std::string text;
  std::vector<std::string> lost;  ///< a line each
};

/// Bulk modulus over shear modulus that stands for a constant volume where a tool cannot hold one.
/// @param kCalculixBulk  CalculiX's own (Poisson's ratio 0.475): its elements lock beyond it
inline constexpr double kCalculixBulk = 20;
inline constexpr double kFebioBulk = 1000;  ///< as elements of mean dilatation bear

}  // namespace pliant
