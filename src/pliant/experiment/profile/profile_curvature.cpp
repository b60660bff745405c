#include "pliant/experiment/profile/profile_curvature.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "pliant/solver/elastica/strip_profile.h"

namespace pliant {
namespace {

constexpr int kPointsPerPiece = 20, kMostPieces = 3;
constexpr int kElements = 16;  // of the line that the curvature bends
constexpr int kMostRounds = 20;
constexpr double kSettled = 1e-9;  // rad
// Wiggles that move the points less than this, beside what moves them most, are noise.
constexpr double kUnseen = 3e-3;
constexpr double kExact = 1e-9;  // m: nearer needs no explanation

// Angles between the lines from point to point, at the points (rad).
std::vector<double> turns_of(const ProfileRows& profile) {
  const auto& points = profile.points;
  std::vector<double> turns(points.size());
  for (size_t i = 1; i + 1 < points.size(); ++i) {
    const Eigen::Vector2d before = points[i] - points[i - 1], after = points[i + 1] - points[i];
    turns[i] = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
  }
  turns.front() = turns[1];
  turns.back() = turns[turns.size() - 2];
  return turns;
}

// Distances of the points along the line.
std::vector<double> places_of(const ProfileRows& profile, const std::vector<double>& turns) {
  std::vector<double> places{0};
  for (size_t i = 1; i < turns.size(); ++i) {
    const double half = (turns[i] + turns[i - 1]) / 4;
    const double chord = (profile.points[i] - profile.points[i - 1]).norm();
    places.push_back(places.back() + chord * (half == 0 ? 1 : half / std::sin(half)));
  }
  return places;
}

// The curvature whose angles come nearest to those of the lines between the points.
Eigen::VectorXd by_angles(const GaussLine& pieces, const ProfileRows& profile,
                          const std::vector<double>& turns, const std::vector<double>& places) {
  const auto lines = static_cast<Eigen::Index>(places.size()) - 1;
  Eigen::MatrixXd turning(lines, pieces.size());
  Eigen::VectorXd angles(lines);
  const Eigen::Vector2d first = profile.points[1] - profile.points[0];
  double angle = std::atan2(first.y(), first.x());
  for (Eigen::Index i = 0; i < lines; ++i) {
    const auto k = static_cast<size_t>(i);
    if (i > 0) angle += turns[k];
    angles(i) = angle;
    turning.row(i) = pieces.integral_weights((places[k] + places[k + 1]) / 2);
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kUnseen);
  return solver.compute(turning).solve(angles);
}

// How far the points are from where a line passes at their places.
Eigen::VectorXd distances(const ProfileRows& profile, const StripProfile& line,
                          const std::vector<double>& places) {
  Eigen::VectorXd result(2 * static_cast<Eigen::Index>(places.size()));
  for (size_t i = 0; i < places.size(); ++i) {
    result.segment<2>(2 * static_cast<Eigen::Index>(i)) =
        profile.points[i] - line.at(places[i]).position;
  }
  return result;
}

Eigen::VectorXd step_towards(const Eigen::VectorXd& beyond, const StripProfile& line,
                             const std::vector<double>& places, Eigen::Index unknowns) {
  Eigen::MatrixXd by_curvature(beyond.size(), unknowns);
  for (size_t i = 0; i < places.size(); ++i) {
    by_curvature.middleRows<2>(2 * static_cast<Eigen::Index>(i)) =
        line.position_by_parameter(places[i]);
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(kUnseen);
  return solver.compute(by_curvature).solve(beyond);
}

double largest_turn(const GaussLine& line, const Eigen::VectorXd& curvature) {
  return line.integrals(curvature).cwiseAbs().maxCoeff();
}

/// A line of some pieces fitted to the points of a profile.
class FittedLine {
 public:
  FittedLine(const ProfileRows& profile, double length, int pieces)
      : profile_(&profile),
        pieces_(length, pieces),
        line_(length, kElements),
        shapes_(line_.size(), pieces_.size()) {
    for (int i = 0; i < line_.size(); ++i) {
      shapes_.row(i) = pieces_.value_weights(line_.places()(i));
    }
    const std::vector<double> turns = turns_of(profile);
    places_ = places_of(profile, turns);
    for (double& place : places_) place *= length / places_.back();
    curvature_ = by_angles(pieces_, profile, turns, places_);
    approach();
  }

  std::vector<double> curvature() const {
    std::vector<double> result;
    for (const double place : places_) {
      result.push_back(pieces_.value_weights(place) * curvature_);
    }
    return result;
  }

  /// Bayesian information criterion: what further pieces explain is worth them where it falls.
  double criterion() const {
    const auto rows = static_cast<double>(2 * (places_.size() - 1));
    return rows * std::log(std::max(beyond_.squaredNorm() / rows, kExact * kExact)) +
           static_cast<double>(pieces_.size()) * std::log(rows);
  }

 private:
  StripProfile bent(const Eigen::VectorXd& by) const {
    return StripProfile(line_, 0, shapes_ * by, shapes_);
  }

  // Gauss and Newton's method, its steps halved until the points come nearer.
  void approach() {
    beyond_ = distances(*profile_, bent(curvature_), places_);
    for (int round = 0; round < kMostRounds; ++round) {
      Eigen::VectorXd step = step_towards(beyond_, bent(curvature_), places_, pieces_.size());
      Eigen::VectorXd there = distances(*profile_, bent(curvature_ + step), places_);
      while (there.norm() >= beyond_.norm() && largest_turn(pieces_, step) > kSettled) {
        step /= 2;
        there = distances(*profile_, bent(curvature_ + step), places_);
      }
      if (largest_turn(pieces_, step) <= kSettled) break;
      curvature_ += step;
      beyond_ = there;
    }
  }

  const ProfileRows* profile_;
  GaussLine pieces_, line_;
  Eigen::MatrixXd shapes_;  // of the line, by the values of the pieces
  std::vector<double> places_;
  Eigen::VectorXd curvature_, beyond_;
};

}  // namespace

double arc_length(const ProfileRows& profile) {
  return places_of(profile, turns_of(profile)).back();
}

std::vector<double> profile_curvature(const ProfileRows& profile, double length) {
  const auto count = static_cast<int>(profile.points.size());
  const int most = std::clamp(count / kPointsPerPiece, 1, kMostPieces);
  FittedLine best(profile, length, 1);
  for (int pieces = 2; pieces <= most; ++pieces) {
    const FittedLine finer(profile, length, pieces);
    if (finer.criterion() < best.criterion()) best = finer;
  }
  return best.curvature();
}

}  // namespace pliant
