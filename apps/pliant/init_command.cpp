#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/io/result_directory.h"
#include "pliant/study/test_template.h"

#include "apps/pliant/command.h"

namespace pliant {

void add_init(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "init", "Start a test: a commented study.yaml, a template CSV and a one-page protocol");
  auto test = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>();
  command.add_option("TEST", *test, "The kind of test")
      ->required()
      ->check(CLI::IsMember(template_tests()));
  command.add_option("-o,--output", *output, "Directory for the files (DIR)")->required();
  registry.on(command, [test, output](CommandContext& context) {
    // Its files are made to be edited: never replaced, unlike results.
    if (std::filesystem::exists(*output) && !std::filesystem::is_empty(*output)) {
      throw InputError({*output, 0, ""}, "is not empty", "a new directory");
    }
    ResultDirectory results(*output, "init");
    for (const auto& [name, content] : test_template(*test)) results.write(name, content);
    results.commit();
    context.say(
        fmt::format("{} is ready: read PROTOCOL.md, fill in the CSV, then "
                    "`pliant fit {}/study.yaml -o RESULTS`",
                    *output, *output));
    context.print_written_json("init", std::filesystem::path(*output) / "study.yaml");
  });
}

}  // namespace pliant
