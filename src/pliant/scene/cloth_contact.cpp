#include "pliant/scene/cloth_contact.h"

#include <fmt/format.h>

#include "pliant/geometry/crossings.h"
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

void refuse_crossings(const SceneContact& contact, const ClothSurface& cloth) {
  const auto pairs = crossing_triangles(cloth.positions, cloth.faces);
  if (!pairs || pairs->empty()) return;
  throw InputError(contact.where,
                   fmt::format("cloth begins passing through cloth: {} pairs of faces, the first "
                               "of them {} and {}, counted from 0 over all cloth",
                               pairs->size(), pairs->front()[0], pairs->front()[1]),
                   "cloth that begins clear of itself, or no `friction` of cloth on cloth");
}

}  // namespace

std::shared_ptr<SurfaceContact> cloth_contact(const Scene& scene, const ClothSurface& cloth,
                                              std::vector<std::string>& warnings) {
  refuse_thickness(scene.contact, cloth.shortest_edge);
  refuse_crossings(scene.contact, cloth);
  const auto surface =
      std::make_shared<const ContactSurface>(cloth.positions, cloth.faces, cloth.moves);
  const SurfaceContactLaw law{scene.contact.thickness, *scene.contact.friction};
  auto contact = std::make_shared<SurfaceContact>(
      surface, cloth.positions,
      contact_stiffness_per_mass(scene.time) * cloth.masses + kShareOfResistance * cloth.resistance,
      law);
  const auto touching = contact->touching(cloth.positions);
  if (touching.pairs > 0) {
    warnings.push_back(fmt::format(
        "{} pairs of parts of the cloth begin nearer to each other than the thickness of {}, the "
        "nearest at {}: they push each other off",
        touching.pairs, millimetres(law.thickness), millimetres(touching.least_distance)));
  }
  return contact;
}

}  // namespace pliant
