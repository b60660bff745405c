#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/io/result_directory.h"
#include "pliant/render/contact_sheet.h"
#include "pliant/render/png.h"
#include "pliant/render/simulation_pictures.h"

#include "apps/pliant/command.h"
#include "apps/pliant/movie_file.h"
#include "apps/pliant/render_options.h"
#include "apps/pliant/view_option.h"

namespace pliant {
namespace {

struct RenderArguments {
  std::string simulation;
  std::string output;
  std::string size;
  std::string frames;
  std::string camera, target = "0,0,0";
  double field_of_view = 30;  // degrees
  std::string view = kDefaultView;
  std::string range;
  std::string colour_map;
  std::string colour, back_colour;
  std::string lines = "auto";
  std::string cut;
  std::string movie;
  double rate = 0;  // pictures a second of the film; 0: as in reality
  bool no_ground = false;
  int contact_sheet = 0;            // pictures; 0: one picture a frame
  std::vector<std::string> beside;  // other results on the sheet
  PictureOptions options;
};

Camera camera_of(const RenderArguments& arguments) {
  Camera camera;
  camera.position = parse_point("--camera", arguments.camera);
  camera.target = parse_point("--target", arguments.target);
  camera.field_of_view = arguments.field_of_view * std::numbers::pi / 180;
  const Eigen::Vector3d forward = camera.target - camera.position;
  if (!(forward.norm() > 0)) {
    throw InputError({"--target"}, "is where the camera is", "another point");
  }
  // Who looks straight up or down has +y upwards in the picture.
  if (forward.head<2>().norm() < 1e-9 * forward.norm()) camera.up = Eigen::Vector3d::UnitY();
  return camera;
}

/// A contact sheet has the pixels that a single picture may have.
void refuse_large_sheet(int count, const SheetLayout& layout, const PictureSize& size) {
  const double pixels = double(layout.columns) * size.width * layout.rows * size.height;
  if (pixels <= kMostPixels) return;
  throw InputError(
      {"--contact-sheet"},
      fmt::format("{} pictures of {}x{} pixels are too large", count, size.width, size.height),
      fmt::format("at most {} million pixels", kMostPixels / 1'000'000));
}

void set_cloth_looks(const RenderArguments& arguments, PictureOptions& options) {
  constexpr float kBackShade = 0.5F;  // of a front of the user's
  if (!arguments.colour.empty()) {
    options.front = parse_colour_option("--colour", arguments.colour);
    options.back = kBackShade * options.front;
  }
  if (!arguments.back_colour.empty()) {
    options.back = parse_colour_option("--back-colour", arguments.back_colour);
  }
  options.lines = arguments.lines != "none";
  if (options.lines && arguments.lines != "auto") {
    options.line_spacing = parse_line_spacing(arguments.lines);
  }
}

PictureOptions picture_options(const RenderArguments& arguments) {
  PictureOptions options = arguments.options;
  options.ground = !arguments.no_ground;
  options.view = parse_view(arguments.view);
  if (!arguments.colour_map.empty()) options.colour_map = parse_colour_map(arguments.colour_map);
  if (arguments.contact_sheet > 0) options.size = {400, 300};
  if (!arguments.size.empty()) options.size = parse_picture_size(arguments.size);
  if (const int count = arguments.contact_sheet; count > 0) {
    const SheetLayout rows{.columns = count, .rows = 1 + static_cast<int>(arguments.beside.size())};
    refuse_large_sheet(count, arguments.beside.empty() ? sheet_layout(count) : rows, options.size);
  }
  if (!arguments.camera.empty()) options.camera = camera_of(arguments);
  if (!arguments.range.empty()) options.range = parse_value_range(arguments.range);
  if (!arguments.cut.empty()) options.cut = parse_cut(arguments.cut);
  set_cloth_looks(arguments, options);
  return options;
}

std::vector<SimulationFrame> evenly_chosen(const std::vector<SimulationFrame>& frames, int count) {
  std::vector<double> times;
  for (const SimulationFrame& frame : frames) times.push_back(frame.time);
  std::vector<SimulationFrame> chosen;
  for (const int place : evenly_in_time(times, count)) {
    chosen.push_back(frames[static_cast<size_t>(place)]);
  }
  return chosen;
}

/// The frames of another simulation at the times of given ones.
std::vector<SimulationFrame> frames_at_times(const SimulationFrames& other,
                                             const std::vector<SimulationFrame>& frames) {
  std::vector<SimulationFrame> found;
  for (const SimulationFrame& frame : frames) {
    const SimulationFrame* same = frame_at(other, frame.time);
    if (!same) {
      throw InputError({other.directory.string()}, fmt::format("has no frame at {} s", frame.time),
                       "frames at the times of the other simulation");
    }
    found.push_back(*same);
  }
  return found;
}

Image contact_sheet_of(const SimulationFrames& simulation,
                       const std::vector<SimulationFrame>& frames, const PictureSetting& setting,
                       const PictureOptions& options, const RenderArguments& arguments,
                       const RunContext& run) {
  std::vector<SheetPart> parts{{&simulation, evenly_chosen(frames, arguments.contact_sheet)}};
  std::vector<SimulationFrames> others;
  for (const std::string& other : arguments.beside) others.push_back(read_simulation_frames(other));
  for (const SimulationFrames& other : others) {
    parts.push_back({&other, frames_at_times(other, parts.front().frames)});
  }
  return sheet_picture(parts, setting, options, run);
}

std::string summary_json(const RenderArguments& arguments, const std::vector<std::string>& names,
                         const PictureSetting& setting) {
  nlohmann::ordered_json json{
      {"command", "render"}, {"directory", arguments.output}, {"pictures", names}};
  if (!arguments.movie.empty()) json["movie"] = arguments.movie;
  if (setting.legend) {
    json["field"] = {{"name", setting.legend->name},
                     {"unit", setting.legend->unit},
                     {"low", setting.legend->scale.low},
                     {"high", setting.legend->scale.high},
                     {"percentiles", setting.legend->percentiles}};
  }
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Where the pictures of frames go: files in a folder, a film or both.
struct FrameOutlet {
  std::optional<ResultDirectory> folder;
  std::optional<MovieFile> movie;
  std::vector<std::string> names = {};  // of the files

  void add(int frame, const Image& picture) {
    if (folder) {
      names.push_back(fmt::format("{:06}.png", frame));
      folder->write(names.back(), png_bytes(picture));
    }
    if (movie) movie->add(picture);
  }
  void commit() {
    if (movie) movie->commit();
    if (folder) folder->commit();
  }
};

void draw_frames(const CommandContext& context, const SimulationFrames& simulation,
                 const std::vector<SimulationFrame>& frames, const PictureSetting& setting,
                 const PictureOptions& options, FrameOutlet& outlet) {
  ProgressTask task(context.run.progress, "drawing frames", double(frames.size()));
  for (size_t i = 0; i < frames.size(); ++i) {
    outlet.add(frames[i].index,
               frame_picture(simulation, frames[i], setting, options, context.run));
    task.advance(double(i + 1));
  }
}

std::string pictures_text(const RenderArguments& arguments, const std::vector<std::string>& names) {
  return fmt::format("{} picture{}: {}", names.size(), names.size() == 1 ? "" : "s",
                     (std::filesystem::path(arguments.output) / names.front()).string());
}

void run_render(const CommandContext& context, const RenderArguments& arguments) {
  if (arguments.output.empty() && arguments.movie.empty()) {
    throw InputError({"--output"}, "is missing", "-o DIR for pictures, --movie FILE.mp4, or both");
  }
  const PictureOptions options = picture_options(arguments);
  const SimulationFrames simulation = read_simulation_frames(arguments.simulation);
  const std::vector<SimulationFrame> frames = select_frames(simulation.frames, arguments.frames);
  const bool sheet = arguments.contact_sheet > 0;
  const FilmRate rate = film_rate(frames, arguments.rate);
  FrameOutlet outlet;
  if (!arguments.output.empty()) outlet.folder.emplace(arguments.output, "render");
  if (!arguments.movie.empty()) outlet.movie.emplace(arguments.movie, options.size, rate.pictures);

  const PictureSetting setting = setting_of(
      simulation, options, sheet ? LegendPlace::beside : LegendPlace::in_picture, context.run);
  if (sheet) {
    outlet.names = {"contact-sheet.png"};
    outlet.folder->write(
        outlet.names.front(),
        png_bytes(contact_sheet_of(simulation, frames, setting, options, arguments, context.run)));
  } else {
    draw_frames(context, simulation, frames, setting, options, outlet);
  }
  outlet.commit();
  if (outlet.folder) context.say(pictures_text(arguments, outlet.names));
  if (outlet.movie) {
    context.say(
        fmt::format("film of {} frames, {}: {}", frames.size(), rate.text(), arguments.movie));
  }
  context.print_json(summary_json(arguments, outlet.names, setting));
}

void add_view_options(CLI::App& command, RenderArguments& arguments) {
  add_view_option(command, arguments.view, "Seen from, fitted to all frames");
  command.add_option("--camera", arguments.camera, "Fixed camera in place of --view: X,Y,Z in m")
      ->type_name("X,Y,Z");
  command.add_option("--target", arguments.target, "What --camera looks at (m)")
      ->type_name("X,Y,Z")
      ->needs("--camera")
      ->capture_default_str();
  command
      .add_option("--field-of-view", arguments.field_of_view,
                  "Of --camera, from bottom to top (degrees)")
      ->check(CLI::Range(1.0, 170.0))
      ->needs("--camera")
      ->capture_default_str();
}

void add_colour_options(CLI::App& command, RenderArguments& arguments) {
  PictureOptions& options = arguments.options;
  command.add_option("--field", options.field,
                     "Show a field of the frames by colour, e.g. strain.stretch.weft");
  command
      .add_option("--range", arguments.range,
                  "Values of the first and last colour (default: the 2nd and 98th percentile over "
                  "all frames; with coolwarm, as far on both sides of zero)")
      ->type_name("LOW:HIGH")
      ->needs("--field");
  command
      .add_option("--colour-map", arguments.colour_map,
                  "Colours for --field (default: coolwarm where it has both signs, else viridis)")
      ->type_name("{viridis,coolwarm}")
      ->needs("--field");
  command.add_option("--colour", arguments.colour, "Of the front of cloth without --field")
      ->type_name("#RRGGBB");
  command
      .add_option("--back-colour", arguments.back_colour,
                  "Of its back (default with --colour: a darker one)")
      ->type_name("#RRGGBB");
  command
      .add_option(
          "--lines", arguments.lines,
          "Lines along warp and (dashed) weft, so far apart at rest, e.g. '50 mm'; auto: by "
          "the size of the cloth")
      ->type_name("{LENGTH,auto,none}")
      ->capture_default_str();
  command
      .add_option("--cut", arguments.cut,
                  "Leave out what lies before a plane, as seen from the camera, and show the "
                  "sections of solids: x=0.02 or \"z = 5 mm\"")
      ->type_name("AXIS=LENGTH");
  command.add_flag("--mesh-lines", options.edges, "Draw the edges of the triangles");
  command.add_flag("--no-ground", arguments.no_ground, "Draw no shadow below the cloth");
  command.add_flag("--hard-shadow", options.hard_shadow, "Shadows with sharp edges");
}

void add_film_options(CLI::App& command, RenderArguments& arguments) {
  command
      .add_option("--movie", arguments.movie,
                  "Film of the frames, beside or in place of pictures; needs ffmpeg")
      ->type_name("FILE.mp4")
      ->excludes("--contact-sheet");
  command
      .add_option("--rate", arguments.rate,
                  "Frames a second of the film (default: as fast as in reality, at most 60)")
      ->check(CLI::Range(0.1, 240.0))
      ->needs("--movie");
}

}  // namespace

void add_render(CommandRegistry& registry) {
  CLI::App& command = registry.add("render", "Draw pictures of a simulation's frames");
  auto arguments = std::make_shared<RenderArguments>();
  command.add_option("DIR", arguments->simulation, "Results of simulate")->required();
  CLI::Option* output =
      command.add_option("-o,--output", arguments->output, "Directory for the pictures (DIR)");
  command.add_option("--frames", arguments->frames, "Numbers of the frames to draw (default: all)")
      ->type_name("FIRST:LAST:STEP");
  command
      .add_option("--contact-sheet", arguments->contact_sheet,
                  "One picture of N frames evenly chosen in time")
      ->type_name("N")
      ->check(CLI::Range(1, 400))
      ->needs(output);
  command
      .add_option(
          "--beside", arguments->beside,
          "Other results of the same mesh in a further row of the contact sheet, at the same "
          "times and seen as the first; may be given again")
      ->type_name("DIR")
      ->allow_extra_args(false)
      ->needs("--contact-sheet");
  add_film_options(command, *arguments);
  command
      .add_option("--size", arguments->size,
                  "Pixels of each picture (default: 800x600, on a contact sheet 400x300)")
      ->type_name("WxH");
  command
      .add_option("--samples", arguments->options.quality.samples,
                  "Rays a pixel; powers of two are spread most evenly")
      ->check(CLI::Range(1, 1024))
      ->capture_default_str();
  add_view_options(command, *arguments);
  add_colour_options(command, *arguments);
  command.footer(
      "Writes 000000.png, 000001.png, ..., one a frame, all in one view and one range of colours; "
      "or\n"
      "contact-sheet.png. Fields are those of the scene's `output: {fields: [strain, friction]}`.\n"
      "Exit status: 0 done, 1 stopped, 2 bad usage or bad input.");
  registry.on(command, [arguments](CommandContext& context) { run_render(context, *arguments); });
}

}  // namespace pliant
