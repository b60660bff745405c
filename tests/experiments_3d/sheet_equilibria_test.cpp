// The equilibria of sheets in full-field sessions.

#include "pliant/experiment/session/sheet_equilibria.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/experiment/session/sheet_bending.h"
#include "pliant/experiment/session/sheet_states.h"
#include "pliant/experiment/session/sheet_test.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/measurement/session/balance.h"

#include "support/cloth_sheet.h"
#include "support/session_sheets.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

using test::linear_cloth;

// A sheet that a table lets hang over its edge, from frame to frame further.
Session overhanging(const TriangleMesh& mesh, const std::vector<double>& edges) {
  Session session;
  session.test = "bend-warp";
  session.sample = {"", 0.1, 0.1, {}, 0.2};
  session.rest = mesh;
  session.table = RestAxis::v;
  for (const double edge : edges) {
    SessionFrame frame;
    frame.table_edge = edge;
    frame.positions = mesh.positions;
    session.frames.push_back(frame);
  }
  return session;
}

TEST(SheetEquilibria, StretchAFlatSheetWithTheClosedFormForce) {
  Session session = test::stretch_session(9, 2);
  session.gravity.setZero();
  for (SessionClip& clip : session.clips) clip.mass = 0;
  SessionFrame& frame = session.frames[1];
  for (Pose& pose : frame.poses) pose.rotation.setIdentity();
  frame.poses[0].translation = {-0.005, 0, 0};
  frame.poses[1].translation = {0.005, 0, 0};
  frame.positions = session.rest.positions;
  SheetEquilibria equilibria(session, linear_cloth(100, 30, 1e-5));
  const auto shapes = equilibria.predict(equilibria.parameters(), {}, 1, {});
  ASSERT_TRUE(shapes.has_value());
  // Without Poisson's effect the sheet stretches evenly: l = 1.1, strain (l^2 - 1) / 2.
  const double force = 0.1 * 1.1 * 100 * (1.1 * 1.1 - 1) / 2;
  EXPECT_NEAR((*shapes)[1].clip_forces(0, 1), force, 1e-4 * force);
  EXPECT_NEAR((*shapes)[1].clip_forces(0, 0), -force, 1e-4 * force);
  EXPECT_NEAR((*shapes)[0].clip_forces.cwiseAbs().maxCoeff(), 0, 1e-6);
}

TEST(SheetEquilibria, CordsCarryTheWeights) {
  const Session session = test::stretch_session(9, 2);
  SheetEquilibria equilibria(session, linear_cloth(100, 30, 1e-5));
  const auto shapes = equilibria.predict(equilibria.parameters(), {}, 2, {});
  ASSERT_TRUE(shapes.has_value());
  const double weight = (0.0031 + 2 * 0.0101) * kStandardGravity;
  const Eigen::Vector3d sum = (*shapes)[1].clip_forces.rowwise().sum();
  EXPECT_NEAR(sum.z(), weight, 1e-3);
  EXPECT_LT(sum.head<2>().norm(), 1e-3);
}

TEST(SheetEquilibria, HaveForcesAndMomentsOfClipsInBalance) {
  Session session = test::stretch_session(9, 2);
  // One clip shifted along itself and turned, so that there are moments.
  Pose& pose = session.frames[1].poses[1];
  pose.translation += Eigen::Vector3d(0, 0.01, 0.002);
  pose.rotation = Eigen::AngleAxisd(0.1, Eigen::Vector3d(1, 1, 1).normalized()) * pose.rotation;
  SheetEquilibria equilibria(session, linear_cloth(100, 30, 1e-5));
  const auto shapes = equilibria.predict(equilibria.parameters(), {}, 2, {});
  ASSERT_TRUE(shapes.has_value());
  const SheetShape& shape = (*shapes)[1];
  session.frames[1].positions = shape.positions;
  const Eigen::VectorXd masses = vertex_masses(session);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (int node = 0; node < masses.size(); ++node) {
    moment += shape.positions.col(node).cross(masses(node) * session.gravity);
  }
  for (int c = 0; c < 2; ++c) {
    const Eigen::Vector3d pull =
        shape.clip_forces.col(c) + session.clips[static_cast<size_t>(c)].mass * session.gravity;
    moment += clip_middle(session, 1, c).cross(pull) + shape.clip_moments.col(c);
  }
  EXPECT_GT(shape.clip_moments.col(1).norm(), 0.005);
  // 10 uN are left on each of 81 nodes at most, 0.2 m from the origin.
  EXPECT_LT(moment.norm(), 81 * 1e-5 * 0.2);
}

TEST(SheetEquilibria, KnowTheirDerivatives) {
  const Session session = test::stretch_session(7, 2);
  const Material material = linear_cloth(100, 30, 1e-5);
  SheetEquilibria equilibria(session, material);
  const std::vector<int> by{2, 0};  // shear, then stretch along weft
  const Eigen::VectorXd at = equilibria.parameters();
  const auto shapes = equilibria.predict(at, by, 1, {});
  ASSERT_TRUE(shapes.has_value());
  for (int k = 0; k < 2; ++k) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(at.size());
    step(by[static_cast<size_t>(k)]) = 1e-2 * at(by[static_cast<size_t>(k)]);
    const auto up = equilibria.predict(at + step, {}, 1, {});
    const auto down = equilibria.predict(at - step, {}, 1, {});
    ASSERT_TRUE(up && down);
    const Eigen::VectorXd difference =
        ((*up)[1].clip_forces - (*down)[1].clip_forces).reshaped() / (2 * step.sum());
    const Eigen::VectorXd derivative = (*shapes)[1].clip_forces_by_parameter.col(k);
    EXPECT_LT((difference - derivative).norm(), 1e-3 * difference.norm() + 1e-5) << k;
  }
}

TEST(SheetBending, KnowsHowHingesFollowTheSheet) {
  Material sheet = test::sheet_cloth(false);
  sheet.components.at("bend.warp").stiffness = ScalarCurve::affine(9e-6, -1e-8);
  sheet.components.at("bend.warp").friction = ComponentFriction{{2e-6, 1e-8, 20}, std::nullopt};
  std::vector<std::string> names{"shear.k[0]"};
  std::vector<double> values{8};
  for (const char* component : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    const ComponentLaw law = *law_of(sheet, component);
    const std::vector<std::string> own = parameter_names(law, component);
    names.insert(names.end(), own.begin(), own.end());
    const Eigen::VectorXd parameters = law.parameters();
    values.insert(values.end(), parameters.begin(), parameters.end());
  }
  const Eigen::VectorXd at = Eigen::VectorXd::Map(values.data(), std::ssize(values));
  const SheetBending bending(regular_grid(0.1, 0.1, 9, 9), sheet, names);
  const Eigen::VectorXd hinges = bending.hinges(at);
  const Eigen::MatrixXd by_values = bending.hinges_by_values(at);
  EXPECT_EQ(hinges(0), 8);      // no bending
  EXPECT_NE(hinges(2), at(2));  // k1 along warp
  const auto tau = std::ranges::find(names, "bend.warp.friction.tau") - names.begin();
  EXPECT_NE(hinges(tau), 20);
  for (Eigen::Index i = 0; i < at.size(); ++i) {
    const Eigen::VectorXd step = 1e-3 * std::abs(at(i)) * Eigen::VectorXd::Unit(at.size(), i);
    const Eigen::VectorXd difference =
        (bending.hinges(at + step) - bending.hinges(at - step)) / (2 * step(i));
    EXPECT_LT((by_values.col(i) - difference).norm(), 1e-3 * difference.norm())
        << names[static_cast<std::size_t>(i)];
  }
}

/// Keeps the rows of the last frame.
class LastFrame : public FrameSink {
 public:
  void take(int, const PredictedFrame& rows) override { last = rows; }
  PredictedFrame last;
};

// How far a sheet hangs follows from its own stiffness through the hinges of its mesh.
TEST(SessionPredictor, KnowsTheDerivativesByTheBendingOfASheet) {
  Material hinges = test::sheet_cloth(false);
  const SheetTest test("bend", test::virtual_bend(hinges, 0, 9, 2), SheetObjective::positions);
  Material sheet = hinges;
  sheet.bending_of = "sheet";
  const auto predictor = test.predictor(sheet);
  const std::vector<std::string>& names = predictor->parameters();
  std::vector<int> by;
  for (const char* name : {"bend.weft.k[0]", "bend.warp.k[0]", "bend.diagonal.k[0]"}) {
    by.push_back(static_cast<int>(std::ranges::find(names, name) - names.begin()));
  }
  const Eigen::VectorXd at = predictor->values();
  LastFrame rows;
  ASSERT_TRUE(predictor->predict(at, by, {}, rows));
  for (std::size_t k = 0; k < by.size(); ++k) {
    Eigen::VectorXd step = Eigen::VectorXd::Zero(at.size());
    step(by[k]) = 0.03 * at(by[k]);
    LastFrame up, down;
    ASSERT_TRUE(predictor->predict(at + step, {}, {}, up));
    ASSERT_TRUE(predictor->predict(at - step, {}, {}, down));
    const Eigen::VectorXd difference = (up.last.value - down.last.value) / (2 * step(by[k]));
    const Eigen::VectorXd own = rows.last.by.col(static_cast<Eigen::Index>(k));
    // Forces of 10 uN are left on each node, which moves what hangs.
    EXPECT_LT((difference - own).norm(), 0.05 * rows.last.by.norm()) << names[by[k]];
  }
}

TEST(SheetEquilibria, BeginAtANeighbourWhereTheMeasuredShapeLeadsNowhere) {
  Session session = test::stretch_session(7, 3);
  const Material material = linear_cloth(100, 30, 1e-5);
  SheetEquilibria measured(session, material);
  const auto shapes = measured.predict(measured.parameters(), {}, 1, {});
  ASSERT_TRUE(shapes.has_value());
  session.frames[1].positions.setConstant(std::numeric_limits<double>::quiet_NaN());
  SheetEquilibria blind(session, material);
  const auto found = blind.predict(blind.parameters(), {}, 2, {});
  ASSERT_TRUE(found.has_value());
  // 10 uN left on a node, over the stiffness with which its weight tightens the sheet.
  EXPECT_LT(((*found)[1].positions - (*shapes)[1].positions).cwiseAbs().maxCoeff(), 1e-4);
}

// The mean height of the row that hangs out furthest.
double tip_height(const SheetShape& shape) {
  const auto n = static_cast<Eigen::Index>(std::lround(std::sqrt(shape.positions.cols())));
  return shape.positions.row(2).tail(n).mean();
}

TEST(SlowSheetEquilibria, HangOverATableAsFarAsItsEdgeSaysWhateverTheMesh) {
  const std::vector<double> edges{0.062, 0.0605, 0.059, 0.0575, 0.056, 0.0545};
  const Material material = [] {
    Material sheet = linear_cloth(200, 60, 3e-6);
    sheet.bending_of = "sheet";
    return sheet;
  }();
  const Session coarse = overhanging(regular_grid(0.1, 0.1, 25, 25), edges);
  const Session fine = overhanging(regular_grid(0.1, 0.1, 37, 37), edges);
  SheetEquilibria few(coarse, material), many(fine, material);
  const auto of_few = few.predict(few.parameters(), {}, 2, {});
  const auto of_many = many.predict(many.parameters(), {}, 2, {});
  ASSERT_TRUE(of_few && of_many);
  EXPECT_LT(few.equilibria_each(), 5);
  for (size_t f = 0; f < edges.size(); ++f) {
    const double depth = -tip_height((*of_many)[f]);
    EXPECT_NEAR(-tip_height((*of_few)[f]), depth, 0.025 * depth) << f;
  }
  // A quarter of a cell further each time, not nothing and then a cell.
  for (size_t f = 1; f < edges.size(); ++f) {
    const double more = tip_height((*of_few)[f - 1]) - tip_height((*of_few)[f]);
    EXPECT_NEAR(more, 0.002, 0.0003) << f;
  }
}

}  // namespace
}  // namespace pliant
