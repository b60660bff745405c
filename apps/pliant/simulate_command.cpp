#include <map>
#include <sys/resource.h>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/pc2.h"
#include "pliant/io/result_directory.h"
#include "pliant/material/material_file.h"
#include "pliant/scene/checkpoint.h"
#include "pliant/scene/contact_text.h"
#include "pliant/scene/frame_files.h"
#include "pliant/scene/obstacle_reach.h"
#include "pliant/scene/simulation_result.h"

#include "apps/pliant/command.h"
#include "apps/pliant/given_document.h"
#include "apps/pliant/report_pictures.h"
#include "apps/pliant/run_facts.h"
#include "apps/pliant/view_option.h"

namespace pliant {
namespace {

constexpr const char* kCheckpoint = "checkpoint.bin";

struct SimulateArguments {
  std::string scene;
  std::string output;
  std::string fill;
  std::string checkpoint_every;
  std::string view = kDefaultView;
  bool resume = false;
  bool no_report = false;
  bool verify = false;
  bool no_friction = false;
};

std::optional<double> checkpoint_period(const SimulateArguments& arguments) {
  const Location where{"--checkpoint-every", 0, ""};
  if (arguments.checkpoint_every.empty()) return std::nullopt;
  try {
    const double period = parse_quantity(arguments.checkpoint_every, Dimension::time);
    if (period > 0) return period;
  } catch (const QuantityError& error) {
    throw InputError(where, error.problem(), error.expected());
  }
  throw InputError(where, "is not positive", "e.g. 1 s");
}

Scene scene_of(const SimulateArguments& arguments) {
  Scene scene = read_scene(arguments.scene);
  if (arguments.no_friction) scene.time.friction.reset();
  return scene;
}

double peak_memory() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;  // from kB
}

// The results of a simulation as they come.
class SimulationRun {
 public:
  SimulationRun(const CommandContext& context, const SimulateArguments& arguments)
      : context_(context),
        arguments_(arguments),
        checkpoint_period_(checkpoint_period(arguments)),
        view_(parse_view(arguments.view)),
        scene_(scene_of(arguments)),
        simulation_(scene_, filler(), context.common.threads),
        identity_(scene_identity(scene_, arguments.fill)),
        results_(
            arguments.output, "simulate",
            arguments.resume ? ResultDirectory::Earlier::keep : ResultDirectory::Earlier::replace) {
    if (checkpoint_period_) {
      const double steps = std::round(*checkpoint_period_ / scene_.time.step);
      steps_per_checkpoint_ = static_cast<int>(std::clamp(steps, 1.0, 1e9));
    }
  }

  void run() {
    for (const std::string& warning : simulation_.built().warnings) {
      context_.run.progress.message(Level::warning, warning);
    }
    begin();
    ProgressTask progress(context_.run.progress, "simulating", scene_.time.step_count());
    progress.advance(simulation_.now().steps);
    while (!simulation_.is_finished()) {
      if (context_.run.stop.stop_requested()) {
        stop();
        context_.say("--resume goes on from " + last_state());
        throw Interrupted();
      }
      try {
        simulation_.advance();
      } catch (const SolverError& error) {
        stop();
        throw std::runtime_error(
            fmt::format("{}; the last good state is that of {}", error.what(), last_state()));
      }
      if (arguments_.verify) verify();
      if (simulation_.is_frame()) write_frame();
      if (steps_per_checkpoint_ > 0 && simulation_.now().steps % steps_per_checkpoint_ == 0) {
        write_summary();
        write_checkpoint();
        results_.publish();
      }
      progress.advance(simulation_.now().steps);
    }
    write_summary();
    write_checkpoint();
    if (!arguments_.no_report) write_report();
    results_.commit();
  }

  const Simulation& simulation() const { return simulation_; }

  /// What `verify` found after all steps, a sentence each.
  std::vector<std::string> verified() const {
    std::vector<std::string> facts{"after no step do triangles pass through each other"};
    if (simulation_.built().obstacle_contacts.empty()) return facts;
    if (deepest_faces_.empty()) {
      facts.push_back(
          "after no step is a vertex or a face inside an obstacle, but for what is led");
      return facts;
    }
    facts.push_back("after no step is a vertex inside an obstacle, but for what is led");
    for (const auto& [obstacle, deepest] : deepest_faces_) {
      facts.push_back(fmt::format(
          "faces come up to {} into {} between their vertices, which alone are kept out (face {}, "
          "counted from 0 over all cloth, at {:.6g} s)",
          millimetres(deepest.face.depth), quoted_value(obstacle), deepest.face.number,
          deepest.time));
    }
    return facts;
  }

  std::string summary() const {
    const RunFacts run = run_facts(context_, scene_.file);
    return simulation_text(simulation_result(simulation_, {.command = run.command,
                                                           .created = run.created,
                                                           .version = run.version,
                                                           .scene_sha256 = run.study_sha256,
                                                           .threads = context_.common.threads,
                                                           .peak_memory = peak_memory()}));
  }

 private:
  // A face that is inside an obstacle between its vertices.
  struct DeepestFace {
    DeepPart face;
    double time = 0;  // s
  };

  // By exact tests that know nothing of contact.
  void verify() {
    const auto crossings = scene_crossings(simulation_.now().state.configuration.positions,
                                           simulation_.built().faces, simulation_.built().bodies);
    if (!crossings) {
      throw InputError({"--verify"}, "was left out when this program was built",
                       "a program that was built with CGAL");
    }
    if (crossings->count() > 0) fail("triangles pass through each other: " + crossings->text());
    for (const ObstacleReach& reach :
         obstacle_reaches(scene_, simulation_.built(), simulation_.now().state)) {
      verify(reach);
    }
  }

  void verify(const ObstacleReach& reach) {
    if (reach.vertex) {
      fail(fmt::format("vertex {}, counted from 0 over all cloth, is {} inside {}",
                       reach.vertex->number, millimetres(reach.vertex->depth),
                       quoted_value(reach.obstacle)));
    }
    if (!reach.face) return;
    DeepestFace& deepest = deepest_faces_[reach.obstacle];
    if (reach.face->depth <= deepest.face.depth) return;
    deepest = {*reach.face, simulation_.now().state.time};
  }

  [[noreturn]] void fail(const std::string& why) {
    stop();
    throw std::runtime_error(fmt::format("{}, in the state of {}", why, last_state()));
  }

  void write_report() {
    results_.publish();  // the report is made of the results
    results_.write("report.html", make_simulation_report(results_.path(), pictures()));
  }

  // A simulation that went astray has frames that nobody can draw, but it has a report.
  SimulationPictures pictures() const {
    try {
      return report_pictures(results_.path(), view_, context_.run);
    } catch (const InputError& error) {
      return {.missing = std::string("No pictures: ") + error.what()};
    }
  }

  std::optional<Material> filler() const {
    if (arguments_.fill.empty()) return std::nullopt;
    return read_material(arguments_.fill);
  }

  void begin() {
    const int points = simulation_.built().vertices;
    if (arguments_.resume) {
      require_checkpoint();
      simulation_.resume(read_checkpoint(results_.path() / kCheckpoint, simulation_, identity_));
      require_time_left();
      if (scene_.output.has(FrameFormat::pc2)) {
        pc2_.emplace(Pc2Writer::resume(results_.path() / "cloth.pc2", points,
                                       static_cast<int>(simulation_.now().energies.size())));
      }
      // It may have been stopped where a shorter run ends.
      if (simulation_.is_finished() && !simulation_.is_recorded()) write_frame();
      return;
    }
    results_.write("cloth.obj", cloth_obj(simulation_));
    if (!scene_.solids.empty()) results_.write("solids.vtu", solids_vtu(simulation_));
    if (!scene_.obstacles.empty()) results_.write("obstacles.obj", obstacles_obj(simulation_));
    if (scene_.output.has(FrameFormat::pc2)) pc2_.emplace(results_.grow("cloth.pc2"), points);
    write_frame();
  }

  void require_checkpoint() const {
    if (std::filesystem::exists(results_.path() / kCheckpoint)) return;
    throw InputError({results_.path().string()}, "holds no checkpoint to go on from",
                     "results of `pliant simulate`, finished or stopped");
  }

  void require_time_left() const {
    if (simulation_.now().steps <= scene_.time.step_count()) return;
    throw InputError({scene_.file, 0, "time.duration"},
                     fmt::format("is {:.6g} s, and {:.6g} s are simulated already",
                                 scene_.time.duration, simulation_.now().state.time),
                     "at least as much, or another folder for a shorter run");
  }

  void write_frame() {
    const int index = static_cast<int>(simulation_.now().energies.size());
    simulation_.record_frame();
    for (const auto& [name, bytes] : frame_files(simulation_, index)) results_.write(name, bytes);
    if (pc2_) pc2_->append(cloth_points(simulation_));
  }

  // Comes last, so that what it goes on from is in place when it is.
  void write_checkpoint() {
    results_.write(kCheckpoint, checkpoint_bytes(simulation_.now(), identity_));
  }

  void write_summary() {
    for (const auto& [name, bytes] : series_files(simulation_)) results_.write(name, bytes);
    results_.write("simulation.json", summary());
  }

  // Leaves what there is so far as results that can be gone on with.
  void stop() {
    write_summary();
    write_checkpoint();
    results_.commit();
  }

  std::string last_state() const {
    return fmt::format("{} (after step {} of {}, at {:.6g} s)",
                       (results_.path() / kCheckpoint).string(), simulation_.now().steps,
                       scene_.time.step_count(), simulation_.now().state.time);
  }

  const CommandContext& context_;
  const SimulateArguments& arguments_;
  std::optional<double> checkpoint_period_;  // s, simulated
  ViewDirection view_;                       // of the report's pictures
  Scene scene_;
  Simulation simulation_;
  std::string identity_;
  ResultDirectory results_;
  std::optional<Pc2Writer> pc2_;
  int steps_per_checkpoint_ = 0;
  std::map<std::string, DeepestFace> deepest_faces_;  // by obstacle; of verified steps
};

void run_simulate(const CommandContext& context, const SimulateArguments& arguments) {
  SimulationRun run(context, arguments);
  run.run();
  const SimulationState& now = run.simulation().now();
  context.say(fmt::format("{}: {} triangles, {} steps of {:.6g} s, {} frames: {}",
                          run.simulation().scene().name, run.simulation().built().faces.cols(),
                          now.steps, run.simulation().scene().time.step, now.energies.size(),
                          (std::filesystem::path(arguments.output) / "simulation.json").string()));
  context.say(limits_text(read_simulation_result(arguments.output)));
  if (arguments.verify) {
    for (const std::string& fact : run.verified()) context.say("verified: " + fact);
  }
  if (!arguments.no_report) {
    context.say(fmt::format("report: {}",
                            (std::filesystem::path(arguments.output) / "report.html").string()));
  }
  context.print_json(run.summary());
}

}  // namespace

void add_simulate(CommandRegistry& registry) {
  CLI::App& command =
      registry.add("simulate", "Simulate cloth: in time, or along a path of equilibria");
  auto arguments = std::make_shared<SimulateArguments>();
  command.add_option("SCENE", arguments->scene, "scene.yaml: cloth, pins, clips, time, output")
      ->required();
  command.add_option("-o,--output", arguments->output, "Directory for the results (DIR)")
      ->required();
  command.add_option("--fill", arguments->fill,
                     "Material file whose components take the place of those that a material of "
                     "the scene does not know; they count as assumed");
  command.add_option("--checkpoint-every", arguments->checkpoint_every,
                     "Simulated time after which a checkpoint is written, e.g. '1 s'; Ctrl-C "
                     "writes one in any case");
  command.add_flag("--resume", arguments->resume,
                   "Go on from the checkpoint in DIR, to the same result");
  add_view_option(command, arguments->view, "From where the report's pictures show the cloth");
  command.add_flag("--no-report", arguments->no_report, "Leave out report.html and its pictures");
  command.add_flag("--no-friction", arguments->no_friction,
                   "Leave out the internal friction of the materials, as `friction: none` does");
  command.add_flag("--verify", arguments->verify,
                   "After each step test exactly that no triangles pass through each other and no "
                   "vertex is inside an obstacle, and stop where some do; tell how far faces come "
                   "into obstacles between their vertices");
  command.footer(
      "Writes frames/, energy.csv, simulation.json and report.html; docs/formats/scene.md tells\n"
      "what a scene may say. `pliant info SCENE` checks one without simulating it.\n"
      "A first simulation:  pliant simulate examples/curtain.yaml --fill "
      "examples/assumed-cloth.json\n"
      "                     -o curtain; pliant render curtain -o pictures.\n"
      "Exit status: 0 done, 1 it did not converge or was stopped (--resume goes on), 2 bad input.");
  registry.on(command, [arguments](CommandContext& context) {
    arguments->scene = given_document(arguments->scene, "scene").string();
    run_simulate(context, *arguments);
  });
}

}  // namespace pliant
