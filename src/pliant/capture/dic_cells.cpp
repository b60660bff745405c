#include "pliant/capture/dic_cells.h"

#include <optional>
#include <set>
#include <utility>

#include "pliant/base/errors.h"
#include "pliant/capture/dic_reference.h"
#include "pliant/capture/pixel_fields.h"

namespace pliant {
namespace {

DicCell read_cell(const Value& value) {
  Fields fields = value.fields();
  DicCell cell;
  cell.where = value.location();
  cell.clip = fields.require("clip").text("the name of a clip");
  cell.cord = fields.require("cord").text("the name of a cord");
  cell.column = fields.require("column").text("the name of the cell's column");
  if (auto v = fields.optional("tare")) cell.tare = v->quantity(Dimension::force);
  if (auto v = fields.optional("slope")) {
    cell.slope = v->number();
    if (!(cell.slope > 0)) v->fail("is no slope of a cell", "true force over its reading, above 0");
  }
  const Value picture = fields.require("picture");
  cell.picture = path_beside(picture, "the picture in which the cord is pointed at");
  cell.where_picture = picture.location();
  const Value along = fields.require("along");
  const std::vector<Value> ends = along.items();
  if (ends.size() != 2) {
    along.fail("are not two places",
               "[column, row] where the cord is fastened to the clip, and where it is seen last");
  }
  cell.from = read_pixel(ends[0]);
  cell.to = read_pixel(ends[1]);
  fields.finish();
  return cell;
}

/// Whether two paths name one file.
bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  return a == b || std::filesystem::equivalent(a, b, error);
}

}  // namespace

std::vector<DicCell> read_cells(const Value& value) {
  std::vector<DicCell> cells;
  for (const Value& item : value.items()) cells.push_back(read_cell(item));
  if (cells.empty()) value.fail("names no cell", "a cell for each cord that pulls");
  return cells;
}

void require_single_cords(const std::vector<DicCell>& cells) {
  constexpr double kShortest = 20;  // pixels
  std::set<std::pair<std::string, std::string>> taken;
  std::set<std::string> columns;
  for (const DicCell& cell : cells) {
    if (!columns.insert(cell.column).second) {
      throw InputError(cell.where, "reads a column that another cell reads", "a column of its own");
    }
    if (!taken.emplace(cell.clip, cell.cord).second) {
      throw InputError(cell.where, "has a cord that stands here twice",
                       "a name for each cord of a clip");
    }
    if ((cell.to - cell.from).norm() < kShortest) {
      throw InputError(cell.where, "points to two pixels too near each other to tell a direction",
                       "two ends 20 pixels apart or more");
    }
  }
}

void resolve_cells(std::vector<DicCell>& cells, const DicViews& views) {
  for (DicCell& cell : cells) {
    bool is_found = false;
    for (std::size_t c = 0; c < views.files.size(); ++c) {
      for (std::size_t f = 0; f < views.files[c].size(); ++f) {
        if (is_found || !is_same_file(views.files[c][f], cell.picture)) continue;
        cell.camera = c;
        cell.frame = static_cast<int>(f);
        is_found = true;
      }
    }
    if (is_found) continue;
    throw InputError(cell.where_picture, "is none of the pictures of `views`",
                     "one of them, in which the cord is pulled and seen as a line");
  }
}

}  // namespace pliant
