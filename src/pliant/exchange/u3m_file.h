#pragma once

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string_view>

#include "pliant/io/document.h"
#include "pliant/io/fields.h"

namespace pliant {

/// The documents of a U3M 1.1 material (github.com/vizoogmbh/u3m) that tell about its mechanics.
struct U3mFile {
  Document physics;  ///< the measurements; see `find_physics`
  /// The description that names the physics file; absent when the user named that file directly.
  std::optional<Document> material = {};
};

/// The mapping that has the key `raw_data`: the root of a physics file, or `physics` or
/// `material.physics` within it. Nothing when there is none.
std::optional<Value> find_physics(const Document& document);

/// The material description: `material` of the file that names the physics file, or of the physics
/// file itself. Nothing when there is none.
std::optional<Value> find_material(const U3mFile& file);

/// The value at a path of keys; nothing where a key is missing, null or no mapping's.
std::optional<Value> find_value(const std::optional<Value>& root,
                                std::initializer_list<std::string_view> path);

/// Whether a file is U3M, by its name (.u3m, .u3ma) or by its content: a zip archive that is no
/// workbook, or JSON with the keys of a physics file or of a material. Whether it is sound only
/// `read_u3m_file` tells: a physics file that breaks off counts as one.
/// @throws InputError when the file cannot be read
bool is_u3m(const std::filesystem::path& path);

/// Finds the measurements: in a physics file (JSON), in the physics file that a material
/// description (.u3m, JSON) names under `material.physics.devices.fab`, or in a zip archive
/// (.u3ma, also .u3m) of these.
/// @throws InputError when a file cannot be read or there is no physics file
U3mFile read_u3m_file(const std::filesystem::path& path);

}  // namespace pliant
