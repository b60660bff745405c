#include "pliant/geometry/mesh_file.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/geometry/world_positions.h"

namespace pliant {
namespace {

/// Garments that start badly stretched stay below it (0.63 has been seen), packed texture
/// coordinates do not.
constexpr double kLargestMismatch = 2;
/// A panel may be gathered or start more stretched than the whole.
constexpr double kLargestPanelMismatch = 4;
/// A sheet that starts with another area than at rest is worth a word.
constexpr double kNotableMismatch = 1.05;

std::string area_text(double area) { return format_number(area, 4) + " m^2"; }

bool is_positive(double value) { return std::isfinite(value) && value > 0; }

/// Turns the faces of a file into a sheet, step by step.
class SheetMaker {
 public:
  SheetMaker(const PolygonMesh& polygons, const MeshFileOptions& options)
      : polygons_(polygons), options_(options), file_(polygons.numbering.file) {}

  MeshFile make() && {
    check_options();
    sheet_.numbering = polygons_.numbering;
    cut_faces();
    place_in_world();
    set_rest_shape();
    // First of all: packed texture coordinates often hold mirrored parts too.
    if (options_.rest == RestShape::uv) check_areas();
    turn_counter_clockwise();
    return std::move(sheet_);
  }

 private:
  TriangleMesh& mesh() { return sheet_.mesh; }

  [[noreturn]] void fail(const char* field, const std::string& problem,
                         const std::string& expected) const {
    throw InputError({file_, 0, field}, problem, expected);
  }

  void check_options() const {
    if (!is_positive(options_.unit)) {
      fail("unit", "the length unit of the file is not given", "metres per unit, above 0");
    }
    if (options_.uv_scale && !is_positive(*options_.uv_scale)) {
      fail("uv_scale", fmt::format("{} is no scale", *options_.uv_scale),
           "metres per unit of the texture coordinates, above 0");
    }
    if (options_.rest == RestShape::uv) check_texture();
  }

  /// Every corner has its texture coordinates.
  void check_texture() const {
    if (!polygons_.has_texture()) {
      fail("rest", "the file has no texture coordinates",
           "an OBJ file with vt lines, or `rest: shape`");
    }
    for (std::size_t face = 0; face < polygons_.faces.size(); ++face) {
      for (std::size_t c = polygons_.faces.begin_of(face); c < polygons_.faces.ends[face]; ++c) {
        if (polygons_.texture.col(static_cast<Eigen::Index>(c)).allFinite()) continue;
        const int index = static_cast<int>(face);
        throw InputError({file_, polygons_.numbering.line_of_face(index), "rest"},
                         fmt::format("face {} has a corner without texture coordinates",
                                     polygons_.numbering.shown(index)),
                         "a vt for every corner, or `rest: shape`");
      }
    }
  }

  void cut_faces() {
    const Eigen::Matrix2Xd plane =
        options_.rest == RestShape::uv ? polygons_.texture : face_planes(polygons_);
    CutFaces cut = cut_into_triangles(polygons_.faces, plane, polygons_.numbering);
    mesh().triangles =
        cut.corners.unaryExpr([this](int corner) { return polygons_.faces.corners[corner]; });
    corners_ = std::move(cut.corners);
    sheet_.numbering.faces = std::move(cut.faces);
  }

  void place_in_world() {
    mesh().positions = world_positions(polygons_, options_.unit, options_.up);
  }

  void set_rest_shape() {
    if (options_.rest == RestShape::uv) {
      const double scale = options_.uv_scale.value_or(options_.unit);
      mesh().rest_corners = scale * polygons_.texture(Eigen::all, corners_.reshaped());
      return;
    }
    ShapeLayout layout = lay_out_shape(mesh().positions, mesh().triangles);
    mesh().rest_corners = std::move(layout.rest_corners);
    if (layout.flat) return;
    sheet_.warnings.push_back(
        "the mesh is not flat: each triangle is at rest as it is, with weft where the x axis "
        "projects on it");
  }

  void turn_counter_clockwise() {
    int clockwise = 0, counter_clockwise = 0;
    int first_clockwise = 0, first_counter_clockwise = 0;
    for (int t = mesh().triangle_count() - 1; t >= 0; --t) {
      const double area = rest_area(mesh(), t);
      if (area < 0) ++clockwise, first_clockwise = t;
      if (area > 0) ++counter_clockwise, first_counter_clockwise = t;
    }
    if (clockwise == 0) return;
    if (counter_clockwise > 0) {
      const bool odd = clockwise <= counter_clockwise;
      fail_mixed(odd ? first_clockwise : first_counter_clockwise,
                 odd ? "clockwise" : "counter-clockwise", std::min(clockwise, counter_clockwise));
    }
    reverse_corners();
    sheet_.warnings.push_back(
        "all faces run clockwise at rest: their corners are taken in reverse, the sheet's front is "
        "its back in the file");
  }

  [[noreturn]] void fail_mixed(int triangle, const char* direction, int count) const {
    const int face = sheet_.numbering.face_of(triangle);
    throw InputError(
        {file_, sheet_.numbering.line_of(triangle)},
        fmt::format("face {} runs {} at rest, unlike most ({} of {} triangles do)",
                    sheet_.numbering.shown(face), direction, count, sheet_.mesh.triangle_count()),
        "faces that all run the same way; mirrored texture coordinates must be turned over");
  }

  void reverse_corners() {
    mesh().triangles.row(1).swap(mesh().triangles.row(2));
    for (int t = 0; t < mesh().triangle_count(); ++t) {
      mesh().rest_corners.col(3 * t + 1).swap(mesh().rest_corners.col(3 * t + 2));
    }
  }

  void check_areas() {
    const AreaPair total = compare_areas(mesh());
    if (!(total.mismatch() <= kLargestMismatch)) fail_scale(total);
    check_panels();
    if (total.mismatch() > kNotableMismatch) {
      sheet_.warnings.push_back(
          fmt::format("the sheet starts {}: its area is {} in space and {} at rest",
                      total.space > total.rest ? "stretched" : "compressed", area_text(total.space),
                      area_text(total.rest)));
    }
  }

  [[noreturn]] void fail_scale(const AreaPair& area) const {
    std::string expected = fmt::format("areas within a factor of {}", kLargestMismatch);
    if (area.rest > 0 && area.space > 0) {
      const double scale =
          options_.uv_scale.value_or(options_.unit) * std::sqrt(area.space / area.rest);
      expected += fmt::format(" (uv_scale: {} would make them equal)",
                              format_quantity(scale, Dimension::length));
    }
    fail("uv_scale", "the faces cover " + in_space_and_at_rest(area), expected);
  }

  void check_panels() const {
    const std::vector<int> panels = find_panels(sheet_.mesh);
    const std::vector<AreaPair> areas = compare_areas(sheet_.mesh, panels);
    for (int t = 0; t < sheet_.mesh.triangle_count(); ++t) {
      const AreaPair& area = areas[panels[t]];
      if (area.mismatch() <= kLargestPanelMismatch) continue;
      const int face = sheet_.numbering.shown(sheet_.numbering.face_of(t));
      fail("uv_scale",
           fmt::format("the panel of face {} covers {}", face, in_space_and_at_rest(area)),
           fmt::format("panels of one scale, each with areas within a factor of {}",
                       kLargestPanelMismatch));
    }
  }

  static std::string in_space_and_at_rest(const AreaPair& area) {
    return fmt::format(
        "{} in space and {} by their texture coordinates, which are packed or scaled",
        area_text(area.space), area_text(area.rest));
  }

  const PolygonMesh& polygons_;
  const MeshFileOptions& options_;
  const std::string& file_;
  MeshFile sheet_;
  Eigen::Matrix3Xi corners_;  // of each triangle, numbers of corners of polygons_.faces
};

}  // namespace

MeshFile make_sheet(const PolygonMesh& polygons, const MeshFileOptions& options) {
  return SheetMaker(polygons, options).make();
}

MeshFile read_mesh_file(const std::filesystem::path& path, const MeshFileOptions& options) {
  MeshFile sheet = make_sheet(read_polygon_mesh(path), options);
  require_good_mesh(sheet.mesh, sheet.numbering);
  return sheet;
}

}  // namespace pliant
