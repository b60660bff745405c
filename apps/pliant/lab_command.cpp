#include <fmt/format.h>

#include "pliant/capture/virtual_capture.h"
#include "pliant/io/result_directory.h"
#include "pliant/material/material_file.h"
#include "pliant/measurement/session.h"
#include "pliant/study/virtual_lab.h"

#include "apps/pliant/command.h"
#include "apps/pliant/given_document.h"

namespace pliant {
namespace {

struct LabArguments {
  std::string lab;
  std::string output;
};

void run_lab(const CommandContext& context, const LabArguments& arguments) {
  const VirtualLab lab = read_lab(arguments.lab);
  if (lab.cameras) {
    for (const auto& test : lab.experiments) require_seen(*test);
  }
  ResultDirectory results(arguments.output, "lab");
  const auto files = make_measurements(lab, context.run);
  for (const auto& [name, content] : files) results.write(name, content);
  results.write("truth.json", material_text(lab.material));
  if (lab.cameras) {
    for (const std::string& folder : session_folders(lab)) {
      draw_capture(read_session(results.staging() / folder), *lab.cameras, context.run,
                   [&](const std::string& name, const std::string& content) {
                     results.write(folder + "-seen/" + name, content);
                   });
    }
  }
  results.commit();
  context.say(fmt::format("{} virtual measurements of {} (seed {}): {}",
                          lab.experiments.size() * static_cast<std::size_t>(lab.specimens),
                          lab.material.name, context.common.seed,
                          (std::filesystem::path(arguments.output) / "study.yaml").string()));
  context.print_written_json("lab", std::filesystem::path(arguments.output) / "study.yaml");
}

}  // namespace

void add_lab(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "lab", "Make virtual measurements of a given material, in the formats that `fit` reads");
  auto arguments = std::make_shared<LabArguments>();
  command.add_option("LAB", arguments->lab, "lab.yaml: material, experiments, noise")->required();
  command.add_option("-o,--output", arguments->output, "Directory for the study (DIR)")->required();
  registry.on(command, [arguments](CommandContext& context) {
    arguments->lab = given_document(arguments->lab, "lab").string();
    run_lab(context, *arguments);
  });
}

}  // namespace pliant
