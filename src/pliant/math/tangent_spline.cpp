#include "pliant/math/tangent_spline.h"

#include <algorithm>

namespace pliant {
namespace {

using Knots = std::vector<double>;

// Adds `factor` times the weights of the value at x, linear between the knots.
void add_hats(const Knots& knots, double x, double factor, Eigen::VectorXd& weights) {
  const auto above = std::ranges::upper_bound(knots, x);
  if (above == knots.begin()) {
    weights(0) += factor;
  } else if (above == knots.end()) {
    weights(weights.size() - 1) += factor;
  } else {
    const auto i = above - knots.begin();
    const double from = *(above - 1), share = (x - from) / (*above - from);
    weights(i - 1) += factor * (1 - share);
    weights(i) += factor * share;
  }
}

Eigen::VectorXd zeros(const Knots& knots) {
  return Eigen::VectorXd::Zero(static_cast<Eigen::Index>(knots.size()));
}

// The way from zero to x, cut at the knots; upwards or downwards.
std::vector<double> cuts(const Knots& knots, double x) {
  std::vector<double> places{0};
  const auto between = [x](double knot) {
    return x > 0 ? knot > 0 && knot < x : knot < 0 && knot > x;
  };
  std::ranges::copy_if(knots, std::back_inserter(places), between);
  if (x < 0) std::reverse(places.begin() + 1, places.end());
  places.push_back(x);
  return places;
}

bool is_one_piece(const Knots& knots, double x) { return cuts(knots, x).size() == 2; }

}  // namespace

Eigen::VectorXd spline_tangent_weights(const Knots& knots, double x) {
  Eigen::VectorXd weights = zeros(knots);
  add_hats(knots, x, 1, weights);
  return weights;
}

Eigen::VectorXd spline_stress_weights(const Knots& knots, double x) {
  Eigen::VectorXd weights = zeros(knots);
  const std::vector<double> places = cuts(knots, x);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double half = (places[i + 1] - places[i]) / 2;
    add_hats(knots, places[i], half, weights);
    add_hats(knots, places[i + 1], half, weights);
  }
  return weights;
}

// The integral of (x - t) times the second derivative.
Eigen::VectorXd spline_energy_weights(const Knots& knots, double x) {
  Eigen::VectorXd weights = zeros(knots);
  const std::vector<double> places = cuts(knots, x);
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const double length = places[i + 1] - places[i], rest = x - places[i + 1];
    add_hats(knots, places[i], length * (length / 3 + rest / 2), weights);
    add_hats(knots, places[i + 1], length * (length / 6 + rest / 2), weights);
  }
  return weights;
}

Eigen::VectorXd spline_secant_weights(const Knots& knots, double x) {
  if (is_one_piece(knots, x)) return spline_tangent_weights(knots, x / 2);
  return spline_stress_weights(knots, x) / x;
}

Eigen::VectorXd spline_secant_slope_weights(const Knots& knots, double x) {
  if (!is_one_piece(knots, x)) {
    return (spline_tangent_weights(knots, x) - spline_secant_weights(knots, x)) / x;
  }
  // Half the slope of the piece that holds x, as (tangent(x) - tangent(0)) / x is it.
  Eigen::VectorXd weights = zeros(knots);
  const auto above = std::ranges::upper_bound(knots, x / 2);
  if (above == knots.begin() || above == knots.end()) return weights;
  const auto i = above - knots.begin();
  const double half = 0.5 / (*above - *(above - 1));
  weights(i - 1) = -half;
  weights(i) = half;
  return weights;
}

}  // namespace pliant
