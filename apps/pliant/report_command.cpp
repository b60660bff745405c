#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/atomic_file.h"
#include "pliant/io/result_manifest.h"
#include "pliant/report/model_fits_report.h"
#include "pliant/report/report.h"

#include "apps/pliant/command.h"
#include "apps/pliant/report_pictures.h"
#include "apps/pliant/view_option.h"

namespace pliant {
namespace {

std::string report_of(const std::filesystem::path& directory, const std::string& view,
                      const RunContext& run) {
  const ViewDirection direction = parse_view(view);
  if (!std::filesystem::is_directory(directory)) {
    throw InputError({directory.string(), 0, ""}, "is no directory",
                     "the results of fit, evaluate or simulate");
  }
  if (std::filesystem::exists(directory / "simulation.json")) {
    return make_simulation_report(directory, report_pictures(directory, direction, run));
  }
  if (std::filesystem::exists(directory / "summary.json")) return make_model_fits_report(directory);
  return make_report(directory);
}

}  // namespace

void add_report(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "report", "Write DIR/report.html anew from the results in DIR, without running anything");
  auto directory = std::make_shared<std::string>();
  command.add_option("DIR", *directory, "Results of fit, evaluate or simulate")->required();
  auto view = std::make_shared<std::string>(kDefaultView);
  add_view_option(command, *view, "From where pictures of a simulation show the cloth");
  registry.on(command, [directory, view](CommandContext& context) {
    const std::filesystem::path file = std::filesystem::path(*directory) / "report.html";
    write_file_atomically(file, report_of(*directory, *view, context.run));
    list_result(*directory, "report.html");
    context.say(fmt::format("report: {}", file.string()));
    context.print_written_json("report", file);
  });
}

}  // namespace pliant
