#include "pliant/io/vtu.h"

#include <cstddef>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/io/base64.h"
#include "pliant/io/byte_order.h"
#include "pliant/io/xml_text.h"

namespace pliant {
namespace {

constexpr const char* kFileAttributes =
    R"(version="1.0" byte_order="LittleEndian" header_type="UInt64")";

std::size_t corner_count(VtkCell cell) {
  switch (cell) {
    case VtkCell::triangle:
      return 3;
    case VtkCell::tetrahedron:
      return 4;
    case VtkCell::hexahedron:
      break;
  }
  return 8;
}

/// Writes the XML and, apart from it, the bytes that stand behind it.
class VtuWriter {
 public:
  VtuWriter(const VtuGrid& grid, const VtuOptions& options) : grid_(grid), options_(options) {
    for (const VtuCells& cells : grid.cells) {
      PLIANT_ASSERT(cells.corners.size() % corner_count(cells.cell) == 0, "cells are complete");
    }
  }

  std::string write() && {
    std::size_t cells = 0;
    for (const VtuCells& own : grid_.cells) cells += own.count();
    xml_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" {}>\n<UnstructuredGrid>\n"
        "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
        kFileAttributes, grid_.points.size(), cells);
    write_fields("PointData", grid_.point_data, grid_.points.size());
    write_fields("CellData", grid_.cell_data, cells);
    write_points();
    write_cells();
    xml_ += "</Piece>\n</UnstructuredGrid>\n";
    if (options_.encoding == VtuEncoding::appended_raw) {
      xml_ += "<AppendedData encoding=\"raw\">\n_" + appended_ + "\n</AppendedData>\n";
    }
    xml_ += "</VTKFile>\n";
    return std::move(xml_);
  }

 private:
  void write_fields(const char* element, const std::vector<VtuArray>& arrays, std::size_t rows) {
    xml_ += fmt::format("<{}>\n", element);
    for (const VtuArray& array : arrays) {
      PLIANT_ASSERT(array.values.size() == rows * array.components, "a field covers its mesh");
      write_reals(array.name, array.components, array.values);
    }
    xml_ += fmt::format("</{}>\n", element);
  }

  void write_points() {
    std::vector<double> coordinates;
    coordinates.reserve(3 * grid_.points.size());
    for (const Point3& point : grid_.points) {
      coordinates.insert(coordinates.end(), point.begin(), point.end());
    }
    xml_ += "<Points>\n";
    write_reals("Points", 3, coordinates);
    xml_ += "</Points>\n";
  }

  void write_cells() {
    xml_ += "<Cells>\n";
    std::string corners, ends, types;
    std::int64_t end = 0;
    for (const VtuCells& cells : grid_.cells) {
      for (const int corner : cells.corners) append_number(corner, ByteOrder::little, corners);
      for (std::size_t i = 0; i < cells.count(); ++i) {
        end += static_cast<std::int64_t>(corner_count(cells.cell));
        append_number(end, ByteOrder::little, ends);
      }
      types.append(cells.count(), static_cast<char>(cells.cell));
    }
    write_array("connectivity", "Int32", 1, corners);
    write_array("offsets", "Int64", 1, ends);
    write_array("types", "UInt8", 1, types);
    xml_ += "</Cells>\n";
  }

  void write_reals(const std::string& name, int components, const std::vector<double>& values) {
    std::string bytes;
    for (const double value : values) {
      if (options_.single_precision) {
        append_number(static_cast<float>(value), ByteOrder::little, bytes);
      } else {
        append_number(value, ByteOrder::little, bytes);
      }
    }
    write_array(name, options_.single_precision ? "Float32" : "Float64", components, bytes);
  }

  void write_array(const std::string& name, const char* type, int components,
                   const std::string& bytes) {
    std::string block;
    append_number(static_cast<std::uint64_t>(bytes.size()), ByteOrder::little, block);
    block += bytes;
    xml_ += fmt::format(R"(<DataArray type="{}" Name="{}" NumberOfComponents="{}" )", type,
                        xml_text(name), components);
    if (options_.encoding == VtuEncoding::base64) {
      xml_ += fmt::format("format=\"binary\">{}</DataArray>\n", base64(block));
    } else {
      xml_ += fmt::format("format=\"appended\" offset=\"{}\"/>\n", appended_.size());
      appended_ += block;
    }
  }

  const VtuGrid& grid_;
  const VtuOptions& options_;
  std::string xml_;
  std::string appended_;
};

}  // namespace

std::size_t VtuCells::count() const { return corners.size() / corner_count(cell); }

std::string write_vtu(const VtuGrid& grid, const VtuOptions& options) {
  return VtuWriter(grid, options).write();
}

std::string write_pvd(std::span<const PvdFrame> frames) {
  std::string xml = fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" {}>\n<Collection>\n", kFileAttributes);
  for (const PvdFrame& frame : frames) {
    xml += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frame.time,
                       xml_text(frame.file));
  }
  return xml + "</Collection>\n</VTKFile>\n";
}

}  // namespace pliant
