#include "pliant/mechanics/element_groups.h"

#include <algorithm>
#include <map>
#include <set>

#include <gtest/gtest.h>

#include "pliant/base/parallel.h"

#include "support/cloth_systems.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

constexpr int kBatches = 1000;

// A line of points: every batch touches two.
void touch_line(int batch, std::vector<int>& touched) {
  touched.insert(touched.end(), {batch, batch + 1});
}

// The same, and one batch in a hundred touches a clip.
void touch_clip(int batch, std::vector<int>& touched) {
  touch_line(batch, touched);
  if (batch % 100 == 0) touched.push_back(5000);
}

void expect_disjoint(const std::vector<ElementGroups::Group>& wave,
                     const ElementGroups::Touched& touch) {
  std::map<int, std::set<int>> groups_at;
  for (const auto& [begin, end] : wave) {
    std::vector<int> touched;
    for (int batch = begin; batch < end; ++batch) touch(batch, touched);
    for (const int one : touched) groups_at[one].insert(begin);
  }
  for (const auto& [one, groups] : groups_at) EXPECT_EQ(groups.size(), 1u) << one;
}

TEST(ElementGroups, HoldEveryBatchOnce) {
  std::vector<int> visits(kBatches, 0);
  const int sum = ElementGroups(kBatches, touch_clip).sum<int>([&](int batch) {
    ++visits[static_cast<size_t>(batch)];
    return batch;
  });
  EXPECT_EQ(sum, kBatches * (kBatches - 1) / 2);
  EXPECT_EQ(std::count(visits.begin(), visits.end(), 1), kBatches);
}

TEST(ElementGroups, OfOneWaveHaveNothingInCommon) {
  const ElementGroups line(kBatches, touch_line), clip(kBatches, touch_clip);
  EXPECT_EQ(line.waves().size(), 2u);  // every other group
  EXPECT_GT(clip.waves().size(), 2u);
  for (const auto& wave : line.waves()) expect_disjoint(wave, touch_line);
  for (const auto& wave : clip.waves()) expect_disjoint(wave, touch_clip);
}

/// Everything that an evaluation and the end of a step give.
struct Evaluated {
  Energy energy;
  Eigen::Matrix3Xd gradient;
  Eigen::VectorXd row_sums;  // of the Hessian
  Eigen::VectorXd history;
  double work = 0;
};

Evaluated evaluated_by(int threads) {
  test::ClothSystem cloth =
      test::cloth_system(test::jittered_grid(0.6, 0.15, 101, 21, 3), test::uneven_cotton());
  System& system = *cloth.system;
  system.coordinates().add_clip({0, 1, 2, 1500, 1501}, false);
  system.coordinates().prescribe(100);
  system.finish();
  State state = system.initial_state();
  RandomStream random(1);
  const Eigen::VectorXd shake = Eigen::VectorXd::NullaryExpr(
      system.coordinates().unknowns(), [&] { return random.uniform(-1e-4, 1e-4); });
  const Configuration at = system.coordinates().moved(state.configuration, shake);
  Evaluated result;
  with_threads(threads, [&] {
    result.energy = test::energy_of(system, at, state);
    result.gradient = test::gradient_of(system, at, state);
    Hessian hessian = system.make_hessian();
    Derivatives derivatives;
    derivatives.hessian = &hessian;
    system.evaluate(at, {state}, Curvature::convex, derivatives);
    result.row_sums = hessian.matrix * Eigen::VectorXd::Ones(system.coordinates().unknowns());
    result.work = system.advance_history(at, {state}, result.history).work;
  });
  return result;
}

TEST(ElementGroups, GiveTheSameBitsForAnyNumberOfThreads) {
  const Evaluated one = evaluated_by(1);
  for (const int threads : {2, 5}) {
    const Evaluated many = evaluated_by(threads);
    EXPECT_EQ(many.energy.stored, one.energy.stored);
    EXPECT_EQ(many.energy.work, one.energy.work);
    EXPECT_EQ(many.gradient, one.gradient);
    EXPECT_EQ(many.row_sums, one.row_sums);
    EXPECT_EQ(many.history, one.history);
    EXPECT_EQ(many.work, one.work);
  }
}

}  // namespace
}  // namespace pliant
