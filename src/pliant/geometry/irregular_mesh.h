#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// An irregular mesh of the rectangle [0, width] x [0, height] at rest: triangles of all directions
/// alike, angles above 25 degrees, no hidden grid.
///
/// The outline, and what lies between corners of regions on it, is cut into equal parts nearest to
/// `edge_length`; the inside is a Delaunay refinement to the same mean edge length, smoothed.
/// Vertices are numbered strip by strip from the lower left. The same arguments give the same mesh.
/// @param width, height  m, > 0
/// @param edge_length  m, > 0: what the mean of all edges comes to, within a few percent where the
///        rectangle is several edges wide
/// @param regions  within the rectangle and apart from each other: edges of the mesh run along
///        their sides, so that triangles lie inside of a region or outside
/// @throws InputError in a build without CGAL
TriangleMesh irregular_rectangle(double width, double height, double edge_length,
                                 const std::vector<Eigen::AlignedBox2d>& regions = {});

/// The same of a disc about the origin, both circles cut into equal parts nearest to `edge_length`.
/// @param radius        m
/// @param inner_radius  of the circle about the origin that edges run along (m, 0 to `radius`)
/// @throws InputError in a build without CGAL
TriangleMesh irregular_disc(double radius, double inner_radius, double edge_length);

/// Whether this build can make irregular meshes.
bool has_irregular_meshes();

}  // namespace pliant
