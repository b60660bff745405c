#include "pliant/scene/met_bodies.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/scene/contact_text.h"

namespace pliant {
namespace {

// "vertex 12", "its face 0-1-2"
std::string part_text(std::vector<int> points, int first_of_body) {
  constexpr const char* kNames[] = {"vertex", "edge", "face"};
  const bool is_its_own = points.front() >= first_of_body;
  if (is_its_own) {
    for (int& point : points) point -= first_of_body;
  }
  return fmt::format("{}{} {}", is_its_own ? "its " : "", kNames[points.size() - 1],
                     fmt::join(points, "-"));
}

std::string met_text(const MetBody& body) {
  const auto& [count, distance, nearest] = body.touching;
  std::vector<std::string> parts;
  for (const std::vector<int>& part : nearest) {
    parts.push_back(part_text(part, body.first_point));
  }
  const bool is_cloth = body.name.empty();
  return fmt::format("{} ({} {} {}{})", is_cloth ? "itself" : quoted_value(body.name),
                     millimetres(distance), parts.size() == 1 ? "from" : "between",
                     fmt::join(parts, " and "),
                     is_cloth ? "" : fmt::format("; {}:{}", body.where.file, body.where.line));
}

}  // namespace

std::vector<MetBody> met_bodies(const Scene& scene, const SceneSystem& built, const State& state) {
  const Eigen::Matrix3Xd& positions = state.configuration.positions;
  const Controls controls = built.schedule(state.time);
  std::vector<MetBody> bodies;
  auto contact = built.obstacle_contacts.begin();
  for (const SceneObstacle& obstacle : scene.obstacles) {
    if (!obstacle.shape()) continue;
    bodies.push_back({obstacle.name, obstacle.where, (*contact++)->touching(positions, controls)});
  }
  if (built.surface_contact) {
    const auto touching = built.surface_contact->touching(positions);
    if (scene.contact.friction) bodies.push_back({"", {}, touching.front()});
    for (size_t i = 0; i < built.bodies.size(); ++i) {
      const auto& [name, body, first_point] = built.bodies[i];
      const auto obstacle = std::ranges::find(scene.obstacles, name, &SceneObstacle::name);
      bodies.push_back({name, obstacle->where, touching[i + 1], first_point});
    }
  }
  std::ranges::stable_sort(bodies, {},
                           [](const MetBody& body) { return body.touching.least_distance; });
  return bodies;
}

std::string nearest_text(const std::vector<MetBody>& bodies, size_t at_least) {
  std::vector<std::string> texts;
  for (const MetBody& body : bodies) {
    const bool is_asked_for = texts.size() < at_least && !body.touching.nearest.empty();
    if (body.touching.count > 0 || is_asked_for) texts.push_back(met_text(body));
  }
  if (texts.empty()) return "";
  return fmt::format("nearest to the cloth {} {}", texts.size() == 1 ? "is" : "are",
                     fmt::join(texts, " and "));
}

}  // namespace pliant
