#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/material/fill.h"
#include "pliant/material/positive_stiffness.h"
#include "pliant/material/use_warnings.h"
#include "pliant/scene/cloth_mesh.h"
#include "pliant/scene/held_vertices.h"
#include "pliant/scene/scene.h"
#include "pliant/scene/solid_piece.h"

#include "apps/pliant/file_info.h"
#include "apps/pliant/volume_info.h"

namespace pliant {
namespace {

std::string vector_text(const Eigen::Vector3d& vector) {
  return fmt::format("[{}, {}, {}]", format_number(vector.x(), kInfoDigits),
                     format_number(vector.y(), kInfoDigits),
                     format_number(vector.z(), kInfoDigits));
}

Json vector_json(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z()}; }

/// A cloth with its mesh, and what it weighs.
struct MeshedCloth {
  const SceneCloth* cloth = nullptr;
  ClothMesh mesh;
  double rest_area = 0;  ///< m^2
  double mass = 0;       ///< kg; 0 where a density is not known
};

double mass_of(const SceneCloth& cloth, const ClothMesh& mesh) {
  const std::vector<int> materials = material_of_triangles(cloth, mesh);
  double mass = 0;
  for (int t = 0; t < mesh.mesh.triangle_count(); ++t) {
    const int m = materials[static_cast<std::size_t>(t)];
    const SceneMaterial& material =
        m == 0 ? cloth.material : cloth.regions[static_cast<std::size_t>(m) - 1].material;
    if (material.material.density == 0) return 0;
    mass += material.material.density * rest_area(mesh.mesh, t);
  }
  return mass;
}

MeshedCloth meshed(const SceneCloth& cloth) {
  MeshedCloth result{&cloth, make_cloth_mesh(cloth.mesh), 0, 0};
  result.rest_area = rest_area(result.mesh.mesh);
  result.mass = mass_of(cloth, result.mesh);
  initial_positions(cloth, result.mesh.mesh.positions);  // judges whether the cloth can be shaped
  return result;
}

std::string source_text(const FileMesh& source) { return source.file.string(); }

std::string extents_text(double width, double height) {
  return fmt::format("{} x {}", format_quantity(width, Dimension::length),
                     format_quantity(height, Dimension::length));
}

std::string source_text(const GridMesh& grid) {
  return fmt::format("grid {}, {} x {} nodes", extents_text(grid.width, grid.height), grid.nodes_u,
                     grid.nodes_v);
}

std::string source_text(const RectangleMesh& rectangle) {
  return fmt::format("irregular mesh of {}, edges of {}",
                     extents_text(rectangle.width, rectangle.height),
                     format_quantity(rectangle.edge, Dimension::length));
}

std::string source_text(const TubeMesh& tube) {
  return fmt::format("tube {} around and long, {} x {} nodes",
                     extents_text(tube.circumference, tube.length), tube.nodes_around,
                     tube.nodes_along);
}

std::string source_text(const MeshSource& source) {
  return std::visit([](const auto& kind) { return source_text(kind); }, source.kind);
}

std::vector<std::string> material_names(const SceneCloth& cloth) {
  std::vector<std::string> names{cloth.material.material.name};
  for (const SceneRegion& region : cloth.regions) names.push_back(region.material.material.name);
  return names;
}

void describe_cloth(const MeshedCloth& meshed, FileInfo& info) {
  const SceneCloth& cloth = *meshed.cloth;
  const TriangleMesh& mesh = meshed.mesh.mesh;
  info.json["cloth"].push_back({{"name", cloth.name},
                                {"mesh", source_text(cloth.mesh)},
                                {"vertices", mesh.vertex_count()},
                                {"triangles", mesh.triangle_count()},
                                {"rest_area", meshed.rest_area},
                                {"mass", meshed.mass > 0 ? Json(meshed.mass) : Json(nullptr)},
                                {"materials", material_names(cloth)}});
  info.lines.push_back(labelled("cloth " + cloth.name, source_text(cloth.mesh)));
  info.lines.push_back(labelled(
      "mesh", fmt::format("{} vertices, {} triangles", mesh.vertex_count(), mesh.triangle_count()),
      1));
  std::string size = format_quantity(meshed.rest_area, Dimension::area);
  if (meshed.mass > 0) size += ", " + format_quantity(meshed.mass, Dimension::mass);
  info.lines.push_back(labelled("size", size, 1));
  info.lines.push_back(
      labelled("material", fmt::format("{}", fmt::join(material_names(cloth), "; regions: ")), 1));
}

void describe_solid(const SceneSolid& solid, const SolidPiece& piece, FileInfo& info) {
  const std::string source = text_of(solid.mesh);
  std::vector<std::string> materials;
  for (const auto& region : piece.regions) materials.push_back(region.material.name);
  const double volume = element_volumes(piece.mesh).sum(), mass = piece.masses().sum();
  info.json["solids"].push_back({{"name", solid.name},
                                 {"mesh", source},
                                 {"nodes", piece.node_count()},
                                 {"tetrahedra", piece.mesh.tetrahedron_count()},
                                 {"hexahedra", piece.mesh.hexahedron_count()},
                                 {"volume", volume},
                                 {"mass", mass > 0 ? Json(mass) : Json(nullptr)},
                                 {"materials", materials}});
  info.lines.push_back(labelled("solid " + solid.name, source));
  info.lines.push_back(
      labelled("mesh",
               fmt::format("{} nodes, {} tetrahedra, {} hexahedra", piece.node_count(),
                           piece.mesh.tetrahedron_count(), piece.mesh.hexahedron_count()),
               1));
  info.lines.push_back(labelled("size",
                                fmt::format("{} m^3, {}", format_number(volume, kInfoDigits),
                                            format_quantity(mass, Dimension::mass)),
                                1));
  info.lines.push_back(
      labelled("material", fmt::format("{}", fmt::join(materials, "; regions: ")), 1));
}

/// What a simulation would refuse of a material.
void warn_of_material(const Material& material, FileInfo& info) {
  for (const std::string& warning : use_warnings(material, components_of_sheet(material))) {
    info.warnings.push_back(warning);
  }
  const auto warn_where_refused = [&](auto check) {
    try {
      check();
    } catch (const InputError& error) {
      info.warnings.push_back(fmt::format("{}; needed: {}", error.problem(), error.expected()));
    }
  };
  warn_where_refused([&] { require_complete(material, sheet_component_names()); });
  warn_where_refused([&] { require_positive_stiffness(material, sheet_component_names()); });
  if (material.density == 0) {
    info.warnings.push_back("the density of the material " + quoted_value(material.name) +
                            " is not known; needed: its mass per area");
  }
}

void warn_of_materials(const Scene& scene, FileInfo& info) {
  std::set<std::filesystem::path> seen;
  const auto warn_once = [&](const SceneMaterial& material) {
    if (seen.insert(material.file).second) warn_of_material(material.material, info);
  };
  for (const SceneCloth& cloth : scene.cloth) {
    warn_once(cloth.material);
    for (const SceneRegion& region : cloth.regions) warn_once(region.material);
  }
}

std::string counted(std::size_t count, const char* one, const char* several) {
  return fmt::format("{} {}", count, count == 1 ? one : several);
}

std::string vertices_text(const std::vector<int>& vertices, const std::string& cloth) {
  return counted(vertices.size(), "vertex", "vertices") + " of " + cloth;
}

std::string motion_text(const std::optional<Motion>& motion) {
  if (!motion) return "held still";
  return fmt::format("moved, {} from {} to {}",
                     counted(motion->times.size(), "keyframe", "keyframes"),
                     format_quantity(motion->times.front(), Dimension::time),
                     format_quantity(motion->times.back(), Dimension::time));
}

std::string clip_text(const SceneClip& clip) {
  return clip.free ? "free, " + counted(clip.cords.size(), "cord", "cords")
                   : motion_text(clip.motion);
}

std::string directions_text(const std::array<bool, 3>& directions) {
  std::string text;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (directions[axis]) text += static_cast<char>('x' + axis);
  }
  return text == "xyz" ? "" : " along " + text;
}

void describe_holds(const Scene& scene, const HeldVertices& held, FileInfo& info) {
  info.json["pins"] = Json::array();
  for (std::size_t i = 0; i < scene.pins.size(); ++i) {
    const ScenePin& pin = scene.pins[i];
    const auto piece = static_cast<std::size_t>(pin.piece);
    const bool of_cloth = piece < scene.cloth.size();
    const std::string& cloth =
        of_cloth ? scene.cloth[piece].name : scene.solids[piece - scene.cloth.size()].name;
    info.json["pins"].push_back({{of_cloth ? "cloth" : "solid", cloth},
                                 {"vertices", held.pins[i].size()},
                                 {"moved", pin.motion.has_value()}});
    info.lines.push_back(
        labelled(fmt::format("pin {}", i),
                 fmt::format("{}, {}{}", vertices_text(held.pins[i], cloth),
                             motion_text(pin.motion), directions_text(pin.directions))));
  }
  info.json["clips"] = Json::array();
  for (std::size_t i = 0; i < scene.clips.size(); ++i) {
    const SceneClip& clip = scene.clips[i];
    const std::string& cloth = scene.cloth[static_cast<std::size_t>(clip.cloth)].name;
    info.json["clips"].push_back({{"name", clip.name},
                                  {"cloth", cloth},
                                  {"vertices", held.clips[i].size()},
                                  {"mass", clip.mass},
                                  {"free", clip.free},
                                  {"cords", clip.cords.size()}});
    info.lines.push_back(labelled(
        "clip " + clip.name, fmt::format("{}, {}, {}", format_quantity(clip.mass, Dimension::mass),
                                         vertices_text(held.clips[i], cloth), clip_text(clip))));
  }
}

Json shape_json(const HalfSpace& plane) {
  return {{"plane", {{"point", vector_json(plane.point)}, {"normal", vector_json(plane.normal)}}}};
}

Json shape_json(const Sphere& sphere) {
  return {{"sphere", {{"centre", vector_json(sphere.centre)}, {"radius", sphere.radius}}}};
}

Json shape_json(const Capsule& capsule) {
  return {{"capsule",
           {{"from", vector_json(capsule.from)},
            {"to", vector_json(capsule.to)},
            {"radius", capsule.radius}}}};
}

Json shape_json(const Box& box) {
  return {{"box", {{"centre", vector_json(box.centre)}, {"size", vector_json(2 * box.half)}}}};
}

std::string shape_text(const Box& box) {
  return fmt::format("box of {} m about {} m", vector_text(2 * box.half), vector_text(box.centre));
}

std::string shape_text(const HalfSpace& plane) {
  return fmt::format("plane through {} m, normal {}", vector_text(plane.point),
                     vector_text(plane.normal));
}

std::string shape_text(const Sphere& sphere) {
  return fmt::format("sphere of radius {} about {} m",
                     format_quantity(sphere.radius, Dimension::length), vector_text(sphere.centre));
}

std::string shape_text(const Capsule& capsule) {
  return fmt::format("capsule of radius {} from {} to {} m",
                     format_quantity(capsule.radius, Dimension::length), vector_text(capsule.from),
                     vector_text(capsule.to));
}

Json body_json(const SceneObstacle& obstacle) {
  if (const BodySource* source = obstacle.surface()) {
    Json json{{"file", source->files.front().string()}, {"up", source->up}};
    if (source->rate == 0) return {{"mesh", json}};
    json["frames"] = source->files.size();
    json["rate"] = source->rate;
    return {{"sequence", json}};
  }
  return std::visit([](const auto& shape) { return shape_json(shape); }, *obstacle.shape());
}

std::string body_text(const SceneObstacle& obstacle) {
  if (const BodySource* source = obstacle.surface()) {
    const std::string file = quoted_value(source->files.front().string());
    if (source->rate == 0) return "mesh " + file;
    return fmt::format("{} frames from {} on, {} a second", source->files.size(), file,
                       format_number(source->rate, kInfoDigits));
  }
  return std::visit([](const auto& shape) { return shape_text(shape); }, *obstacle.shape());
}

std::string friction_text(const CoulombFriction& friction) {
  if (friction.sticking == friction.sliding) {
    return "friction " + format_number(friction.sticking, kInfoDigits);
  }
  return fmt::format("friction {}, {} where it slides",
                     format_number(friction.sticking, kInfoDigits),
                     format_number(friction.sliding, kInfoDigits));
}

void describe_obstacles(const Scene& scene, FileInfo& info) {
  info.json["obstacles"] = Json::array();
  for (const SceneObstacle& obstacle : scene.obstacles) {
    const auto& [sticking, sliding] = obstacle.friction;
    Json json{{"name", obstacle.name}};
    json.update(body_json(obstacle));
    json["friction"] = {{"static", sticking}, {"kinetic", sliding}};
    json["moved"] = obstacle.moves();
    info.json["obstacles"].push_back(json);
    info.lines.push_back(
        labelled("obstacle " + obstacle.name,
                 body_text(obstacle) + ", " + friction_text(obstacle.friction) +
                     (obstacle.motion ? ", " + motion_text(obstacle.motion) : std::string())));
  }
  const std::optional<double>& of_cloth = scene.contact.friction;
  const bool touches = !scene.obstacles.empty() || of_cloth;
  info.json["contact_thickness"] = touches ? Json(scene.contact.thickness) : Json(nullptr);
  info.json["contact_friction"] = of_cloth ? Json(*of_cloth) : Json(nullptr);
  if (!touches) return;
  info.lines.push_back(labelled(
      "contact",
      "from a distance of " + format_quantity(scene.contact.thickness, Dimension::length) +
          (of_cloth ? ", of cloth with cloth too, friction " + format_number(*of_cloth, kInfoDigits)
                    : std::string())));
}

void describe_surroundings(const Scene& scene, FileInfo& info) {
  info.json["gravity"] = vector_json(scene.gravity);
  info.lines.push_back(labelled("gravity", vector_text(scene.gravity) + " m/s^2"));
  info.json["air"] = nullptr;
  if (scene.air) {
    info.json["air"] = {{"drag", scene.air->drag},
                        {"density", scene.air->density},
                        {"wind", vector_json(scene.air->wind)}};
    info.lines.push_back(labelled("air", fmt::format("drag coefficient {}, wind {} m/s",
                                                     format_number(scene.air->drag, kInfoDigits),
                                                     vector_text(scene.air->wind))));
  }
}

const char* solution_text(StepSolve solution) {
  switch (solution) {
    case StepSolve::linearized:
      return "solved once";
    case StepSolve::iterated:
      return "at most three iterations";
    case StepSolve::converged:
      break;
  }
  return "converged";
}

std::string stepping_text(const Stepping& time) {
  const char* friction = name_of(time.friction);
  if (time.kind == SimulationKind::quasi_static) {
    return fmt::format("{} equilibria, friction {}", time.step_count(), friction);
  }
  return fmt::format("{} steps of {}, {}, {}, friction {}{}", time.step_count(),
                     format_quantity(time.step, Dimension::time), name_of(time.integrator),
                     solution_text(time.solution), friction, time.adaptive ? ", adaptive" : "");
}

const char* format_name(FrameFormat format) {
  switch (format) {
    case FrameFormat::ply:
      return "ply";
    case FrameFormat::vtu:
      return "vtu";
    case FrameFormat::pc2:
      break;
  }
  return "pc2";
}

void describe_run(const Scene& scene, FileInfo& info) {
  const Stepping& time = scene.time;
  // Adaptive steps are counted as if none was shortened.
  const int frames = 1 + static_cast<int>(time.duration / scene.output.every * (1 + 1e-6));
  std::vector<std::string> formats;
  for (const FrameFormat format : scene.output.formats) formats.emplace_back(format_name(format));
  info.json["kind"] = name_of(time.kind);
  info.json["steps"] = time.step_count();
  info.json["time_step"] = time.step;
  info.json["duration"] = time.duration;
  info.json["frames"] = frames;
  info.json["formats"] = formats;
  info.lines.push_back(labelled(name_of(time.kind), stepping_text(time)));
  info.lines.push_back(labelled(
      "output",
      fmt::format("{} frames, one each {}; {}", frames,
                  format_quantity(scene.output.every, Dimension::time), fmt::join(formats, ", "))));
}

}  // namespace

FileInfo scene_info(const std::filesystem::path& path) {
  const Scene scene = read_scene(path);
  std::vector<ClothVertices> vertices;
  FileInfo info = begin_info(path, "scene/1");
  info.json["name"] = scene.name;
  info.json["cloth"] = Json::array();
  info.lines.push_back(labelled("name", scene.name));
  for (const SceneCloth& cloth : scene.cloth) {
    const MeshedCloth built = meshed(cloth);
    describe_cloth(built, info);
    for (const std::string& warning : built.mesh.warnings) info.warnings.push_back(warning);
    vertices.push_back({built.mesh.mesh.positions, built.mesh.numbering.groups});
  }
  info.json["solids"] = Json::array();
  for (const SceneSolid& solid : scene.solids) {
    const SolidPiece piece = make_solid_piece(solid, scene);
    describe_solid(solid, piece, info);
    vertices.push_back({piece.mesh.positions, piece.mesh.groups});
  }
  describe_holds(scene, held_vertices(scene, vertices), info);
  describe_obstacles(scene, info);
  describe_surroundings(scene, info);
  describe_run(scene, info);
  warn_of_materials(scene, info);
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
