#include "pliant/io/vtu_volume.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <zlib.h>

#include "pliant/base/errors.h"
#include "pliant/base/number_text.h"
#include "pliant/io/base64.h"
#include "pliant/io/byte_order.h"
#include "pliant/io/text_file.h"
#include "pliant/io/vtu.h"
#include "pliant/io/vtu_tags.h"

namespace pliant {
namespace {

constexpr std::size_t kLargestVtu = std::size_t{1} << 30;
constexpr std::array<std::string_view, 6> kLabelNames{
    "label", "region", "material", "gmsh:physical", "medit:ref", "CellEntityIds"};

/// An array as its tag tells it, and what stands after the tag.
struct VtuArrayTag {
  std::string part;  ///< Points, Cells, CellData
  std::string name, type, format;
  long components = 1;
  std::size_t offset = 0;  ///< of appended bytes
  std::string_view text;
};

/// A .vtu file in its parts.
struct VtuFile {
  std::string file;
  ByteOrder order = ByteOrder::little;
  bool long_headers = false;
  bool packed = false;
  bool appended_base64 = false;
  std::string_view appended;
  std::vector<VtuArrayTag> arrays;

  [[noreturn]] void fail(const std::string& field, const std::string& problem,
                         const std::string& expected) const {
    throw InputError({file, 0, field}, problem, expected);
  }
};

void read_head(std::string_view tag, VtuFile& vtu) {
  if (vtu_attribute(tag, "type") != "UnstructuredGrid") {
    vtu.fail("", "is no VTK unstructured grid", "a .vtu file of tetrahedra or hexahedra");
  }
  if (vtu_attribute(tag, "byte_order") == "BigEndian") vtu.order = ByteOrder::big;
  vtu.long_headers = vtu_attribute(tag, "header_type") == "UInt64";
  const std::string compressor = vtu_attribute(tag, "compressor");
  vtu.packed = !compressor.empty();
  if (vtu.packed && compressor != "vtkZLibDataCompressor") {
    vtu.fail("compressor", "is " + quoted_value(compressor), "vtkZLibDataCompressor, or none");
  }
}

VtuArrayTag array_of(std::string_view tag, const std::string& part, std::string_view text) {
  VtuArrayTag array{part,
                    vtu_attribute(tag, "Name"),
                    vtu_attribute(tag, "type"),
                    vtu_attribute(tag, "format"),
                    parse_integer(vtu_attribute(tag, "NumberOfComponents")).value_or(1),
                    0,
                    text};
  array.offset = static_cast<std::size_t>(parse_integer(vtu_attribute(tag, "offset")).value_or(0));
  return array;
}

VtuFile parts_of(std::string_view text, const std::string& file) {
  VtuFile vtu;
  vtu.file = file;
  VtuTags tags(text);
  std::string part;
  int pieces = 0;
  bool begun = false;
  while (const auto tag = tags.next()) {
    if (tag->starts_with("VTKFile")) {
      read_head(*tag, vtu);
      begun = true;
    }
    if (tag->starts_with("Piece ")) ++pieces;
    for (const std::string_view own : {"Points", "Cells", "CellData", "PointData", "FieldData"}) {
      if (tag->starts_with(own)) part = own;
      if (tag->starts_with('/') && tag->substr(1).starts_with(own)) part.clear();
    }
    if (tag->starts_with("DataArray ")) {
      vtu.arrays.push_back(array_of(*tag, part, tags.text()));
    }
  }
  if (!begun) vtu.fail("", "is no VTK file", "a .vtu file of tetrahedra or hexahedra");
  if (pieces != 1) vtu.fail("Piece", fmt::format("is there {} times", pieces), "one piece");
  vtu.appended_base64 = vtu_attribute(tags.appended_tag(), "encoding") == "base64";
  const std::size_t mark = tags.appended().find('_');
  if (!tags.appended_tag().empty() && mark != std::string_view::npos) {
    vtu.appended = tags.appended().substr(mark + 1);
  }
  return vtu;
}

class VtuNumbers {
 public:
  explicit VtuNumbers(const VtuFile& vtu) : vtu_(vtu) {}

  /// @throws InputError for bytes that are missing, and types that are none
  std::vector<double> of(const VtuArrayTag& array) const {
    if (array.format == "ascii") return written(array);
    const std::string bytes = bytes_of(array);
    if (array.type == "Float64") return loaded<double>(bytes);
    if (array.type == "Float32") return loaded<float>(bytes);
    if (array.type == "Int64") return loaded<std::int64_t>(bytes);
    if (array.type == "UInt64") return loaded<std::uint64_t>(bytes);
    if (array.type == "Int32") return loaded<std::int32_t>(bytes);
    if (array.type == "UInt32") return loaded<std::uint32_t>(bytes);
    if (array.type == "Int16") return loaded<std::int16_t>(bytes);
    if (array.type == "UInt16") return loaded<std::uint16_t>(bytes);
    if (array.type == "Int8") return loaded<std::int8_t>(bytes);
    if (array.type == "UInt8") return loaded<std::uint8_t>(bytes);
    vtu_.fail(array.name, "has numbers of type " + quoted_value(array.type),
              "Float32, Float64, or a type of whole numbers");
  }

 private:
  std::vector<double> written(const VtuArrayTag& array) const {
    std::vector<double> numbers;
    std::string_view rest = array.text;
    while (true) {
      const std::size_t begin = rest.find_first_not_of(" \t\r\n");
      if (begin == std::string_view::npos) return numbers;
      const std::size_t end = std::min(rest.find_first_of(" \t\r\n", begin), rest.size());
      const auto number = parse_number(std::string(rest.substr(begin, end - begin)));
      if (!number) vtu_.fail(array.name, "has text among its numbers", "numbers");
      numbers.push_back(*number);
      rest.remove_prefix(end);
    }
  }

  template <class Number>
  std::vector<double> loaded(const std::string& bytes) const {
    std::vector<double> numbers;
    numbers.reserve(bytes.size() / sizeof(Number));
    for (std::size_t at = 0; at + sizeof(Number) <= bytes.size(); at += sizeof(Number)) {
      numbers.push_back(static_cast<double>(load_number<Number>(bytes.data() + at, vtu_.order)));
    }
    return numbers;
  }

  std::string bytes_of(const VtuArrayTag& array) const {
    const std::string block = block_of(array);
    if (vtu_.packed) return unpacked(array, block);
    const std::size_t size = header(array, block, 0);
    return part(array, block, header_bytes(), size);
  }

  /// A block with its header. Where both are encoded each for itself there is padding between them,
  /// which decoding passes over.
  std::string block_of(const VtuArrayTag& array) const {
    if (array.format == "binary") return decoded(array, array.text);
    if (array.offset > vtu_.appended.size()) missing(array);
    if (!vtu_.appended_base64) return std::string(vtu_.appended.substr(array.offset));
    std::size_t end = vtu_.appended.find('<');
    for (const VtuArrayTag& other : vtu_.arrays) {
      if (other.format == "appended" && other.offset > array.offset) {
        end = std::min(end, other.offset);
      }
    }
    return decoded(array, vtu_.appended.substr(array.offset, end - array.offset));
  }

  std::string decoded(const VtuArrayTag& array, std::string_view text) const {
    auto bytes = bytes_of_base64(text);
    if (!bytes) vtu_.fail(array.name, "is no base64", "numbers as `format` says");
    return std::move(*bytes);
  }

  std::size_t header_bytes() const { return vtu_.long_headers ? 8 : 4; }

  std::size_t header(const VtuArrayTag& array, const std::string& block, std::size_t place) const {
    const std::size_t at = place * header_bytes();
    if (at + header_bytes() > block.size()) missing(array);
    return vtu_.long_headers ? load_number<std::uint64_t>(block.data() + at, vtu_.order)
                             : load_number<std::uint32_t>(block.data() + at, vtu_.order);
  }

  std::string part(const VtuArrayTag& array, const std::string& block, std::size_t at,
                   std::size_t size) const {
    if (at > block.size() || size > block.size() - at) missing(array);
    return block.substr(at, size);
  }

  /// Blocks of zlib: their count, their size unpacked, that of the last (0: as the others), then
  /// the packed size of each.
  std::string unpacked(const VtuArrayTag& array, const std::string& block) const {
    const std::size_t count = header(array, block, 0), size = header(array, block, 1),
                      last = header(array, block, 2);
    std::size_t at = (3 + count) * header_bytes();
    std::string all;
    for (std::size_t k = 0; k < count; ++k) {
      const std::size_t own = header(array, block, 3 + k);
      const std::string packed = part(array, block, at, own);
      std::string raw(k + 1 == count && last > 0 ? last : size, '\0');
      if (raw.size() > kLargestVtu) missing(array);
      uLongf length = static_cast<uLongf>(raw.size());
      const int end = uncompress(reinterpret_cast<Bytef*>(raw.data()), &length,
                                 reinterpret_cast<const Bytef*>(packed.data()),
                                 static_cast<uLong>(packed.size()));
      if (end != Z_OK || length != raw.size()) missing(array);
      all += raw;
      at += own;
    }
    return all;
  }

  [[noreturn]] void missing(const VtuArrayTag& array) const {
    vtu_.fail(array.name, "does not have the bytes that its header tells of", "a whole file");
  }

  const VtuFile& vtu_;
};

const VtuArrayTag& array_called(const VtuFile& vtu, const std::string& part,
                                const std::string& name) {
  const auto found = std::ranges::find_if(vtu.arrays, [&](const VtuArrayTag& array) {
    return array.part == part && (name.empty() || array.name == name);
  });
  if (found == vtu.arrays.end()) {
    vtu.fail(name.empty() ? part : part + "." + name, "is missing", "a whole file");
  }
  return *found;
}

bool is_whole(const VtuArrayTag& array) {
  return array.type.starts_with("Int") || array.type.starts_with("UInt");
}

const VtuArrayTag* labels_of(const VtuFile& vtu) {
  std::vector<const VtuArrayTag*> whole;
  for (const std::string_view name : kLabelNames) {
    for (const VtuArrayTag& array : vtu.arrays) {
      if (array.part == "CellData" && array.components == 1 && array.name == name) return &array;
    }
  }
  for (const VtuArrayTag& array : vtu.arrays) {
    if (array.part == "CellData" && array.components == 1 && is_whole(array)) {
      whole.push_back(&array);
    }
  }
  return whole.size() == 1 ? whole.front() : nullptr;
}

/// What VTK calls the cells that no solid is made of.
std::optional<std::string> skipped_cell(int type) {
  switch (type) {
    case 1:
    case 2:
      return "vertices";
    case 3:
    case 4:
      return "lines";
    case 5:
    case 6:
      return "triangles";
    case 8:
    case 9:
      return "quadrilaterals";
    default:
      return std::nullopt;
  }
}

template <std::size_t Corners>
void add_element(const VtuFile& vtu, const std::vector<double>& corners, std::size_t first,
                 std::size_t points, int label, VolumeData::Elements<Corners>& elements) {
  std::array<int, Corners> own{};
  for (std::size_t i = 0; i < Corners; ++i) {
    const double corner = corners[first + i];
    if (!(corner >= 0 && corner < static_cast<double>(points))) {
      vtu.fail("Cells.connectivity", fmt::format("names the point {}", corner),
               fmt::format("0 to {}", points - 1));
    }
    own[i] = static_cast<int>(corner);
  }
  elements.corners.push_back(own);
  elements.labels.push_back(label);
}

VolumeData volume_of(const VtuFile& vtu) {
  const VtuNumbers numbers(vtu);
  VolumeData data;
  const std::vector<double> places = numbers.of(array_called(vtu, "Points", ""));
  for (std::size_t i = 0; i + 2 < places.size(); i += 3) {
    data.points.push_back({places[i], places[i + 1], places[i + 2]});
  }
  const std::vector<double> corners = numbers.of(array_called(vtu, "Cells", "connectivity")),
                            ends = numbers.of(array_called(vtu, "Cells", "offsets")),
                            types = numbers.of(array_called(vtu, "Cells", "types"));
  if (types.size() != ends.size()) {
    vtu.fail("Cells.types", fmt::format("has {} numbers", types.size()),
             fmt::format("{}, as `offsets`", ends.size()));
  }
  std::vector<double> labels(types.size(), 0);
  if (const VtuArrayTag* own = labels_of(vtu)) labels = numbers.of(*own);
  if (labels.size() != types.size()) {
    vtu.fail("CellData", fmt::format("has {} labels", labels.size()),
             fmt::format("{}, one a cell", types.size()));
  }
  double first = 0;
  for (std::size_t c = 0; c < types.size(); first = ends[c++]) {
    const int type = static_cast<int>(types[c]), label = static_cast<int>(labels[c]);
    const double count = ends[c] - first;
    const auto begin = static_cast<std::size_t>(first);
    if (!(count >= 1 && ends[c] <= static_cast<double>(corners.size()))) {
      vtu.fail("Cells.offsets", fmt::format("end at {} after {}", ends[c], first),
               fmt::format("rising numbers to {}", corners.size()));
    }
    if (type == static_cast<int>(VtkCell::tetrahedron) && count == 4) {
      add_element(vtu, corners, begin, data.points.size(), label, data.tetrahedra);
    } else if (type == static_cast<int>(VtkCell::hexahedron) && count == 8) {
      add_element(vtu, corners, begin, data.points.size(), label, data.hexahedra);
    } else if (const auto skipped = skipped_cell(type)) {
      ++data.ignored[*skipped];
    } else {
      vtu.fail("Cells.types",
               fmt::format("cell {} is of VTK's type {} and has {} corners", c, type, count),
               "tetrahedra (10) and hexahedra (12) of first order");
    }
  }
  return data;
}

}  // namespace

VolumeData read_vtu_volume(const std::filesystem::path& path) {
  const std::string text = read_text_file(path, kLargestVtu);
  return volume_of(parts_of(text, path.string()));
}

std::string write_vtu_volume(const VolumeData& data) {
  VtuGrid grid;
  grid.points = data.points;
  VtuArray labels{"label", 1, {}};
  const auto add = [&](VtkCell cell, const auto& elements) {
    VtuCells cells{cell, {}};
    for (const auto& own : elements.corners) {
      cells.corners.insert(cells.corners.end(), own.begin(), own.end());
    }
    if (!cells.corners.empty()) grid.cells.push_back(std::move(cells));
    labels.values.insert(labels.values.end(), elements.labels.begin(), elements.labels.end());
  };
  add(VtkCell::tetrahedron, data.tetrahedra);
  add(VtkCell::hexahedron, data.hexahedra);
  grid.cell_data.push_back(std::move(labels));
  return write_vtu(grid, {.encoding = VtuEncoding::base64});
}

}  // namespace pliant
