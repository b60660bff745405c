// Pictures of solids that are cut: what is inside shows.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/geometry/block_mesh.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/io/ply.h"
#include "pliant/render/simulation_pictures.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

constexpr double kSide = 0.1;

/// Results of a simulation of a cube, with a field that is 1 at its inner nodes and 0 outside.
class CubeFolder {
 public:
  explicit CubeFolder(const VolumeMesh& mesh) {
    folder_.write("solids.vtu", volume_file_text(mesh, "solids.vtu"));
    PlyMesh ply;
    PlyColumn inside{"inside", {}};
    for (const auto& x : mesh.positions.colwise()) {
      ply.positions.push_back({x(0), x(1), x(2)});
      const bool inner = x.minCoeff() > 1e-9 && x.maxCoeff() < kSide - 1e-9;
      inside.values.push_back(inner ? 1 : 0);
    }
    ply.vertex_columns.push_back(inside);
    const BoundarySurface surface = boundary_surface(mesh);
    for (const auto& t : surface.triangles.colwise()) {
      ply.faces.add(std::array{t(0), t(1), t(2)});
    }
    folder_.write("frames/000000.ply", write_ply(ply));
    folder_.write("simulation.json",
                  "{\"pliant\": \"simulation/1\", \"frames\": [{\"index\": 0, \"time\": 0}],\n"
                  " \"fields\": {\"inside\": \"1\"}, \"solids\": \"solids.vtu\"}\n");
  }

  /// Seen along +y, with the colours of the field.
  Image picture(std::optional<AxisPlane> cut) const {
    PictureOptions options;
    options.size = {90, 90};
    options.quality.samples = 4;
    options.view = ViewDirection::front;
    options.field = "inside";
    options.range = {0, 1};
    options.cut = cut;
    const SimulationFrames simulation = read_simulation_frames(folder_.path());
    const PictureSetting setting = setting_of(simulation, options, LegendPlace::beside, {});
    Image image = frame_picture(simulation, simulation.frames[0], setting, options, {});
    return image;
  }

 private:
  test::TemporaryFolder folder_;
};

/// Of viridis the last colour is yellow, the first a dark violet.
bool is_yellow(const Pixel& p) { return p[1] > 150 && p[2] < 120; }
bool is_violet(const Pixel& p) { return p[1] < 80 && p[2] > p[1]; }

TEST(SolidPictures, ShowTheInsideWhereTheyAreCut) {
  for (const VolumeMesh& mesh : {block_of_tetrahedra(Eigen::Vector3d::Constant(kSide), {4, 4, 4}),
                                 block_of_hexahedra(Eigen::Vector3d::Constant(kSide), {4, 4, 4})}) {
    const CubeFolder folder(mesh);
    const Image whole = folder.picture(std::nullopt);
    EXPECT_TRUE(is_violet(whole.at(40, 45)));
    const Image cut = folder.picture(AxisPlane{1, kSide / 2});
    EXPECT_TRUE(is_yellow(cut.at(40, 45)));
    const Image gone = folder.picture(AxisPlane{1, 2 * kSide});
    EXPECT_FALSE(is_violet(gone.at(40, 45)) || is_yellow(gone.at(40, 45)));
  }
}

}  // namespace
}  // namespace pliant
