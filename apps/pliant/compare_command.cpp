#include <iostream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/geometry/simulation_frames.h"
#include "pliant/geometry/topology.h"
#include "pliant/io/atomic_file.h"
#include "pliant/io/csv_writer.h"
#include "pliant/mechanics/shape_difference.h"

#include "apps/pliant/command.h"

namespace pliant {
namespace {

struct CompareArguments {
  std::string simulation;
  std::string other;  // empty: the same
  int to = -1;        // number of the frame that all are compared with; -1: see below
  std::string output;
};

/// A frame with how far it is from the one that it is compared with.
struct ComparedFrame {
  SimulationFrame frame, with;
  ShapeDifference difference;
};

const SimulationFrame& frame_of_number(const SimulationFrames& simulation, int number) {
  for (const SimulationFrame& frame : simulation.frames) {
    if (frame.index == number) return frame;
  }
  throw InputError(
      {"--to"}, fmt::format("{} has no frame {}", simulation.directory.string(), number),
      fmt::format("{} to {}", simulation.frames.front().index, simulation.frames.back().index));
}

/// What each frame is compared with: a given frame; else that of the same time in another
/// simulation, or the first one. Frames without any are left out.
std::vector<std::pair<SimulationFrame, SimulationFrame>> pairs_of(
    const SimulationFrames& simulation, const SimulationFrames& other,
    const CompareArguments& arguments) {
  std::vector<std::pair<SimulationFrame, SimulationFrame>> pairs;
  for (const SimulationFrame& frame : simulation.frames) {
    const SimulationFrame* with = &other.frames.front();
    if (arguments.to >= 0) {
      with = &frame_of_number(other, arguments.to);
    } else if (!arguments.other.empty()) {
      with = frame_at(other, frame.time);
    }
    if (with) pairs.emplace_back(frame, *with);
  }
  if (!pairs.empty()) return pairs;
  throw InputError({other.directory.string()}, "has no frame at any time of the other's frames",
                   "frames at the same times, or --to FRAME");
}

Eigen::Matrix3Xd shape_of(const SimulationFrames& simulation, const SimulationFrame& frame,
                          const TriangleMesh& cloth) {
  const std::filesystem::path file = simulation.file_of(frame);
  FrameMesh mesh = read_frame(file);
  if (!same_triangles(mesh.triangles, cloth.triangles)) {
    throw InputError({file.string()}, "is of another mesh", "frames of one mesh");
  }
  return std::move(mesh.positions);
}

std::vector<ComparedFrame> compared_frames(const CompareArguments& arguments,
                                           const CommandContext& context) {
  const SimulationFrames simulation = read_simulation_frames(arguments.simulation);
  const SimulationFrames other =
      arguments.other.empty() ? simulation : read_simulation_frames(arguments.other);
  const auto pairs = pairs_of(simulation, other, arguments);
  if (simulation.mesh.empty()) {
    throw InputError({arguments.simulation}, "names no cloth with its rest plane",
                     "results of `pliant simulate`, with cloth.obj");
  }
  const TriangleMesh cloth = read_cloth(simulation.mesh);
  const ShapeComparison compare(cloth);
  std::vector<ComparedFrame> compared;
  for (const auto& [frame, with] : pairs) {
    context.run.stop.throw_if_requested();
    compared.push_back(
        {frame, with, compare(shape_of(simulation, frame, cloth), shape_of(other, with, cloth))});
  }
  return compared;
}

std::string table_text(const std::vector<ComparedFrame>& frames) {
  std::string text = fmt::format("{:>6} {:>9} {:>5} {:>13} {:>12} {:>14}\n", "frame", "time, s",
                                 "with", "distance, mm", "largest, mm", "curvature, 1/m");
  for (const auto& [frame, with, difference] : frames) {
    text += fmt::format("{:>6} {:>9.4g} {:>5} {:>13.4g} {:>12.4g} {:>14.4g}\n", frame.index,
                        frame.time, with.index, 1e3 * difference.distance,
                        1e3 * difference.largest_distance, difference.curvature);
  }
  return text;
}

std::string table_csv(const std::vector<ComparedFrame>& frames) {
  CsvWriter csv(std::vector<std::string>{"frame", "time_s", "with_frame", "with_time_s",
                                         "distance_m", "largest_distance_m", "curvature_1/m"});
  for (const auto& [frame, with, difference] : frames) {
    csv.cell(frame.index).cell(frame.time).cell(with.index).cell(with.time);
    csv.cell(difference.distance).cell(difference.largest_distance).cell(difference.curvature);
    csv.end_row();
  }
  return csv.text();
}

std::string summary_json(const std::vector<ComparedFrame>& frames) {
  nlohmann::ordered_json json{{"command", "compare"}, {"frames", nlohmann::ordered_json::array()}};
  for (const auto& [frame, with, difference] : frames) {
    json["frames"].push_back({{"frame", frame.index},
                              {"time", frame.time},
                              {"with_frame", with.index},
                              {"with_time", with.time},
                              {"distance", difference.distance},
                              {"largest_distance", difference.largest_distance},
                              {"curvature", difference.curvature}});
  }
  return json.dump(2) + "\n";
}

void run_compare(const CommandContext& context, const CompareArguments& arguments) {
  const std::vector<ComparedFrame> frames = compared_frames(arguments, context);
  if (!arguments.output.empty()) {
    write_file_atomically(arguments.output, table_csv(frames));
    context.say("table: " + arguments.output);
  }
  if (!context.common.json) std::cout << table_text(frames);
  context.print_json(summary_json(frames));
}

}  // namespace

void add_compare(CommandRegistry& registry) {
  CLI::App& command = registry.add("compare", "Tell how far shapes of simulated cloth are apart");
  auto arguments = std::make_shared<CompareArguments>();
  command.add_option("DIR", arguments->simulation, "Results of simulate")->required();
  command.add_option("OTHER", arguments->other,
                     "Other results of the same mesh: frames of the same time are compared");
  command
      .add_option("--to", arguments->to,
                  "Compare each frame with this one, by number, of OTHER or else of DIR (default "
                  "without OTHER: the first)")
      ->type_name("FRAME")
      ->check(CLI::NonNegativeNumber);
  command.add_option("-o,--output", arguments->output, "Write the table as FILE.csv, too")
      ->type_name("FILE.csv");
  command.footer(
      "A row a frame: the root mean square and the largest distance of the same points of the\n"
      "cloth, and the root mean square difference of curvatures across edges, which tells how\n"
      "differently it is wrinkled. All over the area at rest.\n"
      "Exit status: 0 done, 1 stopped, 2 bad usage or bad input.");
  registry.on(command, [arguments](CommandContext& context) { run_compare(context, *arguments); });
}

}  // namespace pliant
