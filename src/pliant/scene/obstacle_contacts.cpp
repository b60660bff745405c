#include "pliant/scene/obstacle_contacts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/scene/contact_stiffness.h"
#include "pliant/scene/contact_text.h"
#include "pliant/scene/obstacle_reach.h"

namespace pliant {
namespace {

// How much nearer to the inside an edge comes than its ends: on a round body of radius r by
// l^2 / (8 r), over the edge of a box by l / sqrt(8).
double sag_over(const ObstacleShape& shape, double edge) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return edge * edge / (8 * sphere->radius);
  if (const auto* capsule = std::get_if<Capsule>(&shape)) {
    return edge * edge / (8 * capsule->radius);
  }
  return std::holds_alternative<Box>(shape) ? edge / std::sqrt(8.0) : 0;
}

void refuse_overlap(const SceneObstacle& obstacle, const TouchingCloth& cloth) {
  int inside = 0;
  double deepest = 0;
  for (const int point : cloth.points) {
    const double distance = distance_to(*obstacle.shape(), cloth.positions.col(point));
    inside += distance <= 0 ? 1 : 0;
    deepest = std::min(deepest, distance);
  }
  if (inside == 0) return;
  throw InputError(
      obstacle.where,
      fmt::format("{} of the cloth's vertices begin inside {}, the deepest {} below its "
                  "surface",
                  inside, quoted_value(obstacle.name), millimetres(-deepest)),
      "cloth that begins outside");
}

// Half of a body's least extent: what goes deeper is a rod or a corner that stands in a face.
double half_thickness(const ObstacleShape& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius / 2;
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius / 2;
  if (const auto* box = std::get_if<Box>(&shape)) return box->half.minCoeff() / 2;
  return INFINITY;
}

// A rod or a corner between the vertices, which contact would not push out again; not what cloth
// comes nearer where it lies over a body, as an earlier run may have left it.
void refuse_crossed_faces(const SceneObstacle& obstacle, const TouchingCloth& cloth) {
  constexpr double kRounding = 1e-9;                                 // m
  if (std::holds_alternative<HalfSpace>(*obstacle.shape())) return;  // its vertices tell all
  const auto is_led = [&](int point) { return std::ranges::binary_search(cloth.led, point); };
  const auto reach = reach_into(*obstacle.shape(), {}, cloth.positions, cloth.faces, is_led);
  const double draped =
      std::min(sag_over(*obstacle.shape(), cloth.longest_edge), half_thickness(*obstacle.shape()));
  if (!reach.face || reach.face->depth <= draped + kRounding) return;
  throw InputError(
      obstacle.where,
      fmt::format("{} begins in the cloth between its vertices: face {}, counted from "
                  "0 over all cloth, reaches {} below its surface",
                  quoted_value(obstacle.name), reach.face->number, millimetres(reach.face->depth)),
      "cloth that begins outside");
}

void warn_of_deep_starts(const SceneObstacle& obstacle, double thickness,
                         const TouchingCloth& cloth, std::vector<std::string>& warnings) {
  const auto deep = std::ranges::count_if(cloth.points, [&](int point) {
    return distance_to(*obstacle.shape(), cloth.positions.col(point)) < thickness / 4;
  });
  if (deep == 0) return;
  warnings.push_back(fmt::format(
      "{} vertices begin nearer to {} than a quarter of the thickness of {}: it throws them off",
      deep, quoted_value(obstacle.name), millimetres(thickness)));
}

// What is led goes where it is told to, through anything.
void warn_of_led_points(const SceneObstacle& obstacle, const TouchingCloth& cloth,
                        std::vector<std::string>& warnings) {
  const auto inside = std::ranges::count_if(cloth.led, [&](int point) {
    return distance_to(*obstacle.shape(), cloth.positions.col(point)) <= 0;
  });
  if (inside == 0) return;
  warnings.push_back(
      fmt::format("{} vertices that pins or clips hold begin inside {}, which does "
                  "not push what is held",
                  inside, quoted_value(obstacle.name)));
}

void warn_of_long_edges(const SceneObstacle& obstacle, const Scene& scene,
                        const TouchingCloth& cloth, std::vector<std::string>& warnings) {
  const double sag = sag_over(*obstacle.shape(), cloth.longest_edge);
  if (sag <= scene.contact.thickness / 2) return;
  warnings.push_back(fmt::format(
      "vertices keep off {}, faces between them may come {} nearer, which is more than half the "
      "thickness of {}: a finer mesh, or a larger thickness",
      quoted_value(obstacle.name), millimetres(sag), millimetres(scene.contact.thickness)));
}

}  // namespace

std::vector<std::shared_ptr<ObstacleContact>> obstacle_contacts(
    const Scene& scene, const TouchingCloth& cloth, std::vector<std::string>& warnings) {
  std::vector<std::shared_ptr<ObstacleContact>> contacts;
  const double per_mass = contact_stiffness_per_mass(scene.time);
  int led = 0;
  for (const SceneObstacle& obstacle : scene.obstacles) {
    if (!obstacle.shape()) continue;
    refuse_overlap(obstacle, cloth);
    refuse_crossed_faces(obstacle, cloth);
    warn_of_deep_starts(obstacle, scene.contact.thickness, cloth, warnings);
    warn_of_led_points(obstacle, cloth, warnings);
    warn_of_long_edges(obstacle, scene, cloth, warnings);
    contacts.push_back(std::make_shared<ObstacleContact>(
        *obstacle.shape(), cloth.points, per_mass * cloth.masses(cloth.points),
        scene.contact.thickness, obstacle.friction, obstacle.motion ? led++ : -1));
  }
  return contacts;
}

}  // namespace pliant
