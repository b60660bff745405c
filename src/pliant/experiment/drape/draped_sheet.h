#pragma once

#include <functional>
#include <string>
#include <vector>

#include "pliant/base/errors.h"
#include "pliant/base/progress.h"
#include "pliant/base/random.h"
#include "pliant/experiment/drape/drape_figures.h"
#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/experiment/drape/silhouette.h"
#include "pliant/geometry/triangle_mesh.h"
#include "pliant/material/material.h"

namespace pliant {

/// A specimen that hangs over its disc in equilibrium.
struct DrapedSheet {
  TriangleMesh shape;  ///< what hangs, the middle of the disc's top at the origin, z up
  Silhouette silhouette;
  DrapeFigures figures;
  int crossings = 0;                  ///< pairs of triangles that pass through each other
  std::vector<std::string> warnings;  ///< of the material on the mesh, and of what was found
};

/// @param where  of the test, for the message
/// @throws InputError for a material without a density, or without a component that sheets need, or
///         made of springs, which need a grid
void require_drapable(const Material& material, const Location& where);

/// How the work on a specimen is followed.
struct DrapeWork {
  StopToken stop = {};
  int threads = 1;  ///< on which nothing depends
};

/// Drapes a specimen (Cusick 1965, ISO 9073-9): a round sheet, its middle held flat between two
/// discs, is let down into its history, comes to rest and to an equilibrium of its elasticity, its
/// internal friction and its weight. It moves through time in steps of 10 ms, which damp, in air;
/// the equilibrium at the end is exact.
///
/// The sheet does not feel itself: what passes through itself is counted and told. The discs are
/// thin, so that it may hang inward below them.
/// @param material  with all components of a sheet, and a density
/// @param chance    a mesh at another angle to the yarns, and heights that scatter by 10 um to
///                  begin with: what decides between equilibria that are alike
/// @throws SolverError where it finds no rest or no equilibrium
DrapedSheet drape(const Material& material, const DrapeSetup& setup, RandomStream chance,
                  const DrapeWork& work = {});

}  // namespace pliant
