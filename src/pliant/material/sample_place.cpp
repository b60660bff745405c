#include "pliant/material/sample_place.h"

#include <vector>

#include <fmt/format.h>

#include "pliant/io/vector_fields.h"

namespace pliant {

Eigen::Vector3d read_sample_place(const Value& value, MaterialKind kind) {
  if (kind == MaterialKind::solid) return read_vector(value);
  const std::vector<double> place = value.numbers();
  if (place.size() != 2) {
    value.fail(fmt::format("has {} numbers", place.size()),
               "two: a place along weft and warp, [u, v] in metres");
  }
  return {place[0], place[1], 0};
}

}  // namespace pliant
