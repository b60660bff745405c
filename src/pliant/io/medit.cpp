#include "pliant/io/medit.h"

#include <cmath>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/text_file.h"
#include "pliant/io/token_reader.h"

namespace pliant {
namespace {

struct Skipped {
  std::string_view name;
  int numbers;  ///< a line
};
constexpr Skipped kSkipped[] = {
    {"Edges", 3},   {"Triangles", 4},        {"Quadrilaterals", 5}, {"Corners", 1},
    {"Ridges", 1},  {"RequiredVertices", 1}, {"RequiredEdges", 1},  {"RequiredTriangles", 1},
    {"Normals", 3}, {"NormalAtVertices", 2}, {"Tangents", 3},       {"TangentAtVertices", 2}};

/// Reads field by field.
class MeditReader {
 public:
  MeditReader(std::string_view text, const std::string& file) : tokens_(text, file, true) {}

  VolumeData read() && {
    if (tokens_.word("MeshVersionFormatted") != "MeshVersionFormatted") {
      tokens_.fail("does not begin as a mesh of Medit", "MeshVersionFormatted");
    }
    tokens_.integer("a version");
    while (const auto field = tokens_.next()) {
      if (*field == "End") break;
      read_field(std::string(*field));
    }
    return std::move(data_);
  }

 private:
  void read_field(const std::string& field) {
    if (field == "Dimension") {
      if (tokens_.integer("a dimension") != 3) tokens_.fail("is not of three dimensions", "3");
    } else if (field == "Vertices") {
      read_vertices();
    } else if (field == "Tetrahedra") {
      read_elements(data_.tetrahedra);
    } else if (field == "Hexahedra") {
      read_elements(data_.hexahedra);
    } else {
      skip(field);
    }
  }

  void read_vertices() {
    const int count = tokens_.integer("the count of vertices");
    for (int i = 0; i < count; ++i) {
      Point3 point{};
      for (double& x : point) {
        x = tokens_.number("a coordinate");
        if (!std::isfinite(x)) tokens_.fail("is not finite", "a coordinate");
      }
      tokens_.number("a reference");
      data_.points.push_back(point);
    }
  }

  template <std::size_t Corners>
  void read_elements(VolumeData::Elements<Corners>& elements) {
    const int count = tokens_.integer("the count of elements");
    for (int i = 0; i < count; ++i) {
      std::array<int, Corners> corners{};
      for (int& corner : corners) {
        corner = tokens_.integer("the number of a vertex, from 1", 1) - 1;
        if (corner >= static_cast<int>(data_.points.size())) {
          tokens_.fail(fmt::format("there is no vertex {}", corner + 1),
                       fmt::format("a number up to {}", data_.points.size()));
        }
      }
      elements.corners.push_back(corners);
      elements.lines.push_back(tokens_.line());
      elements.labels.push_back(static_cast<int>(tokens_.number("a reference")));
    }
  }

  void skip(const std::string& field) {
    for (const auto& [name, numbers] : kSkipped) {
      if (field != name) continue;
      const int count = tokens_.integer("a count");
      data_.ignored[field] += count;
      for (int i = 0; i < count; ++i) {
        for (int k = 0; k < numbers; ++k) tokens_.number("a number");
      }
      return;
    }
    tokens_.fail(quoted_value(field) + " is not known", "Vertices, Tetrahedra, Hexahedra, ...");
  }

  TokenReader tokens_;
  VolumeData data_;
};

template <std::size_t Corners>
std::string elements_text(const char* field, const VolumeData::Elements<Corners>& elements) {
  if (elements.corners.empty()) return "";
  std::string text = fmt::format("{}\n{}\n", field, elements.corners.size());
  for (std::size_t e = 0; e < elements.corners.size(); ++e) {
    for (const int corner : elements.corners[e]) text += fmt::format("{} ", corner + 1);
    text += fmt::format("{}\n", elements.labels.empty() ? 0 : elements.labels[e]);
  }
  return text;
}

}  // namespace

VolumeData parse_medit(std::string_view text, const std::string& file) {
  return MeditReader(text, file).read();
}

VolumeData read_medit(const std::filesystem::path& path) {
  return parse_medit(read_text_file(path, kMaxMeshFileSize), path.string());
}

std::string write_medit(const VolumeData& data) {
  std::string text =
      fmt::format("MeshVersionFormatted 2\nDimension 3\nVertices\n{}\n", data.points.size());
  for (const auto& [x, y, z] : data.points) text += fmt::format("{} {} {} 0\n", x, y, z);
  return text + elements_text("Tetrahedra", data.tetrahedra) +
         elements_text("Hexahedra", data.hexahedra) + "End\n";
}

}  // namespace pliant
