#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "io/temporary_folder.h"

namespace pliant::test {

/// Results of a simulation, made by hand: a square of 1 m in two triangles that stands on its lower
/// edge and falls to the floor, with a field `strain_weft`.
class SimulationFolder {
 public:
  explicit SimulationFolder(int frames) {
    std::string list;
    for (int i = 0; i < frames; ++i) {
      const double height = 1 - double(i) / frames;
      folder_.write(fmt::format("sim/frames/{:06}.ply", i), ply(height, 0.01 * i));
      list += fmt::format("{}{{\"index\": {}, \"time\": {}}}", i == 0 ? "" : ", ", i, 0.04 * i);
    }
    write_summary(list);
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  std::filesystem::path write(const std::string& name, std::string_view content) const {
    return folder_.write(name, content);
  }

  /// @param frames  the items of the list of frames, as JSON
  /// @param more    further keys, each after a comma
  void write_summary(const std::string& frames, const std::string& more = "") const {
    folder_.write("sim/simulation.json",
                  fmt::format("{{\"pliant\": \"simulation/1\", \"triangles\": 2, \"steps\": 9,\n"
                              " \"frames\": [{}],\n \"fields\": {{\"strain_weft\": \"1\"}}{}}}\n",
                              frames, more));
  }

 private:
  static std::string ply(double height, double strain) {
    return fmt::format(
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
        "property double z\nproperty double strain_weft\nelement face 1\n"
        "property list uchar int vertex_indices\nend_header\n"
        "0 0 0 0\n1 0 0 {1}\n1 0 {0} {1}\n0 0 {0} 0\n4 0 1 2 3\n",
        height, strain);
  }

  TemporaryFolder folder_;
};

}  // namespace pliant::test
