// Strips of a tensile tester as sheets.

#include "pliant/experiment/session/strip_sheets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/session/sheet_path.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/measurement/session/frame_measures.h"

#include "support/study_folder.h"

namespace pliant {
namespace {

using test::StudyFolder;
using ::testing::HasSubstr;

constexpr double kLength = 0.08, kWidth = 0.04;  // m
constexpr double kOffset = 0.05;                 // N, what the tester reads of a slack strip

/// Two cycles from slack clamps to 90 and 100 mm, the force a straight line over the length from
/// 84 mm on, which is where the second cycle goes slack, too.
std::string two_cycles() {
  std::string rows = "force_N,length_mm\n";
  const auto add = [&](double length) {
    const double force = kOffset + std::max(length - 84, 0.0) / 10;
    rows += fmt::format("{},{}\n", force, length);
  };
  for (int i = 0; i <= 120; ++i) add(78 + 0.1 * i);
  for (int i = 1; i <= 120; ++i) add(90 - 0.1 * i);
  for (int i = 1; i <= 220; ++i) add(78 + 0.1 * i);
  for (int i = 1; i <= 220; ++i) add(100 - 0.1 * i);
  return rows;
}

Study study_of(const StudyFolder& folder, const std::string& direction,
               const std::string& more = "", const std::string& model = "strips: sheet") {
  folder.write("t.csv", two_cycles());
  return folder.study(
      "{name: strip, type: tensile-cycles, data: t.csv, length: 80 mm, "
      "width: 40 mm, direction: " +
          direction + more + "}",
      "model: {" + model + "}\n");
}

StripSheets sheets_of(const Study& study) {
  const ExperimentSpec& spec = study.experiments.front();
  return sheets_of_strips(spec, DataRows(spec.data), study.model, study.density);
}

SheetTest strip_of(const Study& study) {
  StripSheets strips = sheets_of(study);
  EXPECT_EQ(strips.tests.size(), 1U);
  return std::move(strips.tests.front());
}

/// Between the clips (m).
double length_in(const Session& session, int frame) {
  return (clip_middle(session, frame, 1) - clip_middle(session, frame, 0)).norm();
}

Material elastic(double weft, double warp, double shear) {
  Material material;
  material.membrane = MembraneMeasure::stvk;
  material.bending = "discrete-shells";
  material.bending_of = "hinges";
  const auto give = [&](const char* component, double stiffness) {
    material.components[component].stiffness =
        ScalarCurve::hermite({0.0}, {stiffness}, is_even(component));
  };
  give("stretch.weft", weft);
  give("stretch.warp", warp);
  give("shear", shear);
  for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) give(component, 1e-6);
  return material;
}

/// Largest difference of a test's forces from those of a strip that is strained evenly and has the
/// stiffness k (N/m) lengthways.
double farthest_from_uniform(const SheetTest& test, const Material& material, double k) {
  SheetPath path(test.session(), material);
  const auto shapes = path.predict(path.parameters(), {}, 1, {});
  if (!shapes) return INFINITY;
  double farthest = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    const double stretch = length_in(test.session(), frame) / kLength;
    const double force = kWidth * k * stretch * (stretch * stretch - 1) / 2;
    const Eigen::VectorXd found = test.predicted(frame, (*shapes)[static_cast<std::size_t>(frame)]);
    farthest = std::max(farthest, std::abs(found(0) - force));
  }
  return farthest;
}

TEST(StripSheets, KeepAllTurnsAndTheShapeOfEveryBranch) {
  const StudyFolder folder;
  const SheetTest test = strip_of(study_of(folder, "warp"));
  const Session& session = test.session();
  EXPECT_GT(test.frame_count(), 80);
  EXPECT_LT(test.frame_count(), 150);
  EXPECT_EQ(test.rows(), test.frame_count());
  // Turns at 90 and 100 mm, and at 84 mm, where the force goes.
  int reversals = 0;
  double first_peak = 0, peak = 0, farthest = 0;
  for (int f = 1; f < test.frame_count(); ++f) {
    const double length = length_in(session, f), before = length_in(session, f - 1);
    farthest = std::max(farthest, std::abs(length - before));
    peak = std::max(peak, length);
    if (f + 1 == test.frame_count()) break;
    const bool turns = (length_in(session, f + 1) - length) * (length - before) < 0;
    if (turns && reversals == 0) first_peak = length;
    reversals += turns ? 1 : 0;
  }
  EXPECT_EQ(reversals, 3);
  EXPECT_NEAR(first_peak, 0.09, 1e-9);
  EXPECT_NEAR(peak, 0.1, 1e-9);
  EXPECT_LT(farthest, 1e-3);
}

TEST(StripSheets, ForcesAreThoseWithoutTheOffsetAlongTheStrip) {
  const StudyFolder folder;
  for (const char* direction : {"warp", "weft", "bias"}) {
    const SheetTest test = strip_of(study_of(folder, direction));
    for (int f = 0; f < test.frame_count(); ++f) {
      const double length = length_in(test.session(), f);
      EXPECT_NEAR(test.measured(f)(0), std::max(1e3 * length - 84, 0.0) / 10, 1e-6) << direction;
    }
  }
}

TEST(StripSheets, ASlackStripKeepsTheLengthThatUnloadingLeft) {
  const StudyFolder folder;
  const SheetTest test = strip_of(study_of(folder, "weft"));
  EXPECT_NEAR(length_in(test.session(), 0), kLength, 1e-9);
  // Half a per cent of the peak of 1.6 N is gone 0.08 mm before 84 mm; rows are 0.1 mm apart.
  EXPECT_NEAR(length_in(test.session(), test.frame_count() - 1), 0.084, 1.1e-4);
}

TEST(StripSheets, TellWhatTheTesterShows) {
  const StudyFolder folder;
  const Session session = strip_of(study_of(folder, "weft")).session();
  EXPECT_EQ(session.kind, SessionKind::strip);
  int slack = 0;
  for (int f = 0; f < session.frame_count(); ++f) {
    const double extension = *clip_extension(session, f), strip = length_in(session, f) - kLength;
    EXPECT_NEAR(*clip_pull(session, f), std::max(1e3 * extension - 4, 0.0) / 10, 1e-6) << f;
    EXPECT_LT(extension, strip + 1e-9) << f;
    slack += extension < strip - 1e-9 ? 1 : 0;
  }
  EXPECT_GT(slack, 0);
}

TEST(StripSheets, ConditioningIsFollowedAndNotCompared) {
  const StudyFolder folder;
  const SheetTest all = strip_of(study_of(folder, "warp"));
  const SheetTest test = strip_of(study_of(folder, "warp", ", precondition_cycles: 1"));
  EXPECT_EQ(test.frame_count(), all.frame_count());
  EXPECT_EQ(test.rows(0), 0);
  EXPECT_EQ(test.rows(test.frame_count() - 1), 1);
}

TEST(StripSheets, AlongAThreadTheyAreStripsOfOneDimension) {
  const StudyFolder folder;
  const Material material = elastic(60, 100, 20);
  // Of 2 N; equilibria leave 10 uN a node.
  EXPECT_LT(farthest_from_uniform(strip_of(study_of(folder, "warp")), material, 100), 2e-4);
  EXPECT_LT(farthest_from_uniform(strip_of(study_of(folder, "weft")), material, 60), 2e-4);
}

// At 45 degrees half of the strain along the strip stretches each thread and all of it shears:
// where shear is half as stiff as stretch both pull across with the same force, the strip does not
// narrow, and its clamps do not show.
TEST(StripSheets, OnTheBiasThreadsAndShearAreInBalance) {
  const StudyFolder folder;
  const SheetTest test = strip_of(study_of(folder, "bias"));
  EXPECT_LT(farthest_from_uniform(test, elastic(80, 80, 40), 80), 2e-4);
  EXPECT_GT(farthest_from_uniform(test, elastic(80, 80, 20), 80), 0.1);
}

// A sheet of equal threads, half as stiff in shear, is as stiff in all directions and does not
// narrow.
TEST(StripSheets, AtAnyAngleAnIsotropicSheetIsAStripOfOneDimension) {
  const StudyFolder folder;
  for (const char* direction : {"30 deg", "1.2 rad", "150 deg"}) {
    const SheetTest test = strip_of(study_of(folder, direction));
    EXPECT_EQ(test.session().test, "bias-extension");
    EXPECT_LT(farthest_from_uniform(test, elastic(80, 80, 40), 80), 2e-4) << direction;
  }
}

/// Largest force of a strip that is cut in a direction (N).
double peak_force(const std::string& direction, const Material& material) {
  const StudyFolder folder;
  const SheetTest test = strip_of(study_of(folder, direction));
  SheetPath path(test.session(), material);
  const auto shapes = path.predict(path.parameters(), {}, 1, {});
  if (!shapes) return NAN;
  double peak = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    const SheetShape& shape = (*shapes)[static_cast<std::size_t>(frame)];
    peak = std::max(peak, test.predicted(frame, shape)(0));
  }
  return peak;
}

TEST(StripSheets, AnglesCountFromWeftTowardsWarp) {
  const double near_weft = peak_force("15 deg", elastic(160, 20, 20));
  EXPECT_GT(near_weft, 1.5 * peak_force("75 deg", elastic(160, 20, 20)));
  // Mirrored sheets; the diagonals of their grids are not.
  EXPECT_NEAR(near_weft, peak_force("75 deg", elastic(20, 160, 20)), 0.01 * near_weft);
  EXPECT_NEAR(near_weft, peak_force("165 deg", elastic(160, 20, 20)), 0.01 * near_weft);
}

TEST(StripSheets, AnglesOfWeftBiasAndWarpAreTheseDirections) {
  const StudyFolder folder;
  for (const auto& [angle, direction] :
       {std::pair{"0 deg", "weft"}, {"45 deg", "bias"}, {"90 deg", "warp"}}) {
    const Study study = study_of(folder, angle, "", "strips: one-dimensional");
    EXPECT_EQ(study.experiments.front().direction, direction);
  }
}

TEST(StripSheets, NeedNoDensity) {
  const StudyFolder folder;
  const Study study = study_of(folder, "warp");
  const ExperimentSpec& spec = study.experiments.front();
  const StripSheets strips = sheets_of_strips(spec, DataRows(spec.data), study.model, 0);
  const Session& session = strips.tests.front().session();
  EXPECT_FALSE(states_density(session));
  write_session(folder.path() / "session", session);
  EXPECT_EQ(read_session(folder.path() / "session").frame_count(), session.frame_count());
}

TEST(StripSheets, LoseWhatTheirClampsAddToThePull) {
  const StudyFolder folder;
  const auto longest = [&](const std::string& clamps) {
    const SheetTest strip = strip_of(study_of(folder, "warp", clamps));
    double length = 0;
    for (int frame = 0; frame < strip.frame_count(); ++frame) {
      length = std::max(length, length_in(strip.session(), frame));
    }
    return length;
  };
  // Its largest force is 1.6 N, at 100 mm.
  EXPECT_NEAR(longest(""), 0.1, 1e-9);
  EXPECT_NEAR(longest(", compliance: 0.5 mm/N"), 0.1 - 0.8e-3, 1e-5);
  EXPECT_NEAR(longest(", slip: 0.25 mm/N"), 0.1 - 0.4e-3, 1e-5);
  try {
    longest(", slip: unknown");
    FAIL() << "sheets do not look for it";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("fits of sheets do not look for"));
  }
}

TEST(StripSheets, OfSpringsAreRefused) {
  const StudyFolder folder;
  const Study study = study_of(folder, "bias", "", "strips: sheet, membrane: spring");
  try {
    sheets_of(study);
    FAIL() << "springs lie along weft and warp";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("springs"));
  }
}

}  // namespace
}  // namespace pliant
