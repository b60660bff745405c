#include "pliant/geometry/mesh_file_fields.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"

namespace pliant {

double read_file_unit(Fields& fields) {
  const std::string expected = fmt::format("the length unit of the file's coordinates: {}",
                                           fmt::join(units_of(Dimension::length), ", "));
  const auto value = fields.optional("unit");
  if (!value) {
    Location where = fields.location();
    where.field += ".unit";
    throw InputError(where, "is missing", expected);
  }
  const std::optional<double> unit = unit_scale(value->text(), Dimension::length);
  if (!unit) value->fail(quoted_value(value->text()), expected);
  return *unit;
}

std::optional<std::string> read_file_up(Fields& fields) {
  const auto value = fields.optional("up");
  if (!value) return std::nullopt;
  return value->choice({"x", "y", "z", "-x", "-y", "-z"});
}

}  // namespace pliant
