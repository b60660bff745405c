// Facts that a potential of every strain measure must show on a small irregular mesh, with
// elasticity, friction and damping at once. The measures are compared with their folder: a new one
// cannot be forgotten.

#include "pliant/mechanics/element_potential.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "pliant/material/density/dahl_friction.h"
#include "pliant/material/density/damping.h"
#include "pliant/material/density/stiffness_density.h"
#include "pliant/material/density/sum.h"
#include "pliant/math/check_derivatives.h"
#include "pliant/mechanics/nodal_dilatation.h"

#include "support/cloth_systems.h"
#include "support/element_stencils.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

constexpr double kEdge = 0.02;  // m; of solids twice that: no shake turns them inside out
constexpr StepTime kTime{1 / 0.01, 1, 0};

TriangleMesh small_mesh() { return test::jittered_grid(4 * kEdge, 3 * kEdge, 5, 4, 7); }

/// Strains of the elements that the membranes have at a shake of a tenth of an edge are near one
/// tenth; those of hinges, near `unit` times that.
std::shared_ptr<Sum> law_of_all(int strains, double unit) {
  auto sum = std::make_shared<Sum>();
  for (int c = 0; c < strains; ++c) {
    // The energy keeps its size where strains have another unit.
    const double k = (30 + 20 * c) / (unit * unit), a = 1.2 / unit;
    sum->add_addend(std::make_unique<StiffnessDensity>(c, ScalarCurve::affine(k, k / (2 * unit))));
    sum->add_addend(
        std::make_unique<DahlFriction>(c, DahlParameters{a, 0.1 * k, (0.04 + 0.02 * c) * unit}));
    sum->add_addend(std::make_unique<Damping>(c, 1e-3 * k));
  }
  return sum;
}

/// A system of one potential on 20 points and more: all free or, `held`, one of them held and three
/// in a free clip.
struct ElementSystem {
  std::string header;
  std::shared_ptr<ParametricPotential> potential;
  const ElementFields* fields = nullptr;
  std::shared_ptr<Sum> law;
  std::unique_ptr<System> system;
};

/// @param make  the potential of a law with its places
template <class Make>
ElementSystem system_of(const std::string& header, const Eigen::Matrix3Xd& positions, int strains,
                        double unit, bool held, const Make& make) {
  ElementSystem result;
  result.header = header;
  result.law = law_of_all(strains, unit);
  std::vector<int> places;
  // The other way round, with a gap: parameters stand anywhere among the system's.
  const int count = static_cast<int>(result.law->parameters().size());
  for (int k = 0; k < count; ++k) places.push_back(count - k);
  const auto potential = make(result.law, places);
  result.potential = potential;
  result.fields = potential.get();
  result.system = std::make_unique<System>(positions, Eigen::VectorXd::Ones(positions.cols()));
  result.system->add(potential);
  Eigen::VectorXd values(count + 1);
  values << 0, result.law->parameters().reverse();
  result.system->add_parameters(std::vector<std::string>(static_cast<size_t>(count) + 1), values);
  if (held) {
    result.system->coordinates().prescribe(7);
    result.system->coordinates().add_clip({0, 5, 11}, false);
  }
  result.system->finish();
  return result;
}

template <class Measure>
ElementSystem element_system(const std::string& header, const Stencils<Measure>& stencils,
                             double unit, bool held,
                             const Eigen::Matrix3Xd& positions = small_mesh().positions) {
  return system_of(header, positions, Measure::kStrains, unit, held,
                   [&](const std::shared_ptr<Sum>& law, const std::vector<int>& places) {
                     return std::make_shared<ElementPotential<Measure>>(stencils, law, places);
                   });
}

ElementSystem nodal_system(bool held) {
  const VolumeMesh mesh = test::shaken_block(true, 2 * kEdge);
  const Stencils<LinearTetrahedron> stencils = test::tetrahedra_of(mesh);
  return system_of("nodal_dilatation", mesh.positions, 1, 1, held,
                   [&](const std::shared_ptr<Sum>& law, const std::vector<int>& places) {
                     return std::make_shared<NodalDilatation>(stencils.points, stencils.sizes, law,
                                                              places);
                   });
}

std::vector<ElementSystem> registry(bool held = false) {
  const TriangleMesh mesh = small_mesh();
  std::vector<ElementSystem> systems;
  systems.push_back(
      element_system("stvk_membrane", test::triangles_of<StvkMembrane>(mesh), 1, held));
  systems.push_back(element_system("soft_constraint_membrane",
                                   test::triangles_of<SoftConstraintMembrane>(mesh), 1, held));
  systems.push_back(element_system("spring", test::springs_of(mesh), 1, held));
  systems.push_back(element_system("discrete_shells", test::hinges_of(mesh), 3 / kEdge, held));
  const VolumeMesh tetrahedra = test::shaken_block(true, 2 * kEdge),
                   hexahedra = test::shaken_block(false, 2 * kEdge);
  systems.push_back(element_system("linear_tetrahedron", test::tetrahedra_of(tetrahedra), 1, held,
                                   tetrahedra.positions));
  systems.push_back(element_system("trilinear_hexahedron", test::hexahedron_points_of(hexahedra), 1,
                                   held, hexahedra.positions));
  systems.push_back(element_system("hexahedron_dilatation", test::dilatations_of(hexahedra), 1,
                                   held, hexahedra.positions));
  systems.push_back(nodal_system(held));
  return systems;
}

/// Two accepted steps: every element remembers something else.
State with_history(const System& system, RandomStream& random) {
  State state = system.initial_state();
  for (int step = 0; step < 2; ++step) {
    Eigen::VectorXd change(system.coordinates().unknowns());
    for (double& x : change) x = 0.1 * kEdge * random.normal();
    test::accept(system, state, system.coordinates().moved(state.configuration, change), kTime);
  }
  return state;
}

Configuration moved_on(const System& system, const State& state, RandomStream& random) {
  Eigen::VectorXd change(system.coordinates().unknowns());
  for (double& x : change) x = 0.1 * kEdge * random.normal();
  return system.coordinates().moved(state.configuration, change);
}

// Steps of differences, a five hundredth of an edge and less: the chance that one takes an element
// past its last strain, where the slope jumps, is small, and the seeds are fixed.
Eigen::VectorXd step_scale(const System& system) {
  return Eigen::VectorXd::Constant(system.coordinates().unknowns(), 0.002 * kEdge);
}

TEST(ElementPotential, IsTestedForEveryMeasure) {
  const std::set<std::string> helpers{"strain_measure", "membrane_rest", "green_strain",
                                      "inversion"};
  std::set<std::string> headers{"nodal_dilatation"}, tested;  // that one is no measure
  const std::filesystem::path folder =
      std::filesystem::path(PLIANT_SOURCE_DIR) / "src/pliant/material/strain";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().stem().string();
    if (entry.path().extension() == ".h" && !helpers.contains(name)) headers.insert(name);
  }
  for (const ElementSystem& s : registry()) tested.insert(s.header);
  EXPECT_EQ(headers, tested);
}

TEST(ElementPotential, HasTheForcesAndTheStiffnessOfItsEnergy) {
  RandomStream random(1);
  for (const ElementSystem& s : registry()) {
    const System& system = *s.system;
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(system.coordinates().unknowns());
    for (int trial = 0; trial < 3; ++trial) {
      const State from = with_history(system, random);
      const Configuration at = moved_on(system, from, random);
      const VectorFunction energy = [&](const Eigen::VectorXd& change) {
        const Configuration there = system.coordinates().moved(at, change);
        return Eigen::VectorXd::Constant(1, test::energy_of(system, there, from, kTime).total());
      };
      const VectorFunction force = [&](const Eigen::VectorXd& change) {
        return test::reduced_gradient(system, system.coordinates().moved(at, change), from, kTime);
      };
      const Eigen::VectorXd gradient = test::reduced_gradient(system, at, from, kTime);
      const DerivativeCheck first =
          check_derivatives(energy, gradient.transpose(), zero, step_scale(system));
      const DerivativeCheck second = check_derivatives(
          force, test::hessian_of(system, at, from, kTime), zero, step_scale(system));
      EXPECT_LT(first.error, 1e-7) << s.header << ": " << first.describe();
      EXPECT_LT(second.error, 1e-7) << s.header << ": " << second.describe();
    }
  }
}

// With a clip and a held point: the same numbers, taken through the coordinates.
TEST(ElementPotential, PutsItsStiffnessThroughClipsAndPastHeldPoints) {
  RandomStream random(2);
  const std::vector<ElementSystem> held = registry(true), all_free = registry(false);
  for (size_t k = 0; k < held.size(); ++k) {
    const System& system = *held[k].system;
    const System& whole = *all_free[k].system;
    const State from = with_history(system, random);
    const Configuration at = moved_on(system, from, random);
    // d points / d unknowns by differences of what moves linearly in them, or nearly so.
    const VectorFunction points = [&](const Eigen::VectorXd& change) -> Eigen::VectorXd {
      return system.coordinates().moved(at, change).positions.reshaped();
    };
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(system.coordinates().unknowns());
    const Eigen::MatrixXd jacobian =
        estimate_jacobian(points, zero, Eigen::VectorXd::Constant(zero.size(), 0.5));
    State as_free = whole.initial_state();
    as_free.history = from.history;
    const Configuration free_points{at.positions, {}};
    // The moments of the clip also turn with it: left out on both sides.
    Hessian hessian = system.make_hessian();
    Derivatives derivatives;
    derivatives.hessian = &hessian;
    system.evaluate(at, {.from = from, .time = kTime}, Curvature::exact, derivatives);
    const Eigen::MatrixXd expected =
        jacobian.transpose() * test::hessian_of(whole, free_points, as_free, kTime) * jacobian;
    EXPECT_LT((test::dense(hessian.matrix) - expected).norm(), 1e-9 * expected.norm())
        << held[k].header;
  }
}

TEST(ElementPotential, HasAConvexStandInOfItsStiffness) {
  RandomStream random(3);
  for (const ElementSystem& s : registry()) {
    for (int trial = 0; trial < 3; ++trial) {
      const State from = with_history(*s.system, random);
      const Configuration at = moved_on(*s.system, from, random);
      const Eigen::MatrixXd convex =
          test::hessian_of(*s.system, at, from, kTime, Curvature::convex);
      const Eigen::VectorXd values =
          Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(convex, Eigen::EigenvaluesOnly)
              .eigenvalues();
      EXPECT_GE(values(0), -1e-13 * values(values.size() - 1)) << s.header;
      EXPECT_GT(values(values.size() - 1), 0);
    }
  }
}

TEST(ElementPotential, IsFreeOfForceWhereItWasMovedRigidly) {
  RandomStream random(4);
  for (const ElementSystem& s : registry()) {
    const System& system = *s.system;
    const State state = system.initial_state();
    const double scale = test::gradient_of(system, moved_on(system, state, random), state).norm();
    for (int trial = 0; trial < 10; ++trial) {
      Eigen::Vector3d axis(random.normal(), random.normal(), random.normal());
      const Eigen::AngleAxisd turn(random.uniform(0, 3), axis.normalized());
      Configuration at = state.configuration;
      at.positions = (turn.toRotationMatrix() * at.positions).colwise() +
                     Eigen::Vector3d(random.normal(), random.normal(), random.normal());
      // Rounding of coordinates near 1 m over edges of 2 cm, against strains of a tenth.
      EXPECT_LT(test::gradient_of(system, at, state, {}).norm(), 1e-12 * scale) << s.header;
      EXPECT_LT(std::abs(test::energy_of(system, at, state).total()), 1e-12) << s.header;
    }
  }
}

TEST(ElementPotential, ExertsNoForceAndNoMomentAsAWhole) {
  RandomStream random(5);
  for (const ElementSystem& s : registry()) {
    const State from = with_history(*s.system, random);
    const Configuration at = moved_on(*s.system, from, random);
    const Eigen::Matrix3Xd force = test::gradient_of(*s.system, at, from, kTime);
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (int i = 0; i < force.cols(); ++i) {
      moment += Eigen::Vector3d(at.positions.col(i)).cross(Eigen::Vector3d(force.col(i)));
    }
    EXPECT_LT(force.rowwise().sum().norm(), 1e-12 * force.norm()) << s.header;
    EXPECT_LT(moment.norm(), 1e-12 * force.norm() * at.positions.norm()) << s.header;
  }
}

TEST(ElementPotential, AddsToWhatIsThere) {
  RandomStream random(6);
  for (const ElementSystem& s : registry()) {
    const State from = with_history(*s.system, random);
    const Configuration at = moved_on(*s.system, from, random);
    Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Ones(3, s.system->points());
    Derivatives derivatives;
    derivatives.energy = {5, 7};
    derivatives.gradient = &gradient;
    s.system->evaluate(at, {.from = from, .time = kTime}, Curvature::exact, derivatives);
    const Energy energy = test::energy_of(*s.system, at, from, kTime);
    EXPECT_DOUBLE_EQ(derivatives.energy.stored, 5 + energy.stored);
    EXPECT_DOUBLE_EQ(derivatives.energy.work, 7 + energy.work);
    EXPECT_TRUE((gradient.array() - 1)
                    .matrix()
                    .isApprox(test::gradient_of(*s.system, at, from, kTime), 1e-12));
  }
}

TEST(ElementPotential, RemembersTheLastTwoStrains) {
  const TriangleMesh mesh = small_mesh();
  const Stencils<StvkMembrane> stencils = test::triangles_of<StvkMembrane>(mesh);
  const ElementSystem s = element_system("stvk_membrane", stencils, 1, false);
  RandomStream random(7);
  State state = s.system->initial_state();
  const Configuration first = moved_on(*s.system, state, random);
  test::accept(*s.system, state, first);
  const Configuration second = moved_on(*s.system, state, random);
  test::accept(*s.system, state, second);

  const double* history = s.system->history_of(*s.potential, state);
  const int columns = static_cast<int>(state.history.size()) /
                      (kLanes * ((mesh.triangle_count() + kLanes - 1) / kLanes));
  EXPECT_EQ(columns, 2 * 3 + 3);
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const auto& nodes = stencils.points[static_cast<size_t>(t)];
    const auto strain = [&](const Configuration& at) {
      return StvkMembrane::strain(stencils.rests[static_cast<size_t>(t)],
                                  at.positions(Eigen::all, nodes));
    };
    const double* own = history + kLanes * columns * (t / kLanes) + t % kLanes;
    for (int c = 0; c < 3; ++c) {
      EXPECT_NEAR(own[kLanes * c], strain(second)(c), 1e-14);
      EXPECT_NEAR(own[kLanes * (3 + c)], strain(first)(c), 1e-14);
    }
  }
}

TEST(ElementPotential, ChangesItsHistoryOnlyWhereAStepIsAccepted) {
  RandomStream random(8);
  for (const ElementSystem& s : registry()) {
    const State from = with_history(*s.system, random);
    const Eigen::VectorXd before = from.history;
    const Configuration at = moved_on(*s.system, from, random);
    test::hessian_of(*s.system, at, from, kTime);
    EXPECT_EQ(from.history, before);
    State once = from, again = from;
    const double work = test::accept(*s.system, once, at, kTime);
    EXPECT_EQ(test::accept(*s.system, again, at, kTime), work);
    EXPECT_EQ(once.history, again.history);
    EXPECT_NE(once.history, before);
  }
}

TEST(ElementPotential, ShowsItsStrainsAndItsFriction) {
  const TriangleMesh mesh = small_mesh();
  const Stencils<DiscreteShells> stencils = test::hinges_of(mesh);
  const DahlParameters dahl{2e-5, 1e-7, 20};
  auto law = std::make_shared<Sum>();
  law->add_addend(std::make_unique<StiffnessDensity>(0, ScalarCurve::constant(1e-5)));
  law->add_addend(std::make_unique<DahlFriction>(0, dahl));
  const auto potential = std::make_shared<ElementPotential<DiscreteShells>>(
      stencils, law, std::vector<int>{}, std::vector<std::string>{"strain.bend", "friction.bend"});
  System system(mesh.positions, Eigen::VectorXd::Ones(mesh.vertex_count()));
  system.add(potential);
  system.finish();
  EXPECT_EQ(potential->field_names(), (std::vector<std::string>{"strain.bend", "friction.bend"}));
  EXPECT_EQ(potential->element_sizes().size(), static_cast<Eigen::Index>(stencils.sizes.size()));

  RandomStream random(9);
  State state = system.initial_state();
  Eigen::VectorXd friction = Eigen::VectorXd::Zero(potential->element_sizes().size());
  Eigen::VectorXd strain = friction;
  for (int step = 0; step < 3; ++step) {
    test::accept(system, state, moved_on(system, state, random));
    const Eigen::MatrixXd fields = potential->field_values(system.history_of(*potential, state));
    for (size_t h = 0; h < stencils.points.size(); ++h) {
      const auto e = static_cast<Eigen::Index>(h);
      const auto& nodes = stencils.points[h];
      const double now = DiscreteShells::strain(
          stencils.rests[h], state.configuration.positions(Eigen::all, nodes))(0);
      friction(e) = friction_stress(dahl, now, {strain(e), friction(e)}).stress;
      strain(e) = now;
      EXPECT_NEAR(fields(0, e), now, 1e-10);  // 1/m; angles over heights of 2 cm
      EXPECT_NEAR(fields(1, e), friction(e), 1e-15);
      EXPECT_EQ(potential->element_points()(3, e), nodes[3]);
      EXPECT_EQ(potential->element_sizes()(e), stencils.sizes[h]);
    }
  }
}

TEST(ElementPotential, TakesItsParametersFromTheirPlaces) {
  for (const ElementSystem& s : registry()) {
    const Eigen::Index count = s.law->parameters().size();
    Eigen::VectorXd all = Eigen::VectorXd::LinSpaced(count + 1, 100, 100 + double(count));
    EXPECT_EQ(s.system->with(all).law(0)->parameters(), all.tail(count).reverse()) << s.header;
  }
}

/// A path of accepted configurations that depend on the parameters themselves, and the forces at
/// its end.
struct Path {
  std::vector<Configuration> points;
  Eigen::MatrixXd by_parameter;  // d positions, the same at each point of the path

  Configuration point(size_t k, const Eigen::VectorXd& change) const {
    Configuration at = points[k];
    at.positions.reshaped() += by_parameter * change;
    return at;
  }
};

// d forces / d parameters along a path with friction, quasi-statically.
TEST(ElementPotential, CarriesTheSensitivityOfAPath) {
  RandomStream random(10);
  for (const ElementSystem& s : registry()) {
    const System& system = *s.system;
    const Eigen::Index own = s.law->parameters().size(), all = own + 1;
    Eigen::VectorXd parameters(all);
    parameters << 0, s.law->parameters().reverse();
    Path path;
    State start = system.initial_state();
    for (int k = 0; k < 4; ++k) {
      path.points.push_back({test::shaken(start.configuration.positions, random, 0.1 * kEdge), {}});
    }
    path.by_parameter.resize(3 * system.points(), all);
    for (double& x : path.by_parameter.reshaped()) x = 0.1 * kEdge * random.normal();
    for (Eigen::Index k = 0; k < all; ++k) {
      path.by_parameter.col(k) /= std::max(std::abs(parameters(k)), 1e-3);
    }

    const VectorFunction last_force = [&](const Eigen::VectorXd& p) -> Eigen::VectorXd {
      const Parameters laws = system.with(p);
      State state = start;
      for (size_t k = 0; k + 1 < path.points.size(); ++k) {
        test::accept(system, state, path.point(k, p - parameters), {}, laws);
      }
      const Configuration last = path.point(path.points.size() - 1, p - parameters);
      return test::gradient_of(system, last, state, {}, laws).reshaped();
    };

    const std::vector<int> by = system.all_parameters();
    State state = start;
    Eigen::MatrixXd history = Eigen::MatrixXd::Zero(state.history.size(), all);
    for (size_t k = 0; k + 1 < path.points.size(); ++k) {
      system.advance_sensitivity(path.points[k], {state}, by, path.by_parameter, history);
      test::accept(system, state, path.points[k]);
    }
    const Configuration& end = path.points.back();
    Eigen::MatrixXd stated = test::hessian_of(system, end, state) * path.by_parameter;
    system.add_force_sensitivity(end, {state}, by, history, stated);

    const Eigen::VectorXd scale = 1e-3 * parameters.cwiseAbs().cwiseMax(1e-3);
    const DerivativeCheck check = check_derivatives(last_force, stated, parameters, scale);
    EXPECT_LT(check.error, 1e-6) << s.header << ": " << check.describe();
  }
}

}  // namespace
}  // namespace pliant
