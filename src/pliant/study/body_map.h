#pragma once

#include <string>

#include "pliant/estimation/fit_result.h"
#include "pliant/geometry/triangle_mesh.h"
#include "pliant/geometry/volume_mesh.h"

namespace pliant {

/// A body at rest (m), without fields.
VtuGrid grid_at_rest(const VolumeMesh& body);

/// A sheet in its rest plane, at z = 0 (m), without fields; triangles have corners of their own.
VtuGrid grid_at_rest(const TriangleMesh& sheet);

/// The body or sheet of a fit of a heterogeneous material as a VTK file: for each number that
/// samples differ in its value in each cell (in its unit), and its standard error; NaN where that
/// is not known, as some sample that counts there stands at its bound.
/// @param result  has a body
std::string body_map(const StudyResult& result);

}  // namespace pliant
