#pragma once

#include <filesystem>
#include <string>

#include "pliant/experiment/simulation.h"

namespace pliant {

/// What tells a scene from any other: the digest of its document, its meshes, its materials and
/// what fills them.
/// @param filler  the file of `--fill`; may be empty
std::string scene_identity(const Scene& scene, const std::filesystem::path& filler);

/// The bytes of a checkpoint: everything that a simulation remembers, friction and the branches of
/// hinge angles included, bit by bit: a line with the type and a digest of the rest, then CBOR (RFC
/// 8949).
std::string checkpoint_bytes(const SimulationState& state, const std::string& identity,
                             int threads);

/// @param simulation  of the scene that the checkpoint should be of
/// @throws InputError for a file that is no checkpoint or damaged, one of another scene, and one
///         that was computed with another number of threads
SimulationState read_checkpoint(const std::filesystem::path& file, const Simulation& simulation,
                                const std::string& identity, int threads);

}  // namespace pliant
