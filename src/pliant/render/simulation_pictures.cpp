#include "pliant/render/simulation_pictures.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/render/contact_sheet.h"
#include "pliant/render/field_range.h"
#include "pliant/render/number_scale.h"

namespace pliant {
namespace {

/// More of the light comes from all around where the colour is what matters.
constexpr double kFieldAmbient = 0.55;

/// Part of a picture's width that the colour bar may keep free of cloth; beyond it they overlap.
constexpr double kWidestLegend = 0.4;

constexpr std::uint32_t kObstacleGrey = 0xc9c6c0;

/// A field has both signs where the smaller side reaches this part of the larger one: less is
/// rounding, or not to be seen.
constexpr double kBothSigns = 0.01;

/// What all frames span.
struct Extent {
  Eigen::AlignedBox3d box;
  FieldRange field;
};

const Eigen::VectorXd& field_of(const FrameMesh& mesh, const std::string& name,
                                const std::filesystem::path& file) {
  const auto found = mesh.fields.find(name);
  if (found != mesh.fields.end()) return found->second;
  std::vector<std::string> names;
  for (const auto& [other, values] : mesh.fields) names.push_back(other);
  throw InputError({file.string()}, "has no field " + quoted_value(name),
                   names.empty() ? "a simulation that writes fields"
                                 : fmt::format("one of {}", fmt::join(names, ", ")));
}

void extend(Extent& extent, const FrameMesh& mesh, const std::string& field,
            const std::filesystem::path& file) {
  extent.box.extend(Eigen::AlignedBox3d(mesh.positions.rowwise().minCoeff(),
                                        mesh.positions.rowwise().maxCoeff()));
  if (field.empty()) return;
  extent.field.add(field_of(mesh, field, file));
}

Extent extent_of(const SimulationFrames& simulation, const std::string& field,
                 const RunContext& run) {
  Extent extent{{}, FieldRange(simulation.frames.size())};
  ProgressTask task(run.progress, "reading frames", double(simulation.frames.size()));
  for (size_t i = 0; i < simulation.frames.size(); ++i) {
    run.stop.throw_if_requested();
    const std::filesystem::path file = simulation.file_of(simulation.frames[i]);
    extend(extent, read_frame(file), field, file);
    task.advance(double(i + 1));
  }
  return extent;
}

bool has_both_signs(double low, double high) {
  return low < 0 && high > 0 && std::min(-low, high) >= kBothSigns * std::max(-low, high);
}

/// In the middle of coolwarm is zero, unless a range was asked for.
ColourScale scale_of(const ShownRange& range, const PictureOptions& options) {
  if (options.range) {
    const auto [low, high] = *options.range;
    const ColourMap map = low == -high ? ColourMap::coolwarm : ColourMap::viridis;
    return {options.colour_map.value_or(map), low, high};
  }
  const ColourMap map =
      has_both_signs(range.low, range.high) ? ColourMap::coolwarm : ColourMap::viridis;
  if (options.colour_map.value_or(map) == ColourMap::viridis) {
    return {ColourMap::viridis, range.low, range.high};
  }
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  return {ColourMap::coolwarm, -largest, largest};
}

FieldLegend legend_of(const SimulationFrames& simulation, const Extent& extent,
                      const PictureOptions& options) {
  const auto unit = simulation.units.find(options.field);
  const ShownRange range = extent.field.shown().value_or(ShownRange{});
  return {options.field, unit == simulation.units.end() ? "" : unit->second,
          scale_of(range, options), range.percentiles && !options.range};
}

int time_decimals(const std::vector<SimulationFrame>& frames) {
  double spacing = std::numeric_limits<double>::infinity();
  for (size_t i = 1; i < frames.size(); ++i) {
    spacing = std::min(spacing, frames[i].time - frames[i - 1].time);
  }
  return std::isfinite(spacing) ? decimals_for(spacing) : 3;
}

FrameMesh cut_frame(const FrameMesh& frame, const PictureSetting& setting,
                    const std::filesystem::path& file) {
  if (setting.solids.size() > 0 && setting.solids.maxCoeff() >= frame.positions.cols()) {
    throw InputError({file.string()}, "does not have the nodes of the solids",
                     "frames and solids.vtu of one simulation");
  }
  const PlaneCut cut = cut_by_plane(frame.positions, frame.triangles, setting.solids, *setting.cut);
  FrameMesh left{cut.values(frame.positions), cut.triangles, {}};
  for (const auto& [name, values] : frame.fields) {
    left.fields[name] = cut.values(values.transpose()).transpose();
  }
  return left;
}

RenderScene scene_of(FrameMesh frame, const PictureSetting& setting,
                     const PictureOptions& options) {
  RenderScene scene;
  scene.ground = setting.ground;
  scene.light = light_for_view(setting.camera.target - setting.camera.position);
  if (options.hard_shadow) scene.light.angular_radius = 0;
  RenderMesh mesh{std::move(frame.positions),
                  std::move(frame.triangles),
                  options.front,
                  options.back,
                  {},
                  setting.lines,
                  options.edges};
  if (setting.legend) {
    scene.ambient = kFieldAmbient;
    mesh.field = VertexField{std::move(frame.fields[options.field]), setting.legend->scale};
  }
  if (mesh.triangles.size() > 0) scene.meshes.push_back(std::move(mesh));
  return scene;
}

void add_obstacles(const std::filesystem::path& file, const std::optional<Plane>& plane,
                   RenderScene& scene) {
  if (file.empty()) return;
  SolidMesh solid = read_obstacles(file);
  if (plane) {
    const PlaneCut cut = cut_by_plane(solid.positions, solid.triangles, {}, *plane);
    solid = {cut.values(solid.positions), cut.triangles};
  }
  if (solid.triangles.size() == 0) return;
  const Colour grey = colour_of_rgb(kObstacleGrey);
  scene.meshes.push_back({std::move(solid.positions), std::move(solid.triangles), grey, grey});
}

Image timed_picture(const SimulationFrames& simulation, const SimulationFrame& frame,
                    const PictureSetting& setting, const PictureOptions& options,
                    const RunContext& run) {
  const std::filesystem::path file = simulation.file_of(frame);
  FrameMesh mesh = read_frame(file);
  if (setting.legend) field_of(mesh, options.field, file);
  if (setting.lines && setting.lines->rest_corners.cols() != mesh.triangles.size()) {
    throw InputError({file.string()}, fmt::format("has {} triangles", mesh.triangles.cols()),
                     fmt::format("{}, as in {}", setting.lines->rest_corners.cols() / 3,
                                 simulation.mesh.string()));
  }
  if (setting.cut) mesh = cut_frame(mesh, setting, file);
  RenderScene scene = scene_of(std::move(mesh), setting, options);
  add_obstacles(simulation.obstacles_of(frame), setting.cut, scene);
  Image image = render(scene, setting.camera, options.size, options.quality, run);
  draw_time(image, frame.time, setting.time_decimals);
  if (setting.scale_bar) draw_scale_bar(image, *setting.scale_bar);
  return image;
}

std::optional<RestLines> lines_of(const SimulationFrames& simulation,
                                  const PictureOptions& options) {
  if (!options.lines || options.cut || simulation.mesh.empty()) return std::nullopt;
  const TriangleMesh cloth = read_cloth(simulation.mesh);
  const double area = rest_area(cloth);
  if (!(area > 0)) return std::nullopt;
  return RestLines{cloth.rest_corners, options.line_spacing.value_or(usual_spacing(area))};
}

/// A round length of a tenth to a quarter of the picture's width in the middle of what is shown.
std::optional<ScaleBar> scale_bar_of(const PictureSetting& setting, double aspect,
                                     const Eigen::AlignedBox3d& box) {
  const double width = width_at(setting.camera, aspect, box.center());
  if (!(width > 0)) return std::nullopt;
  ScaleBar bar;
  bar.length = round_step(0.1 * width);
  bar.share = bar.length / width;
  if (setting.lines) bar.lines = setting.lines->spacing;
  return bar;
}

/// The plane of a cut, whose normal points to the camera.
Plane plane_of(const AxisPlane& cut, const Camera& camera) {
  const double side = camera.position(cut.axis) > cut.at ? 1 : -1;
  return {side * Eigen::Vector3d::Unit(cut.axis), side * cut.at};
}

// Of all frames, which differ where obstacles are led.
Eigen::AlignedBox3d extent_of_obstacles(const SimulationFrames& simulation) {
  Eigen::AlignedBox3d box;
  std::set<std::filesystem::path> files;
  for (const SimulationFrame& frame : simulation.frames) {
    files.insert(simulation.obstacles_of(frame));
  }
  files.erase("");
  for (const std::filesystem::path& file : files) {
    const Eigen::Matrix3Xd solid = read_obstacles(file).positions;
    box.extend(Eigen::AlignedBox3d(solid.rowwise().minCoeff(), solid.rowwise().maxCoeff()));
  }
  return box;
}

}  // namespace

PictureSetting setting_of(const SimulationFrames& simulation, const PictureOptions& options,
                          LegendPlace legend, const RunContext& run) {
  Extent extent = extent_of(simulation, options.field, run);
  PictureSetting setting;
  extent.box.extend(extent_of_obstacles(simulation));
  Margins margins;
  if (!options.field.empty()) setting.legend = legend_of(simulation, extent, options);
  if (setting.legend && legend == LegendPlace::in_picture) {
    const int width = colour_bar_width(*setting.legend, label_style(options.size.height));
    margins.right = std::min(kWidestLegend, double(width) / options.size.width);
  }
  setting.camera =
      options.camera.value_or(fit_camera(extent.box, options.view, options.size.aspect(), margins));
  // A little below, so that a cloth which lies flat does not touch it.
  if (options.ground) setting.ground = extent.box.min().z() - 1e-3 * extent.box.diagonal().norm();
  setting.lines = lines_of(simulation, options);
  if (options.cut) {
    setting.cut = plane_of(*options.cut, setting.camera);
    if (!simulation.solids.empty()) setting.solids = read_solids(simulation.solids);
  }
  setting.scale_bar = scale_bar_of(setting, options.size.aspect(), extent.box);
  setting.time_decimals = time_decimals(simulation.frames);
  return setting;
}

Image frame_picture(const SimulationFrames& simulation, const SimulationFrame& frame,
                    const PictureSetting& setting, const PictureOptions& options,
                    const RunContext& run) {
  Image image = timed_picture(simulation, frame, setting, options, run);
  if (setting.legend) draw_colour_bar(image, *setting.legend, label_style(options.size.height));
  return image;
}

SheetLayout layout_of(const std::vector<SheetPart>& parts) {
  const int count = static_cast<int>(parts.front().frames.size());
  if (parts.size() == 1) return sheet_layout(count);
  return {.columns = count, .rows = static_cast<int>(parts.size())};
}

Image sheet_picture(const std::vector<SheetPart>& parts, const PictureSetting& setting,
                    const PictureOptions& options, const RunContext& run) {
  const SheetLayout layout = layout_of(parts);
  std::vector<Image> pictures;
  ProgressTask task(run.progress, "drawing frames", double(layout.columns) * layout.rows);
  for (const SheetPart& part : parts) {
    for (const SimulationFrame& frame : part.frames) {
      pictures.push_back(timed_picture(*part.simulation, frame, setting, options, run));
      task.advance(double(pictures.size()));
    }
  }
  if (!setting.legend) return contact_sheet(pictures, layout, 0);
  const TextStyle style = label_style(options.size.height);
  Image sheet = contact_sheet(pictures, layout, colour_bar_width(*setting.legend, style));
  draw_colour_bar(sheet, *setting.legend, style);
  return sheet;
}

}  // namespace pliant
