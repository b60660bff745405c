#include "pliant/contact/contact_surface.h"

#include <algorithm>
#include <memory>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/parallel.h"
#include "pliant/contact/near_pairs.h"

#include "contact/stacked_sheets.h"

namespace pliant {
namespace {

using test::random_ways;
using test::Sheets;
using test::stacked_sheets;
using Kind = SurfacePair::Kind;

/// All pairs of a surface that share no point, found without a search.
std::vector<SurfacePair> all_pairs(const Sheets& sheets) {
  std::set<std::array<int, 2>> edges;
  std::vector<SurfacePair> pairs;
  for (const auto& face : sheets.faces.colwise()) {
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = std::minmax({face(k), face((k + 1) % 3)});
      edges.insert({low, high});
    }
    for (int v = 0; v < sheets.positions.cols(); ++v) {
      if ((face.array() == v).any()) continue;
      pairs.push_back({Kind::vertex_face, {v, face(0), face(1), face(2)}});
    }
  }
  for (auto a = edges.begin(); a != edges.end(); ++a) {
    for (auto b = std::next(a); b != edges.end(); ++b) {
      const auto [p, q] = *a;
      const auto [r, s] = *b;
      if (p != r && p != s && q != r && q != s) pairs.push_back({Kind::edge_edge, {p, q, r, s}});
    }
  }
  return pairs;
}

/// The least distance that is met when a pair goes its ways, looked at in many places.
double least_distance(const SurfacePair& pair, const Eigen::Matrix3Xd& positions,
                      const Eigen::Matrix3Xd& ways) {
  constexpr int kSteps = 20;
  double least = INFINITY;
  for (int k = 0; k <= kSteps; ++k) {
    const PairPoints there =
        points_of(pair, positions) + double(k) / kSteps * points_of(pair, ways);
    least = std::min(least, gap_between(pair.kind, there).distance());
  }
  return least;
}

void expect_complete(const Sheets& sheets, const Eigen::Matrix3Xd& ways, double reach) {
  const ContactSurface surface(sheets.positions, {sheets.faces},
                               std::vector<bool>(size_t(sheets.positions.cols()), true));
  const std::vector<SurfacePair> found = surface.near_pairs(sheets.positions, ways, reach);
  EXPECT_TRUE(std::ranges::is_sorted(found));
  EXPECT_EQ(std::ranges::adjacent_find(found), found.end()) << "each pair once";
  size_t near = 0;
  for (const SurfacePair& pair : all_pairs(sheets)) {
    if (least_distance(pair, sheets.positions, ways) >= reach) continue;
    ++near;
    EXPECT_TRUE(std::ranges::binary_search(found, pair));
  }
  EXPECT_GT(near, 0u);
  EXPECT_LT(found.size(), all_pairs(sheets).size() / 4);
}

TEST(ContactSurface, FindsAllThatIsNear) {
  Sheets sheets = stacked_sheets(3, 6, 0.004);
  RandomStream random(1);
  sheets.positions += random_ways(random, sheets.positions.cols(), 0.001);
  expect_complete(sheets, Eigen::Matrix3Xd::Zero(3, sheets.positions.cols()), 0.005);
}

TEST(ContactSurface, FindsAllThatComesNear) {
  const Sheets sheets = stacked_sheets(3, 6, 0.02);
  RandomStream random(2);
  expect_complete(sheets, random_ways(random, sheets.positions.cols(), 0.006), 0.002);
}

TEST(ContactSurface, FindsTheSameOnAnyNumberOfThreads) {
  const Sheets sheets = stacked_sheets(3, 12, 0.004);
  const ContactSurface surface(sheets.positions, {sheets.faces},
                               std::vector<bool>(size_t(sheets.positions.cols()), true));
  const Eigen::Matrix3Xd still = 0 * sheets.positions;
  const auto alone = surface.near_pairs(sheets.positions, still, 0.005);
  EXPECT_FALSE(alone.empty());
  for (const int threads : {2, 5}) {
    with_threads(threads,
                 [&] { EXPECT_EQ(surface.near_pairs(sheets.positions, still, 0.005), alone); });
  }
}

TEST(ContactSurface, SeesNothingInWhatAllMoveAlike) {
  const Sheets sheets = stacked_sheets(2, 6, 0.02);
  const ContactSurface surface(sheets.positions, {sheets.faces},
                               std::vector<bool>(size_t(sheets.positions.cols()), true));
  const Eigen::Matrix3Xd ways = Eigen::Vector3d(1, 2, 3).replicate(1, sheets.positions.cols());
  EXPECT_EQ(surface.near_pairs(sheets.positions, ways, 0.001).size(),
            surface.near_pairs(sheets.positions, 0 * ways, 0.001).size());
}

TEST(ContactSurface, LeavesOutWhatDoesNotMove) {
  const Sheets sheets = stacked_sheets(2, 4, 0.001);
  const ContactSurface surface(sheets.positions, {sheets.faces},
                               std::vector<bool>(size_t(sheets.positions.cols()), false));
  EXPECT_TRUE(surface.near_pairs(sheets.positions, 0 * sheets.positions, 0.002).empty());
}

// Where a step goes astray nearly everything may meet nearly everything: 12 million pairs here.
TEST(SlowNearPairs, AreTooManyWhereWaysLeadFarToAllSides) {
  const Sheets sheets = stacked_sheets(2, 36, 0.003);
  const Eigen::Index count = sheets.positions.cols();
  const auto surface =
      std::make_shared<const ContactSurface>(sheets.positions, ContactSurface::Faces{sheets.faces},
                                             std::vector<bool>(size_t(count), true));
  const NearPairs near(surface, 0.002, 0.004);
  RandomStream random(6);
  const Eigen::Matrix3Xd astray = random_ways(random, count, 1);
  const auto between = [&](const Eigen::Matrix3Xd& ways) {
    return near.between_if_few(sheets.positions, sheets.positions + ways);
  };
  EXPECT_FALSE(between(astray));
  EXPECT_TRUE(between(1e-4 * astray));
  Eigen::Matrix3Xd apart = 0 * astray;
  apart.leftCols(count / 2).row(0).setConstant(10);
  const auto met = between(apart);
  ASSERT_TRUE(met);
  EXPECT_GT(met->size(), between(0 * astray)->size()) << "on a way that is long and all alike";
}

// What was asked before changes nothing but pairs beyond the reach.
TEST(NearPairs, DoNotDependOnWhatWasAskedBefore) {
  constexpr double kReach = 0.002;
  const Sheets sheets = stacked_sheets(3, 6, 0.003);
  const auto surface = std::make_shared<const ContactSurface>(
      sheets.positions, ContactSurface::Faces{sheets.faces},
      std::vector<bool>(size_t(sheets.positions.cols()), true));
  const NearPairs often(surface, kReach, 0.001);
  RandomStream random(3);
  Eigen::Matrix3Xd positions = sheets.positions;
  for (int step = 0; step < 30; ++step) {
    positions += random_ways(random, positions.cols(), 1e-4);
    const auto near = [&](const NearPairs& pairs) {
      std::vector<SurfacePair> within;
      const NearPairs::Pairs found = pairs.at(positions);
      std::ranges::copy_if(*found, std::back_inserter(within), [&](const SurfacePair& pair) {
        return gap_between(pair.kind, points_of(pair, positions)).distance() < kReach;
      });
      return within;
    };
    EXPECT_EQ(near(often), near(NearPairs(surface, kReach, 0.001))) << step;
  }
}

}  // namespace
}  // namespace pliant
