#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/capture/capture_template.h"
#include "pliant/exchange/tester_study.h"
#include "pliant/experiment/registry.h"
#include "pliant/io/result_directory.h"
#include "pliant/study/test_template.h"

#include "apps/pliant/command.h"
#include "apps/pliant/reading_options.h"

namespace pliant {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCapture = "capture";

struct InitArguments {
  std::string test;
  std::vector<std::string> tables;
  std::string output;
  ReadingOptions reading;
};

/// The last of the files may be the new directory.
void take_directory(InitArguments& arguments) {
  if (!arguments.output.empty()) return;
  const bool names_directory = arguments.tables.size() > 1 &&
                               !fs::is_regular_file(arguments.tables.back()) &&
                               !fs::path(arguments.tables.back()).has_extension();
  if (!names_directory) {
    throw InputError({}, "no directory is given for the files", "-o DIR");
  }
  arguments.output = arguments.tables.back();
  arguments.tables.pop_back();
}

/// Its files are made to be edited: never replaced, unlike results.
void write_once(const std::string& output, const TestFiles& files) {
  if (fs::exists(output) && !(fs::is_directory(output) && fs::is_empty(output))) {
    throw InputError({output, 0, ""}, "is not empty", "a new directory");
  }
  ResultDirectory results(output, "init");
  for (const auto& [name, content] : files) results.write(name, content);
  results.commit();
}

void write_template(const CommandContext& context, const InitArguments& arguments) {
  write_once(arguments.output, test_template(arguments.test));
  const TestType* type = find_test_type(arguments.test);
  const bool predicted = type && type->facts.only_predicted;
  context.say(fmt::format(
      "{0} is ready: read PROTOCOL.md, fill in the CSV, then `pliant {1} {0}/study.yaml{2} -o "
      "RESULTS`",
      arguments.output, predicted ? "evaluate" : "fit", predicted ? " -m MATERIAL" : ""));
}

void write_capture(const CommandContext& context, const InitArguments& arguments) {
  write_once(arguments.output, capture_template());
  context.say(
      fmt::format("{0} is ready: read PROTOCOL.md, print labels.pdf, fill in pull.yaml, then "
                  "`pliant import --dic "
                  "{0}/pull.yaml -o PULL`",
                  arguments.output));
  context.print_written_json("init", fs::path(arguments.output) / "pull.yaml");
}

std::vector<std::string> kinds_of_templates() {
  std::vector<std::string> kinds = template_tests();
  kinds.emplace_back(kCapture);
  return kinds;
}

void write_study_of_tables(const CommandContext& context, const InitArguments& arguments) {
  const TestType* type = arguments.test.empty() ? nullptr : find_test_type(arguments.test);
  std::vector<TesterFile> tables;
  for (const std::string& table : arguments.tables) {
    tables.push_back(read_tester_file(table, arguments.reading.csv(), type));
  }
  const ImportedStudy study = tester_study(tables);
  TestFiles files = study.files;
  files.emplace_back("study.yaml", study.study_yaml);
  write_once(arguments.output, files);
  for (const std::string& note : study.notes) context.say(note);
  context.say(fmt::format("study: {0}/study.yaml, for `pliant fit {0}/study.yaml -o RESULTS`",
                          arguments.output));
}

void init(const CommandContext& context, InitArguments& arguments) {
  if (arguments.tables.empty() && arguments.test.empty()) {
    throw InputError({}, "neither a kind of test nor a table is given",
                     "pliant init TEST -o DIR, or pliant init --from FILE -o DIR");
  }
  take_directory(arguments);
  if (arguments.test == kCapture && arguments.tables.empty()) {
    return write_capture(context, arguments);
  }
  if (arguments.tables.empty()) {
    write_template(context, arguments);
  } else {
    write_study_of_tables(context, arguments);
  }
  context.print_written_json("init", fs::path(arguments.output) / "study.yaml");
}

}  // namespace

void add_init(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "init",
      "Start a study: of a kind of test, with a template CSV and a protocol; or of the tables of a "
      "testing machine (--from)");
  auto arguments = std::make_shared<InitArguments>();
  command
      .add_option(
          "TEST", arguments->test,
          "The kind of test, or capture: pictures by one camera; with --from it is found out")
      ->check(CLI::IsMember(kinds_of_templates()));
  command.add_option("--from", arguments->tables,
                     "Tables of a testing machine (CSV or text, .xlsx): the study says all that "
                     "they tell, and leaves ??? for the rest");
  command.add_option("-o,--output", arguments->output,
                     "Directory for the files (DIR); after the tables it needs no -o");
  add_reading_options(command, arguments->reading);
  registry.on(command, [arguments](CommandContext& context) { init(context, *arguments); });
}

}  // namespace pliant
