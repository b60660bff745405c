#include "solver/bent_sheet.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include "pliant/geometry/rest_patch.h"
#include "pliant/mechanics/cloth_potentials.h"
#include "pliant/solver/static_solver.h"

namespace pliant::test {
namespace {

Eigen::Matrix3Xd on_cylinder(const TriangleMesh& mesh, const Cylinder& cylinder) {
  const Eigen::Vector2d across(std::cos(cylinder.direction), std::sin(cylinder.direction));
  const Eigen::Vector2d along(-across.y(), across.x());
  const Eigen::Vector2d centre = mesh.positions.topRows<2>().rowwise().mean();
  Eigen::Matrix3Xd x(3, mesh.vertex_count());
  for (int i = 0; i < mesh.vertex_count(); ++i) {
    const Eigen::Vector2d place = mesh.positions.col(i).head<2>() - centre;
    const double angle = cylinder.curvature * place.dot(across);
    x.col(i) << std::sin(angle) / cylinder.curvature, place.dot(along),
        (1 - std::cos(angle)) / cylinder.curvature;
  }
  return x;
}

/// A cloth on a cylinder, in equilibrium but for its rim.
class RolledCloth {
 public:
  RolledCloth(const TriangleMesh& mesh, const Material& material, const Cylinder& cylinder)
      : patch_(rest_patch(mesh, std::numeric_limits<int>::max())),
        material_(material),
        system_(on_cylinder(patch_.mesh, cylinder),
                Eigen::VectorXd::Zero(patch_.mesh.vertex_count())) {
    cloth_ = add_cloth(system_, patch_.mesh, material, {});
    for (int i = 0; i < system_.points(); ++i) {
      if (patch_.depths[static_cast<size_t>(i)] < 2) system_.coordinates().prescribe(i);
    }
    system_.finish();
    find_equilibrium();
  }

  /// Whether a vertex is out of reach of the rim, which cannot relax as the sheet would.
  bool is_deep(int vertex) const { return patch_.depths[static_cast<size_t>(vertex)] >= 4; }

  /// Mean energy per area of the triangles whose vertices are deep (J/m^2).
  double energy_density() const {
    double energy = 0, area = 0;
    for (const ShownPotential& part : cloth_.shown) energy += energy_inside(part);
    for (const auto& corners : patch_.mesh.triangles.colwise()) area += area_inside(corners);
    return energy / area;
  }

  /// Curvature of the cylinder nearest to the deep vertices, from a quadratic surface through them
  /// by least squares; good to (curvature * size)^2 / 12. It is not quite the curvature of the rim,
  /// which does not relax as the inside does and so turns it away by a fraction of about edge /
  /// size.
  double curvature() const {
    const Eigen::Matrix3Xd& x = state_.configuration.positions;
    const double size = (x.rowwise().maxCoeff() - x.rowwise().minCoeff()).maxCoeff();
    Eigen::Matrix<double, 6, 6> normal = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Vector<double, 6> right = Eigen::Vector<double, 6>::Zero();
    for (int i = 0; i < system_.points(); ++i) {
      if (!is_deep(i)) continue;
      const double across = x(0, i) / size, along = x(1, i) / size;
      Eigen::Vector<double, 6> polynomials;
      polynomials << across * across / 2, across * along, along * along / 2, across, along, 1;
      normal += polynomials * polynomials.transpose();
      right += x(2, i) * polynomials;
    }
    return normal.ldlt().solve(right)(0) / (size * size);
  }

 private:
  void find_equilibrium() {
    state_ = system_.initial_state();
    NewtonOptions options;
    // Bending alone leaves some 1e-6 N at a vertex; membranes round positions to forces.
    const double membrane = material_.components.at("stretch.weft").stiffness->value(0);
    options.tolerance = 1e-10 + 5e-14 * membrane;
    StaticSolver solver(system_, options);
    const NewtonSummary summary = solver.find_equilibrium(state_);
    EXPECT_TRUE(summary.converged)
        << summary.residual << " N left after " << summary.iterations << " iterations";
    solver.accept(state_);  // what fields show
  }

  /// Rest area of a triangle, if its corners are deep.
  double area_inside(const Eigen::Vector3i& corners) const {
    for (const int corner : corners) {
      if (!is_deep(corner)) return 0;
    }
    return rest_area(corners);
  }

  double rest_area(const Eigen::Vector3i& corners) const {
    const Eigen::Matrix3Xd& rest = patch_.mesh.positions;
    const Eigen::Vector3d a = rest.col(corners(0));
    return (rest.col(corners(1)) - a).cross(rest.col(corners(2)) - a).norm() / 2;
  }

  /// The part of a triangle or hinge that lies inside. A third of each of its two triangles is at a
  /// hinge.
  double share_inside(const Eigen::VectorXi& points) const {
    const Eigen::Vector3i first = points.head<3>();
    if (points.size() == 3) return area_inside(first) > 0 ? 1 : 0;
    const Eigen::Vector3i second(points(0), points(1), points(3));
    return (area_inside(first) + area_inside(second)) / (rest_area(first) + rest_area(second));
  }

  double energy_inside(const ShownPotential& part) const {
    const std::vector<std::string> names = part.fields->field_names();
    const Eigen::MatrixXi points = part.fields->element_points();
    const Eigen::VectorXd sizes = part.fields->element_sizes();
    const Eigen::MatrixXd strains =
        part.fields->field_values(system_.history_of(*part.potential, state_));
    double energy = 0;
    for (Eigen::Index f = 0; f < strains.rows(); ++f) {
      const std::string component = names[static_cast<size_t>(f)].substr(strlen("strain."));
      const double stiffness = material_.components.at(component).stiffness->value(0);
      for (Eigen::Index e = 0; e < strains.cols(); ++e) {
        energy +=
            share_inside(points.col(e)) * sizes(e) * stiffness / 2 * std::pow(strains(f, e), 2);
      }
    }
    return energy;
  }

  RestPatch patch_;
  const Material& material_;
  System system_;
  Cloth cloth_;
  State state_;
};

}  // namespace

double shown_stiffness(const TriangleMesh& mesh, const Material& material,
                       const Cylinder& cylinder) {
  const RolledCloth cloth(mesh, material, cylinder);
  const double curvature = cloth.curvature();
  return cloth.energy_density() / (1.5 * curvature * curvature);
}

}  // namespace pliant::test
