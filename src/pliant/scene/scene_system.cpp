#include "pliant/scene/scene_system.h"

#include <algorithm>
#include <functional>
#include <set>

#include <fmt/format.h>

#include "pliant/geometry/inside_volume.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/mechanics/cord.h"
#include "pliant/mechanics/point_forces.h"
#include "pliant/scene/cloth_mesh.h"
#include "pliant/scene/cloth_regions.h"
#include "pliant/scene/held_vertices.h"
#include "pliant/scene/obstacle_contacts.h"
#include "pliant/scene/surface_contacts.h"

namespace pliant {
namespace {

std::vector<int> held_axes(const ScenePin& pin) {
  std::vector<int> axes;
  for (int axis = 0; axis < 3; ++axis) {
    if (pin.directions[static_cast<size_t>(axis)]) axes.push_back(axis);
  }
  return axes;
}

// A material that a fit gave samples is of the body that they lie in, and of its coordinates.
void warn_of_samples_outside(const SolidPiece& piece, std::vector<std::string>& warnings) {
  for (const SolidPiece::Region& region : piece.regions) {
    const std::vector<SampledComponents>& samples = region.material.samples.at;
    const auto outside = std::ranges::count_if(
        samples, [&](const SampledComponents& own) { return !is_inside(piece.mesh, own.place); });
    if (outside == 0) continue;
    warnings.push_back(fmt::format(
        "{} of {} samples of the material {} lie outside the body {}: was it fitted to another?",
        outside, samples.size(), quoted_value(region.material.name), piece.name));
  }
}

// Builds the system step by step; each step uses what the ones before it left.
class SceneBuilder {
 public:
  SceneBuilder(const Scene& scene, const std::optional<Material>& filler)
      : scene_(scene), filler_(filler) {}

  SceneSystem build() && {
    read_pieces();
    read_bodies();
    count_points();
    result_.system = std::make_unique<System>(positions_, masses_);
    for (size_t i = 0; i < scene_.pins.size(); ++i) add_pin(scene_.pins[i], held_.pins[i]);
    for (size_t i = 0; i < scene_.clips.size(); ++i) add_clip(scene_.clips[i], held_.clips[i]);
    add_materials();
    add_forces();
    add_bodies();
    add_obstacles();
    add_surface_contact();
    result_.system->finish();
    set_schedule();
    result_.start = result_.system->initial_state();
    require_limits();
    set_velocities();
    return std::move(result_);
  }

 private:
  System& system() { return *result_.system; }

  void read_pieces() {
    std::vector<ClothVertices> vertices;
    read_cloths(vertices);
    for (const SceneSolid& solid : scene_.solids) {
      SolidPiece piece = make_solid_piece(solid, scene_);
      piece.first_point = result_.vertices;
      vertices.push_back({piece.mesh.positions, piece.mesh.groups});
      result_.vertices += piece.node_count();
      result_.solids.push_back(std::move(piece));
    }
    held_ = held_vertices(scene_, vertices);
  }

  void read_cloths(std::vector<ClothVertices>& vertices) {
    for (const SceneCloth& cloth : scene_.cloth) {
      ClothMesh made = make_cloth_mesh(cloth.mesh);
      result_.warnings.insert(result_.warnings.end(), made.warnings.begin(), made.warnings.end());
      regions_.push_back(cloth_regions(cloth, made, scene_, filler_, result_.warnings));
      TriangleMesh& mesh = made.mesh;
      vertices.push_back({mesh.positions, made.numbering.groups});
      mesh.positions = initial_positions(cloth, mesh.positions);
      const int count = mesh.vertex_count();
      result_.cloths.push_back({cloth.name, std::move(mesh), result_.vertices, {}});
      result_.vertices += count;
    }
  }

  void read_bodies() {
    for (const SceneObstacle& obstacle : scene_.obstacles) {
      if (!obstacle.surface()) continue;
      result_.bodies.push_back(
          {obstacle.name, std::make_shared<const MeshBody>(*obstacle.surface(), obstacle.motion)});
    }
  }

  // Positions, masses and faces of all points.
  void count_points() {
    int attachments = 0, faces = 0;
    for (const SceneClip& clip : scene_.clips) {
      for (const SceneCord& cord : clip.cords) attachments += cord.vertex ? 0 : 1;
    }
    for (const ClothPiece& cloth : result_.cloths) faces += cloth.mesh.triangle_count();
    for (const SolidPiece& solid : result_.solids) {
      faces += static_cast<int>(solid.surface.cols());
    }
    int points = result_.vertices + attachments;
    for (BodyPiece& piece : result_.bodies) {
      piece.first_point = points;
      points += static_cast<int>(piece.body->vertex_count());
    }
    positions_.resize(3, points);
    masses_ = Eigen::VectorXd::Zero(positions_.cols());
    result_.faces.resize(3, faces);
    place_cloths();
    place_clips();
    for (const BodyPiece& piece : result_.bodies) {
      positions_.middleCols(piece.first_point, piece.body->vertex_count()) =
          piece.body->positions(0);
    }
  }

  void place_cloths() {
    int next_face = 0;
    for (size_t c = 0; c < result_.cloths.size(); ++c) {
      const ClothPiece& cloth = result_.cloths[c];
      const TriangleMesh& mesh = cloth.mesh;
      positions_.middleCols(cloth.first_point, mesh.vertex_count()) = mesh.positions;
      result_.faces.middleCols(next_face, mesh.triangle_count()) =
          mesh.triangles.array() + cloth.first_point;
      next_face += mesh.triangle_count();
      for (const ClothRegion& region : regions_[c]) add_mass(cloth, region);
    }
    for (const SolidPiece& solid : result_.solids) {
      positions_.middleCols(solid.first_point, solid.node_count()) = solid.placed;
      masses_.segment(solid.first_point, solid.node_count()) = solid.masses();
      result_.faces.middleCols(next_face, solid.surface.cols()) = solid.faces();
      next_face += static_cast<int>(solid.surface.cols());
    }
  }

  void add_mass(const ClothPiece& cloth, const ClothRegion& region) {
    for (const int t : region.triangles) {
      const double third = region.material.density * rest_area(cloth.mesh, t) / 3;
      for (const int vertex : cloth.mesh.triangles.col(t)) {
        masses_(cloth.first_point + vertex) += third;
      }
    }
  }

  // Masses of clips and the points of their cords.
  void place_clips() {
    int next_point = result_.vertices;
    for (size_t k = 0; k < scene_.clips.size(); ++k) {
      const SceneClip& clip = scene_.clips[k];
      const int first = result_.cloths[static_cast<size_t>(clip.cloth)].first_point;
      for (const int vertex : held_.clips[k]) {
        masses_(first + vertex) += clip.mass / static_cast<double>(held_.clips[k].size());
      }
      for (const SceneCord& cord : clip.cords) {
        if (cord.vertex) continue;
        positions_.col(next_point++) =
            initial_position(scene_.cloth[static_cast<size_t>(clip.cloth)], cord.at);
      }
    }
  }

  // Of a cloth or, counted on, a solid.
  int first_point_of(int piece) const {
    const auto number = static_cast<size_t>(piece), cloths = result_.cloths.size();
    return number < cloths ? result_.cloths[number].first_point
                           : result_.solids[number - cloths].first_point;
  }

  void add_pin(const ScenePin& pin, const std::vector<int>& vertices) {
    const int first = first_point_of(pin.piece);
    const std::vector<int> axes = held_axes(pin);
    std::vector<int> points;
    for (const int vertex : vertices) {
      points.push_back(first + vertex);
      hold(points.back(), axes);
    }
    if (!pin.motion) return;
    const Eigen::Matrix3Xd start = positions_(Eigen::all, points);
    drives_.push_back(
        [points, start, motion = *pin.motion, axes = pin.directions](Controls& controls) {
          const Pose pose = pose_at(motion, controls.time);
          for (size_t i = 0; i < points.size(); ++i) {
            controls.places.push_back(
                {points[i], pose.apply(start.col(static_cast<Eigen::Index>(i))), axes});
          }
        });
  }

  void hold(int point, const std::vector<int>& axes) {
    if (axes.size() == 3) {
      system().coordinates().prescribe(point);
      return;
    }
    for (const int axis : axes) system().coordinates().prescribe_axis(point, axis);
  }

  void add_clip(const SceneClip& clip, const std::vector<int>& vertices) {
    const int first = result_.cloths[static_cast<size_t>(clip.cloth)].first_point;
    std::vector<int> points;
    for (const int vertex : vertices) points.push_back(first + vertex);
    std::vector<int> pulled;  // the points of the cords
    for (const SceneCord& cord : clip.cords) {
      pulled.push_back(cord.vertex ? first + *cord.vertex : next_attachment_++ + result_.vertices);
      if (!cord.vertex) points.push_back(pulled.back());
    }
    const int number = system().coordinates().add_clip(points, !clip.free);
    if (clip.motion) {
      const Eigen::Vector3d origin = positions_(Eigen::all, points).rowwise().mean();
      drives_.push_back([number, origin, motion = *clip.motion](Controls& controls) {
        const Pose moved = pose_at(motion, controls.time);
        controls.poses.push_back({number, {moved.rotation, moved.apply(origin)}});
      });
    }
    for (size_t i = 0; i < clip.cords.size(); ++i) add_cord(clip.cords[i], pulled[i]);
  }

  void add_cord(const SceneCord& cord, int point) {
    const int control = vectors_++;
    if (cord.force) {
      system().add(
          std::make_shared<PointForces>(control, Eigen::VectorXd::Unit(positions_.cols(), point)));
    } else {
      const CordSpring& spring = cord.spring;
      system().add(std::make_shared<Cord>(point, spring.stiffness, spring.length,
                                          value_at(spring.end, 0), control));
    }
    drives_.push_back(
        [control, vector = cord.force ? *cord.force : cord.spring.end](Controls& controls) {
          controls.vectors.col(control) = value_at(vector, controls.time);
        });
  }

  void set_schedule() {
    result_.schedule = [drives = std::move(drives_), vectors = vectors_](double time) {
      Controls controls;
      controls.time = time;
      controls.vectors.resize(3, vectors);
      for (const auto& drive : drives) drive(controls);
      return controls;
    };
  }

  void add_materials() {
    for (size_t c = 0; c < result_.cloths.size(); ++c) {
      ClothPiece& piece = result_.cloths[c];
      for (const ClothRegion& region : regions_[c]) {
        DensityOptions options;
        options.friction = scene_.time.friction.has_value();
        options.friction_form = scene_.time.friction.value_or(FrictionForm::variational);
        options.damping_fraction =
            scene_.damping_fraction.value_or(region.material.damping_fraction.value_or(0));
        Cloth cloth = add_cloth(system(), piece.mesh, piece.first_point, region.material,
                                region.triangles, options);
        piece.shown.insert(piece.shown.end(), cloth.shown.begin(), cloth.shown.end());
        result_.warnings.insert(result_.warnings.end(), cloth.warnings.begin(),
                                cloth.warnings.end());
      }
    }
    for (SolidPiece& solid : result_.solids) {
      warn_of_samples_outside(solid, result_.warnings);
      add_solid_materials(system(), scene_, solid);
    }
  }

  void add_forces() {
    system().add(std::make_shared<PointForces>(scene_.gravity * masses_.transpose()));
  }

  void add_obstacles() {
    TouchingCloth cloth{{}, {}, positions_, result_.faces, masses_};
    for (const int point : outer_points()) {
      const bool led = system().coordinates().is_led(point);
      (led ? cloth.led : cloth.points).push_back(point);
    }
    for (const ClothPiece& piece : result_.cloths) {
      cloth.longest_edge = std::max(cloth.longest_edge, mesh_quality(piece.mesh).longest_edge);
    }
    for (const SolidPiece& piece : result_.solids) {
      cloth.longest_edge = std::max(cloth.longest_edge, piece.edge_lengths().longest);
    }
    result_.obstacle_contacts = obstacle_contacts(scene_, cloth, result_.warnings);
    for (const auto& contact : result_.obstacle_contacts) system().add(contact);
    for (const SceneObstacle& obstacle : scene_.obstacles) {
      if (!obstacle.shape() || !obstacle.motion) continue;
      drives_.push_back([motion = *obstacle.motion](Controls& controls) {
        controls.bodies.push_back(pose_at(motion, controls.time));
      });
    }
  }

  // Those of faces, rising: nodes inside a solid meet nothing.
  std::vector<int> outer_points() const {
    const auto corners = result_.faces.reshaped();
    const std::set<int> points(corners.begin(), corners.end());
    return {points.begin(), points.end()};
  }

  void add_bodies() {
    for (const BodyPiece& piece : result_.bodies) {
      const int count = static_cast<int>(piece.body->vertex_count());
      for (int i = 0; i < count; ++i) system().coordinates().prescribe(piece.first_point + i);
      if (!piece.body->moves()) continue;
      drives_.push_back([piece](Controls& controls) {
        const Eigen::Matrix3Xd places = piece.body->positions(controls.time);
        for (int i = 0; i < places.cols(); ++i) {
          controls.places.push_back({piece.first_point + i, places.col(i)});
        }
      });
    }
  }

  void add_surface_contact() {
    double shortest_edge = INFINITY;
    for (const ClothPiece& piece : result_.cloths) {
      shortest_edge = std::min(shortest_edge, mesh_quality(piece.mesh).shortest_edge);
    }
    for (const SolidPiece& piece : result_.solids) {
      shortest_edge = std::min(shortest_edge, piece.edge_lengths().shortest);
    }
    std::vector<bool> moves;
    for (int point = 0; point < system().points(); ++point) {
      moves.push_back(!system().coordinates().is_prescribed(point));
    }
    result_.surface_contact =
        surface_contact(scene_,
                        {positions_, result_.faces, result_.bodies, std::move(moves), masses_,
                         resistance_to_stretch(), shortest_edge},
                        result_.warnings);
    if (result_.surface_contact) system().add(result_.surface_contact);
  }

  // Of the stiffest cloth at each point (N/m).
  Eigen::VectorXd resistance_to_stretch() const {
    Eigen::VectorXd resistance = Eigen::VectorXd::Zero(positions_.cols());
    for (size_t c = 0; c < result_.cloths.size(); ++c) {
      const ClothPiece& cloth = result_.cloths[c];
      for (const ClothRegion& region : regions_[c]) {
        double largest = 0;
        for (const char* component : {"stretch.weft", "stretch.warp"}) {
          const auto law = law_of(region.material, component);
          if (law) largest = std::max(largest, law->stiffness_at_rest());
        }
        for (const int t : region.triangles) {
          for (const int vertex : cloth.mesh.triangles.col(t)) {
            double& own = resistance(cloth.first_point + vertex);
            own = std::max(own, largest);
          }
        }
      }
    }
    for (const SolidPiece& solid : result_.solids) {
      resistance.segment(solid.first_point, solid.node_count()) = solid.resistance_to_stretch();
    }
    return resistance;
  }

  void require_limits() {
    for (size_t c = 0; c < result_.cloths.size(); ++c) {
      require_limits(scene_.cloth[c].where, result_.cloths[c].shown);
    }
    for (size_t s = 0; s < result_.solids.size(); ++s) {
      require_limits(scene_.solids[s].where, result_.solids[s].shown);
    }
  }

  void require_limits(const Location& where, const std::vector<ShownPotential>& potentials) {
    for (const ShownPotential& shown : potentials) {
      const double left = shown.potential->share_left(
          {result_.start.configuration, system().history_of(*shown.potential, result_.start)});
      if (left > 0) continue;
      throw InputError(where,
                       fmt::format("begins with {:.3g} times the energy that a limit of its "
                                   "material allows",
                                   1 - left),
                       "a shape nearer to that at rest, or a larger limit");
    }
  }

  // Free clips start with their cloth; what is held, or moved from outside, starts at rest.
  void set_velocities() {
    Eigen::Matrix3Xd& velocities = result_.start.velocities;
    const auto of_cloth = [this](int cloth) -> Eigen::Vector3d {
      return scene_.cloth[static_cast<size_t>(cloth)].velocity.value_or(Eigen::Vector3d::Zero());
    };
    for (size_t c = 0; c < result_.cloths.size(); ++c) {
      const ClothPiece& piece = result_.cloths[c];
      velocities.middleCols(piece.first_point, piece.mesh.vertex_count()).colwise() =
          of_cloth(static_cast<int>(c));
    }
    for (size_t s = 0; s < result_.solids.size(); ++s) {
      const SolidPiece& piece = result_.solids[s];
      velocities.middleCols(piece.first_point, piece.node_count()).colwise() =
          scene_.solids[s].velocity.value_or(Eigen::Vector3d::Zero());
    }
    for (size_t k = 0; k < scene_.clips.size(); ++k) {
      const SceneClip& clip = scene_.clips[k];
      const Eigen::Vector3d velocity =
          clip.free ? of_cloth(clip.cloth) : Eigen::Vector3d::Zero().eval();
      for (const int point : system().coordinates().clip_points(static_cast<int>(k))) {
        velocities.col(point) = velocity;
      }
    }
    for (size_t i = 0; i < scene_.pins.size(); ++i) stop_pin(scene_.pins[i], held_.pins[i]);
  }

  void stop_pin(const ScenePin& pin, const std::vector<int>& vertices) {
    const int first = first_point_of(pin.piece);
    const std::vector<int> axes = held_axes(pin);
    for (const int vertex : vertices) {
      for (const int axis : axes) result_.start.velocities(axis, first + vertex) = 0;
    }
  }

  const Scene& scene_;
  const std::optional<Material>& filler_;
  SceneSystem result_;
  std::vector<std::vector<ClothRegion>> regions_;  // by cloth
  HeldVertices held_;
  Eigen::Matrix3Xd positions_;
  Eigen::VectorXd masses_;
  int next_attachment_ = 0;
  std::vector<std::function<void(Controls&)>> drives_;  // each sets its part at `time`
  int vectors_ = 0;                                     // of the controls
};

}  // namespace

SceneSystem build_scene(const Scene& scene, const std::optional<Material>& filler) {
  return SceneBuilder(scene, filler).build();
}

}  // namespace pliant
