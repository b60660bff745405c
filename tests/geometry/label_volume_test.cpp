// Segmented images: what their files say, and the meshes that fill their regions.

#include "pliant/geometry/label_volume.h"

#include <numbers>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>

#include "pliant/geometry/irregular_mesh.h"
#include "pliant/geometry/volume_mesher.h"
#include "pliant/geometry/volume_quality.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string header(const std::string& type, const std::string& encoding,
                   const std::string& more = "") {
  return "NRRD0004\n# made up\ntype: " + type +
         "\ndimension: 3\nspace: left-posterior-superior\nsizes: 2 3 2\n"
         "space directions: (0.5,0,0) (0,0.25,0) (0,0,2)\nspace origin: (1,2,-3)\nencoding: " +
         encoding + "\n" + more + "\n";
}

LabelVolume read(const std::string& text) {
  const test::TemporaryFolder folder;
  return read_label_volume(folder.write("a.nrrd", text));
}

std::string packed(const std::string& raw) {
  std::string result(1000, '\0');
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 16 + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
  std::string input = raw;
  stream.next_in = reinterpret_cast<Bytef*>(input.data());
  stream.avail_in = static_cast<uInt>(input.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  return result;
}

TEST(LabelVolume, ReadsNumbersInEveryEncoding) {
  std::string raw;
  for (char i = 0; i < 12; ++i) raw += i;
  std::string big;
  for (char i = 0; i < 12; ++i) big += std::string{'\0', i};
  for (const std::string& text :
       {header("uchar", "raw") + raw, header("unsigned char", "gzip") + packed(raw),
        header("short", "raw", "endian: big\n") + big,
        header("int", "ascii") + "0 1 2 3 4 5 6\n7 8 9 10 11\n"}) {
    const LabelVolume volume = read(text);
    EXPECT_THAT(volume.labels, ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
    EXPECT_EQ(volume.size, Eigen::Vector3i(2, 3, 2));
    EXPECT_EQ(volume.axes.diagonal(), Eigen::Vector3d(0.5, 0.25, 2));
    EXPECT_EQ(volume.origin, Eigen::Vector3d(1, 2, -3));
    EXPECT_EQ(volume.at({1.5, 2.25, -1}), 9);
    EXPECT_EQ(volume.at({1.4, 2.3, -1.2}), 9);
    EXPECT_EQ(volume.at({0.9, 2.25, -1}), 0);
  }
}

TEST(LabelVolume, IsRefusedWithTheFieldThatIsWrong) {
  const auto refused = [](const std::string& text) {
    return test::input_error_of([&] { read(text); });
  };
  EXPECT_THAT(refused("PNG").problem(), HasSubstr("no .nrrd file"));
  EXPECT_EQ(refused(header("float", "raw")).where().field, "type");
  EXPECT_EQ(refused(header("uchar", "bzip2")).where().field, "encoding");
  EXPECT_THAT(refused(header("uchar", "raw") + "123").problem(), HasSubstr("12 voxels"));
  EXPECT_EQ(refused(header("uchar", "gzip") + "123").where().field, "encoding");
  EXPECT_EQ(
      refused("NRRD0004\ntype: uchar\ndimension: 2\nsizes: 2 3\nencoding: raw\n\n").where().field,
      "sizes");
  EXPECT_EQ(
      refused("NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 2\nencoding: raw\n\n").where().field,
      "space directions");
}

/// A ball of label 1 with a ball of label 5 in its middle.
LabelVolume two_balls(double radius, double inner) {
  constexpr int kVoxels = 40;
  LabelVolume volume;
  volume.size.setConstant(kVoxels);
  volume.axes = Eigen::Matrix3d::Identity() * 2.4 * radius / (kVoxels - 1);
  volume.origin.setConstant(-1.2 * radius);
  for (int z = 0; z < kVoxels; ++z) {
    for (int y = 0; y < kVoxels; ++y) {
      for (int x = 0; x < kVoxels; ++x) {
        const double r = (volume.origin + volume.axes * Eigen::Vector3d(x, y, z)).norm();
        volume.labels.push_back(r < inner ? 5 : r < radius ? 1 : 0);
      }
    }
  }
  return volume;
}

TEST(SlowLabelVolume, IsFilledRegionByRegion) {
  if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  const LabelVolume volume = two_balls(0.02, 0.01);
  const VolumeMesh mesh = fill_labels(volume, 0.004);
  EXPECT_TRUE(find_volume_problems(mesh).empty());
  const Eigen::VectorXd volumes = element_volumes(mesh);
  double inner = 0;
  for (int e = 0; e < mesh.element_count(); ++e) {
    const int label = mesh.labels[static_cast<std::size_t>(e)];
    EXPECT_TRUE(label == 1 || label == 5) << label;
    if (label == 5) inner += volumes(e);
  }
  const auto ball = [](double r) { return 4 * std::numbers::pi / 3 * r * r * r; };
  EXPECT_NEAR(volumes.sum(), ball(0.02), 0.05 * ball(0.02));
  EXPECT_NEAR(inner, ball(0.01), 0.1 * ball(0.01));
  const VolumeMesh again = fill_labels(volume, 0.004);
  EXPECT_TRUE(mesh.positions == again.positions);
  EXPECT_THAT(test::input_error_of([&] {
                LabelVolume nothing = volume;
                std::ranges::fill(nothing.labels, 0);
                fill_labels(nothing, 0.004, "a.nrrd");
              }).problem(),
              HasSubstr("no region"));
}

}  // namespace
}  // namespace pliant
