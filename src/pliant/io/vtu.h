#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "pliant/io/mesh_data.h"

namespace pliant {

/// VTK's numbers of the shapes of cells.
enum class VtkCell : std::uint8_t { triangle = 5, tetrahedron = 10, hexahedron = 12 };

/// A named field: `components` numbers for each point or cell, point by point.
struct VtuArray {
  std::string name;
  int components = 1;
  std::vector<double> values;
};

/// Cells of one shape.
struct VtuCells {
  VtkCell cell = VtkCell::triangle;
  std::vector<int> corners;  ///< points of each cell, one cell after the other, in VTK's order

  std::size_t count() const;
};

/// A mesh of cells with fields on it. Cells are counted through all shapes, in their order.
struct VtuGrid {
  std::vector<Point3> points;
  std::vector<VtuCells> cells;
  std::vector<VtuArray> point_data;
  std::vector<VtuArray> cell_data;
};

enum class VtuEncoding {
  appended_raw,  ///< smallest and fastest; the file is no well-formed XML
  base64,        ///< well-formed XML
};

struct VtuOptions {
  VtuEncoding encoding = VtuEncoding::appended_raw;
  bool single_precision = false;  ///< of points and fields: half the size
};

/// A VTK unstructured grid file (.vtu), as ParaView reads it.
std::string write_vtu(const VtuGrid& grid, const VtuOptions& options = {});

/// A field as the head of a file tells it.
struct VtuField {
  std::string name;
  int components = 1;
  bool of_points = true;  ///< else of cells
};

/// What a file holds, without its numbers.
struct VtuHead {
  long points = 0;
  long cells = 0;
  std::vector<VtuField> fields;
};

/// Reads the head of a file of one piece, as `write_vtu` writes it.
/// @throws InputError for a file that is no such grid
VtuHead read_vtu_head(const std::filesystem::path& path);

/// One moment of a series.
struct PvdFrame {
  double time = 0;   ///< s
  std::string file;  ///< relative to the .pvd file
};

/// A ParaView data file (.pvd) that opens a series of files with their times.
std::string write_pvd(std::span<const PvdFrame> frames);

}  // namespace pliant
