#include <fmt/format.h>

#include "pliant/estimation/study_fit.h"
#include "pliant/io/result_directory.h"
#include "pliant/report/report.h"

#include "apps/pliant/command.h"
#include "apps/pliant/imported_study.h"
#include "apps/pliant/run_facts.h"
#include "apps/pliant/summary.h"

namespace pliant {
namespace {

struct FitArguments {
  std::vector<std::string> studies;
  std::string output;
  std::string estimator;
  std::vector<std::string> profiles;
  std::string compare;
};

void fit_one(const CommandContext& context, const FitArguments& arguments,
             const std::filesystem::path& study_file, const std::filesystem::path& output) {
  ResultDirectory results(output, "fit");
  const StudyFile file = study_or_imported(context, study_file, results);
  Study study = read_study(file.path);
  if (arguments.estimator == "anchor") study.fit.estimator = EstimatorKind::anchor;
  if (arguments.estimator == "path") study.fit.estimator = EstimatorKind::path;

  StudyFitOptions options;
  options.compare_friction = arguments.compare == "friction";
  options.profiles = arguments.profiles;
  const StudyResult result = fit_study(study, options, context.run);

  const RunFacts facts = run_facts(context, study_file);
  for (const auto& [name, content] : fit_files(result, facts)) results.write(name, content);
  results.write("study.resolved.yaml", resolved_study_text(study, file.results_base));
  results.write("report.html", make_report(results.staging()));
  results.commit();

  say_fit(context, result);
  context.say(fmt::format("report: {}", (output / "report.html").string()));
  context.print_json(summary_text(result, facts, true));
}

}  // namespace

void add_fit(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "fit", "Estimate a material from measurements: a study, or an instrument's file");
  auto arguments = std::make_shared<FitArguments>();
  command
      .add_option("STUDY", arguments->studies,
                  "study.yaml, or an instrument file that is imported first; of several, each "
                  "gets its own folder in DIR")
      ->required();
  command.add_option("-o,--output", arguments->output, "Directory for the results (DIR)")
      ->required();
  command
      .add_option("--estimator", arguments->estimator,
                  "path: friction carried along the measured path (default); anchor: the published "
                  "estimator; overrides the study")
      ->check(CLI::IsMember({"path", "anchor"}));
  command.add_option("--profile", arguments->profiles,
                     "Profile likelihood of a parameter, e.g. stretch.warp.friction.tau or "
                     "'*.friction.*'");
  command
      .add_option("--compare", arguments->compare,
                  "friction: fit its other parameterisations too and rank them by AIC and BIC")
      ->check(CLI::IsMember({"friction"}));
  registry.on(command, [arguments](CommandContext& context) {
    for (const std::string& study : arguments->studies) {
      std::filesystem::path output = arguments->output;
      if (arguments->studies.size() > 1) output /= folder_name(study);
      fit_one(context, *arguments, study, output);
    }
  });
}

}  // namespace pliant
