#include "pliant/report/loop_figure.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pliant::report {
namespace {

using ::testing::Contains;
using ::testing::Not;

ResultExperiment experiment(const std::string& quantity) {
  ResultExperiment e;
  e.component = "stretch.warp";
  e.quantity = quantity;
  return e;
}

Prediction cycle() {
  Prediction p;
  p.strain = {0.0, 0.1, 0.2, 0.1, 0.0};
  p.branch = {Branch::load, Branch::load, Branch::load, Branch::unload, Branch::unload};
  p.specimen.assign(5, "1");
  p.used = {0, 1, 1, 1, 1};
  p.measured = {0.0, 1.1, 2.1, 0.6, 0.1};
  p.predicted = {0.0, 1.0, 2.0, 0.5, 0.0};
  p.elastic = {0.0, 0.8, 1.9, 0.8, 0.0};
  return p;
}

std::vector<std::string> groups(const LoopFigure& loop) {
  std::vector<std::string> names;
  for (const auto& trace : loop.figure.traces) names.push_back(trace.at("legendgroup"));
  return names;
}

const nlohmann::json& trace_of(const LoopFigure& loop, const std::string& group) {
  return *std::find_if(loop.figure.traces.begin(), loop.figure.traces.end(),
                       [&](const nlohmann::json& t) { return t.at("legendgroup") == group; });
}

TEST(LoopFigure, TellsLoadingAndUnloadingApartByColourAndByDash) {
  const LoopFigure loop = loop_figure(experiment("force_N"), cycle(), {});
  const auto& load = trace_of(loop, "predicted-load").at("line");
  const auto& unload = trace_of(loop, "predicted-unload").at("line");
  EXPECT_NE(load.at("color"), unload.at("color"));
  EXPECT_NE(load.at("dash"), unload.at("dash"));
}

TEST(LoopFigure, ShowsWhatWasLeftOutApart) {
  const LoopFigure loop = loop_figure(experiment("force_N"), cycle(), {});
  EXPECT_EQ(trace_of(loop, "excluded").at("x"), nlohmann::json({0.0}));
  EXPECT_EQ(trace_of(loop, "measured-load").at("x"), nlohmann::json({10.0, 20.0}));
}

TEST(LoopFigure, MarksRowsThatTheFitLeavesByFar) {
  ResultExperiment e = experiment("force_N");
  EXPECT_THAT(groups(loop_figure(e, cycle(), {})), Not(Contains("outlier")));
  e.outliers = {2};
  const LoopFigure loop = loop_figure(e, cycle(), {});
  EXPECT_EQ(trace_of(loop, "outlier").at("x"), nlohmann::json({20.0}));
  EXPECT_EQ(trace_of(loop, "outlier").at("y"), nlohmann::json({2.1}));
}

TEST(LoopFigure, LegendNamesExactlyTheSeriesDrawn) {
  const LoopFigure loop = loop_figure(experiment("force_N"), cycle(), {});
  std::vector<std::string> legend;
  for (const SeriesStyle& style : loop.legend) legend.emplace_back(style.group);
  EXPECT_EQ(legend, groups(loop));
}

TEST(LoopFigure, DrawsAnElasticCurveOnceWherePassesFallTogether) {
  const LoopFigure loop = loop_figure(experiment("force_N"), cycle(), {});
  EXPECT_EQ(trace_of(loop, "elastic").at("x"), nlohmann::json({0.0, 0.0, 10.0, 10.0, 20.0}));
}

TEST(LoopFigure, DrawsAnElasticCurvePassByPassWhereItsZeroDrifts) {
  Prediction p = cycle();
  p.elastic = {0.0, 0.8, 1.9, 2.8, 4.0};
  const LoopFigure loop = loop_figure(experiment("force_N"), p, {});
  EXPECT_EQ(trace_of(loop, "elastic").at("y"), nlohmann::json(p.elastic));
}

TEST(LoopFigure, OnPageOneShowsTheLoopsAlone) {
  const LoopFigure loop =
      loop_figure(experiment("force_N"), cycle(), {.budget = 300, .compact = true});
  EXPECT_THAT(groups(loop), Not(Contains("elastic")));
  EXPECT_THAT(groups(loop), Not(Contains("excluded")));
}

TEST(LoopFigure, DrawsBothEdgesOfABandAlongBothBranches) {
  Prediction p = cycle();
  p.low = {-0.1, 0.9, 1.9, 0.4, -0.1};
  p.high = {0.1, 1.1, 2.1, 0.6, 0.1};
  const nlohmann::json nothing;
  EXPECT_EQ(trace_of(loop_figure(experiment("force_N"), p, {}), "band").at("y"),
            nlohmann::json({-0.1, 0.9, 1.9, nothing, 1.9, 0.4, -0.1, nothing, 0.1, 1.1, 2.1,
                            nothing, 2.1, 0.6, 0.1}));
}

TEST(LoopFigure, DrawsLengthsAgainstTheLoadThatCausedThem) {
  Prediction p = cycle();
  p.driver = {0.0, 1.0, 2.0, 1.0, 0.0};
  p.driver_column = "weight_N";
  const LoopFigure loop = loop_figure(experiment("length_mm"), p, {});
  EXPECT_EQ(trace_of(loop, "predicted-unload").at("x"), nlohmann::json({2.0, 0.5, 0.0}));
  EXPECT_EQ(trace_of(loop, "predicted-unload").at("y"), nlohmann::json({2.0, 1.0, 0.0}));
  EXPECT_EQ(loop.figure.layout.at("yaxis").at("title").at("text"), "Weight (N)");
}

TEST(LoopFigure, DrawsMomentsAgainstTheCurvature) {
  ResultExperiment bending = experiment("moment_N");
  bending.component = "bend.warp";
  Prediction p = cycle();
  p.strain = {0, 300, 750, 300, 0};  // three times the curvature
  const LoopFigure loop = loop_figure(bending, p, {});
  EXPECT_EQ(trace_of(loop, "measured-load").at("x"), nlohmann::json({100.0, 250.0}));
  EXPECT_EQ(loop.figure.layout.at("xaxis").at("title").at("text"), "Curvature (1/m)");
  EXPECT_EQ(loop.figure.layout.at("yaxis").at("title").at("text"), "Moment per width (N)");
}

}  // namespace
}  // namespace pliant::report
