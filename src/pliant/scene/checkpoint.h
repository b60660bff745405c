#pragma once

#include <filesystem>
#include <string>

#include "pliant/scene/simulation.h"

namespace pliant {

/// What tells a scene from any other: the digest of what its document says, of every file that it
/// names, of what fills its materials, and of whether they have friction. How long it lasts is left
/// out: what was simulated can be gone on with for longer.
/// @param filler  the file of `--fill`; may be empty
std::string scene_identity(const Scene& scene, const std::filesystem::path& filler);

/// The bytes of a checkpoint: everything that a simulation remembers, friction and the branches of
/// hinge angles included, bit by bit: a line with the type and a digest of the rest, then CBOR (RFC
/// 8949).
std::string checkpoint_bytes(const SimulationState& state, const std::string& identity);

/// @param simulation  of the scene that the checkpoint should be of
/// @throws InputError for a file that is no checkpoint or damaged, and one of another scene
SimulationState read_checkpoint(const std::filesystem::path& file, const Simulation& simulation,
                                const std::string& identity);

/// What a checkpoint says of itself.
struct CheckpointFacts {
  std::string identity;  ///< of its scene, as `scene_identity` tells it
  int steps = 0;
  double time = 0;  ///< s, simulated
};

/// Whether a file begins as checkpoints do.
bool is_checkpoint(const std::filesystem::path& file);

/// @throws InputError for a file that is no checkpoint or damaged
CheckpointFacts read_checkpoint_facts(const std::filesystem::path& file);

}  // namespace pliant
