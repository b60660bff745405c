#include "pliant/capture/point_frames.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/letter_case.h"
#include "pliant/base/number_text.h"
#include "pliant/io/csv.h"

namespace pliant {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<const char*, 3> kPlaces{"x", "y", "z"};
constexpr std::array<const char*, 3> kDisplacements{"u", "v", "w"};

/// How systems for digital image correlation call their columns.
const std::map<std::string, std::vector<std::string>>& dic_synonyms() {
  static const std::map<std::string, std::vector<std::string>> synonyms{
      {"x", {"coordinate x", "COORDINATE_X", "x coordinate", "x_px", "ref_x"}},
      {"y", {"coordinate y", "COORDINATE_Y", "y coordinate", "y_px", "ref_y"}},
      {"z", {"coordinate z", "COORDINATE_Z", "z coordinate", "ref_z"}},
      {"u", {"displacement x", "DISPLACEMENT_X", "x displacement", "u_px", "dx"}},
      {"v", {"displacement y", "DISPLACEMENT_Y", "y displacement", "v_px", "dy"}},
      {"w", {"displacement z", "DISPLACEMENT_Z", "z displacement", "dz"}},
      {"id", {"index", "point", "point id", "number"}}};
  return synonyms;
}

/// What stands in a cell of a point that was lost.
bool is_blank(std::string_view cell) {
  for (const std::string_view word : {"", "nan", "-nan", "n/a", "na", "-", "null", "inf", "-inf"}) {
    if (same_letters(cell, word)) return true;
  }
  return false;
}

std::vector<double> numbers_of(const CsvTable& table, const std::string& header, double factor) {
  const std::vector<std::string> cells = table.texts(header);
  std::vector<double> values;
  for (std::size_t row = 0; row < cells.size(); ++row) {
    const std::string_view cell = trimmed(cells[row]);
    const auto number = table.number_of_cell(cell);
    if (!number && !is_blank(cell)) {
      throw InputError({table.file(), table.line(row), header},
                       quoted_value(cell) + " is no number",
                       "a number, or nothing for a lost point");
    }
    values.push_back(number ? factor * *number : kNone);
  }
  return values;
}

/// A coordinate in metres; nothing where the table has none of the name.
std::optional<std::vector<double>> coordinate(const CsvTable& table, const char* name,
                                              const std::optional<double>& scale) {
  const auto header = table.quantity_column(name);
  if (!header) return std::nullopt;
  const std::string unit = table.quantity_unit(name).value_or("");
  const bool of_pixels = unit.empty() || same_letters(unit, "px") || same_letters(unit, "pixel");
  const auto factor = of_pixels ? scale : unit_scale(unit, Dimension::length);
  if (!factor) {
    throw InputError({table.file(), table.header_line(), *header},
                     of_pixels ? "tells no unit" : quoted_value(unit) + " is no length",
                     "a unit in the header, \"x (mm)\", or `scale`, the length of one unit of the "
                     "columns: \"0.05 mm\" of a pixel, \"1 mm\"");
  }
  return numbers_of(table, *header, *factor);
}

/// Where points are at rest, and by now.
using Places = std::vector<std::pair<Eigen::Vector3d, Eigen::Vector3d>>;

/// @param all  how many points there are, lost ones too
PointFrame frame_of(const Places& places, std::size_t all) {
  PointFrame frame;
  frame.rest.resize(3, std::ssize(places));
  frame.moved.resize(3, std::ssize(places));
  for (Eigen::Index i = 0; i < frame.rest.cols(); ++i) {
    const auto& [rest, moved] = places[static_cast<std::size_t>(i)];
    frame.rest.col(i) = rest;
    frame.moved.col(i) = moved;
  }
  frame.patches.setZero(frame.rest.cols());
  frame.lost = static_cast<int>(all - places.size());
  return frame;
}

}  // namespace

/// The columns of a frame's file; NaN where a point was lost.
struct PointFrames::Table {
  std::string file;
  std::array<std::optional<std::vector<double>>, 3> place, displacement;
  std::optional<std::vector<std::string>> id;
  std::vector<double> sigma;

  std::size_t rows() const { return place[0]->size(); }
  Eigen::Vector3d place_of(std::size_t row) const { return vector(place, row); }
  Eigen::Vector3d displacement_of(std::size_t row) const { return vector(displacement, row); }
  bool is_lost(std::size_t row) const { return !sigma.empty() && sigma[row] < 0; }

 private:
  static Eigen::Vector3d vector(const std::array<std::optional<std::vector<double>>, 3>& columns,
                                std::size_t row) {
    Eigen::Vector3d result = Eigen::Vector3d::Zero();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (columns[axis]) result(static_cast<Eigen::Index>(axis)) = (*columns[axis])[row];
    }
    return result;
  }
};

PointFrames::PointFrames(const DicFile& dic) : dic_(dic) {
  const Table first = read_table(0);
  in_space_ = first.place[2].has_value();
  if (first.displacement[0]) return;
  if (!first.id) {
    throw InputError({first.file}, "has neither displacements nor numbers of its points",
                     "columns u, v (and w) beside x, y (and z), or a column id; `points: {file, "
                     "columns: {u: \"THEIR NAME\"}}` tells other names");
  }
  for (std::size_t row = 0; row < first.rows(); ++row) {
    if (first.is_lost(row) || !first.place_of(row).allFinite()) continue;
    if (!rest_.emplace((*first.id)[row], first.place_of(row)).second) {
      throw InputError({first.file}, "the point " + quoted_value((*first.id)[row]) + " comes twice",
                       "a row for each point");
    }
  }
}

PointFrames::Table PointFrames::read_table(int frame) const {
  CsvOptions options = dic_.points.csv;
  options.synonyms = dic_synonyms();
  const CsvTable table = read_csv(dic_.points.files[static_cast<std::size_t>(frame)], options);
  Table result;
  result.file = table.file();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.place[axis] = coordinate(table, kPlaces[axis], dic_.scale);
    result.displacement[axis] = coordinate(table, kDisplacements[axis], dic_.scale);
  }
  for (const std::size_t axis : {std::size_t{0}, std::size_t{1}}) {
    if (result.place[axis] &&
        result.displacement[0].has_value() == result.displacement[axis].has_value()) {
      continue;
    }
    throw InputError({table.file(), table.header_line()},
                     fmt::format("has no column {} or {}", kPlaces[axis], kDisplacements[axis]),
                     "x, y and u, v of each point; `points: {file, columns: {x: \"THEIR NAME\"}}` "
                     "tells other names");
  }
  if (const auto id = table.quantity_column("id")) result.id = table.texts(*id);
  if (const auto sigma = table.quantity_column("sigma"))
    result.sigma = numbers_of(table, *sigma, 1);
  return result;
}

PointFrame PointFrames::by_displacement(const Table& table) const {
  Places places;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Eigen::Vector3d place = table.place_of(row), by = table.displacement_of(row);
    if (table.is_lost(row) || !place.allFinite() || !by.allFinite()) continue;
    places.emplace_back(place, place + by);
  }
  return frame_of(places, table.rows());
}

PointFrame PointFrames::by_number(const Table& table) const {
  if (!table.id) throw InputError({table.file}, "has no numbers of its points", "a column id");
  std::map<std::string, Eigen::Vector3d> seen;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.is_lost(row) || !table.place_of(row).allFinite()) continue;
    seen.emplace((*table.id)[row], table.place_of(row));
  }
  Places places;
  for (const auto& [id, place] : rest_) {
    const auto now = seen.find(id);
    if (now != seen.end()) places.emplace_back(place, now->second);
  }
  return frame_of(places, rest_.size());
}

PointFrame PointFrames::read(int frame) {
  const Table table = read_table(frame);
  if (table.place[2].has_value() != in_space_) {
    throw InputError({table.file}, "has another number of coordinates than the first file",
                     "x, y in all files, or x, y, z in all");
  }
  return rest_.empty() ? by_displacement(table) : by_number(table);
}

}  // namespace pliant
