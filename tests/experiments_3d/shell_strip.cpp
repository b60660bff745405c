#include "experiments_3d/shell_strip.h"

#include <cmath>
#include <memory>

#include "pliant/base/quantity.h"
#include "pliant/geometry/hinges.h"
#include "pliant/geometry/regular_grid.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/mechanics/element_potential.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/solver/static_path.h"

#include "support/cloth_sheet.h"

namespace pliant::test {

/// The energy of a constant stress; with moments times rest areas as sizes of its stencils, that of
/// moments that act on hinges from outside.
class FadingMoment : public ParametricDensity {
 public:
  explicit FadingMoment(double share) : share_(share) {}

  int history_size() const override { return 0; }
  void add(const Samples& samples, const StepTime&, Response& response) const override {
    response.stored -= share_ * samples.strain.col(0);
    response.stress.col(0) -= share_;
  }
  void advance(const Samples&, const StepTime&, MutableLaneView, Lane&) const override {}
  Eigen::VectorXd parameters() const override { return Eigen::VectorXd::Constant(1, share_); }
  std::unique_ptr<ParametricDensity> with_parameters(const Eigen::VectorXd& share) const override {
    return std::make_unique<FadingMoment>(share(0));
  }
  void differentiate(const Samples&, const StepTime&, int, int, int,
                     SampleDerivatives&) const override {}

 private:
  double share_;
};

namespace {

// A woven cloth: under its own weight a strip of 100 mm grows by 0.01 %.
constexpr double kMembrane = 5000, kShear = 2500;  // N/m

MaterialComponent component_of(const ComponentLaw& law) {
  if (law.friction_law == FrictionLaw::none) return component(law.stiffness);
  return component(law.stiffness,
                   DahlParameters{law.friction[0], law.friction[1], law.friction[2]});
}

}  // namespace

Material bending_all_ways(const ComponentLaw& bending, double density) {
  Material material = linear_cloth(kMembrane, kShear, 0);
  material.density = density;
  material.bending_of = "sheet";
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] = component_of(bending);
  }
  return material;
}

Material bending_along_warp(const ComponentLaw& bending, double density) {
  Material material = bending_all_ways(bending, density);
  const double k = bending.stiffness.value(0);
  material.components["bend.weft"] = component(ScalarCurve::constant(k));
  material.components["bend.diagonal"] = component(ScalarCurve::constant(1e4 * k));
  return material;
}

ShellStrip::ShellStrip(const StripGrid& grid, const Material& material, double curvature,
                       StripStart start)
    : grid_(grid),
      mesh_(regular_grid(grid.width, grid.rows * grid.cell(), grid.columns + 1, grid.rows + 1)),
      system_(bent_positions(start == StripStart::bent ? curvature : 0),
              material.density * vertex_areas(mesh_)) {
  add_cloth(system_, mesh_, material, {});
  system_.add(std::make_shared<PointForces>(0, system_.masses()));
  hold(*law_of(material, "bend.warp"), curvature, start);
  for (const int number : {0, 1}) {
    for (const int vertex : row(number)) system_.coordinates().prescribe(vertex);
  }
}

std::vector<int> ShellStrip::row(int number) const {
  std::vector<int> vertices;
  const int across = grid_.columns + 1;
  for (int i = 0; i < across; ++i) vertices.push_back(number * across + i);
  return vertices;
}

Eigen::Vector2d ShellStrip::middle(const Eigen::Matrix3Xd& positions, int number) const {
  return positions(Eigen::all, row(number)).topRows<2>().rowwise().mean();
}

// Row after row at their rest distance, turned at each by what the curvature makes of a cell: the
// hinges then have the curvature of the cylinder, and the membrane is not strained. Curvature to
// the left is away from the mesh's normals, so that its strains are positive.
Eigen::Matrix3Xd ShellStrip::bent_positions(double curvature) const {
  Eigen::Matrix3Xd positions(3, mesh_.vertex_count());
  Eigen::Vector2d at(-grid_.cell() / 2, 0);
  for (int number = 0; number < row_count(); ++number) {
    for (const int vertex : row(number)) {
      positions.col(vertex) << at, grid_.width / 2 - mesh_.positions(0, vertex);
    }
    const double angle = curvature * grid_.cell() * number;
    at += grid_.cell() * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  }
  return positions;
}

Eigen::Matrix3Xd ShellStrip::weight() const {
  return Eigen::Vector3d(0, -kStandardGravity, 0) * system_.masses().transpose();
}

// Per width (N), of what hangs beyond a row about it.
double ShellStrip::hanging_moment(const Eigen::Matrix3Xd& positions, int number) const {
  const Eigen::Matrix3Xd forces = weight();
  double moment = 0;
  for (int beyond = number + 1; beyond < row_count(); ++beyond) {
    const double lever = middle(positions, beyond).x() - middle(positions, number).x();
    moment += lever * forces(1, row(beyond)).sum();
  }
  return moment / grid_.width;
}

// The moments of the bent cloth, less those of the weight, on all hinges across the strip. A sheet
// that relaxes takes the moment m by its hinges across and m/2 by those of its squares' diagonals,
// which vertices out of the cylinder bend the other way: moments that do not push them there.
void ShellStrip::hold(const ComponentLaw& law, double curvature, StripStart start) {
  const double strain = kStrainPerCurvature * curvature;
  const double bent = law.elastic_stress(strain) + law.friction_stress(strain, {}).stress;
  const double of_diagonals = start == StripStart::flat ? 0.5 : 0;
  const auto share = [=](const Hinge& hinge) {
    return hinge.rest_edge.y() == 0 ? 1.0 : of_diagonals;
  };
  add_moments([&](const Hinge& hinge) { return share(hinge) * bent; });
  const Eigen::Matrix3Xd positions = bent_positions(curvature);
  add_moments([&](const Hinge& hinge) {
    const int number = hinge.vertices[0] / (grid_.columns + 1);
    return -share(hinge) * hanging_moment(positions, number);
  });
}

void ShellStrip::add_moments(const std::function<double(const Hinge&)>& moment) {
  Stencils<DiscreteShells> stencils;
  for (const Hinge& hinge : find_hinges(mesh_)) {
    if (hinge.rest_edge.x() == 0) continue;  // along the strip
    stencils.add(hinge.vertices, {0, hinge.height, 0}, moment(hinge) * hinge.area);
  }
  const std::vector<int> place = system_.add_parameters({"share"}, Eigen::VectorXd::Zero(1));
  system_.add(std::make_shared<ElementPotential<DiscreteShells>>(
      stencils, std::make_shared<FadingMoment>(0), place));
}

std::vector<double> ShellStrip::places() const {
  std::vector<double> places;
  for (int number = 1; number < row_count(); ++number) {
    places.push_back((number - 0.5) * grid_.cell());
  }
  return places;
}

std::vector<Eigen::Vector2d> ShellStrip::released(int steps) {
  return rolled_and_released(0, steps);
}

std::vector<Eigen::Vector2d> ShellStrip::rolled_and_released(int steps_rolled, int steps) {
  return follow(steps_rolled + steps, [=](int step) {
    if (step <= steps_rolled) return Loads{static_cast<double>(step) / steps_rolled, 0, 0};
    const double left = 1 - static_cast<double>(step - steps_rolled) / steps;
    return Loads{left, left, 1};
  });
}

std::vector<Eigen::Vector2d> ShellStrip::loaded(int steps) {
  return follow(steps, [=](int step) { return Loads{0, 0, static_cast<double>(step) / steps}; });
}

std::vector<Eigen::Vector2d> ShellStrip::follow(int steps, const std::function<Loads(int)>& loads) {
  system_.finish();
  const std::vector<double>& given = system_.parameters().values;
  Eigen::VectorXd values = Eigen::Map<const Eigen::VectorXd>(given.data(), std::ssize(given));
  StaticPathOptions options;
  options.newton.tolerance = 1e-9;       // N; a vertex weighs some 1e-6 N, rounding leaves 1e-10
  options.newton.max_iterations = 2000;  // a strip that swings down is far from where it was
  State state = system_.initial_state();
  for (int step = 1; step <= steps; ++step) {
    const Loads now = loads(step);
    values.tail<2>() << now.rolling, now.carrying;
    options.parameters = system_.with(values);
    options.schedule = [&](double) {
      Controls controls;
      controls.vectors = Eigen::Vector3d(0, -now.weight * kStandardGravity, 0);
      return controls;
    };
    StaticPath path(system_, options, state);
    path.step(step);
    state = path.state();
  }
  std::vector<Eigen::Vector2d> points;
  for (int number = 1; number < row_count(); ++number) {
    points.push_back(middle(state.configuration.positions, number));
  }
  return points;
}

}  // namespace pliant::test
