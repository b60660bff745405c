#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/name_pattern.h"
#include "pliant/io/result_directory.h"
#include "pliant/report/report.h"
#include "pliant/study/joint_study.h"
#include "pliant/study/sheet_models.h"
#include "pliant/study/sheet_study.h"
#include "pliant/study/solid_study.h"
#include "pliant/study/study_fit.h"

#include "apps/pliant/command.h"
#include "apps/pliant/fit_models.h"
#include "apps/pliant/fit_progress.h"
#include "apps/pliant/given_document.h"
#include "apps/pliant/given_study.h"
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
  std::vector<std::string> models, variants;
  bool resume = false;
};

bool compares_models(const FitArguments& arguments) {
  return !arguments.models.empty() || !arguments.variants.empty();
}

bool is_unknown(const StudyResult& result, const std::string& pattern) {
  const auto named = [&](const ParameterEstimate& p) { return matches(pattern, p.name); };
  return std::none_of(result.parameters.begin(), result.parameters.end(), named) &&
         std::none_of(result.nuisance.begin(), result.nuisance.end(), named);
}

// Which parameters there are is known after the fit: a curve's control points are grown.
void refuse_unknown_profiles(const std::vector<std::string>& patterns, const StudyResult& result) {
  for (const std::string& pattern : patterns) {
    if (!is_unknown(result, pattern)) continue;
    std::vector<std::string> names;
    for (const ParameterEstimate& p : result.parameters) names.push_back(p.name);
    throw InputError({"--profile", 0, ""}, quoted_value(pattern) + " matches no parameter",
                     fmt::format("{}, or a pattern with *", fmt::join(names, ", ")));
  }
}

std::vector<std::string> model_names() {
  std::vector<std::string> names;
  for (const SheetModel& model : sheet_models()) names.push_back(model.name);
  return names;
}

std::vector<std::string> variant_names() {
  std::vector<std::string> names;
  for (const SheetVariant& variant : sheet_variants()) names.push_back(variant.name);
  return names;
}

/// What a list on the command line asks for; nothing, or `all` in it, asks for all.
std::vector<std::string> chosen(const std::vector<std::string>& asked,
                                std::vector<std::string> all) {
  const bool everything = asked.empty() || std::ranges::find(asked, "all") != asked.end();
  return everything ? all : asked;
}

std::vector<std::string> and_all(std::vector<std::string> names) {
  names.emplace_back("all");
  return names;
}

/// Options that would change nothing in the fit of this study.
void refuse_without_effect(const FitArguments& arguments, const Study& study) {
  const auto refuse = [](const char* option, const char* why) {
    throw InputError({option, 0, ""}, why, "the same command without it");
  };
  const bool solids = measures_solids(study);
  if (arguments.resume && solids) {
    refuse("--resume", "fits of solids keep no progress to go on from");
  }
  if (!solids && (fits_strips(study) || !fits_sheets(study))) return;
  if (!arguments.profiles.empty()) {
    refuse("--profile", "is of the laws of strips, and the study fits none");
  }
  if (!arguments.compare.empty()) {
    refuse("--compare", "ranks the laws of strips, and the study fits none");
  }
}

/// Files the results of a fit, and a report on them.
/// @return the text of fit.json, or of summary.json where models are compared
std::string fit_into(ResultDirectory& results, const CommandContext& context,
                     const FitArguments& arguments, const std::filesystem::path& study_file) {
  const StudyFile file = study_or_imported(context, study_file, results);
  Study study = read_study(file.path);
  if (arguments.estimator == "anchor") study.fit.estimator = EstimatorKind::anchor;
  if (arguments.estimator == "path") study.fit.estimator = EstimatorKind::path;

  refuse_without_effect(arguments, study);

  if (compares_models(arguments)) {
    std::string summary =
        fit_models(context, study, study_file, chosen(arguments.models, model_names()),
                   chosen(arguments.variants, variant_names()), results);
    results.commit();
    return summary;
  }

  StudyFitOptions options;
  options.compare_friction = arguments.compare == "friction";
  options.compare_laws = arguments.compare == "laws";
  options.profiles = arguments.profiles;
  const StudyResult result = fit_study(study, options, context.run);
  refuse_unknown_profiles(options.profiles, result);

  const RunFacts facts = run_facts(context, study_file);
  for (const auto& [name, content] : fit_files(result, facts)) results.write(name, content);
  results.write("study.resolved.yaml", resolved_study_text(study, file.results_base));
  results.write("report.html", make_report(results.staging()));
  results.commit();

  say_fit(context, result);
  context.say(fmt::format("report: {}", (results.path() / "report.html").string()));
  return summary_text(result, facts, true);
}

/// The same, in a folder of its own, which keeps the progress of a long fit that is stopped.
std::string fit_one(const CommandContext& context, const FitArguments& arguments,
                    const std::filesystem::path& study_file, const std::filesystem::path& output) {
  ResultDirectory results(output, "fit");
  FitProgress progress(results, arguments.resume);
  const RunContext& run = context.run;
  const CommandContext remembering{
      context.common,
      context.arguments,
      {run.progress, run.stop, run.threads, run.seed, progress.journal()}};
  try {
    return fit_into(results, remembering, arguments, study_file);
  } catch (const Interrupted&) {
    if (progress.save()) context.say("--resume goes on from " + progress.file().string());
    throw;
  }
}

// Folders of the studies' results: DIR itself for one, else one in it for each.
std::vector<std::filesystem::path> output_folders(const FitArguments& arguments) {
  const std::filesystem::path directory = arguments.output;
  if (arguments.studies.size() == 1) return {directory};
  std::vector<std::filesystem::path> folders;
  for (const std::string& study : arguments.studies) {
    const std::filesystem::path folder = directory / folder_name(study);
    if (std::find(folders.begin(), folders.end(), folder) != folders.end()) {
      throw InputError({study, 0, ""},
                       "a second study whose results would go to " + quoted_value(folder.string()),
                       "studies of different names, or one command for each");
    }
    folders.push_back(folder);
  }
  return folders;
}

void fit_all(const CommandContext& context, const FitArguments& arguments) {
  const std::vector<std::filesystem::path> folders = output_folders(arguments);
  std::string summaries;
  for (size_t i = 0; i < folders.size(); ++i) {
    const std::string summary = fit_one(context, arguments, arguments.studies[i], folders[i]);
    if (i > 0) summaries += ",";
    summaries += summary;
  }
  context.print_json(folders.size() == 1
                         ? summaries
                         : "{\"pliant\": \"fits/1\", \"fits\": [" + summaries + "]}\n");
}

void add_model_options(CLI::App& command, FitArguments& arguments) {
  // One list a time: what follows may be the study.
  CLI::Option* models =
      command
          .add_option("--models", arguments.models,
                      "all, or some cloth models (stvk,springs) that sessions are fitted with: "
                      "results in DIR/MODEL.VARIANT, a table in DIR/summary.csv")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->check(CLI::IsMember(and_all(model_names())));
  CLI::Option* variants =
      command
          .add_option("--variants", arguments.variants,
                      "all, or some variants of these models: linear is without curves, isotropic "
                      "with weft and warp alike; --models and --variants default to all where the "
                      "other is given")
          ->delimiter(',')
          ->allow_extra_args(false)
          ->check(CLI::IsMember(and_all(variant_names())));
  for (const char* other : {"--profile", "--compare", "--estimator"}) {
    models->excludes(command.get_option(other));
    variants->excludes(command.get_option(other));
  }
}

}  // namespace

void add_fit(CommandRegistry& registry) {
  CLI::App& command = registry.add(
      "fit", "Estimate a material from measurements: a study, or an instrument's file");
  auto arguments = std::make_shared<FitArguments>();
  command
      .add_option(
          "STUDY", arguments->studies,
          "study.yaml, its folder, or an instrument file that is imported first; of several, each "
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
      .add_option(
          "--compare", arguments->compare,
          "friction: fit its other parameterisations too and rank them by AIC and BIC; laws: "
          "the same with further laws, e.g. softening, and which test would tell them")
      ->check(CLI::IsMember({"friction", "laws"}));
  command.add_flag("--resume", arguments->resume,
                   "Go on with a fit that was stopped, from its last search in DIR");
  add_model_options(command, *arguments);
  registry.on(command, [arguments](CommandContext& context) {
    for (std::string& study : arguments->studies) study = given_document(study, "study").string();
    fit_all(context, *arguments);
  });
}

}  // namespace pliant
