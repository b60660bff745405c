#include <algorithm>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/exchange/u3m_info.h"
#include "pliant/exchange/u3m_physics.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

using Range = std::pair<double, double>;

Range range_of(const U3mTest& test, std::vector<double> U3mSegment::*samples) {
  Range range{std::numeric_limits<double>::max(), std::numeric_limits<double>::lowest()};
  for (const U3mSegment& segment : test.segments) {
    for (const double value : segment.*samples) {
      range = {std::min(range.first, value), std::max(range.second, value)};
    }
  }
  return range;
}

std::size_t row_count(const U3mTest& test) {
  std::size_t rows = 0;
  for (const U3mSegment& segment : test.segments) rows += segment.distance.size();
  return rows;
}

std::string range_text(const Range& range, Dimension dimension) {
  return fmt::format("{} to {}", format_quantity(range.first, dimension, kInfoDigits),
                     format_quantity(range.second, dimension, kInfoDigits));
}

void add_test(const std::string& direction, const U3mTest& test, FileInfo& info) {
  const Range distance = range_of(test, &U3mSegment::distance);
  const Range force = range_of(test, &U3mSegment::force);
  const std::string name = direction + "-" + test.name;
  info.json["tests"].push_back({{"name", name},
                                {"type", test_type_of(test).name},
                                {"direction", direction},
                                {"rows", row_count(test)},
                                {"half_cycles", test.segments.size()},
                                {"length", test.length},
                                {"width", test.width ? Json(*test.width) : Json(nullptr)},
                                {"distance_range", {distance.first, distance.second}},
                                {"force_range", {force.first, force.second}}});
  info.lines.push_back(labelled(
      name,
      fmt::format("{} rows in {} half cycles; clamps {} apart (straight at {}), force {}, width {}",
                  row_count(test), test.segments.size(), range_text(distance, Dimension::length),
                  format_quantity(test.length, Dimension::length, kInfoDigits),
                  range_text(force, Dimension::force),
                  test.width ? format_quantity(*test.width, Dimension::length, kInfoDigits)
                             : "not told (give it to `import --width`)")));
}

}  // namespace

FileInfo u3m_file_info(const std::filesystem::path& path) {
  const U3mFile file = read_u3m_file(path);
  const U3mPhysics physics = read_u3m_physics(file);
  const U3mInfo about = read_u3m_info(file);
  FileInfo info = begin_info(path, "u3m");
  info.json["name"] = about.name;
  info.json["density"] = physics.density > 0 ? Json(physics.density) : Json(nullptr);
  info.json["info"] = Json::object();
  info.json["tests"] = Json::array();
  if (!about.name.empty()) info.lines.push_back(labelled("name", about.name));
  info.lines.push_back(labelled(
      "density", physics.density > 0
                     ? format_quantity(physics.density, Dimension::area_density, kInfoDigits)
                     : "not stated"));
  for (const auto& [key, text] : about.entries) {
    info.json["info"][key] = text;
    info.lines.push_back(labelled(key, text));
  }
  for (const U3mDirection& direction : physics.directions) {
    for (const U3mTest& test : direction.tests) add_test(direction.name, test, info);
  }
  info.warnings = physics.warnings;
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
