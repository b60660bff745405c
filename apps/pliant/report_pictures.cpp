#include "apps/pliant/report_pictures.h"

#include <algorithm>

#include "pliant/render/contact_sheet.h"
#include "pliant/render/png.h"
#include "pliant/render/simulation_pictures.h"

namespace pliant {
namespace {

constexpr int kSheetPictures = 6;

/// Small and coarse: a short simulation must not wait for its pictures.
PictureOptions picture_options(ViewDirection view) {
  PictureOptions options;
  options.view = view;
  options.size = {400, 300};
  options.quality.samples = 4;
  return options;
}

SimulationFrames with_frames(const SimulationFrames& simulation,
                             std::vector<SimulationFrame> frames) {
  SimulationFrames chosen = simulation;
  chosen.frames = std::move(frames);
  return chosen;
}

/// A few frames, evenly in time: the view and the colours are fitted to these alone, so that a long
/// simulation is not read as a whole.
SimulationFrames chosen_frames(const SimulationFrames& simulation) {
  std::vector<double> times;
  for (const SimulationFrame& frame : simulation.frames) times.push_back(frame.time);
  std::vector<SimulationFrame> chosen;
  for (const int place : evenly_in_time(times, kSheetPictures)) {
    chosen.push_back(simulation.frames[static_cast<size_t>(place)]);
  }
  return with_frames(simulation, std::move(chosen));
}

std::string motion_picture(const SimulationFrames& simulation, const PictureOptions& options,
                           const RunContext& run) {
  const SimulationFrames chosen = chosen_frames(simulation);
  const PictureSetting setting = setting_of(chosen, options, LegendPlace::beside, run);
  return png_bytes(sheet_picture({{&chosen, chosen.frames}}, setting, options, run));
}

/// Names of the fields, strains first.
std::vector<std::string> field_names(const SimulationFrames& simulation) {
  std::vector<std::string> names;
  for (const auto& [name, unit] : simulation.units) names.push_back(name);
  std::stable_partition(names.begin(), names.end(),
                        [](const std::string& name) { return name.starts_with("strain."); });
  return names;
}

/// The fields at the last frame, less those that are the same everywhere.
std::vector<FieldPicture> field_pictures(const SimulationFrames& simulation, PictureOptions options,
                                         const RunContext& run) {
  const SimulationFrames last = with_frames(simulation, {simulation.frames.back()});
  options.ground = false;
  std::vector<FieldPicture> pictures;
  for (const std::string& name : field_names(simulation)) {
    options.field = name;
    const PictureSetting setting = setting_of(last, options, LegendPlace::in_picture, run);
    if (!(setting.legend->scale.low < setting.legend->scale.high)) continue;
    pictures.push_back(
        {name, png_bytes(frame_picture(last, last.frames.front(), setting, options, run))});
  }
  return pictures;
}

}  // namespace

SimulationPictures report_pictures(const std::filesystem::path& directory, ViewDirection view,
                                   const RunContext& run) {
  const SimulationFrames simulation = read_simulation_frames(directory);
  if (!std::filesystem::exists(simulation.file_of(simulation.frames.back()))) {
    return {.missing = "No pictures: the frames were not written as PLY files."};
  }
  const RunContext quietly{silent_progress(), run.stop, run.threads, run.seed};
  const PictureOptions options = picture_options(view);
  return {motion_picture(simulation, options, quietly),
          field_pictures(simulation, options, quietly), ""};
}

}  // namespace pliant
