#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/u3m_import.h"
#include "pliant/io/result_directory.h"

#include "apps/pliant/command.h"

namespace pliant {
namespace {

struct ImportArguments {
  std::string file;
  std::string output;
  std::string width;
};

ImportOptions import_options(const ImportArguments& arguments) {
  ImportOptions options;
  if (arguments.width.empty()) return options;
  try {
    options.width_m = parse_quantity(arguments.width, Dimension::length);
  } catch (const QuantityError& error) {
    throw InputError({"--width", 0, ""}, error.problem(), error.expected());
  }
  if (*options.width_m <= 0) throw InputError({"--width", 0, ""}, "is not positive", "e.g. 4 cm");
  return options;
}

}  // namespace

void add_import(CommandRegistry& registry) {
  CLI::App& command =
      registry.add("import", "Turn an instrument's file (U3M 1.1 physics or .u3m) into a study");
  auto arguments = std::make_shared<ImportArguments>();
  command.add_option("FILE", arguments->file, "The instrument's file")->required();
  command.add_option("-o,--output", arguments->output, "Directory for the study (DIR)")->required();
  command.add_option("--width", arguments->width, "Strip width, if not the file's, e.g. 5 cm");
  registry.on(command, [arguments](CommandContext& context) {
    const ImportedStudy study = import_u3m(arguments->file, import_options(*arguments));
    ResultDirectory results(arguments->output, "import");
    results.write("study.yaml", study.study_yaml);
    for (const auto& [name, content] : study.files) results.write(name, content);
    results.commit();
    for (const std::string& note : study.notes) context.say(note);
    for (const std::string& warning : study.warnings) {
      context.run.progress.message(Level::warning, warning);
    }
    context.say(fmt::format("study: {}",
                            (std::filesystem::path(arguments->output) / "study.yaml").string()));
    context.print_written_json("import", std::filesystem::path(arguments->output) / "study.yaml");
  });
}

}  // namespace pliant
