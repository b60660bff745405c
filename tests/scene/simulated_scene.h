#pragma once

#include <string>

#include "pliant/material/material_file.h"
#include "pliant/scene/simulation.h"

#include "scene/scene_text.h"

namespace pliant::test {

/// A scene of which the first line is left out, with what its materials lack from the cloth that
/// the examples assume.
inline Simulation simulated(const std::string& scene) {
  return Simulation(read_scene_text("pliant: scene/1\n" + scene),
                    read_material(PLIANT_SOURCE_DIR "/examples/assumed-cloth.json"));
}

}  // namespace pliant::test
