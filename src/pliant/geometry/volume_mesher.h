#pragma once

#include <string>

#include "pliant/geometry/label_volume.h"
#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// Fills a closed surface with tetrahedra of about one size (CGAL's Mesh_3: restricted Delaunay
/// refinement, then slivers are perturbed). Its edges that are sharper than 60 degrees
/// stay. The same surface gives the same mesh.
/// @param triangles  of the surface, all counter-clockwise seen from one side
/// @param edge       length that edges aim at (m)
/// @param file       of the surface, for errors; may be empty
/// @throws InputError for a surface that is not closed, with the first of its open edges, and where
///         the program was built without CGAL
VolumeMesh fill_surface(const Eigen::Matrix3Xd& positions, const Eigen::Matrix3Xi& triangles,
                        double edge, const std::string& file = {});

/// Fills what a segmented image labels with tetrahedra of about one size, whose labels are its
/// (CGAL's Mesh_3); regions that touch share their faces. The same image gives the same mesh.
/// @param volume  in m
/// @param edge    length that edges aim at (m)
/// @param file    of the image, for errors; may be empty
/// @throws InputError for an image without labels above 0, and where the program was built without
///         CGAL
VolumeMesh fill_labels(const LabelVolume& volume, double edge, const std::string& file = {});

}  // namespace pliant
