#include "pliant/geometry/polygon_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/obj.h"
#include "pliant/io/ply.h"

namespace pliant {
namespace {

/// A cut through a polygon: a triangle below this part of the whole area is degenerate, and a
/// corner that turns the wrong way by less is straight.
constexpr double kNegligible = 1e-6;
constexpr std::size_t kMaxFaceCorners = 256;

std::string lower_case_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

Eigen::Matrix3Xd to_matrix(const std::vector<Point3>& points) {
  Eigen::Matrix3Xd matrix(3, points.size());
  for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
    matrix.col(i) = Eigen::Map<const Eigen::Vector3d>(points[i].data());
  }
  return matrix;
}

Eigen::Matrix2Xd texture_of(const ObjMesh& obj) {
  Eigen::Matrix2Xd texture(2, obj.texture_corners.size());
  for (Eigen::Index i = 0; i < texture.cols(); ++i) {
    const int point = obj.texture_corners[i];
    if (point < 0) {
      texture.col(i).setConstant(std::numeric_limits<double>::quiet_NaN());
    } else {
      texture.col(i) = Eigen::Map<const Eigen::Vector2d>(obj.texture_points[point].data());
    }
  }
  return texture;
}

PolygonMesh from_obj(ObjMesh obj, const std::string& file) {
  PolygonMesh mesh;
  mesh.numbering = {
      file, 1, {}, std::move(obj.face_lines), std::move(obj.vertex_lines), std::move(obj.groups)};
  mesh.positions = to_matrix(obj.positions);
  mesh.texture = texture_of(obj);
  mesh.faces = std::move(obj.faces);
  for (const auto& [statement, count] : obj.ignored) {
    mesh.ignored.push_back(
        fmt::format("{} line{} \"{}\"", count, count == 1 ? "" : "s", statement));
  }
  return mesh;
}

PolygonMesh from_ply(PlyMesh ply, const std::string& file) {
  PolygonMesh mesh;
  mesh.numbering.file = file;
  mesh.positions = to_matrix(ply.positions);
  mesh.faces = std::move(ply.faces);
  mesh.ignored = std::move(ply.ignored);
  for (const PlyColumn& column : ply.vertex_columns) {
    mesh.ignored.push_back(fmt::format("{} of each vertex", quoted_value(column.name)));
    std::vector<int>& group = mesh.numbering.groups[column.name];
    for (std::size_t i = 0; i < column.values.size(); ++i) {
      if (column.values[i] != 0) group.push_back(static_cast<int>(i));
    }
  }
  for (const PlyColumn& column : ply.face_columns) {
    mesh.ignored.push_back(fmt::format("{} of each face", quoted_value(column.name)));
  }
  return mesh;
}

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// One polygon in its plane.
class PlanePolygon {
 public:
  PlanePolygon(const Eigen::Matrix2Xd& plane, std::size_t begin, std::size_t count)
      : points_(
            plane.middleCols(static_cast<Eigen::Index>(begin), static_cast<Eigen::Index>(count))) {
    for (int i = 1; i + 1 < size(); ++i) area_ += triangle_area(0, i, i + 1);
  }

  int size() const { return static_cast<int>(points_.cols()); }

  /// Whether it turns the same way at every corner, and once around.
  bool is_convex() const {
    const double least = -kNegligible * std::abs(area_);
    double turned = 0;
    for (int i = 0; i < size(); ++i) {
      const Eigen::Vector2d in = edge(i), out = edge((i + 1) % size());
      if (std::copysign(1.0, area_) * cross(in, out) < least) return false;
      turned += std::atan2(cross(in, out), in.dot(out));
    }
    return std::abs(turned) < 3 * std::numbers::pi;
  }

  /// The first corner whose triangles all have an area; 0 when there is none.
  int best_apex() const {
    for (int apex = 0; apex < size(); ++apex) {
      bool good = true;
      for (int i = 1; i + 1 < size() && good; ++i) {
        good = std::abs(triangle_area(apex, (apex + i) % size(), (apex + i + 1) % size())) >
               kNegligible * std::abs(area_);
      }
      if (good) return apex;
    }
    return 0;
  }

 private:
  Eigen::Vector2d edge(int i) const { return points_.col((i + 1) % size()) - points_.col(i); }
  double triangle_area(int a, int b, int c) const {
    return cross(points_.col(b) - points_.col(a), points_.col(c) - points_.col(a)) / 2;
  }

  Eigen::Matrix2Xd points_;
  double area_ = 0;
};

/// Where the triangles of a face meet.
int apex_of(const Polygons& faces, std::size_t face, const Eigen::Matrix2Xd& plane,
            const MeshNumbering& numbering) {
  const std::size_t begin = faces.begin_of(face), count = faces.ends[face] - begin;
  if (count == 3) return 0;
  const auto fail = [&](const std::string& problem, const std::string& expected) {
    const int index = static_cast<int>(face);
    throw InputError({numbering.file, numbering.line_of_face(index)},
                     fmt::format("face {} {}", numbering.shown(index), problem), expected);
  };
  if (count > kMaxFaceCorners) {
    fail(fmt::format("has {} corners", count), fmt::format("at most {}", kMaxFaceCorners));
  }
  const PlanePolygon polygon(plane, begin, count);
  if (!polygon.is_convex()) {
    fail(fmt::format("({} corners) is not convex", count),
         "convex faces, or faces cut into triangles");
  }
  return polygon.best_apex();
}

}  // namespace

bool is_mesh_file(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  return extension == ".obj" || extension == ".ply";
}

PolygonMesh read_polygon_mesh(const std::filesystem::path& path) {
  const std::string extension = lower_case_extension(path);
  const std::string file = path.string();
  if (!is_mesh_file(path)) {
    throw InputError({file}, "unknown kind of mesh file " + quoted_value(extension),
                     "an .obj or .ply file");
  }
  PolygonMesh mesh =
      extension == ".obj" ? from_obj(read_obj(path), file) : from_ply(read_ply(path), file);
  if (mesh.faces.size() == 0) throw InputError({file}, "the mesh has no faces", "a surface");
  if (mesh.faces.corners.size() > std::numeric_limits<int>::max() / 3) {
    throw InputError({file}, "the mesh is too large", "fewer faces");
  }
  return mesh;
}

CutFaces cut_into_triangles(const Polygons& faces, const Eigen::Matrix2Xd& plane,
                            const MeshNumbering& numbering) {
  CutFaces cut;
  std::vector<std::array<int, 3>> triangles;
  for (std::size_t face = 0; face < faces.size(); ++face) {
    const int begin = static_cast<int>(faces.begin_of(face));
    const int count = static_cast<int>(faces.ends[face]) - begin;
    const int apex = apex_of(faces, face, plane, numbering);
    for (int i = 1; i + 1 < count; ++i) {
      triangles.push_back(
          {begin + apex, begin + (apex + i) % count, begin + (apex + i + 1) % count});
      cut.faces.push_back(static_cast<int>(face));
    }
  }
  cut.corners = Eigen::Map<const Eigen::Matrix3Xi>(triangles.data()->data(), 3,
                                                   static_cast<Eigen::Index>(triangles.size()));
  return cut;
}

Eigen::Matrix2Xd face_planes(const PolygonMesh& mesh) {
  Eigen::Matrix2Xd plane(2, mesh.faces.corners.size());
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    const std::span<const int> corners = mesh.faces[face];
    // Newell's normal: the sum over the triangles from any point.
    const Eigen::Vector3d origin = mesh.positions.col(corners[0]);
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      normal += (mesh.positions.col(corners[i]) - origin)
                    .cross(mesh.positions.col(corners[i + 1]) - origin);
    }
    const Eigen::Vector3d first = normal.unitOrthogonal();
    const Eigen::Vector3d second = normal.normalized().cross(first);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Eigen::Vector3d offset = mesh.positions.col(corners[i]) - origin;
      plane.col(static_cast<Eigen::Index>(mesh.faces.begin_of(face) + i)) << offset.dot(first),
          offset.dot(second);
    }
  }
  return plane;
}

}  // namespace pliant
