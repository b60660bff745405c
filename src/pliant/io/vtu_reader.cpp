#include <optional>
#include <string_view>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/io/text_file.h"
#include "pliant/io/vtu.h"
#include "pliant/io/vtu_tags.h"

namespace pliant {
namespace {

constexpr std::size_t kLargestFile = std::size_t{1} << 30;

long count(std::string_view tag, const std::string& name, const std::string& file) {
  const std::optional<long> number = parse_integer(vtu_attribute(tag, name));
  if (!number || *number < 0) {
    throw InputError({file, 0, name}, quoted_value(vtu_attribute(tag, name)) + " is no count",
                     "a whole number from 0");
  }
  return *number;
}

std::string unescaped(std::string text) {
  constexpr std::pair<std::string_view, char> kEscapes[] = {
      {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}};
  for (const auto& [escape, character] : kEscapes) {
    for (std::size_t at = text.find(escape); at != std::string::npos; at = text.find(escape, at)) {
      text.replace(at++, escape.size(), 1, character);
    }
  }
  return text;
}

}  // namespace

VtuHead read_vtu_head(const std::filesystem::path& path) {
  const std::string file = path.string();
  const std::string text = read_text_file(path, kLargestFile);
  VtuHead head;
  bool has_piece = false;
  std::string_view part;  // of the file that holds the arrays which come next
  VtuTags tags(text);
  while (const auto tag = tags.next()) {
    if (tag->starts_with("Piece ")) {
      if (has_piece) throw InputError({file}, "is a grid of several pieces", "one piece");
      has_piece = true;
      head.points = count(*tag, "NumberOfPoints", file);
      head.cells = count(*tag, "NumberOfCells", file);
    }
    if (tag->starts_with("PointData") || tag->starts_with("CellData")) part = *tag;
    if (tag->starts_with("/PointData") || tag->starts_with("/CellData")) part = {};
    if (tag->starts_with("DataArray ") && !part.empty()) {
      const std::optional<long> components =
          parse_integer(vtu_attribute(*tag, "NumberOfComponents"));
      head.fields.push_back({unescaped(vtu_attribute(*tag, "Name")),
                             static_cast<int>(components.value_or(1)),
                             part.starts_with("PointData")});
    }
  }
  if (!has_piece || text.find("UnstructuredGrid") == std::string::npos) {
    throw InputError({file}, "is no VTK unstructured grid", "a .vtu file, as `simulate` writes it");
  }
  return head;
}

}  // namespace pliant
