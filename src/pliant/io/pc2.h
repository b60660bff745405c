#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <span>
#include <vector>

#include "pliant/io/mesh_data.h"

namespace pliant {

/// Writes a PC2 point cache (Blender's mesh cache modifier) frame by frame. The file is complete
/// and valid after each of them.
class Pc2Writer {
 public:
  /// Starts a new file, whatever stood there before.
  /// @param frame_step  frames of the animation between two frames of the cache
  /// @throws InputError when the file cannot be created
  Pc2Writer(std::filesystem::path path, int point_count, double frame_step = 1);

  /// Goes on with a file of an earlier run behind its first `frames` frames; later ones are cut
  /// off.
  /// @throws InputError when it is no such file, has other points, or has fewer frames
  static Pc2Writer resume(const std::filesystem::path& path, int point_count, int frames);

  /// @param points  as many as the cache has, in the coordinates of the mesh it belongs to
  /// @throws OutputError
  void append(std::span<const Point3> points);

  int frame_count() const { return frame_count_; }

 private:
  Pc2Writer() = default;
  void write(std::streamoff at, const std::string& bytes);

  std::filesystem::path path_;
  std::fstream file_;
  int point_count_ = 0;
  int frame_count_ = 0;
};

/// A whole point cache.
struct Pc2Cache {
  int point_count = 0;
  double start_frame = 0;
  double frame_step = 1;
  std::vector<std::vector<std::array<float, 3>>> frames;
};

/// @throws InputError
Pc2Cache read_pc2(const std::filesystem::path& path);

}  // namespace pliant
