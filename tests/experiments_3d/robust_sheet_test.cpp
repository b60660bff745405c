// Frames far off count less in fits of sheets, too, where a study asks for it (`fit.loss`).

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "pliant/experiment/session/virtual_session.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

constexpr double kTruth = 80;  // N/m

/// A stretch along weft of 40 frames; in every eighth the load cell shows a half more.
class RobustSheet : public ::testing::TestWithParam<const char*> {
 protected:
  RobustSheet() {
    VirtualSession options = usual_session("stretch-weft");
    options.nodes = {7, 7};
    options.frames = 40;
    options.noise = {.position = 20e-6, .force = 3e-3};
    RandomStream random(3);
    Session session = make_virtual_session(test::sheet_cloth(/*stiffens=*/false), options, random);
    for (int f = 4; f < session.frame_count(); f += 8) {
      for (auto& cords : session.frames[static_cast<std::size_t>(f)].cords) {
        for (CordForce& cord : cords) cord.force *= 1.5;
      }
    }
    write_session(folder_.path() / "stretch", session);
  }

  double off(const std::string& loss) const {
    folder_.write("study.yaml",
                  "pliant: study/1\nname: stretch\n"
                  "experiments:\n  - {name: stretch, type: session, data: stretch}\n"
                  "model: {mesh: measured, stiffness: constant, friction: none}\n"
                  "fit: {loss: " +
                      loss + "}\n");
    RunContext context;
    context.threads = 2;
    const StudyResult fit = fit_study(read_study(folder_.path() / "study.yaml"), {}, context);
    const auto stiffness =
        std::ranges::find(fit.parameters, "stretch.weft.k[0]", &ParameterEstimate::name);
    return std::abs(stiffness->value / kTruth - 1);
  }

  test::TemporaryFolder folder_;
};

TEST_P(RobustSheet, MeetsTheTruthThatSquaresMiss) {
  const double squares = off("none"), robust = off(GetParam());
  EXPECT_GT(squares, 0.04);
  EXPECT_LT(robust, 0.2 * squares);
}

INSTANTIATE_TEST_SUITE_P(Losses, RobustSheet, ::testing::Values("huber", "cauchy"));

}  // namespace
}  // namespace pliant
