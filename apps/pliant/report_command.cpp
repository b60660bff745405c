#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/atomic_file.h"
#include "pliant/report/report.h"

#include "apps/pliant/command.h"

namespace pliant {

void add_report(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "report", "Write DIR/report.html anew from the results in DIR, without running anything");
  auto directory = std::make_shared<std::string>();
  command.add_option("DIR", *directory, "Results of fit or evaluate")->required();
  registry.on(command, [directory](CommandContext& context) {
    const std::filesystem::path file = std::filesystem::path(*directory) / "report.html";
    if (!std::filesystem::is_directory(*directory)) {
      throw InputError({*directory, 0, ""}, "is no directory", "the results of fit or evaluate");
    }
    write_file_atomically(file, make_report(*directory));
    context.say(fmt::format("report: {}", file.string()));
    context.print_written_json("report", file);
  });
}

}  // namespace pliant
