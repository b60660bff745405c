#include "pliant/experiment/hanging/weight_path.h"

#include <algorithm>

#include "pliant/material/law_path.h"
#include "pliant/math/root.h"

namespace pliant {
namespace {

// Strains between which an equilibrium is looked for; the Green-Lagrange strain of length 0 is
// -0.5.
constexpr double kLowestStrain = -0.45;
constexpr double kHighestStrain = 50;

// Walking step of the search for the next equilibrium: small against tau, over which stress can
// bend.
double search_step(const ComponentLaw& law) {
  if (law.friction_law != FrictionLaw::dahl) return 0.01;
  return std::clamp(law.friction[2] / 4, 5e-4, 0.02);
}

}  // namespace

std::optional<HungLengths> hang_weights(const ComponentLaw& law, const UniaxialGeometry& geometry,
                                        std::span<const double> forces,
                                        std::span<const char> rested, bool jacobian) {
  const auto rows = static_cast<Eigen::Index>(forces.size());
  const int parameters = jacobian ? law.parameter_count() : 0;
  HungLengths out{Eigen::VectorXd(rows), Eigen::VectorXd(rows), Eigen::MatrixXd(rows, parameters)};
  const PathPoint rest{0, 0, Eigen::VectorXd::Zero(parameters), Eigen::VectorXd::Zero(parameters)};
  const double step = search_step(law);
  LawPath path(law, rest);

  for (Eigen::Index i = 0; i < rows; ++i) {
    const double force = forces[static_cast<size_t>(i)];
    if (rested[static_cast<size_t>(i)]) path = LawPath(law, rest);
    const auto excess = [&](double strain) {
      return force_factor(geometry, strain) * path.stress_at(strain) - force;
    };
    const double from = path.start().strain;
    const bool up = excess(from) < 0;
    const std::optional<double> strain =
        first_root(excess, from, up ? step : -step, up ? kHighestStrain : kLowestStrain);
    if (!strain) return std::nullopt;

    const PathStress here = path.at(*strain);
    const double factor = force_factor(geometry, *strain);
    const double slope = factor * here.slope + force_factor_slope(geometry, *strain) * here.stress;
    const Eigen::VectorXd gradient = -factor / slope * here.gradient;
    path.turn_at(*strain, gradient);
    out.strain(i) = *strain;
    out.length(i) = length_at(geometry, *strain);
    if (jacobian)
      out.jacobian.row(i) = gradient.transpose() / strain_slope(geometry, out.length(i));
  }
  return out;
}

}  // namespace pliant
