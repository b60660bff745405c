// Predictions follow the loops of a cloth with friction, and not their middle.

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/experiment/session/virtual/observed_session.h"
#include "pliant/experiment/session/virtual_session.h"
#include "pliant/measurement/session/frame_measures.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

/// Friction of a fifth to a quarter of the elastic stress halfway.
Material cloth() {
  Material material = first_sheet_material({});
  material.density = 0.15;
  const auto give = [&](const char* name, double stiffness, const DahlParameters& friction) {
    material.components[name].stiffness = ScalarCurve::hermite({0.0}, {stiffness}, is_even(name));
    material.components[name].friction = ComponentFriction{friction, std::nullopt};
  };
  give("stretch.weft", 300, {1.7, 0, 0.006});
  give("stretch.warp", 500, {2.2, 15, 0.006});
  give("shear", 20, {0.4, 0, 0.015});
  return material;
}

/// The measure of a frame that is nearest to half of the way, on the way there and back.
double force_halfway(const Session& session, bool there) {
  std::vector<double> way;
  for (int f = 0; f < session.frame_count(); ++f) way.push_back(travel(session, f));
  const auto turn = std::ranges::max_element(way);
  const auto first = there ? way.begin() : turn, last = there ? turn : way.end();
  const auto nearest = std::ranges::min_element(
      first, last, {}, [&](double at) { return std::abs(at - *turn / 2); });
  const int frame = static_cast<int>(nearest - way.begin());
  return session.test == "shear" ? aggregated_torque(session, frame)
                                 : cord_pull(session, frame, 0).norm();
}

/// Each test there and back, with noise, on the grid of the fit.
class Loops : public ::testing::Test {
 protected:
  Loops() {
    std::string experiments;
    RandomStream random(1);
    for (const char* test : kTests) {
      VirtualSession options = usual_session(test);
      options.nodes = {9, 9};
      options.frames = 30;
      sessions_.push_back(make_virtual_session(cloth(), options, random));
      Session seen = sessions_.back();
      observe({.position = 75e-6, .force = 3e-3}, random, seen);
      write_session(folder_.path() / test, seen);
      experiments += fmt::format("  - {{name: {0}, type: session, data: {0}}}\n", test);
    }
    experiments_ = experiments;
  }

  std::vector<ExperimentResult> fit(const char* friction) const {
    folder_.write("study.yaml", "pliant: study/1\nname: loops\nexperiments:\n" + experiments_ +
                                    "model: {mesh: measured, friction: " + friction + "}\n");
    RunContext context;
    context.threads = 2;
    return fit_study(read_study(folder_.path() / "study.yaml"), {}, context).experiments;
  }

  static constexpr const char* kTests[] = {"stretch-weft", "stretch-warp", "shear"};
  test::TemporaryFolder folder_;
  std::vector<Session> sessions_;
  std::string experiments_;
};

using SlowSheetLoops = Loops;

TEST_F(SlowSheetLoops, AreMetFourTimesAsWellAsByAnElasticFit) {
  const std::vector<ExperimentResult> elastic = fit("none"), joint = fit("auto");
  for (std::size_t i = 0; i < sessions_.size(); ++i) {
    const double ratio = force_halfway(sessions_[i], true) / force_halfway(sessions_[i], false);
    std::printf("%-13s there / back %.2f; elastic %.2f %% of the peak, with friction %.2f %%\n",
                kTests[i], ratio, elastic[i].rms_percent, joint[i].rms_percent);
    // As the thesis measured.
    EXPECT_GT(ratio, 1.4) << kTests[i];
    EXPECT_LT(ratio, 1.8) << kTests[i];
    EXPECT_LT(joint[i].rms_percent, elastic[i].rms_percent / 4) << kTests[i];
  }
}

}  // namespace
}  // namespace pliant
