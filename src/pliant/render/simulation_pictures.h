#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/geometry/plane_cut.h"
#include "pliant/geometry/simulation_frames.h"
#include "pliant/render/annotations.h"
#include "pliant/render/contact_sheet.h"
#include "pliant/render/render.h"

namespace pliant {

/// A plane across an axis of the world.
struct AxisPlane {
  int axis = 0;   ///< x, y, z
  double at = 0;  ///< m
};

/// How the frames of a simulation are drawn.
struct PictureOptions {
  PictureSize size;
  RenderQuality quality;
  ViewDirection view = ViewDirection::three_quarter;  ///< fitted to all frames
  std::optional<Camera> camera = {};                  ///< in place of `view`
  std::string field = {};                             ///< shown by colour; empty: none
  /// By default coolwarm for a field that has values of both signs, and viridis otherwise.
  std::optional<ColourMap> colour_map = {};
  /// Values of the first and the last colour; by default the 2nd and the 98th percentile over all
  /// frames, for coolwarm as far from zero on both sides.
  std::optional<std::pair<double, double>> range = {};
  Colour front = RenderMesh().front;  ///< where no field is shown
  Colour back = RenderMesh().back;
  bool lines = true;                        ///< along weft and warp, where rest shapes are known
  std::optional<double> line_spacing = {};  ///< at rest (m); by default by the size of the cloth
  bool edges = false;
  std::optional<AxisPlane> cut = {};  ///< on the camera's side of it nothing is drawn
  bool ground = true;                 ///< a floor below the lowest point of all frames
  bool hard_shadow = false;
};

/// What all pictures of a simulation have in common, so that a sequence does not jump.
struct PictureSetting {
  Camera camera;
  std::optional<double> ground;       ///< height (m)
  std::optional<FieldLegend> legend;  ///< of the field shown
  std::optional<RestLines> lines;
  std::optional<Plane> cut;
  Eigen::Matrix4Xi solids;  ///< tetrahedra that the plane cuts
  std::optional<ScaleBar> scale_bar;
  int time_decimals = 0;
};

/// Where the colour bar goes.
enum class LegendPlace {
  in_picture,  ///< at the right edge of each picture, which keeps the cloth clear of it
  beside,      ///< beside the pictures of a sheet
};

/// Reads every frame once for its extent and the range of its field.
/// @throws InputError, also for a field that a frame does not have; Interrupted
PictureSetting setting_of(const SimulationFrames& simulation, const PictureOptions& options,
                          LegendPlace legend, const RunContext& run);

/// One frame with its time and a colour bar.
/// @throws InputError; Interrupted
Image frame_picture(const SimulationFrames& simulation, const SimulationFrame& frame,
                    const PictureSetting& setting, const PictureOptions& options,
                    const RunContext& run);

/// Frames of one simulation on a sheet.
struct SheetPart {
  const SimulationFrames* simulation = nullptr;
  std::vector<SimulationFrame> frames;  ///< one or more
};

/// How the frames of a sheet are arranged: those of one simulation as `sheet_layout` has it, those
/// of several with a row for each.
SheetLayout layout_of(const std::vector<SheetPart>& parts);

/// Several frames with their times and one colour bar. `options.size` is that of each.
/// @param parts    one or more, of one mesh and of as many frames each
/// @param setting  that of the first simulation, in which all are seen
/// @throws InputError; Interrupted
Image sheet_picture(const std::vector<SheetPart>& parts, const PictureSetting& setting,
                    const PictureOptions& options, const RunContext& run);

}  // namespace pliant
