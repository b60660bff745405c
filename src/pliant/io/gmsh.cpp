#include "pliant/io/gmsh.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <unordered_map>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/text_file.h"
#include "pliant/io/token_reader.h"

namespace pliant {
namespace {

struct ElementType {
  int number;
  int dimension;
  int corners;
  const char* name;
};
constexpr ElementType kTypes[] = {{15, 0, 1, "points"},    {1, 1, 2, "lines"},
                                  {2, 2, 3, "triangles"},  {3, 2, 4, "quadrangles"},
                                  {4, 3, 4, "tetrahedra"}, {5, 3, 8, "hexahedra"},
                                  {6, 3, 6, "prisms"},     {7, 3, 5, "pyramids"}};

/// Reads section by section; nodes have numbers of their own in the file.
class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& file) : tokens_(text, file) {}

  VolumeData read() && {
    while (const auto section = tokens_.next()) {
      const std::string name(*section);
      if (name == "$MeshFormat") {
        read_format();
      } else if (version_ == 0) {
        tokens_.fail("does not begin as a mesh of gmsh", "$MeshFormat");
      } else if (name == "$PhysicalNames") {
        read_names();
      } else if (name == "$Entities") {
        read_entities();
      } else if (name == "$Nodes") {
        version_ == 2 ? read_nodes() : read_node_blocks();
      } else if (name == "$Elements") {
        version_ == 2 ? read_elements() : read_element_blocks();
      } else if (!name.starts_with("$")) {
        tokens_.fail(quoted_value(name) + " begins no section", "a section such as $Nodes");
      }
      skip_to_end(name);
    }
    if (version_ == 0) tokens_.fail("is empty", "a mesh of gmsh");
    for (auto& [name, points] : grouped_) {
      data_.groups[name].assign(points.begin(), points.end());
    }
    return std::move(data_);
  }

 private:
  void skip_to_end(const std::string& section) {
    const std::string end = "$End" + section.substr(1);
    while (tokens_.word(end) != end) {
    }
  }

  void read_format() {
    const double version = tokens_.number("the version of the format");
    if (version != 2.2 && version != 4.1) {
      tokens_.fail(fmt::format("is of format {}", version), "format 2.2 or 4.1");
    }
    if (tokens_.integer("0 for ASCII") != 0) tokens_.fail("is a binary file", "an ASCII file");
    version_ = version == 2.2 ? 2 : 4;
  }

  void read_names() {
    const int count = tokens_.integer("the count of names");
    for (int i = 0; i < count; ++i) {
      const int dimension = tokens_.integer("a dimension");
      const int tag = tokens_.integer("the number of a physical group");
      names_[{dimension, tag}] = tokens_.quoted("a name");
      if (dimension == 3) data_.region_names[tag] = names_[{dimension, tag}];
    }
  }

  // Which physical group the parts of the geometry belong to (4.1).
  void read_entities() {
    int counts[4];
    for (int& count : counts) count = tokens_.integer("the count of entities");
    for (int dimension = 0; dimension < 4; ++dimension) {
      for (int i = 0; i < counts[dimension]; ++i) read_entity(dimension);
    }
  }

  void read_entity(int dimension) {
    const int tag = tokens_.integer("the number of an entity", 1);
    for (int k = 0; k < (dimension == 0 ? 3 : 6); ++k) tokens_.number("a coordinate");
    const int groups = tokens_.integer("the count of physical groups");
    for (int k = 0; k < groups; ++k) {
      const int group = std::abs(static_cast<int>(tokens_.number("a physical group")));
      if (k == 0) physical_[{dimension, tag}] = group;
    }
    if (dimension == 0) return;
    const int sides = tokens_.integer("the count of bounding entities");
    for (int k = 0; k < sides; ++k) tokens_.number("the number of an entity");
  }

  void add_node(int number) {
    if (!numbers_.try_emplace(number, static_cast<int>(data_.points.size())).second) {
      tokens_.fail(fmt::format("node {} is there twice", number), "each node once");
    }
  }

  void read_coordinates() {
    Point3 point{};
    for (double& x : point) {
      x = tokens_.number("a coordinate");
      if (!std::isfinite(x)) tokens_.fail("is not finite", "a coordinate");
    }
    data_.points.push_back(point);
  }

  void read_nodes() {
    const int count = tokens_.integer("the count of nodes");
    for (int i = 0; i < count; ++i) {
      add_node(tokens_.integer("the number of a node"));
      read_coordinates();
    }
  }

  void read_node_blocks() {
    const int blocks = tokens_.integer("the count of blocks");
    for (int k = 0; k < 3; ++k) tokens_.integer("a count or number of nodes");
    for (int b = 0; b < blocks; ++b) {
      const int dimension = tokens_.integer("a dimension");
      tokens_.integer("the number of an entity");
      const bool parametric = tokens_.integer("0 or 1") != 0;
      const int count = tokens_.integer("the count of nodes");
      std::vector<int> own;
      for (int i = 0; i < count; ++i) own.push_back(tokens_.integer("the number of a node"));
      for (const int number : own) {
        add_node(number);
        read_coordinates();
        for (int k = 0; parametric && k < dimension; ++k) tokens_.number("a parameter");
      }
    }
  }

  void read_elements() {
    const int count = tokens_.integer("the count of elements");
    for (int i = 0; i < count; ++i) {
      tokens_.integer("the number of an element");
      const int line = tokens_.line();
      const ElementType& type = type_of(tokens_.integer("a type of element"));
      const int tags = tokens_.integer("the count of tags");
      int group = 0;
      for (int k = 0; k < tags; ++k) {
        const int tag = static_cast<int>(tokens_.number("a tag"));
        if (k == 0) group = tag;
      }
      read_element(type, group, line);
    }
  }

  void read_element_blocks() {
    const int blocks = tokens_.integer("the count of blocks");
    for (int k = 0; k < 3; ++k) tokens_.integer("a count or number of elements");
    for (int b = 0; b < blocks; ++b) {
      const int dimension = tokens_.integer("a dimension");
      const int entity = tokens_.integer("the number of an entity");
      const ElementType& type = type_of(tokens_.integer("a type of element"));
      const int count = tokens_.integer("the count of elements");
      const auto physical = physical_.find({dimension, entity});
      for (int i = 0; i < count; ++i) {
        tokens_.integer("the number of an element");
        read_element(type, physical == physical_.end() ? 0 : physical->second, tokens_.line());
      }
    }
  }

  const ElementType& type_of(int number) const {
    const auto found = std::ranges::find(kTypes, number, &ElementType::number);
    if (found == std::end(kTypes)) {
      tokens_.fail(fmt::format("holds elements of type {}", number),
                   "tetrahedra and hexahedra of first order");
    }
    if (number == 6 || number == 7) {
      tokens_.fail(fmt::format("holds {}", found->name), "tetrahedra and hexahedra alone");
    }
    return *found;
  }

  void read_element(const ElementType& type, int group, int line) {
    std::array<int, 8> corners{};
    for (int k = 0; k < type.corners; ++k) {
      const int number = tokens_.integer("the number of a node");
      const auto found = numbers_.find(number);
      if (found == numbers_.end()) {
        tokens_.fail(fmt::format("there is no node {}", number), "a node of $Nodes");
      }
      corners[static_cast<std::size_t>(k)] = found->second;
    }
    if (type.number == 4) {
      add({corners[0], corners[1], corners[2], corners[3]}, group, line, data_.tetrahedra);
    } else if (type.number == 5) {
      add(corners, group, line, data_.hexahedra);
    } else {
      const auto named = names_.find({type.dimension, group});
      if (named == names_.end()) {
        ++data_.ignored[type.name];
        return;
      }
      grouped_[named->second].insert(corners.begin(), corners.begin() + type.corners);
    }
  }

  template <std::size_t Corners>
  static void add(const std::array<int, Corners>& corners, int label, int line,
                  VolumeData::Elements<Corners>& elements) {
    elements.corners.push_back(corners);
    elements.labels.push_back(label);
    elements.lines.push_back(line);
  }

  TokenReader tokens_;
  VolumeData data_;
  int version_ = 0;
  std::unordered_map<int, int> numbers_;              // of points, by those of the file
  std::map<std::pair<int, int>, std::string> names_;  // by dimension and physical group
  std::map<std::pair<int, int>, int> physical_;       // by dimension and entity
  std::map<std::string, std::set<int>> grouped_;
};

/// The text of a file of format 2.2; groups of points are elements of one point each.
class GmshWriter {
 public:
  explicit GmshWriter(const VolumeData& data) : data_(data) {}

  std::string write() && {
    text_ = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
    write_names();
    write_nodes();
    for (int group = 1; const auto& [name, points] : data_.groups) {
      for (const int point : points) write_element(15, group, {&point, 1});
      ++group;
    }
    write_elements(data_.tetrahedra, 4);
    write_elements(data_.hexahedra, 5);
    text_ += fmt::format("$Elements\n{}\n{}$EndElements\n", elements_, lines_);
    return std::move(text_);
  }

 private:
  void write_names() {
    if (data_.region_names.empty() && data_.groups.empty()) return;
    text_ += fmt::format("$PhysicalNames\n{}\n", data_.region_names.size() + data_.groups.size());
    for (int group = 1; const auto& [name, points] : data_.groups) {
      text_ += fmt::format("0 {} \"{}\"\n", group++, name);
    }
    for (const auto& [label, name] : data_.region_names) {
      text_ += fmt::format("3 {} \"{}\"\n", label, name);
    }
    text_ += "$EndPhysicalNames\n";
  }

  void write_nodes() {
    text_ += fmt::format("$Nodes\n{}\n", data_.points.size());
    for (std::size_t i = 0; i < data_.points.size(); ++i) {
      const auto& [x, y, z] = data_.points[i];
      text_ += fmt::format("{} {} {} {}\n", i + 1, x, y, z);
    }
    text_ += "$EndNodes\n";
  }

  template <std::size_t Corners>
  void write_elements(const VolumeData::Elements<Corners>& elements, int type) {
    for (std::size_t e = 0; e < elements.corners.size(); ++e) {
      write_element(type, elements.labels.empty() ? 0 : elements.labels[e], elements.corners[e]);
    }
  }

  void write_element(int type, int group, std::span<const int> corners) {
    lines_ += fmt::format("{} {} 2 {} {}", ++elements_, type, group, group);
    for (const int corner : corners) lines_ += fmt::format(" {}", corner + 1);
    lines_ += '\n';
  }

  const VolumeData& data_;
  std::string text_;
  std::string lines_;  // of elements
  int elements_ = 0;
};

}  // namespace

VolumeData parse_gmsh(std::string_view text, const std::string& file) {
  return GmshReader(text, file).read();
}

VolumeData read_gmsh(const std::filesystem::path& path) {
  return parse_gmsh(read_text_file(path, kMaxMeshFileSize), path.string());
}

std::string write_gmsh(const VolumeData& data) { return GmshWriter(data).write(); }

}  // namespace pliant
