#include "pliant/material/density/stiffness_density.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

// The cubic of the way through four values, at equal distances over a length.
std::array<double, 4> cubic_through(const std::array<double, 4>& f, double length) {
  const double first = (-11 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / 2;
  const double second = (18 * f[0] - 45 * f[1] + 36 * f[2] - 9 * f[3]) / 2;
  const double third = 4.5 * (f[3] - f[0] + 3 * (f[1] - f[2]));
  return {f[0], first / length, second / (length * length), third / (length * length * length)};
}

}  // namespace

StiffnessDensity::StiffnessDensity(int component, ScalarCurve stiffness)
    : component_(component), stiffness_(std::move(stiffness)) {
  cut_into_pieces();
}

// What equilibria ask for millions of times: no search among the knots for each of value, slope and
// energy, and no division.
void StiffnessDensity::cut_into_pieces() {
  if (stiffness_.is_of_energy()) cut_energy();
  if (stiffness_.kind() != CurveKind::hermite) return;
  const std::vector<double>& knots = stiffness_.knots();
  const auto add = [&](double from, const std::array<double, 4>& coefficients) {
    pieces_.push_back({from, coefficients, stiffness_.first_moment(from)});
  };
  add(knots.front(), {stiffness_.values().front()});
  for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
    const double length = knots[i + 1] - knots[i];
    std::array<double, 4> values{};
    for (std::size_t k = 0; k < 4; ++k) {
      values[k] = stiffness_.value(knots[i] + static_cast<double>(k) / 3 * length);
    }
    add(knots[i], cubic_through(values, length));
  }
  add(knots.back(), {stiffness_.values().back()});
}

// Zero is a cut too, so that nothing is lost where stresses are small. Tangents are linear between
// cuts and may jump at them.
void StiffnessDensity::cut_energy() {
  std::vector<double> cuts = stiffness_.knots();
  const auto zero = std::ranges::lower_bound(cuts, 0.0);
  if (zero == cuts.end() || *zero != 0) cuts.insert(zero, 0.0);
  const auto tangent = [&](double strain) {
    return stiffness_.value(strain) + strain * stiffness_.slope(strain);
  };
  const double beyond = std::max(cuts.back() - cuts.front(), 1.0);
  for (std::size_t i = 0; i <= cuts.size(); ++i) {
    const double from = cuts[std::max<std::size_t>(i, 1) - 1];
    double first = 0, slope = 0;
    if (i == 0 || i == cuts.size()) {
      first = tangent(from + (i == 0 ? -beyond : beyond));
    } else {
      const double third = (cuts[i] - from) / 3;
      const double near = tangent(from + third), far = tangent(from + 2 * third);
      first = 2 * near - far;
      slope = (far - near) / third;
    }
    pieces_.push_back(
        {from, {stiffness_.value(from) * from, first, slope / 2}, stiffness_.first_moment(from)});
  }
}

StiffnessDensity::LanePieces StiffnessDensity::pieces_at(const Lane& strain) const {
  LanePieces at;
  Lane place = strain;
  at.sign = Lane::Ones();
  if (stiffness_.even()) {
    place = strain.abs();
    for (int i = 0; i < kLanes; ++i) at.sign(i) = std::copysign(1.0, strain(i));
  }
  for (int i = 0; i < kLanes; ++i) {
    std::size_t p = pieces_.size() - 1;
    while (p > 0 && place(i) < pieces_[p].from) --p;
    const Piece& piece = pieces_[p];
    at.from(i) = piece.from;
    at.c0(i) = piece.coefficients[0];
    at.c1(i) = piece.coefficients[1];
    at.c2(i) = piece.coefficients[2];
    at.c3(i) = piece.coefficients[3];
    at.energy(i) = piece.energy;
  }
  at.way = place - at.from;
  return at;
}

void StiffnessDensity::add_hermite(const Samples& samples, Response& response) const {
  const Lane strain = samples.strain.col(component_);
  const auto [way, from, c0, c1, c2, c3, energy, sign] = pieces_at(strain);
  const Lane stiffness = c0 + way * (c1 + way * (c2 + way * c3));
  const Lane slope = sign * (c1 + way * (2 * c2 + way * 3 * c3));
  const Lane integral = way * (c0 + way * (c1 / 2 + way * (c2 / 3 + way * c3 / 4)));
  const Lane moment = way * way * (c0 / 2 + way * (c1 / 3 + way * (c2 / 4 + way * c3 / 5)));
  response.stored += energy + from * integral + moment;
  response.stress.col(component_) += stiffness * strain;
  response.tangent.col(component_ * samples.strain.cols() + component_) +=
      stiffness + slope * strain;
}

void StiffnessDensity::add_energy(const Samples& samples, Response& response) const {
  const auto [way, from, c0, c1, c2, c3, energy, sign] = pieces_at(samples.strain.col(component_));
  response.stored += energy + way * (c0 + way * (c1 / 2 + way * c2 / 3));
  response.stress.col(component_) += sign * (c0 + way * (c1 + way * c2));
  response.tangent.col(component_ * samples.strain.cols() + component_) += c1 + 2 * c2 * way;
}

void StiffnessDensity::add(const Samples& samples, const StepTime&, Response& response) const {
  if (stiffness_.kind() == CurveKind::hermite) {
    add_hermite(samples, response);
    return;
  }
  if (stiffness_.is_of_energy()) {
    add_energy(samples, response);
    return;
  }
  const auto strain = samples.strain.col(component_);
  auto stress = response.stress.col(component_);
  auto tangent = response.tangent.col(component_ * samples.strain.cols() + component_);
  const double k1 = stiffness_.values()[0];
  const double k2 = stiffness_.kind() == CurveKind::affine ? stiffness_.values()[1] : 0;
  const Lane growth = k2 * strain.abs();
  response.stored += strain.square() * (k1 / 2 + growth / 3);
  stress += strain * (k1 + growth);
  tangent += k1 + 2 * growth;
}

void StiffnessDensity::advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const {}

Eigen::VectorXd StiffnessDensity::parameters() const {
  return Eigen::Map<const Eigen::VectorXd>(stiffness_.values().data(), stiffness_.size());
}

std::unique_ptr<ParametricDensity> StiffnessDensity::with_parameters(
    const Eigen::VectorXd& values) const {
  return std::make_unique<StiffnessDensity>(component_, stiffness_.with_values(values.data()));
}

void StiffnessDensity::differentiate(const Samples& samples, const StepTime&, int lane, int,
                                     int first_parameter, SampleDerivatives& derivatives) const {
  const double strain = samples.strain(lane, component_);
  derivatives.stored_by_parameter.segment(first_parameter, stiffness_.size()) +=
      stiffness_.first_moment_weights(strain);
  derivatives.stress_by_parameter.row(component_).segment(first_parameter, stiffness_.size()) +=
      strain * stiffness_.weights(strain).transpose();
}

}  // namespace pliant
