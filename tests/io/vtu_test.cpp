#include "pliant/io/vtu.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/assert.h"
#include "pliant/io/byte_order.h"

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

VtuGrid sample_grid() {
  VtuGrid grid;
  grid.points = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0.5}, {0, 1, 0}};
  grid.cells = {{VtkCell::triangle, {0, 1, 2, 0, 2, 3}}};
  grid.point_data = {{"velocity", 3, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}}};
  grid.cell_data = {{"strain < 1 & \"more\"", 1, {0.25, -0.5}}};
  return grid;
}

/// The numbers of an array of an appended-raw file: its offset is in the XML, the bytes follow "_".
template <typename T>
std::vector<T> appended_array(const std::string& vtu, const std::string& name) {
  const std::size_t element = vtu.find("Name=\"" + name + "\"");
  const std::size_t offset_at = vtu.find("offset=\"", element) + 8;
  const std::size_t start = vtu.find("encoding=\"raw\">\n_") + 17;
  const char* block = vtu.data() + start + std::stoul(vtu.substr(offset_at, 20));
  const auto size = load_number<std::uint64_t>(block, ByteOrder::little);
  std::vector<T> values;
  for (std::size_t at = 0; at < size; at += sizeof(T)) {
    values.push_back(load_number<T>(block + 8 + at, ByteOrder::little));
  }
  return values;
}

TEST(Vtu, HoldsPointsCellsAndFieldsBehindTheXml) {
  const std::string vtu = write_vtu(sample_grid());
  EXPECT_THAT(vtu, AllOf(StartsWith("<?xml"), EndsWith("</VTKFile>\n"),
                         HasSubstr("NumberOfPoints=\"4\" NumberOfCells=\"2\"")));
  EXPECT_EQ(appended_array<double>(vtu, "Points"),
            (std::vector<double>{0, 0, 0, 1, 0, 0, 1, 1, 0.5, 0, 1, 0}));
  EXPECT_EQ(appended_array<std::int32_t>(vtu, "connectivity"), sample_grid().cells[0].corners);
  EXPECT_EQ(appended_array<std::int64_t>(vtu, "offsets"), (std::vector<std::int64_t>{3, 6}));
  EXPECT_EQ(appended_array<std::uint8_t>(vtu, "types"), (std::vector<std::uint8_t>{5, 5}));
  EXPECT_EQ(appended_array<double>(vtu, "velocity"), sample_grid().point_data[0].values);
  EXPECT_EQ(appended_array<double>(vtu, "strain &lt; 1 &amp; &quot;more&quot;"),
            sample_grid().cell_data[0].values);
}

TEST(Vtu, HalvesItsNumbersOnRequest) {
  const std::string vtu = write_vtu(sample_grid(), {.single_precision = true});
  EXPECT_EQ(appended_array<float>(vtu, "Points")[8], 0.5f);
  EXPECT_THAT(vtu, HasSubstr("type=\"Float32\" Name=\"Points\""));
}

TEST(Vtu, IsWellFormedXmlInBase64) {
  VtuGrid grid = sample_grid();
  grid.cell_data[0] = {"a", 1, {1, -2}};
  const std::string vtu = write_vtu(grid, {VtuEncoding::base64});
  // The block of an array: its size as a 64-bit number, then its bytes; by coreutils' base64.
  EXPECT_THAT(vtu, HasSubstr("format=\"binary\">EAAAAAAAAAAAAAAAAADwPwAAAAAAAADA</DataArray>"));
  EXPECT_THAT(vtu, HasSubstr("Name=\"types\" NumberOfComponents=\"1\" format=\"binary\">"
                             "AgAAAAAAAAAFBQ==</DataArray>"));
  EXPECT_THAT(vtu, testing::Not(HasSubstr("AppendedData")));
}

TEST(Vtu, RefusesAFieldOfAnotherSize) {
  VtuGrid grid = sample_grid();
  grid.point_data[0].values.pop_back();
  EXPECT_THROW(write_vtu(grid), AssertionError);
  grid = sample_grid();
  grid.cells[0].cell = VtkCell::tetrahedron;
  EXPECT_THROW(write_vtu(grid), AssertionError);
}

TEST(Pvd, NamesEveryFileWithItsTime) {
  const PvdFrame frames[] = {{0, "frames/000000.vtu"}, {0.04, "frames/000001.vtu"}};
  EXPECT_THAT(write_pvd(frames),
              AllOf(HasSubstr("type=\"Collection\""),
                    HasSubstr("<DataSet timestep=\"0.04\" part=\"0\" file=\"frames/000001.vtu\"/>"),
                    EndsWith("</VTKFile>\n")));
}

TEST(VtuHead, TellsSizesAndFieldsOfBothEncodings) {
  const TemporaryFolder folder;
  VtuGrid grid;
  grid.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  grid.cells = {{VtkCell::triangle, {0, 1, 2}}};
  grid.point_data = {{"strain.<weft>", 1, {1, 2, 3}}, {"velocity", 3, std::vector<double>(9)}};
  grid.cell_data = {{"stress", 1, {1}}};
  for (const VtuEncoding encoding : {VtuEncoding::appended_raw, VtuEncoding::base64}) {
    const VtuHead head =
        read_vtu_head(folder.write("a.vtu", write_vtu(grid, {.encoding = encoding})));
    EXPECT_EQ(head.points, 3);
    EXPECT_EQ(head.cells, 1);
    ASSERT_EQ(head.fields.size(), 3u);
    EXPECT_EQ(head.fields[0].name, "strain.<weft>");
    EXPECT_EQ(head.fields[1].components, 3);
    EXPECT_TRUE(head.fields[1].of_points);
    EXPECT_FALSE(head.fields[2].of_points);
  }
}

TEST(VtuHead, RefusesWhatIsNoGrid) {
  const TemporaryFolder folder;
  for (const char* text : {"", "solid", "<VTKFile type=\"PolyData\"><Piece ",
                           "<UnstructuredGrid><Piece NumberOfPoints=\"-1\" NumberOfCells=\"1\">",
                           "<UnstructuredGrid><Piece NumberOfPoints=\"1\" NumberOfCells=\"1\">"
                           "<Piece NumberOfPoints=\"1\" NumberOfCells=\"1\">"}) {
    const auto file = folder.write("a.vtu", text);
    EXPECT_EQ(input_error_of([&] { read_vtu_head(file); }).where().file, file.string()) << text;
  }
}

}  // namespace
}  // namespace pliant
