#include "pliant/math/hermite_energy.h"

#include <algorithm>
#include <cmath>

namespace pliant {
namespace {

using Knots = std::vector<double>;
using Weights = Eigen::VectorXd;

// The second derivative between two distances from rest, linear: its weights at both ends.
struct Piece {
  double from = 0, to = 0;
  Weights first, last;

  Weights at(double distance) const {
    const double share = (distance - from) / (to - from);
    return (1 - share) * first + share * last;
  }
};

// Points of one side of rest by their distance from it, rest itself first, and the weights of the
// energy there.
struct Side {
  std::vector<double> distance{0};
  std::vector<Weights> value;
};

Side side_of(const Knots& knots, bool positive) {
  const auto count = std::ssize(knots);
  Side side;
  side.value.push_back(Weights::Zero(count));
  for (Eigen::Index i = 0; i < count; ++i) {
    const Eigen::Index k = positive ? i : count - 1 - i;
    const double knot = knots[static_cast<std::size_t>(k)];
    if ((knot > 0) != positive) continue;
    side.distance.push_back(std::abs(knot));
    side.value.push_back(Weights::Unit(count, k));
  }
  return side;
}

// Slopes at the points of a side, which has one beside rest at least: none at rest.
std::vector<Weights> slopes_of(const Side& side) {
  const std::size_t last = side.distance.size() - 1;
  const auto length = [&](std::size_t i) { return side.distance[i + 1] - side.distance[i]; };
  const auto chord = [&](std::size_t i) -> Weights {
    return (side.value[i + 1] - side.value[i]) / length(i);
  };
  std::vector<Weights> slopes{side.value.front()};
  for (std::size_t i = 1; i < last; ++i) {
    const double before = length(i - 1), after = length(i);
    slopes.emplace_back((after * chord(i - 1) + before * chord(i)) / (before + after));
  }
  if (last == 1) {
    slopes.emplace_back(2 * chord(0));
  } else {
    const double share = length(last - 1) / (length(last - 2) + length(last - 1));
    slopes.emplace_back((1 + share) * chord(last - 1) - share * chord(last - 2));
  }
  return slopes;
}

std::vector<Piece> pieces_of(const Knots& knots, bool positive) {
  const Side side = side_of(knots, positive);
  if (side.distance.size() < 2) return {};
  const std::vector<Weights> slopes = slopes_of(side);
  std::vector<Piece> pieces;
  for (std::size_t i = 0; i + 1 < slopes.size(); ++i) {
    const double length = side.distance[i + 1] - side.distance[i];
    const Weights chord = (side.value[i + 1] - side.value[i]) / length;
    pieces.push_back({side.distance[i], side.distance[i + 1],
                      (6 * chord - 4 * slopes[i] - 2 * slopes[i + 1]) / length,
                      (2 * slopes[i] + 4 * slopes[i + 1] - 6 * chord) / length});
  }
  return pieces;
}

// The side of a strain; one without points goes on from the other.
std::vector<Piece> pieces_at(const Knots& knots, double x) {
  std::vector<Piece> pieces = pieces_of(knots, x >= 0);
  if (!pieces.empty()) return pieces;
  const Weights at_rest = pieces_of(knots, x < 0).front().first;
  return {{0, 1, at_rest, at_rest}};
}

// The same with the last piece going on to a distance beyond it.
std::vector<Piece> pieces_to(const Knots& knots, double x) {
  std::vector<Piece> pieces = pieces_at(knots, x);
  const double distance = std::abs(x);
  while (pieces.size() > 1 && pieces.back().from >= distance) pieces.pop_back();
  Piece& last = pieces.back();
  if (distance <= last.to) {
    last.last = last.at(distance);
    last.to = distance;
  } else {
    pieces.push_back({last.to, distance, last.last, last.last});
  }
  return pieces;
}

}  // namespace

Weights hermite_energy_tangent_weights(const Knots& knots, double x) {
  if (x == 0) return pieces_at(knots, x).front().first;
  return pieces_to(knots, x).back().last;
}

Weights hermite_energy_stress_weights(const Knots& knots, double x) {
  Weights weights = Weights::Zero(std::ssize(knots));
  if (x == 0) return weights;
  for (const Piece& piece : pieces_to(knots, x)) {
    weights += (piece.to - piece.from) / 2 * (piece.first + piece.last);
  }
  return x < 0 ? Weights(-weights) : weights;
}

// The integral of (distance - s) times the second derivative.
Weights hermite_energy_weights(const Knots& knots, double x) {
  Weights weights = Weights::Zero(std::ssize(knots));
  if (x == 0) return weights;
  for (const Piece& piece : pieces_to(knots, x)) {
    const double length = piece.to - piece.from, rest = std::abs(x) - piece.to;
    weights += length * (length / 3 + rest / 2) * piece.first;
    weights += length * (length / 6 + rest / 2) * piece.last;
  }
  return weights;
}

Weights hermite_energy_secant_weights(const Knots& knots, double x) {
  const Piece first = pieces_at(knots, x).front();
  if (std::abs(x) <= first.to) return first.at(std::abs(x) / 2);
  return hermite_energy_stress_weights(knots, x) / x;
}

Weights hermite_energy_secant_slope_weights(const Knots& knots, double x) {
  const Piece first = pieces_at(knots, x).front();
  if (std::abs(x) <= first.to) {
    return (x < 0 ? -0.5 : 0.5) / (first.to - first.from) * (first.last - first.first);
  }
  return (hermite_energy_tangent_weights(knots, x) - hermite_energy_secant_weights(knots, x)) / x;
}

Eigen::MatrixXd hermite_energy_curvatures(const Knots& knots) {
  std::vector<Weights> rows;
  for (const bool positive : {false, true}) {
    for (const Piece& piece : pieces_of(knots, positive)) {
      rows.push_back(piece.first);
      rows.push_back(piece.last);
    }
  }
  Eigen::MatrixXd curvatures(std::ssize(rows), std::ssize(knots));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    curvatures.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  }
  return curvatures;
}

}  // namespace pliant
