#include <algorithm>
#include <array>
#include <charconv>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/io/byte_order.h"
#include "pliant/io/ply.h"
#include "pliant/io/ply_header.h"

namespace pliant {
namespace {

constexpr std::array<std::string_view, 3> kFormatNames{"ascii", "binary_little_endian",
                                                       "binary_big_endian"};

bool is_word(const std::string& name) {
  return !name.empty() && name.find_first_of(" \t\r\n") == std::string::npos;
}

/// The shortest text that reads back as the same number of this type.
template <typename T>
void append_text(T value, std::string& text) {
  std::array<char, 32> buffer;
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  text.append(buffer.data(), result.ptr);
  text += ' ';
}

class PlyWriter {
 public:
  PlyWriter(const PlyMesh& mesh, const PlyOptions& options)
      : mesh_(mesh), options_(options), corner_count_type_(corner_count_type()) {
    PLIANT_ASSERT(!is_integer(options.coordinates), "coordinates are floating-point numbers");
  }

  std::string write() && {
    write_header();
    for (std::size_t i = 0; i < mesh_.positions.size(); ++i) {
      for (const double coordinate : mesh_.positions[i]) add(coordinate, options_.coordinates);
      write_row(mesh_.vertex_columns, i);
    }
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
      const std::span<const int> corners = mesh_.faces[i];
      add(static_cast<double>(corners.size()), corner_count_type_);
      for (const int corner : corners) add(corner, PlyType::int32);
      write_row(mesh_.face_columns, i);
    }
    return std::move(bytes_);
  }

 private:
  PlyType corner_count_type() const {
    std::size_t most = 0;
    for (std::size_t i = 0; i < mesh_.faces.size(); ++i) {
      most = std::max(most, mesh_.faces[i].size());
    }
    return most <= std::numeric_limits<std::uint8_t>::max() ? PlyType::uint8 : PlyType::int32;
  }

  void write_header() {
    bytes_ = fmt::format("ply\nformat {} 1.0\n", kFormatNames[static_cast<int>(options_.format)]);
    for (const std::string& comment : mesh_.comments) {
      PLIANT_ASSERT(comment.find('\n') == std::string::npos, "a comment is one line");
      bytes_ += fmt::format("comment {}\n", comment);
    }
    bytes_ += fmt::format("element vertex {}\n", mesh_.positions.size());
    for (const char axis : {'x', 'y', 'z'}) {
      bytes_ += fmt::format("property {} {}\n", name_of(options_.coordinates), axis);
    }
    write_properties(mesh_.vertex_columns, mesh_.positions.size());
    bytes_ += fmt::format("element face {}\nproperty list {} int vertex_indices\n",
                          mesh_.faces.size(), name_of(corner_count_type_));
    write_properties(mesh_.face_columns, mesh_.faces.size());
    bytes_ += "end_header\n";
  }

  void write_properties(const std::vector<PlyColumn>& columns, std::size_t rows) {
    for (const PlyColumn& column : columns) {
      PLIANT_ASSERT(is_word(column.name), "a property's name is one word");
      PLIANT_ASSERT(column.values.size() == rows, "a column has a number for each row");
      bytes_ += fmt::format("property {} {}\n", name_of(column.type), column.name);
    }
  }

  void write_row(const std::vector<PlyColumn>& columns, std::size_t row) {
    for (const PlyColumn& column : columns) add(column.values[row], column.type);
    if (options_.format == PlyFormat::ascii) bytes_.back() = '\n';
  }

  void add(double value, PlyType type) {
    switch (type) {
      case PlyType::int8:
        return add_as<std::int8_t>(value);
      case PlyType::uint8:
        return add_as<std::uint8_t>(value);
      case PlyType::int16:
        return add_as<std::int16_t>(value);
      case PlyType::uint16:
        return add_as<std::uint16_t>(value);
      case PlyType::int32:
        return add_as<std::int32_t>(value);
      case PlyType::uint32:
        return add_as<std::uint32_t>(value);
      case PlyType::float32:
        return add_as<float>(value);
      case PlyType::float64:
        break;
    }
    add_as<double>(value);
  }

  template <typename T>
  void add_as(double value) {
    if constexpr (std::numeric_limits<T>::is_integer) {
      PLIANT_ASSERT(value >= std::numeric_limits<T>::min() &&
                        value <= std::numeric_limits<T>::max() &&
                        static_cast<double>(static_cast<T>(value)) == value,
                    "an integer column holds integers in its range");
    }
    const T number = static_cast<T>(value);
    if (options_.format == PlyFormat::ascii) {
      append_text(number, bytes_);
    } else {
      const bool little = options_.format == PlyFormat::binary_little_endian;
      append_number(number, little ? ByteOrder::little : ByteOrder::big, bytes_);
    }
  }

  const PlyMesh& mesh_;
  const PlyOptions& options_;
  PlyType corner_count_type_;
  std::string bytes_;
};

}  // namespace

std::string write_ply(const PlyMesh& mesh, const PlyOptions& options) {
  return PlyWriter(mesh, options).write();
}

}  // namespace pliant
