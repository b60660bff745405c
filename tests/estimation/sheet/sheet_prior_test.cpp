// Priors beside sheets whose residuals go together.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/estimation/sheet/first_laws.h"
#include "pliant/experiment/session/virtual_session.h"
#include "pliant/study/study_fit.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

/// Adds noise that remembers the frame before it (AR(1)) to what each clip is pulled with.
void add_slow_noise(double sd, double memory, Session& session) {
  RandomStream random(1);
  for (std::size_t clip = 0; clip < session.clips.size(); ++clip) {
    for (int axis = 0; axis < 3; ++axis) {
      double noise = sd * random.normal();
      for (SessionFrame& frame : session.frames) {
        frame.cords[clip].front().force(axis) += noise;
        noise = memory * noise + sd * std::sqrt(1 - memory * memory) * random.normal();
      }
    }
  }
}

/// A stretch along weft; what it does not tell is as a fit guesses it.
class SlowlyNoisyStretch {
 public:
  SlowlyNoisyStretch() {
    Material cloth = first_sheet_material({});
    cloth.density = 0.2;
    cloth.components.at("stretch.weft").stiffness = ScalarCurve::hermite({0.0}, {300.0});
    cloth.components.at("shear").stiffness = ScalarCurve::hermite({0.0}, {60.0}, true);
    VirtualSession options = usual_session("stretch-weft");
    options.nodes = {6, 6};
    options.frames = 60;
    RandomStream random(1);
    Session session = make_virtual_session(cloth, options, random);
    add_slow_noise(0.02, 0.8, session);
    write_session(folder_.path() / "weft", session);
  }

  StudyResult fit(const std::string& priors) const {
    folder_.write("study.yaml",
                  "pliant: study/1\nname: slow\nexperiments:\n"
                  "  - {name: weft, type: session, data: weft}\n"
                  "model: {mesh: measured}\nfit: {control_points: 1" +
                      priors + "}\n");
    return fit_study(read_study(folder_.path() / "study.yaml"), {}, {});
  }

 private:
  test::TemporaryFolder folder_;
};

TEST(SlowSheetPriors, CountAsOneMoreMeasurementWhereResidualsGoTogether) {
  const SlowlyNoisyStretch stretch;
  const StudyResult alone = stretch.fit("");
  const ParameterEstimate& data = alone.parameters.front();
  ASSERT_EQ(data.owner, "stretch.weft");
  // (1 + 0.8) / (1 - 0.8) = 9 of the 60 x 6 rows count as one, which 60 frames tell roughly.
  EXPECT_LT(alone.experiments.front().effective_rows, 360.0 / 4);
  EXPECT_THAT(alone.assumptions, Contains(HasSubstr("weft: neighbouring residuals go together")));

  // A prior as sharp as the data, two standard errors off: the answer lies half way. Were each row
  // a measurement of its own, it would lie a fifth of a standard error off.
  const StudyResult result =
      stretch.fit(fmt::format(", priors: {{stretch.weft.k: {{mean: {}, sd: {}}}}}",
                              data.value + 2 * *data.std_error, *data.std_error));
  const ParameterEstimate& both = result.parameters.front();
  EXPECT_NEAR((both.value - data.value) / *data.std_error, 1, 0.25);
  EXPECT_NEAR(*both.std_error / *data.std_error, std::sqrt(0.5), 0.1);
}

}  // namespace
}  // namespace pliant
