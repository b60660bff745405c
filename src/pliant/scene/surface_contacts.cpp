#include "pliant/scene/surface_contacts.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/scene/contact_stiffness.h"
#include "pliant/scene/contact_text.h"

namespace pliant {
namespace {

// So that cloth pulled taut over cloth does not come much nearer than half the thickness.
constexpr double kShareOfResistance = 0.1;

void refuse_thickness(const SceneContact& contact, double shortest_edge) {
  if (contact.thickness < shortest_edge / 2) return;
  Location where = contact.where;
  where.field = "contact.thickness";
  throw InputError(where,
                   fmt::format("{} would push neighbours in the cloth off each other",
                               millimetres(contact.thickness)),
                   fmt::format("less than half the shortest edge, which is {} long",
                               millimetres(shortest_edge)));
}

void refuse_crossings(const Scene& scene, const SceneSurfaces& surfaces) {
  auto crossings = scene_crossings(surfaces.positions, surfaces.faces, surfaces.bodies);
  if (!crossings) return;
  if (!crossings->of_bodies.empty()) {
    crossings->of_cloth.clear();
    const std::string& name = crossings->of_bodies.front().name;
    const auto obstacle = std::ranges::find(scene.obstacles, name, &SceneObstacle::name);
    throw InputError(obstacle->where, "cloth begins passing through it: " + crossings->text(),
                     "cloth that begins clear of what it meets");
  }
  if (!scene.contact.friction || crossings->of_cloth.empty()) return;
  throw InputError(scene.contact.where, "cloth begins passing through cloth: " + crossings->text(),
                   "cloth that begins clear of itself, or no `friction` of cloth on cloth");
}

ContactSurface::Faces faces_of(const Scene& scene, const SceneSurfaces& surfaces) {
  Eigen::Index count = 0;
  for (const BodyPiece& piece : surfaces.bodies) count += piece.body->triangles().cols();
  Eigen::Matrix3Xi bodies(3, count);
  Eigen::Index next = 0;
  for (const BodyPiece& piece : surfaces.bodies) {
    const Eigen::Matrix3Xi triangles = piece.triangles();
    bodies.middleCols(next, triangles.cols()) = triangles;
    next += triangles.cols();
  }
  return {surfaces.faces, bodies, scene.contact.friction.has_value()};
}

SurfaceContactLaw law_of(const Scene& scene, const SceneSurfaces& surfaces) {
  SurfaceContactLaw law{scene.contact.thickness, scene.contact.friction.value_or(0)};
  for (const BodyPiece& piece : surfaces.bodies) {
    const auto obstacle = std::ranges::find(scene.obstacles, piece.name, &SceneObstacle::name);
    law.bodies.push_back({piece.first_point, obstacle->friction.sliding});
  }
  return law;
}

// Of all points before those of bodies.
Eigen::VectorXd stiffness_of(const Scene& scene, const SceneSurfaces& surfaces) {
  const Eigen::Index count =
      surfaces.bodies.empty() ? surfaces.masses.size() : surfaces.bodies.front().first_point;
  return contact_stiffness_per_mass(scene.time) * surfaces.masses.head(count) +
         kShareOfResistance * surfaces.resistance.head(count);
}

}  // namespace

std::shared_ptr<SurfaceContact> surface_contact(const Scene& scene, const SceneSurfaces& surfaces,
                                                std::vector<std::string>& warnings) {
  if (!scene.contact.friction && surfaces.bodies.empty()) return nullptr;
  if (scene.contact.friction) refuse_thickness(scene.contact, surfaces.shortest_edge);
  refuse_crossings(scene, surfaces);
  const SurfaceContactLaw law = law_of(scene, surfaces);
  auto contact = std::make_shared<SurfaceContact>(
      std::make_shared<const ContactSurface>(surfaces.positions, faces_of(scene, surfaces),
                                             surfaces.moves),
      surfaces.positions, stiffness_of(scene, surfaces), law);
  Touching touching;
  for (const Touching& met : contact->touching(surfaces.positions)) {
    touching.count += met.count;
    touching.least_distance = std::min(touching.least_distance, met.least_distance);
  }
  if (touching.count > 0) {
    warnings.push_back(fmt::format(
        "{} pairs of parts of {} begin nearer to each other than the thickness of {}, the "
        "nearest at {}: they push each other off",
        touching.count, surfaces.bodies.empty() ? "the cloth" : "the cloth and bodies",
        millimetres(law.thickness), millimetres(touching.least_distance)));
  }
  return contact;
}

}  // namespace pliant
