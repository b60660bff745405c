#include "pliant/material/law_path.h"

#include <vector>

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/addend/addend_registry.h"
#include "pliant/math/check_derivatives.h"

#include "support/added_stiffness.h"
#include "support/random_laws.h"

namespace pliant {
namespace {

using test::parameter_scales;
using test::random_law;

/// Turning strains, and one strain on the way to each, at rest at first.
struct Route {
  std::vector<double> turns;
  std::vector<double> on_the_way;
};

/// One that remembers between two that do not.
std::vector<Addend> random_addends(RandomStream& random) {
  const DahlParameters dahl = test::random_dahl(random);
  const auto elastic = [&] {
    return Addend(test::added_stiffness(),
                  Eigen::Vector2d(random.uniform(1, 20), random.uniform(1, 20)));
  };
  const Addend first = elastic();
  return {first, {*find_addend_kind("dahl"), Eigen::Vector3d(dahl.a, dahl.b, dahl.tau)}, elastic()};
}

Route random_route(RandomStream& random) {
  Route route;
  double from = 0, sign = 1;
  for (int i = 0; i < 6; ++i, sign = -sign) {
    const double to = from + sign * random.uniform(0.02, 0.3);
    route.turns.push_back(to);
    route.on_the_way.push_back(from + random.uniform(0.2, 0.8) * (to - from));
    from = to;
  }
  return route;
}

/// Total and friction stress at every strain on the way. The arguments are the law's parameters, a
/// factor on all strains and the friction stress at the start.
Eigen::VectorXd stresses(const ComponentLaw& like, const Route& route, const Eigen::VectorXd& x) {
  const int count = like.parameter_count();
  LawPath path(like.with_parameters(x.head(count)), {0, x(count + 1), {}, {}});
  std::vector<double> values;
  for (size_t i = 0; i < route.turns.size(); ++i) {
    const PathStress stress = path.at(x(count) * route.on_the_way[i]);
    values.insert(values.end(), {stress.stress, stress.friction});
    path.turn_at(x(count) * route.turns[i], {});
  }
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// The Jacobian of `stresses` as the path carries it along.
Eigen::MatrixXd carried_jacobian(const ComponentLaw& like, const Route& route,
                                 const Eigen::VectorXd& x) {
  const int count = like.parameter_count();
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(count + 2);
  LawPath path(like.with_parameters(x.head(count)),
               {0, x(count + 1), zero, Eigen::VectorXd::Unit(count + 2, count + 1)});
  Eigen::MatrixXd jacobian(2 * route.turns.size(), count + 2);
  for (size_t i = 0; i < route.turns.size(); ++i) {
    const Eigen::VectorXd moved = Eigen::VectorXd::Unit(count + 2, count) * route.on_the_way[i];
    const PathStress stress = path.at(x(count) * route.on_the_way[i]);
    const auto row = static_cast<Eigen::Index>(2 * i);
    jacobian.row(row) = stress.gradient + stress.slope * moved;
    jacobian.row(row + 1) = stress.friction_gradient + stress.friction_slope * moved;
    path.turn_at(x(count) * route.turns[i],
                 Eigen::VectorXd::Unit(count + 2, count) * route.turns[i]);
  }
  return jacobian;
}

TEST(LawPath, CarriesTheDerivativesThroughReversals) {
  RandomStream random(21);
  for (const CurveKind curve : {CurveKind::constant, CurveKind::affine, CurveKind::hermite}) {
    for (const FrictionLaw friction :
         {FrictionLaw::none, FrictionLaw::dahl, FrictionLaw::constant_slope}) {
      for (int draw = 0; draw < 10; ++draw) {
        ComponentLaw law = random_law(random, curve, friction);
        if (draw % 2 == 1) law.addends = random_addends(random);
        const Route route = random_route(random);
        const int count = law.parameter_count();
        Eigen::VectorXd at(count + 2), scale(count + 2);
        at << law.parameters(), 1, 0.3 * law.max_friction(0);
        // Small enough that no strain passes a turning point or a knot of the stiffness.
        scale << parameter_scales(law) * 0.1, 1e-3, 0.1;
        const DerivativeCheck check =
            check_derivatives([&](const Eigen::VectorXd& x) { return stresses(law, route, x); },
                              carried_jacobian(law, route, at), at, scale);
        // Differences are good to 1e-9 or so; a wrong term shows at 1e-3 and more.
        EXPECT_LT(check.error, 1e-7) << check.describe();
      }
    }
  }
}

TEST(LawPath, StressesDoNotDependOnTheSamplesBetweenTurningPoints) {
  RandomStream random(22);
  const ComponentLaw law = random_law(random, CurveKind::affine);
  LawPath path(law, {});
  path.turn_at(0.2, {});
  const double direct = path.at(0.05).stress;
  for (const double strain : {0.19, 0.15, 0.1}) path.turn_at(strain, {});
  EXPECT_NEAR(path.at(0.05).stress, direct, 1e-12);  // rounding of four exponentials
}

TEST(LawPath, SlopesAreThoseAlongTheStretch) {
  RandomStream random(23);
  const ComponentLaw law = random_law(random, CurveKind::hermite);
  LawPath path(law, {});
  path.turn_at(0.2, {});
  for (const double strain : {0.18, 0.12, 0.02}) {
    const PathStress here = path.at(strain);
    EXPECT_EQ(here.stress, path.stress_at(strain));
    const VectorFunction along = [&](const Eigen::VectorXd& x) {
      const PathStress stress = path.at(x(0));
      return Eigen::VectorXd(Eigen::Vector2d(stress.stress, stress.friction));
    };
    const DerivativeCheck check =
        check_derivatives(along, Eigen::Vector2d(here.slope, here.friction_slope),
                          Eigen::VectorXd::Constant(1, strain), Eigen::VectorXd::Constant(1, 0.01));
    EXPECT_LT(check.error, 1e-8) << check.describe();  // accuracy of the differences
  }
}

TEST(LawPath, WithoutGradientsGivesTheSameStressAndNone) {
  RandomStream random(24);
  const ComponentLaw law = random_law(random, CurveKind::affine);
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(law.parameter_count());
  LawPath with(law, {0, 0, zero, zero});
  LawPath without(law, {});
  with.turn_at(0.1, zero);
  without.turn_at(0.1, {});
  EXPECT_EQ(with.at(0.04).stress, without.at(0.04).stress);
  EXPECT_EQ(without.at(0.04).gradient.size(), 0);
}

}  // namespace
}  // namespace pliant
