#include "pliant/experiment/press/pressed_body.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/geometry/surface_nodes.h"

namespace pliant {
namespace {

constexpr double kThickness = 2e-4;  // of an edge
constexpr double kFading = 0.02;     // of an edge
constexpr double kTolerance = 1e-8;  // of stiffness times an edge's square
constexpr double kCoarser = 100;     // at limits, which multiply the rounding of forces

ObstacleShape indenter_of(const PressSetup& setup, double thickness) {
  const std::optional<double> touch = first_touch(setup);
  PLIANT_ASSERT(touch, "the indenter meets the body");
  const Eigen::Vector3d way = *touch * setup.direction;
  if (setup.radius) return Sphere{setup.through + way, *setup.radius - thickness};
  return HalfSpace{way - thickness * setup.direction, setup.direction};
}

bool has_history(const std::shared_ptr<const ParametricDensity>& law) {
  return law && law->history_size() > 0;
}

}  // namespace

std::vector<int> nodes_to_touch(const PressSetup& setup) {
  std::vector<int> nodes = surface_nodes(setup.mesh);
  std::erase_if(nodes, [&](int node) { return std::ranges::binary_search(setup.held, node); });
  return nodes;
}

double area_to_touch(const PressSetup& setup) {
  const Eigen::VectorXd areas =
      node_areas(setup.mesh.positions, boundary_surface(setup.mesh).triangles);
  return areas(nodes_to_touch(setup)).sum();
}

std::optional<double> first_touch(const PressSetup& setup) {
  std::optional<double> first;
  for (const int node : nodes_to_touch(setup)) {
    const Eigen::Vector3d place = setup.mesh.positions.col(node) - setup.through;
    double along = place.dot(setup.direction);
    if (setup.radius) {
      const double beside = (place - along * setup.direction).norm();
      if (beside >= *setup.radius) continue;
      along -= std::sqrt(*setup.radius * *setup.radius - beside * beside);
    } else {
      along = setup.mesh.positions.col(node).dot(setup.direction);
    }
    first = std::min(first.value_or(along), along);
  }
  return first;
}

PressedBody::PressedBody(const PressSetup& setup, const SolidLaw& law, double pressure)
    : setup_(setup),
      triangles_(boundary_surface(setup.mesh).triangles),
      remembers_(has_history(law.of_points) || has_history(law.of_volume)),
      edge_(mean_surface_edge(setup.mesh)),
      thickness_(kThickness * edge_),
      fading_(kFading * edge_),
      tolerance_(kTolerance * stiffness_at_rest(law).cwiseAbs().maxCoeff() * edge_ * edge_),
      indenter_(indenter_of(setup, thickness_)),
      system_(setup.mesh.positions, Eigen::VectorXd::Zero(setup.mesh.node_count())) {
  for (const int node : setup.held) system_.coordinates().prescribe(node);
  add_solid(system_, setup.mesh, law);
  const std::vector<int> nodes = nodes_to_touch(setup);
  const Eigen::VectorXd areas = node_areas(setup.mesh.positions, triangles_);
  contact_ =
      std::make_shared<ObstacleContact>(indenter_, nodes, pressure / thickness_ * areas(nodes),
                                        thickness_, CoulombFriction{}, /*body=*/0);
  system_.add(contact_);
  system_.finish();
  if (system_.is_limited()) tolerance_ *= kCoarser;
}

Controls PressedBody::controls(double travel) const {
  Controls controls;
  controls.bodies.push_back({Eigen::Quaterniond::Identity(), travel * setup_.direction});
  return controls;
}

SmoothedArea PressedBody::area(const Eigen::Matrix3Xd& positions, double travel) const {
  return touching_area(positions, triangles_, indenter_, controls(travel).body(0), setup_.direction,
                       thickness_, fading_);
}

double PressedBody::force(const Evaluation& at) const {
  Eigen::Matrix3Xd gradient = Eigen::Matrix3Xd::Zero(3, at.configuration.positions.cols());
  Derivatives derivatives;
  derivatives.gradient = &gradient;
  contact_->evaluate(at, derivatives);
  return -setup_.direction.dot(gradient.rowwise().sum());
}

}  // namespace pliant
