// Points of a T-shirt in ten shapes (Chhatkuli et al.), as a system for image correlation exports
// them; skipped where PLIANT_TEST_DATA does not hold them. The lines they print are those of the
// documentation.

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/capture/dic_import.h"
#include "pliant/capture/median.h"
#include "pliant/geometry/topology.h"

#include "real/matlab_file.h"
#include "real/real_fit.h"

namespace pliant::test {
namespace {

constexpr const char* kFile = "tracked_tshirt_points/tshirtdata.mat";
constexpr Eigen::Index kPoints = 85;
constexpr int kFrames = 10;

/// The points of each frame in camera axes (mm), and where its photograph shows them (pixels).
struct Shirt {
  Eigen::Matrix3d to_pixels;
  std::vector<Eigen::Matrix3Xd> points, seen;
};

Shirt read_shirt() {
  const std::string variable = matlab_variable(measurement(kFile));
  const MatlabStruct scene = matlab_structs(variable).at(0);
  Shirt shirt;
  shirt.to_pixels = matlab_matrix(scene.at("K"));
  for (const MatlabStruct& frame : matlab_structs(scene.at("Pgth"))) {
    shirt.points.emplace_back(matlab_matrix(frame.at("P")));
  }
  for (const MatlabStruct& frame : matlab_structs(scene.at("m"))) {
    shirt.seen.emplace_back(matlab_matrix(frame.at("p")));
  }
  return shirt;
}

TEST(RealShirt, PointsAreWhereThePhotographsShowThem) {
  SKIP_WITHOUT(measurement(kFile));
  const Shirt shirt = read_shirt();
  ASSERT_EQ(std::ssize(shirt.points), kFrames);
  ASSERT_EQ(std::ssize(shirt.seen), kFrames);
  std::vector<double> misses, of_frames;
  for (std::size_t f = 0; f < shirt.points.size(); ++f) {
    ASSERT_EQ(shirt.points[f].cols(), kPoints);
    const Eigen::Matrix2Xd shown = (shirt.to_pixels * shirt.points[f]).colwise().hnormalized();
    const Eigen::RowVectorXd miss = (shown - shirt.seen[f].topRows<2>()).colwise().norm();
    of_frames.push_back(median({miss.begin(), miss.end()}));
    misses.insert(misses.end(), miss.begin(), miss.end());
  }
  fmt::print("shirt: points miss their pictures by {:.2f} px (median), by frame {:.2f}\n",
             median(misses), fmt::join(of_frames, ", "));
  EXPECT_LT(median(misses), 0.85);  // 0.8 is known of the data
}

using Edge = std::pair<Eigen::Index, Eigen::Index>;

/// Each point with its four nearest.
std::vector<Edge> edges_between(const Eigen::Matrix3Xd& points) {
  constexpr std::size_t kNearest = 4;
  std::vector<Edge> edges;
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    std::vector<Eigen::Index> others(static_cast<std::size_t>(points.cols()));
    std::iota(others.begin(), others.end(), 0);
    std::ranges::sort(others, {},
                      [&](Eigen::Index k) { return (points.col(k) - points.col(i)).norm(); });
    for (std::size_t n = 1; n <= kNearest; ++n) edges.push_back(std::minmax(i, others[n]));
  }
  std::ranges::sort(edges);
  edges.erase(std::ranges::unique(edges).begin(), edges.end());
  return edges;
}

/// By which edges are longer in one frame than in another; without those that are not seen in both.
std::vector<double> length_changes(const std::vector<Edge>& edges, const Eigen::Matrix3Xd& before,
                                   const Eigen::Matrix3Xd& after) {
  std::vector<double> changes;
  for (const auto& [i, k] : edges) {
    const double change =
        (after.col(i) - after.col(k)).norm() / (before.col(i) - before.col(k)).norm() - 1;
    if (std::isfinite(change)) changes.push_back(change);
  }
  return changes;
}

/// Of their sizes.
double mean_size(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double number : numbers) sum += std::abs(number);
  return sum / static_cast<double>(numbers.size());
}

// Cloth hardly stretches by its own weight: what lengths scatter by is the error of the points.
TEST(RealShirt, EdgesBetweenItsPointsKeepTheirLengths) {
  SKIP_WITHOUT(measurement(kFile));
  const Shirt shirt = read_shirt();
  const std::vector<Edge> edges = edges_between(shirt.points.front());
  std::vector<double> all, of_frames;
  for (std::size_t f = 1; f < shirt.points.size(); ++f) {
    const std::vector<double> changes =
        length_changes(edges, shirt.points.front(), shirt.points[f]);
    all.insert(all.end(), changes.begin(), changes.end());
    of_frames.push_back(100 * mean_size(changes));
  }
  fmt::print("shirt: {} edges differ from the first frame by {:.2f} % (mean), by frame {:.1f} %\n",
             edges.size(), 100 * mean_size(all), fmt::join(of_frames, ", "));
  EXPECT_LT(mean_size(all), 0.03);  // 0.027 is known of the data
}

/// A table a frame, as systems for image correlation write them, and what describes them: rows of
/// pictures count downwards, and so does y; a shirt has no clip but what it hangs from, and its
/// weight is anyone's guess, on which nothing here depends.
std::filesystem::path write_export(const TemporaryFolder& folder, const Shirt& shirt) {
  for (std::size_t f = 0; f < shirt.points.size(); ++f) {
    std::string table = "id,x (mm),y (mm),z (mm)\n";
    for (Eigen::Index i = 0; i < shirt.points[f].cols(); ++i) {
      table += fmt::format("{},{}\n", i, fmt::join(shirt.points[f].col(i), ","));
    }
    folder.write(fmt::format("points/{:02}.csv", f), table);
  }
  return folder.write("shirt.yaml",
                      "pliant: dic/1\ntest: worn\n"
                      "sample: {width: 210 mm, height: 210 mm, density: 150 g/m^2}\n"
                      "points: points/*.csv\nwarp: -y\nclips: [{name: shoulders, side: top}]\n");
}

// The shirt is worn in the first frame, too: it is unrolled, by which it has to stretch a little.
TEST(RealShirt, ItsPointsAreImportedUnrolled) {
  SKIP_WITHOUT(measurement(kFile));
  const TemporaryFolder folder;
  const DicImport imported = import_dic(write_export(folder, read_shirt()), {}, {});
  const Session& session = imported.made.session;
  std::vector<Edge> edges;
  for (const MeshEdge& edge : find_edges(session.rest.triangles)) {
    edges.emplace_back(edge.vertices[0], edge.vertices[1]);
  }
  const Eigen::Matrix3Xd& first = session.frames.front().positions;
  std::vector<double> of_frames;
  for (const SessionFrame& frame : session.frames) {
    of_frames.push_back(100 * mean_size(length_changes(edges, first, frame.positions)));
  }
  const std::vector<double> at_rest = length_changes(edges, session.rest.positions, first);
  fmt::print(
      "shirt, imported: {}\nedges of the first frame are {:.1f} % longer than flat (median of {}); "
      "by frame they differ from it by {:.1f} % (mean)\n",
      fmt::join(imported.study.notes, "\n"), 100 * median(at_rest), at_rest.size(),
      fmt::join(of_frames, ", "));
  EXPECT_EQ(session.frame_count(), kFrames);
  EXPECT_THAT(imported.made.lost, ::testing::Each(0));
  EXPECT_GT(imported.made.off_plane, 5e-3);
  EXPECT_THAT(imported.study.notes, ::testing::Contains(::testing::HasSubstr("off their plane")));
  ASSERT_TRUE(imported.made.unrolled);
  EXPECT_LT(*imported.made.unrolled, 0.02);
  EXPECT_LT(std::abs(median(at_rest)), 0.005);
}

}  // namespace
}  // namespace pliant::test
