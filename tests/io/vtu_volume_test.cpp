// Volume meshes in .vtu files, in the ways that programs write them.

#include "pliant/io/vtu_volume.h"

#include <gtest/gtest.h>

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;

/// Two tetrahedra and a triangle with labels, packed by zlib in blocks of 64 bytes, headers and
/// bytes encoded each for itself, as VTK appends them.
const std::string kPacked =
    R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian" header_type="UInt32" compressor="vtkZLibDataCompressor">
<UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="3">
<CellData><DataArray type="Int32" Name="gmsh:physical" NumberOfComponents="1" format="appended" offset="216"/></CellData>
<Points><DataArray type="Float32" Name="Points" NumberOfComponents="3" format="appended" offset="0"/></Points>
<Cells><DataArray type="Int64" Name="connectivity" NumberOfComponents="1" format="appended" offset="48"/><DataArray type="Int64" Name="offsets" NumberOfComponents="1" format="appended" offset="128"/><DataArray type="UInt8" Name="types" NumberOfComponents="1" format="appended" offset="176"/></Cells>
</Piece></UnstructuredGrid>
<AppendedData encoding="base64">
   _AQAAAEAAAAA8AAAAEgAAAA==eJxjYEAGDfYMBPkIDABPVgR7AgAAAEAAAAAYAAAAFwAAABAAAAA=eJxjYIAARijNBKWZ0cRZcMgDAAIIABF4nGNggABGKM0EpQEAOAAEAQAAAEAAAAAYAAAAEAAAAA==eJxjYYAADijNDaUBAVAAGA==AQAAAEAAAAADAAAACwAAAA==eJzj4mIFAAA6ABo=AQAAAEAAAAAMAAAAEQAAAA==eJxjZ2BgYAZiTiAGAACcABQ=
</AppendedData>
</VTKFile>
)";

/// The same as text; without labels.
const std::string kWritten =
    R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="5" NumberOfCells="3">
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0  1 0 0  0 1 0  0 0 1  1 1 1 </DataArray></Points>
<Cells><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2 3 1 4 2 3 0 1 2</DataArray>
<DataArray type="Int32" Name="offsets" format="ascii">4 8 11</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">10 10 5</DataArray></Cells>
</Piece></UnstructuredGrid></VTKFile>
)";

VolumeData read(const std::string& text) {
  const TemporaryFolder folder;
  return read_vtu_volume(folder.write("mesh.vtu", text));
}

std::string replaced(std::string text, const std::string& old, const std::string& by) {
  const std::size_t at = text.find(old);
  EXPECT_NE(at, std::string::npos) << old;
  return text.replace(at, old.size(), by);
}

void expect_two_tetrahedra(const VolumeData& data, const std::vector<int>& labels) {
  const std::vector<std::array<int, 4>> expected{{0, 1, 2, 3}, {1, 4, 2, 3}};
  ASSERT_EQ(data.points.size(), 5u);
  EXPECT_EQ(data.points[4], (Point3{1, 1, 1}));
  EXPECT_EQ(data.tetrahedra.corners, expected);
  EXPECT_EQ(data.tetrahedra.labels, labels);
  EXPECT_TRUE(data.hexahedra.corners.empty());
  EXPECT_EQ(data.ignored, (std::map<std::string, int>{{"triangles", 1}}));
}

TEST(VtuVolume, IsReadWherePackedAndAppended) { expect_two_tetrahedra(read(kPacked), {7, 3}); }

TEST(VtuVolume, IsReadAsText) { expect_two_tetrahedra(read(kWritten), {0, 0}); }

TEST(VtuVolume, IsReadFromBase64WithinItsTags) {
  std::string text = replaced(kWritten, R"(format="ascii">
0 0 0  1 0 0  0 1 0  0 0 1  1 1 1 <)",
                              R"(format="binary">@<)");
  text = replaced(text, "Float64", "Float32");
  text = replaced(
      text, "@",
      "PAAAAA==AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AACAPwAAgD8AAIA/");
  expect_two_tetrahedra(read(text), {0, 0});
}

TEST(VtuVolume, ComesBackAsItWasWritten) {
  VolumeData data;
  for (int i = 0; i < 12; ++i) data.points.push_back({0.1 * i, 1.0 / (i + 3), -i * 1e-17});
  data.tetrahedra.corners = {{0, 1, 2, 3}, {3, 2, 1, 4}};
  data.tetrahedra.labels = {2, 5};
  data.hexahedra.corners = {{0, 1, 2, 3, 4, 5, 6, 7}};
  data.hexahedra.labels = {-1};
  const VolumeData back = read(write_vtu_volume(data));
  EXPECT_EQ(back.points, data.points);
  EXPECT_EQ(back.tetrahedra, data.tetrahedra);
  EXPECT_EQ(back.hexahedra, data.hexahedra);
}

TEST(VtuVolume, RefusesWhatItCannotRead) {
  const auto problem = [](const std::string& text) {
    return input_error_of([&] { read(text); }).problem();
  };
  EXPECT_EQ(problem("solid x"), "is no VTK file");
  EXPECT_EQ(problem(replaced(kWritten, "type=\"UnstructuredGrid\"", "type=\"PolyData\"")),
            "is no VTK unstructured grid");
  EXPECT_EQ(problem(replaced(kPacked, "vtkZLib", "vtkLZ4")), "is \"vtkLZ4DataCompressor\"");
  EXPECT_EQ(problem(replaced(kWritten, "10 10 5", "10 24 5")),
            "cell 1 is of VTK's type 24 and has 4 corners");
  EXPECT_EQ(problem(replaced(kWritten, "10 10 5", "10 5")), "has 2 numbers");
  EXPECT_EQ(problem(replaced(kWritten, "1 4 2 3", "1 9 2 3")), "names the point 9");
  EXPECT_EQ(problem(replaced(kWritten, "4 8 11", "4 8 12")), "end at 12 after 8");
  EXPECT_EQ(problem(replaced(kWritten, "4 8 11", "4 3 11")), "end at 3 after 4");
  EXPECT_EQ(problem(replaced(kWritten, "0 0 1  1", "0 0 one  1")), "has text among its numbers");
  EXPECT_EQ(problem(replaced(kPacked, "Z2BgYAZiTiAGAACcABQ=", "")),
            "does not have the bytes that its header tells of");
}

}  // namespace
}  // namespace pliant
