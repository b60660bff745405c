#include "pliant/experiment/session/virtual_session.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/session/sheet_equilibria.h"
#include "pliant/experiment/session/sheet_test.h"
#include "pliant/material/law_path.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/measurement/session/frame_measures.h"
#include "pliant/solver/elastica/strip_release.h"

#include "support/cloth_sheet.h"
#include "support/session_sheets.h"

namespace pliant::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A few frames on a grid whose rows end where clips do.
VirtualSession small_session(std::string_view test, int frames = 5) {
  VirtualSession session = usual_session(test);
  session.frames = frames;
  session.nodes = test == "bias-extension" ? std::pair(11, 31) : std::pair(21, 21);
  return session;
}

Session made(const Material& material, const VirtualSession& options) {
  RandomStream random(1);
  return make_virtual_session(material, options, random);
}

Material elastic() { return linear_cloth(1000, 30, 1e-5); }

/// Force per width of a sheet between bars: k(E) E and friction, E = (s^2 - 1) / 2, times s.
double tension(double stress, double strain) { return stress * (1 + strain); }
double green(double strain) { return strain + strain * strain / 2; }

TEST(VirtualStretch, PullsWithTheForceOfTheLaw) {
  for (const int axis : {0, 1}) {
    VirtualSession options = small_session(axis == 0 ? "stretch-weft" : "stretch-warp");
    options.amplitude = 0.1;
    const Session session = made(elastic(), options);
    const Eigen::Vector3d pull = cord_pull(session, 2, 1);
    // The sheet sags by 18 um between the bars, which makes it longer by a ten millionth.
    EXPECT_NEAR(pull(axis), 0.1 * tension(1000 * green(0.1), 0.1), 2e-5);
    EXPECT_NEAR(pull(1 - axis), 0, 1e-6);
    EXPECT_NEAR(pull.z(), (0.0101 + 0.5 * 0.2 * 0.01) * kStandardGravity, 1e-6)
        << "a clip and half of the sheet";
    EXPECT_NEAR(cord_pull(session, 2, 0)(axis), -pull(axis), 1e-6);
  }
}

TEST(VirtualStretch, RemembersAsTheLawDoes) {
  VirtualSession options = small_session("stretch-warp", 21);
  const Session session = made(cotton(), options);
  LawPath path(*law_of(cotton(), "stretch.warp"), {});
  for (int f = 0; f < 21; ++f) {
    const double strain = 0.002 + 0.048 * (1 - std::abs(f - 10) / 10.0);
    const double stress = path.at(green(strain)).stress;
    if (f == 10) path.turn_at(green(strain), {});
    // Where it is slack, its weight stretches the sheet, too.
    if (f < 3 || stress < 1) continue;
    EXPECT_NEAR(cord_pull(session, f, 1).y(), 0.1 * tension(stress, strain), 2e-3) << f;
  }
}

/// Work of the clips over a session by trapezoids (J).
double work(const Session& session) {
  double sum = 0;
  for (int f = 1; f < session.frame_count(); ++f) {
    for (int c = 0; c < static_cast<int>(session.clips.size()); ++c) {
      sum += (cord_pull(session, f, c) + cord_pull(session, f - 1, c))
                 .dot(clip_middle(session, f, c) - clip_middle(session, f - 1, c)) /
             2;
    }
  }
  return sum;
}

TEST(VirtualStretch, TakesWorkWithFrictionAndGivesItBackWithout) {
  const VirtualSession options = small_session("stretch-weft", 21);
  EXPECT_GT(work(made(cotton(), options)), 1e-4) << "2 mN m of 5 mm at 0.5 N";
  EXPECT_NEAR(work(made(elastic(), options)), 0, 1e-7);
}

TEST(VirtualShear, ShearsByItsAngle) {
  VirtualSession options = small_session("shear");
  // Bars are rigid across, too: of deep ones the affine map of all clamped vertices knows less.
  options.grip = 1e-6;
  const Session session = made(elastic(), options);
  EXPECT_NEAR(*effective_shear(session, 2), options.amplitude, 1e-4 * options.amplitude);
  EXPECT_NEAR(*effective_shear(session, 4), 0, 1e-12);
}

TEST(VirtualCornerPull, PullsOnePairAfterTheOther) {
  const Session session = made(elastic(), small_session("corner-pull"));
  EXPECT_GT(*stretching_force_difference(session, 1), 0.1);
  EXPECT_LT(*stretching_force_difference(session, 3), -0.1);
}

TEST(VirtualComplexShear, BucklesTheSheet) {
  const Session session = made(elastic(), small_session("complex-shear"));
  const auto height = [&](int frame) {
    const auto z = session.frames[static_cast<std::size_t>(frame)].positions.row(2);
    return z.maxCoeff() - z.minCoeff();
  };
  EXPECT_GT(height(2), 1e-3);
}

TEST(VirtualBending, HangsAsAHeavyElastica) {
  Material material = linear_cloth(1000, 300, 1e-5);
  material.bending_of = "sheet";
  for (const char* component : {"bend.weft", "bend.warp"}) {
    const bool weft = component == std::string("bend.weft");
    const Session session = made(material, small_session(weft ? "bend-weft" : "bend-warp", 6));
    const Elastica strip(0.06);
    const ComponentLaw law = *law_of(material, component);
    StripHistory history = strip.rested(law);
    const auto shape =
        released(strip, law, material.density * kStandardGravity, {}, false, history);
    ASSERT_TRUE(shape.has_value());
    const Eigen::Vector2d tip = strip.profile({}, *shape).at(0.06).position;
    const Eigen::Matrix3Xd& last = session.frames.back().positions;
    EXPECT_NEAR(last.row(2).minCoeff(), tip.y(), 0.04 * std::abs(tip.y()));
    EXPECT_DOUBLE_EQ(*session.frames.back().table_edge, 0.04);
  }
}

Material without_friction(Material material) {
  for (auto& [name, component] : material.components) component.friction.reset();
  return material;
}

/// Stiffer by friction that never slips: where it begins, Dahl's friction with a > b tau
/// is a stiffness a / tau, and less than that from there on ([T] Eq. 5.2).
Material cotton_whose_friction_sticks() {
  Material material = cotton();
  for (auto& [name, component] : material.components) {
    const DahlParameters& dahl = component.friction->positive;
    const std::vector<double>& k = component.stiffness->values();
    component.stiffness = ScalarCurve::affine(k[0] + dahl.a / dahl.tau, k[1]);
  }
  return without_friction(std::move(material));
}

/// How far the lowest point is below the table (m).
double sag(const Session& session, std::size_t frame) {
  return -session.frames[frame].positions.row(2).minCoeff();
}

TEST(VirtualBending, IsHeldUpByItsFrictionButLessThanIfThatStuck) {
  const VirtualSession options = small_session("bend-weft", 4);
  const Session found = made(cotton(), options);
  const Session without = made(without_friction(cotton()), options);
  const Session sticking = made(cotton_whose_friction_sticks(), options);
  EXPECT_THAT(found.warnings, IsEmpty());
  for (std::size_t f = 0; f < found.frames.size(); ++f) {
    // Shapes are found to a thousandth of the weight: bounds are apart by more.
    EXPECT_LT(sag(found, f), 0.95 * sag(without, f)) << f;
    EXPECT_GT(sag(found, f), 1.02 * sag(sticking, f)) << f;
  }
}

TEST(VirtualBias, StretchesAStripThatIsCutAtFortyFiveDegrees) {
  const Session session = made(elastic(), small_session("bias-extension"));
  EXPECT_NEAR(rest_area(session.rest), 0.05 * 0.15, 1e-15);
  EXPECT_NEAR(session.sample.width, 0.2 / std::numbers::sqrt2, 1e-15);
  const Eigen::Vector3d pull = cord_pull(session, 2, 1);
  EXPECT_GT(pull.x(), 0.1);
  EXPECT_NEAR(pull.x(), pull.y(), 0.01 * pull.x()) << "weft and warp are alike";
}

TEST(VirtualSheet, IsIrregularUnlessAGridIsAskedFor) {
  VirtualSession options = small_session("stretch-weft", 3);
  EXPECT_EQ(made(elastic(), options).rest.vertex_count(), 21 * 21);
  options.nodes.reset();
  options.edge = 0.01;
  const Session session = made(elastic(), options);
  EXPECT_NEAR(rest_area(session.rest), 0.01, 1e-15);
  EXPECT_NEAR(session.rest.vertex_count(), 145, 40);  // more of them along clips
}

class VirtualSessions : public testing::TestWithParam<const char*> {};

TEST_P(VirtualSessions, AreReadWithoutComplaint) {
  const Session session = made(elastic(), small_session(GetParam()));
  const SessionFolder folder(session);
  const Session read = read_session(folder.path());
  EXPECT_THAT(read.warnings, IsEmpty());
  EXPECT_EQ(read.test, GetParam());
  EXPECT_EQ(read.frame_count(), 5);
  for (int f = 0; f < 5 && !read.table; ++f) {
    // The moment that a clip's cords cannot give: some 10 mN at 5 mm.
    EXPECT_LT(imbalance(read, f).moment.norm(), 2e-4);
    EXPECT_LT(imbalance(read, f).force.norm(), 1e-4);
  }
}

TEST_P(VirtualSessions, AreTheEquilibriaOfTheirMaterial) {
  const Session session = made(elastic(), small_session(GetParam()));
  SheetEquilibria equilibria(session, elastic());
  const auto shapes = equilibria.predict(equilibria.parameters(), {}, 1, {});
  ASSERT_TRUE(shapes.has_value());
  for (int f = 0; f < session.frame_count(); ++f) {
    const SheetShape& shape = (*shapes)[static_cast<std::size_t>(f)];
    const Eigen::Matrix3Xd& positions = session.frames[static_cast<std::size_t>(f)].positions;
    // On a table a frame lies between two equilibria, which are searched for again; what they may
    // leave of forces is a thousandth of the weight.
    EXPECT_LT((shape.positions - positions).cwiseAbs().maxCoeff(), session.table ? 1e-7 : 1e-8);
    for (int c = 0; c < static_cast<int>(session.clips.size()); ++c) {
      EXPECT_LT((shape.clip_forces.col(c) - cord_pull(session, f, c)).norm(), 1e-9);
    }
  }
}

std::string name_of_test(const testing::TestParamInfo<const char*>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Tests, VirtualSessions,
                         testing::Values("stretch-weft", "stretch-warp", "shear", "bend-weft",
                                         "bend-warp", "corner-pull", "complex-shear",
                                         "bias-extension"),
                         name_of_test);

TEST(VirtualSessionWork, TellsOfItsFramesAndStops) {
  int frames = 0;
  RandomStream random(1);
  make_virtual_session(elastic(), small_session("stretch-weft", 4), random,
                       {.done = [&](int more) { frames += more; }});
  EXPECT_EQ(frames, 4);
  StopFlag flag;
  flag.request();
  EXPECT_THROW(make_virtual_session(elastic(), small_session("stretch-weft", 4), random,
                                    {.stop = flag.token()}),
               Interrupted);
}

}  // namespace
}  // namespace pliant::test
