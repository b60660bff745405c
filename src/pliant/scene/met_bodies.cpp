#include "pliant/scene/met_bodies.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/scene/contact_text.h"

namespace pliant {

std::vector<MetBody> met_bodies(const Scene& scene, const SceneSystem& built, const State& state) {
  const Eigen::Matrix3Xd& positions = state.configuration.positions;
  const Controls controls = built.schedule(state.time);
  std::vector<MetBody> bodies;
  auto contact = built.obstacle_contacts.begin();
  for (const SceneObstacle& obstacle : scene.obstacles) {
    if (!obstacle.shape()) continue;
    bodies.push_back({obstacle.name, (*contact++)->touching(positions, controls)});
  }
  if (built.surface_contact) {
    const auto touching = built.surface_contact->touching(positions);
    if (scene.contact.friction) bodies.push_back({"", touching.front()});
    for (size_t i = 0; i < built.bodies.size(); ++i) {
      bodies.push_back({built.bodies[i].name, touching[i + 1]});
    }
  }
  std::ranges::stable_sort(bodies, {},
                           [](const MetBody& body) { return body.touching.least_distance; });
  return bodies;
}

std::string nearest_text(const std::vector<MetBody>& bodies) {
  std::vector<std::string> texts;
  for (const auto& [name, touching] : bodies) {
    if (touching.count == 0) continue;
    texts.push_back(fmt::format("{} ({})", name.empty() ? "itself" : quoted_value(name),
                                millimetres(touching.least_distance)));
  }
  if (texts.empty()) return "";
  return fmt::format("nearest to the cloth {} {}", texts.size() == 1 ? "is" : "are",
                     fmt::join(texts, " and "));
}

}  // namespace pliant
