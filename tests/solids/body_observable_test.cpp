// What images will measure: intensities of a picture at the places to which points of a body have
// moved ([T] 4.4.2), beside the force, through the same equilibria and the same fit as marks.

#include "pliant/experiment/moved_body/body_observable.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "pliant/estimation/solid/solid_fit.h"
#include "pliant/estimation/solid/solid_laws.h"
#include "pliant/experiment/moved_body/moved_body_predictor.h"
#include "pliant/experiment/stored_rows.h"
#include "pliant/material/solid/standard_solids.h"

#include "solids/bodies.h"

namespace pliant {
namespace {

constexpr double kWave = 150;           // of the picture, 1/m
constexpr double kForceNoise = 0.001;   // N
constexpr double kPictureNoise = 0.01;  // of greys that range over some units

/// A volume whose grey changes smoothly, of the order of 1.
struct Picture {
  static double intensity(const Eigen::Vector3d& x) {
    return std::sin(kWave * x.x()) + std::cos(kWave * (x.y() + x.z() / 2));
  }
  static Eigen::Vector3d gradient(const Eigen::Vector3d& x) {
    const double across = -kWave * std::sin(kWave * (x.y() + x.z() / 2));
    return {kWave * std::cos(kWave * x.x()), across, across / 2};
  }
};

/// Intensities at all nodes of a block, and the force along x, in two frames.
class PictureTest : public Experiment, public BodyObservable {
 public:
  explicit PictureTest(const VirtualMovedBody& body) : setup_(body.setup), shifts_(body.shifts) {
    info_.name = "picture";
    info_.quantity = {"reading", "reading", "1", 1};
    info_.force_noise = 1;
    const int rows = per_frame() * static_cast<int>(shifts_.size());
    info_.used.assign(static_cast<std::size_t>(rows), 1);
    info_.specimens = {"block"};
    measured_ = Eigen::VectorXd::Zero(rows);
  }

  /// Measures what a material does.
  void measure(const Material& truth) {
    const auto own = predictor(truth);
    StoredRows rows(*this);
    ASSERT_TRUE(own->predict(own->values(), {}, {}, rows));
    measured_ = rows.rows().value;
  }

  std::vector<Frame> frames() const override {
    std::vector<Frame> frames;
    for (int f = 0; f < static_cast<int>(shifts_.size()); ++f) {
      frames.push_back({f * per_frame(), per_frame(), 0});
    }
    return frames;
  }
  std::vector<std::vector<int>> series() const override { return {}; }
  double reference() const override { return 1; }
  double stress() const override { return 9e3; }
  std::unique_ptr<Predictor> predictor(const Material& material) const override {
    return std::make_unique<MovedBodyPredictor>(
        setup_, MovedBodyPredictor::Schedule{frames(), shifts_, *this}, material);
  }
  BodyReadout read(int row, const Eigen::Matrix3Xd& positions,
                   const Eigen::Vector3d& force) const override {
    const int node = row % per_frame() - 1;
    if (node < 0) return {force.x() / kForceNoise, Eigen::Vector3d::UnitX() / kForceNoise};
    const Eigen::Vector3d place = positions.col(node);
    return {Picture::intensity(place) / kPictureNoise,
            Eigen::Vector3d::Zero(),
            {{node, Picture::gradient(place) / kPictureNoise}}};
  }

 private:
  int per_frame() const { return 1 + static_cast<int>(setup_.mesh.positions.cols()); }

  BodySetup setup_;
  std::vector<Eigen::Vector3d> shifts_;
};

TEST(BodyObservable, IntensitiesAreDifferentiatedThroughEquilibria) {
  const PictureTest experiment(test::moved_block({3, 2, 2}));
  const auto predictor = experiment.predictor(neo_hookean_solid(15e3, 30e3));
  const Eigen::VectorXd values = predictor->values();
  StoredRows all(experiment, 2);
  ASSERT_TRUE(predictor->predict(values, {0, 1}, {}, all));
  for (int p = 0; p < 2; ++p) {
    const auto at = [&](double share) {
      Eigen::VectorXd changed = values;
      changed(p) *= 1 + share;
      StoredRows rows(experiment);
      EXPECT_TRUE(predictor->predict(changed, {}, {}, rows));
      return rows.rows().value;
    };
    const Eigen::VectorXd difference = (at(1e-4) - at(-1e-4)) / (2e-4 * values(p));
    EXPECT_LT((all.rows().by.col(p) - difference).norm(), 1e-5 * difference.norm()) << p;
  }
}

TEST(BodyObservable, IntensitiesAndForcesTellASolidByTheOneFit) {
  PictureTest experiment(test::moved_block({3, 2, 2}));
  experiment.measure(neo_hookean_solid(15e3, 30e3));
  FitSettings settings;
  settings.model.kind = MaterialKind::solid;
  settings.model.solid_law = "neo-hookean";
  settings.density = 1000;
  const SolidFit fit = fit_solid(settings, solid_components(settings.model, /*compressible=*/true),
                                 {}, {&experiment}, {}, {});
  EXPECT_TRUE(fit.converged);
  ASSERT_EQ(fit.values.size(), 2);
  const Material truth = neo_hookean_solid(15e3, 30e3);
  const auto predictor = experiment.predictor(truth);
  for (Eigen::Index i = 0; i < 2; ++i) {
    const auto& names = predictor->parameters();
    const auto own = std::ranges::find(names, fit.unknowns[static_cast<std::size_t>(i)].name);
    ASSERT_NE(own, names.end());
    const double value = predictor->values()(own - names.begin());
    EXPECT_NEAR(fit.values(i), value, 1e-5 * value) << *own;
  }
}

}  // namespace
}  // namespace pliant
