#include "pliant/measurement/session/sheet_files.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/geometry/polygon_mesh.h"
#include "pliant/io/ply.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

std::string size_text(double width, double height) {
  return fmt::format("{} x {}", format_quantity(width, Dimension::length),
                     format_quantity(height, Dimension::length));
}

void require_flat(const PolygonMesh& polygons) {
  const Eigen::Vector3d size =
      polygons.positions.rowwise().maxCoeff() - polygons.positions.rowwise().minCoeff();
  const double most = kFlatness * size.head<2>().norm();
  Eigen::Index vertex = 0;
  const double height = polygons.positions.row(2).cwiseAbs().maxCoeff(&vertex);
  if (height <= most) return;
  throw InputError(
      {polygons.numbering.file},
      fmt::format("the rest mesh is not flat: vertex {} is at z = {}", vertex,
                  format_quantity(polygons.positions(2, vertex), Dimension::length)),
      fmt::format("z = 0 to {}, u = x, v = y in metres", format_quantity(most, Dimension::length)));
}

/// Before single faces are judged: all of them run clockwise where an axis is mirrored.
void refuse_mirrored(const TriangleMesh& mesh, const std::string& file) {
  const double area = rest_area(mesh);
  if (area >= 0) return;
  throw InputError({file},
                   fmt::format("the faces run clockwise at rest (their area is {:.3g} m^2): an "
                               "axis is mirrored, or the sheet lies face down",
                               area),
                   "faces counter-clockwise seen from +z, with u = x along weft, v = y along warp");
}

bool agrees(double found, double stated) {
  return std::abs(found - stated) <= kSampleAgreement * stated;
}

/// What would explain a rest mesh of another size.
std::string explanation(const Eigen::Vector2d& found, const Eigen::Vector2d& stated) {
  for (const auto& [unit, scale] :
       {std::pair("millimetres", 1e-3), std::pair("centimetres", 1e-2)}) {
    if (agrees(scale * found.x(), stated.x()) && agrees(scale * found.y(), stated.y())) {
      return fmt::format(" (it would fit in {})", unit);
    }
  }
  if (agrees(found.x(), stated.y()) && agrees(found.y(), stated.x())) {
    return " (it would fit with u and v exchanged)";
  }
  return "";
}

void require_sample_size(const TriangleMesh& mesh, const SessionSample& sample,
                         const std::string& file) {
  const Eigen::Vector2d found =
      mesh.rest_corners.rowwise().maxCoeff() - mesh.rest_corners.rowwise().minCoeff();
  if (agrees(found.x(), sample.width) && agrees(found.y(), sample.height)) return;
  throw InputError(
      {file},
      fmt::format("the rest mesh measures {}, the sample {}{}", size_text(found.x(), found.y()),
                  size_text(sample.width, sample.height),
                  explanation(found, {sample.width, sample.height})),
      fmt::format("width x height of the sample within {:.0f} %, in metres",
                  100 * kSampleAgreement));
}

Eigen::Matrix3Xd to_matrix(const std::vector<Point3>& points) {
  Eigen::Matrix3Xd matrix(3, points.size());
  for (Eigen::Index i = 0; i < matrix.cols(); ++i) {
    matrix.col(i) = Eigen::Map<const Eigen::Vector3d>(points[i].data());
  }
  return matrix;
}

void require_same_faces(const Polygons& faces, const Polygons& rest, const fs::path& file,
                        int frame) {
  if (faces.size() == 0 || faces == rest) return;
  std::size_t face = 0;
  while (face < std::min(faces.size(), rest.size()) &&
         std::ranges::equal(faces[face], rest[face])) {
    ++face;
  }
  throw InputError(
      {file.string()},
      fmt::format("frame {}: its faces are not those of the rest mesh, first face {}", frame, face),
      "the faces of the rest mesh in their order, or none: vertices have one order");
}

/// Mean length of the edges between vertices that were seen (m); NaN without any.
double mean_edge(const Eigen::Matrix3Xi& triangles, const Eigen::Matrix3Xd& positions) {
  double sum = 0;
  int edges = 0;
  for (const auto& corners : triangles.colwise()) {
    for (int k = 0; k < 3; ++k) {
      const double length =
          (positions.col(corners[(k + 1) % 3]) - positions.col(corners[k])).norm();
      if (!std::isfinite(length)) continue;
      sum += length;
      ++edges;
    }
  }
  return sum / edges;
}

void require_metres(const Eigen::Matrix3Xd& positions, const TriangleMesh& rest,
                    const fs::path& file, int frame) {
  const double found = mean_edge(rest.triangles, positions);
  if (std::isnan(found)) {
    throw InputError({file.string()},
                     fmt::format("frame {}: no edge between vertices that were seen", frame),
                     "finite coordinates of most vertices");
  }
  const double at_rest = mean_edge(rest.triangles, rest.positions);
  if (found <= kMostFrameScale * at_rest && at_rest <= kMostFrameScale * found) return;
  throw InputError(
      {file.string()},
      fmt::format("frame {}: edges are {} long on average, at rest {}", frame,
                  format_quantity(found, Dimension::length),
                  format_quantity(at_rest, Dimension::length)),
      fmt::format("positions in metres, with edges within a factor of {}", kMostFrameScale));
}

constexpr std::array kDeviations{"sd_x", "sd_y", "sd_z"};

Eigen::Matrix3Xd deviations_of(const PlyMesh& ply, const Eigen::Matrix3Xd& positions,
                               const fs::path& file, int frame) {
  Eigen::Matrix3Xd deviations;
  for (std::size_t axis = 0; axis < kDeviations.size(); ++axis) {
    const auto column = std::ranges::find(ply.vertex_columns, kDeviations[axis], &PlyColumn::name);
    const bool known = column != ply.vertex_columns.end();
    if (!known && deviations.cols() == 0) continue;
    if (!known || (axis > 0 && deviations.cols() == 0)) {
      throw InputError({file.string()},
                       fmt::format("frame {}: not all of sd_x, sd_y, sd_z are told", frame),
                       "the standard deviations of all coordinates (m), or none");
    }
    deviations.conservativeResize(3, positions.cols());
    deviations.row(static_cast<Eigen::Index>(axis)) =
        Eigen::Map<const Eigen::RowVectorXd>(column->values.data(), positions.cols());
  }
  for (Eigen::Index v = 0; v < deviations.cols(); ++v) {
    if (!positions.col(v).allFinite()) continue;
    if (deviations.col(v).allFinite() && deviations.col(v).minCoeff() > 0) continue;
    throw InputError({file.string()},
                     fmt::format("frame {}: vertex {} was seen, with a deviation of {}", frame, v,
                                 deviations.col(v).minCoeff()),
                     "standard deviations above 0 (m)");
  }
  return deviations;
}

}  // namespace

RestSheet read_rest_sheet(const fs::path& file, const SessionSample& sample) {
  const PolygonMesh polygons = read_polygon_mesh(file);
  require_flat(polygons);
  const Eigen::Matrix2Xd vertices = polygons.positions.topRows<2>();
  const Eigen::Matrix2Xd plane = vertices(Eigen::all, polygons.faces.corners);
  CutFaces cut = cut_into_triangles(polygons.faces, plane, polygons.numbering);
  const Eigen::Matrix3Xi triangles =
      cut.corners.unaryExpr([&](int corner) { return polygons.faces.corners[corner]; });
  RestSheet sheet{flat_mesh(vertices, triangles), polygons.faces};
  refuse_mirrored(sheet.mesh, file.string());
  MeshNumbering numbering = polygons.numbering;
  numbering.faces = std::move(cut.faces);
  require_good_mesh(sheet.mesh, numbering);
  require_sample_size(sheet.mesh, sample, file.string());
  return sheet;
}

FrameSheet read_frame_sheet(const fs::path& file, int frame, const RestSheet& rest) {
  const PlyMesh ply = read_ply(file, PlyPositions::any);
  const Eigen::Matrix3Xd positions = to_matrix(ply.positions);
  if (positions.cols() != rest.mesh.vertex_count()) {
    throw InputError(
        {file.string()}, fmt::format("frame {} has {} vertices", frame, positions.cols()),
        fmt::format("the {} of the rest mesh, in its order", rest.mesh.vertex_count()));
  }
  require_same_faces(ply.faces, rest.faces, file, frame);
  require_metres(positions, rest.mesh, file, frame);
  return {positions, deviations_of(ply, positions, file, frame)};
}

std::string sheet_ply(const TriangleMesh& mesh, const Eigen::Matrix3Xd& positions,
                      const std::vector<int>& unseen, const Eigen::Matrix3Xd& deviations) {
  PlyMesh ply;
  for (const auto& point : positions.colwise()) {
    ply.positions.push_back({point.x(), point.y(), point.z()});
  }
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  for (const int vertex : unseen) {
    ply.positions[static_cast<std::size_t>(vertex)] = {kNone, kNone, kNone};
  }
  for (Eigen::Index axis = 0; deviations.cols() > 0 && axis < 3; ++axis) {
    PlyColumn column{kDeviations[static_cast<std::size_t>(axis)], {}, PlyType::float64};
    for (const double value : deviations.row(axis)) column.values.push_back(value);
    ply.vertex_columns.push_back(std::move(column));
  }
  for (const auto& corners : mesh.triangles.colwise()) {
    ply.faces.add(std::array{corners[0], corners[1], corners[2]});
  }
  return write_ply(ply);
}

}  // namespace pliant
