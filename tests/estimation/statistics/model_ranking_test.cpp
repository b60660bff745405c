#include "pliant/estimation/statistics/model_ranking.h"

#include <cmath>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kRounding = 1e-12;

TEST(RankModels, ChargesTwoOrTheLogarithmOfTheRowsForAParameter) {
  const auto scores = rank_models({{2, 3}, {1, 5}}, 50);
  EXPECT_NEAR(scores[0].aic, 50 * std::log(2.0) + 6, kRounding);
  EXPECT_NEAR(scores[0].bic, 50 * std::log(2.0) + 3 * std::log(50.0), 50 * kRounding);
  EXPECT_EQ(scores[1].delta_bic, 0);
  EXPECT_NEAR(scores[0].delta_bic, 50 * std::log(2.0) - 2 * std::log(50.0), 50 * kRounding);
}

TEST(RankModels, PrefersTheSimplerModelOfFewEffectiveRows) {
  // 10 % less scatter for one parameter: 100 rows tell, 10 do not.
  EXPECT_GT(rank_models({{1, 3}, {0.9, 4}}, 100)[0].delta_bic, 0);
  EXPECT_GT(rank_models({{1, 3}, {0.9, 4}}, 10)[1].delta_bic, 0);
}

}  // namespace
}  // namespace pliant
