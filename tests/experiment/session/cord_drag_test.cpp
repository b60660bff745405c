#include "pliant/experiment/session/cord_drag.h"

#include <cstdint>

#include <gtest/gtest.h>

#include "pliant/experiment/session/virtual_session.h"

#include "support/session_sheets.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

Session session_of(const char* test, const SessionNoise& noise, std::uint64_t seed = 1) {
  VirtualSession options = usual_session(test);
  options.nodes = {13, 13};
  options.frames = 25;
  options.noise = noise;
  RandomStream random(seed);
  return make_virtual_session(test::sheet_cloth(false), options, random);
}

Eigen::Matrix3Xd pulls_at(const Session& session, int clip) {
  Eigen::Matrix3Xd pulls = Eigen::Matrix3Xd::Zero(3, session.frame_count());
  for (int f = 0; f < session.frame_count(); ++f) pulls.col(f) = cord_pull(session, f, clip);
  return pulls;
}

Eigen::Matrix3Xd drags_at(const Session& session, int clip) {
  Eigen::Matrix3Xd drags = Eigen::Matrix3Xd::Zero(3, session.frame_count());
  for (const CordDrag& cord : cord_drags(session)) {
    if (cord.clip == clip) drags += cord.forces;
  }
  return drags;
}

TEST(CordDrag, IsWhatALabAddsToForces) {
  for (const char* test : {"stretch-weft", "complex-shear", "corner-pull"}) {
    const Session ideal = session_of(test, {}), seen = session_of(test, {.cord_friction = 0.1});
    for (int clip = 0; clip < static_cast<int>(ideal.clips.size()); ++clip) {
      const Eigen::Matrix3Xd added = pulls_at(seen, clip) - pulls_at(ideal, clip);
      EXPECT_LT((added - 0.1 * drags_at(seen, clip)).cwiseAbs().maxCoeff(), 1e-9)
          << test << ", clip " << clip;
      EXPECT_GT(added.cwiseAbs().maxCoeff(), 0.05);
    }
  }
}

// The clips of the corner-pull hold few vertices, and two of them are still half of the time. A
// cord that moves across its pull tells its direction to nobody.
TEST(CordDrag, KeepsItsDirectionInTheNoiseOfCameras) {
  int frames = 0, others = 0;
  for (const char* test : {"stretch-weft", "complex-shear", "corner-pull"}) {
    const Session ideal = session_of(test, {});
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
      const Session seen = session_of(test, {.position = 75e-6}, seed);
      for (int clip = 0; clip < static_cast<int>(ideal.clips.size()); ++clip) {
        const Eigen::Matrix3Xd change = drags_at(seen, clip) - drags_at(ideal, clip);
        frames += static_cast<int>(change.cols());
        others += static_cast<int>((change.colwise().norm().array() > 0.05).count());
      }
    }
  }
  EXPECT_LT(others, 0.02 * frames);
}

TEST(CordDrag, AddsToForcesMomentsAndDerivatives) {
  const Session session = test::stretch_session();
  const std::vector<CordDrag> cords = cord_drags(session);
  ASSERT_EQ(cords.size(), 4U);
  EXPECT_EQ(cords[2].clip, 1);
  EXPECT_EQ(cords[2].cord, "front");
  SheetShape empty;
  empty.clip_forces = empty.clip_moments = Eigen::Matrix3Xd::Zero(3, 2);
  empty.clip_forces_by_parameter = Eigen::MatrixXd::Ones(6, 1);
  empty.positions_by_parameter = Eigen::MatrixXd::Ones(9, 1);
  SheetShape last = empty;
  const Eigen::Vector4d widths(0.1, 0.2, 0, 0.4);
  add_cord_drags(cords, widths, true, 2, last);
  const Eigen::MatrixXd& by_width = last.clip_forces_by_parameter;
  ASSERT_EQ(by_width.cols(), 5);
  EXPECT_LT((by_width.rightCols(4) * widths - last.clip_forces.reshaped()).norm(), 1e-15);
  EXPECT_TRUE((by_width.col(0).array() == 1).all());
  EXPECT_TRUE((last.positions_by_parameter.rightCols(4).array() == 0).all());
  // All four cords pull outward, by half of their widths.
  EXPECT_NEAR(last.clip_forces.col(0).norm(), 0.15, 1e-15);
  EXPECT_NEAR(last.clip_forces.col(1).norm(), 0.2, 1e-15);
  // Cords are 0.05 m to both sides of the middle of the clip; most of their pull is across that.
  EXPECT_NEAR(last.clip_moments.col(1).norm(), 0.05 * 0.2, 1e-12);
}

}  // namespace
}  // namespace pliant
