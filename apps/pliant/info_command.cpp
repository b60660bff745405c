#include <iostream>
#include <memory>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/atomic_file.h"
#include "pliant/io/schema_text.h"

#include "apps/pliant/command.h"
#include "apps/pliant/file_info.h"
#include "apps/pliant/reading_options.h"
#include "apps/pliant/table_preview.h"

namespace pliant {
namespace {

struct InfoArguments {
  std::string file;
  std::string schema;
  std::string plot;
  ReadingOptions reading;
};

void draw_readings(const CommandContext& context, const InfoArguments& arguments) {
  const auto page = table_preview(arguments.file, arguments.reading.csv());
  if (!page) {
    context.run.progress.message(
        Level::warning,
        fmt::format("no plot: {} holds no readings that could be drawn, columns of a force or "
                    "moment and of what drives it (--columns tells them)",
                    arguments.file));
    return;
  }
  write_file_atomically(arguments.plot, *page);
  context.say("plot: " + arguments.plot);
}

void print_info(const CommandContext& context, const InfoArguments& arguments) {
  if (!arguments.plot.empty()) draw_readings(context, arguments);
  const FileInfo info = describe_file(arguments.file, arguments.reading.csv());
  // File names and vendors' texts need not be UTF-8; what is not is replaced rather than refused.
  context.print_json(
      info.json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  for (const std::string& warning : info.warnings) {
    context.run.progress.message(Level::warning, warning);
  }
  // The description is the result of this command, not a message about one.
  if (context.common.json || context.common.quiet) return;
  for (const std::string& line : info.lines) std::cout << line << '\n';
}

}  // namespace

void add_info(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "info", "Say what a file is, its sizes, units and ranges, and whether it is valid");
  auto arguments = std::make_shared<InfoArguments>();
  CLI::Option* file = command.add_option(
      "FILE", arguments->file,
      "A study, material, lab, scene, CSV, mesh or instrument file, the directory of a session, or "
      "the results of another command");
  command
      .add_option("--schema", arguments->schema,
                  "Print the JSON schema of a type of document instead")
      ->check(CLI::IsMember(schema_types()))
      ->excludes(file);
  command.add_option("--plot", arguments->plot,
                     "Draw the readings of a table before any fit, in a page OUT.html");
  add_reading_options(command, arguments->reading);
  registry.on(command, [arguments](CommandContext& context) {
    if (!arguments->schema.empty()) {
      std::cout << schema_text(arguments->schema);
    } else if (arguments->file.empty()) {
      throw InputError({}, "no file is given", "pliant info FILE, or pliant info --schema TYPE");
    } else {
      print_info(context, *arguments);
    }
  });
}

}  // namespace pliant
