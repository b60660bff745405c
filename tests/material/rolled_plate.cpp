#include "material/rolled_plate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <gtest/gtest.h>

#include "pliant/geometry/rest_patch.h"
#include "pliant/material/bending_strain.h"

namespace pliant::test {
namespace {

/// What a law remembers, and the energy that it stores.
struct LawPoint {
  FrictionState last;
  double stored = 0;
  std::vector<Eigen::VectorXd> histories = {};  // of addends, where there are any

  struct Answer {
    double stress, slope, stored, work;  // the work of a step: what it takes and what it stores
  };
  Answer at(const ComponentLaw& law, double strain) const {
    Answer answer{law.elastic_stress(strain), law.elastic_tangent(strain),
                  law.elastic_energy(strain), -stored};
    for (size_t i = 0; i < law.addends.size(); ++i) {
      const Addend& addend = law.addends[i];
      if (addend.is_elastic()) continue;
      const Addend::Answer own = addend.at(strain, last.strain, history(addend, i));
      answer.stress += own.stress;
      answer.slope += own.tangent;
      answer.stored += own.stored;
      answer.work += own.work;
    }
    answer.work += answer.stored;
    if (law.friction_law == FrictionLaw::none) return answer;
    const DahlParameters dahl{law.friction[0], law.friction[1], law.friction[2]};
    const FrictionStress friction = friction_stress(dahl, strain, last);
    answer.stress += friction.stress;
    answer.slope += friction.slope;
    answer.work += friction_work({dahl, dahl}, strain, last);
    return answer;
  }
  void advance(const ComponentLaw& law, double strain) {
    stored = at(law, strain).stored;
    std::vector<Eigen::VectorXd> next;
    for (size_t i = 0; i < law.addends.size(); ++i) {
      next.push_back(law.addends[i].advanced(strain, last.strain, history(law.addends[i], i)));
    }
    histories = std::move(next);
    last = {strain, law.friction_stress(strain, last).stress};
  }

 private:
  Eigen::VectorXd history(const Addend& addend, size_t place) const {
    return histories.empty() ? Eigen::VectorXd::Zero(addend.history_size()) : histories[place];
  }
};

/// Slope of the heights of a triangle, by the heights of its corners.
Eigen::Matrix<double, 2, 3> slope(const Eigen::Matrix<double, 2, 3>& corners) {
  Eigen::Matrix3d plane;
  plane << corners.transpose(), Eigen::Vector3d::Ones();
  return plane.inverse().topRows<2>();
}

}  // namespace

void RolledPlate::add_hinges(const TriangleMesh& mesh, const std::vector<int>& unknown_of_vertex,
                             const std::vector<double>& shown_of_triangle) {
  const std::vector<Hinge> hinges = find_hinges(mesh);
  const std::vector<BendingVector> weights = bending_weights(hinges, bending_rule(mesh));
  double shown_area = 0;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    shown_area += shown_of_triangle[static_cast<size_t>(t)] * rest_area(mesh, t);
  }
  for (size_t i = 0; i < hinges.size(); ++i) {
    const Hinge& hinge = hinges[i];
    PlateHinge plate{weights[i], hinge.area, 0, Eigen::RowVector3d::Zero(), {}};
    const Eigen::Vector2d along = hinge.rest_edge.normalized();
    const Eigen::Vector2d middle =
        (mesh.positions.col(hinge.vertices[0]) + mesh.positions.col(hinge.vertices[1])).head<2>() /
        2;
    Eigen::Vector2d across(-along.y(), along.x());
    if (across.dot(mesh.positions.col(hinge.vertices[3]).head<2>() - middle) < 0) across = -across;
    for (int side = 0; side < 2; ++side) {
      const int t = hinge.triangles[static_cast<size_t>(side)];
      plate.shown += shown_of_triangle[static_cast<size_t>(t)] * rest_area(mesh, t) / shown_area;
      const Eigen::Vector3i corners = mesh.triangles.col(t);
      const Eigen::Matrix<double, 2, 3> at = mesh.positions(Eigen::all, corners).topRows<2>();
      const Eigen::RowVector3d bend =
          (side == 0 ? -1 : 1) * across.transpose() * slope(at) / hinge.height;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector2d x = at.col(k) - middle;
        plate.by_curvature +=
            bend(k) * Eigen::RowVector3d(x.x() * x.x() / 2, x.y() * x.y() / 2, x.x() * x.y());
        const int unknown = unknown_of_vertex[static_cast<size_t>(corners(k))];
        if (unknown >= 0) plate.by_unknown.emplace_back(unknown, bend(k));
      }
    }
    hinges_.push_back(plate);
  }
}

RolledPlate RolledPlate::periodic(Diagonals diagonals) {
  constexpr int kCells = 6, kFirst = 2, kPeriod = 2;
  RolledPlate plate;
  const TriangleMesh mesh = regular_grid(kCells, kCells, kCells + 1, kCells + 1, diagonals);
  std::vector<int> unknowns;
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const int u = i % (kCells + 1), v = i / (kCells + 1);
    unknowns.push_back(u % kPeriod + kPeriod * (v % kPeriod) - 1);  // one of four is held
  }
  std::vector<double> shown;
  for (int t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector2d middle = mesh.rest_triangle(t).rowwise().mean();
    const auto inside = [&](double x) { return x > kFirst && x < kFirst + kPeriod; };
    shown.push_back(inside(middle.x()) && inside(middle.y()) ? 1 : 0);
  }
  plate.add_hinges(mesh, unknowns, shown);
  plate.unknowns_ = kPeriod * kPeriod - 1;
  // What repeats is all there is: hinges count with what they have inside.
  for (PlateHinge& hinge : plate.hinges_) hinge.area = hinge.shown;
  std::erase_if(plate.hinges_, [](const PlateHinge& hinge) { return hinge.shown == 0; });
  return plate;
}

RolledPlate RolledPlate::piece(const TriangleMesh& mesh) {
  constexpr int kHeld = 1, kInside = 4;  // rings of vertices from the rim
  RolledPlate plate;
  const RestPatch patch = rest_patch(mesh, std::numeric_limits<int>::max());
  std::vector<int> unknowns;
  for (const int depth : patch.depths) {
    unknowns.push_back(depth > kHeld ? plate.unknowns_++ : -1);
  }
  std::vector<double> shown;
  for (const auto& corners : patch.mesh.triangles.colwise()) {
    const bool inside = std::ranges::all_of(
        corners, [&](int vertex) { return patch.depths[static_cast<size_t>(vertex)] >= kInside; });
    shown.push_back(inside ? 1 : 0);
  }
  plate.add_hinges(patch.mesh, unknowns, shown);
  return plate;
}

/// The plate at some moment of a loop.
class RolledPlate::Rolling {
 public:
  Rolling(const RolledPlate& plate, const HingeLaws& laws, const Eigen::Vector3d& direction)
      : plate_(plate),
        laws_(laws),
        direction_(direction),
        points_(plate.hinges_.size()),
        heights_(Eigen::VectorXd::Zero(plate.unknowns_)) {}

  /// Energy and work of the step to a curvature, shown inside (J/m^2).
  double step(double curvature) {
    curvature_ = curvature;
    relax();
    double work = 0;
    for_each_law([&](size_t h, size_t c, double part, double strain) {
      const ComponentLaw& law = laws_[c];
      work += plate_.hinges_[h].shown * part / 3 * points_[h][c].at(law, strain).work;
      points_[h][c].advance(law, strain);
    });
    return work;
  }

  double stored() const {
    double energy = 0;
    for_each_law([&](size_t h, size_t c, double part, double strain) {
      energy += plate_.hinges_[h].shown * part / 3 * points_[h][c].at(laws_[c], strain).stored;
    });
    return energy;
  }

  /// The sum of both principal curvatures inside: the flux of the slope out of it.
  double mean_curvature() const {
    double sum = 0;
    for (const PlateHinge& hinge : plate_.hinges_) sum += hinge.shown * bend(hinge);
    return sum;
  }

 private:
  double bend(const PlateHinge& hinge) const {
    double sum = curvature_ * hinge.by_curvature.dot(direction_);
    for (const auto& [unknown, by] : hinge.by_unknown) sum += by * heights_(unknown);
    return sum;
  }

  template <class Visit>
  void for_each_law(const Visit& visit) const {
    for (size_t h = 0; h < points_.size(); ++h) {
      const double strain = kStrainPerCurvature * bend(plate_.hinges_[h]);
      for (size_t c = 0; c < laws_.size(); ++c) {
        const double part = plate_.hinges_[h].parts(static_cast<Eigen::Index>(c));
        if (part > 0) visit(h, c, part, strain);
      }
    }
  }

  double energy() const {
    double sum = 0;
    for_each_law([&](size_t h, size_t c, double part, double strain) {
      sum += plate_.hinges_[h].area * part * points_[h][c].at(laws_[c], strain).work;
    });
    return sum;
  }

  /// The direction in which the energy falls: Newton's, with slopes kept above a share of the
  /// stiffness at rest where friction falls faster than elasticity grows.
  Eigen::VectorXd descent(Eigen::VectorXd& gradient) const {
    constexpr double kLeastSlope = 0.05;
    gradient.setZero(plate_.unknowns_);
    std::vector<Eigen::Triplet<double>> entries;
    for_each_law([&](size_t h, size_t c, double part, double strain) {
      const PlateHinge& hinge = plate_.hinges_[h];
      const LawPoint::Answer answer = points_[h][c].at(laws_[c], strain);
      const double size = kStrainPerCurvature * hinge.area * part;
      const double least = kLeastSlope * laws_[c].stiffness_at_rest();
      const double slope = kStrainPerCurvature * size * std::max(answer.slope, least);
      for (const auto& [row, by_row] : hinge.by_unknown) {
        gradient(row) += size * answer.stress * by_row;
        for (const auto& [column, by_column] : hinge.by_unknown) {
          if (row >= column) entries.emplace_back(row, column, slope * by_row * by_column);
        }
      }
    });
    Eigen::SparseMatrix<double> matrix(plate_.unknowns_, plate_.unknowns_);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(matrix);
    return -factor.solve(gradient);
  }

  void relax() {
    constexpr int kMaxIterations = 60;
    constexpr double kTolerance = 1e-8, kLeastStep = 1e-6;
    Eigen::VectorXd gradient;
    double now = energy();
    for (int i = 0; i < kMaxIterations; ++i) {
      const Eigen::VectorXd way = descent(gradient);
      const double gain = -gradient.dot(way);
      if (gain <= kTolerance * std::abs(now)) return;
      const Eigen::VectorXd start = heights_;
      double length = 1, next = 0;
      do {
        heights_ = start + length * way;
        next = energy();
        length /= 2;
      } while (next > now && length > kLeastStep);
      if (next > now) {
        heights_ = start;
        return;
      }
      now = next;
    }
    ADD_FAILURE() << "no equilibrium at curvature " << curvature_;
  }

  const RolledPlate& plate_;
  const HingeLaws& laws_;
  Eigen::Vector3d direction_;
  std::vector<std::array<LawPoint, 3>> points_;
  Eigen::VectorXd heights_;
  double curvature_ = 0;
};

Loop RolledPlate::roll(const HingeLaws& laws, double curvature, double direction, int steps) const {
  const double angle = direction * std::numbers::pi / 180;
  const double u = std::cos(angle), v = std::sin(angle);
  Rolling rolling(*this, laws, {u * u, v * v, u * v});
  for (int i = 1; 2 * i <= steps; ++i) rolling.step(2.0 * i / steps * curvature);
  Loop loop{rolling.stored(), rolling.mean_curvature()};
  for (int i = 1; i <= steps; ++i) loop.loss += rolling.step((1 - 2.0 * i / steps) * curvature);
  for (int i = 1; i <= steps; ++i) loop.loss += rolling.step((2.0 * i / steps - 1) * curvature);
  loop.loss -= rolling.stored();
  return loop;
}

double loop_loss(const ComponentLaw& law, const Loop& loop) {
  const double strain = kStrainPerCurvature * loop.curvature;
  LawPoint point;
  double loss = 0;
  point.advance(law, strain);
  for (const double to : {-strain, strain}) {
    loss += point.at(law, to).work / kStrainPerCurvature;
    point.advance(law, to);
  }
  return loss;
}

}  // namespace pliant::test
