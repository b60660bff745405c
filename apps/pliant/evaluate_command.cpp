#include <fmt/format.h>

#include "pliant/io/result_directory.h"
#include "pliant/material/material_file.h"
#include "pliant/report/report.h"
#include "pliant/study/study_evaluation.h"

#include "apps/pliant/command.h"
#include "apps/pliant/given_document.h"
#include "apps/pliant/given_study.h"
#include "apps/pliant/run_facts.h"
#include "apps/pliant/summary.h"

namespace pliant {
namespace {

struct EvaluateArguments {
  std::string study;
  std::string material;
  std::string output;
};

void evaluate(const CommandContext& context, const EvaluateArguments& arguments) {
  const Material material = read_material(arguments.material);
  ResultDirectory results(arguments.output, "evaluate");
  const StudyFile file = study_or_imported(context, arguments.study, results);
  const Study study = read_study(file.path);
  RunFacts facts = run_facts(context, arguments.study);
  const StudyResult result =
      evaluate_study(study, material, context.run,
                     nuisance_beside(arguments.material, material, facts.study_sha256));
  facts.material_file = arguments.material;
  for (const auto& [name, content] : evaluation_files(result, facts)) results.write(name, content);
  results.write("study.resolved.yaml", resolved_study_text(study, file.results_base));
  results.write("report.html", make_report(results.staging()));
  results.commit();

  say_experiments(context, result);
  context.say(fmt::format("report: {}",
                          (std::filesystem::path(arguments.output) / "report.html").string()));
  context.print_json(summary_text(result, facts, false));
}

}  // namespace

void add_evaluate(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "evaluate", "Predict a study's experiments with a given material, without fitting");
  auto arguments = std::make_shared<EvaluateArguments>();
  command.add_option("STUDY", arguments->study, "study.yaml, its folder, or an instrument file")
      ->required();
  command
      .add_option("-m,--material", arguments->material,
                  "Material file (material/1), or results of a fit")
      ->required();
  command.add_option("-o,--output", arguments->output, "Directory for the results (DIR)")
      ->required();
  registry.on(command, [arguments](CommandContext& context) {
    arguments->study = given_document(arguments->study, "study").string();
    arguments->material = given_document(arguments->material, "material").string();
    evaluate(context, *arguments);
  });
}

}  // namespace pliant
