#pragma once

#include "pliant/experiment/bending_length/bending_length_type.h"
#include "pliant/experiment/cantilever/cantilever_type.h"
#include "pliant/experiment/rolled/rolled_strip_type.h"
#include "pliant/study/virtual_lab.h"

#include "support/published_bending.h"
#include "support/virtual_lab.h"

namespace pliant::test {

/// A fabric of the table in [P] 4.3, by its name.
inline Material published_bending_material(const std::string& name) {
  for (const PublishedBending& fabric : published_bending()) {
    if (fabric.name != name) continue;
    Material material = made_up_material("bend.warp", fabric.law());
    material.name = name;
    material.density = fabric.density;
    return material;
  }
  throw std::invalid_argument("no published fabric " + name);
}

/// A strip of 100 mm by 25 mm, rolled once around each of the cylinders (radii in m) and let go.
inline VirtualRolledStrip rolled_strips(std::vector<double> radii) {
  VirtualRolledStrip experiment;
  experiment.name = "rolls";
  experiment.direction = "warp";
  experiment.width = 0.025;
  experiment.settings = std::move(radii);
  return experiment;
}

/// Strips that stick out of a clamp (overhangs in m).
inline VirtualCantilever overhanging_strips(std::vector<double> overhangs) {
  VirtualCantilever experiment;
  experiment.name = "overhangs";
  experiment.direction = "warp";
  experiment.width = 0.025;
  experiment.settings = std::move(overhangs);
  return experiment;
}

/// A strip pushed over an edge until it dips by 41.5 degrees, twice on each face.
inline VirtualBendingLength pushed_strips() {
  VirtualBendingLength experiment;
  experiment.name = "lengths";
  experiment.direction = "warp";
  experiment.width = 0.025;
  return experiment;
}

/// The cylinders of [P] 4.3.
inline std::vector<double> published_radii() {
  return {0.003, 0.004, 0.005, 0.006, 0.007, 0.0075, 0.010, 0.016, 0.023, 0.0275, 0.0315, 0.050};
}

}  // namespace pliant::test
