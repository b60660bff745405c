#include "pliant/study/sheet_model_fits.h"

#include <exception>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/estimation/estimate.h"
#include "pliant/study/conclusion.h"
#include "pliant/study/sheet_study.h"

namespace pliant {
namespace {

/// Tasks named after the fit that they belong to.
class NamedProgress : public Progress {
 public:
  NamedProgress(Progress& progress, std::string name)
      : progress_(progress), name_(std::move(name)) {}

  void begin(std::string_view task, double total) override {
    progress_.begin(fmt::format("{}: {}", name_, task), total);
  }
  void advance(double done) override { progress_.advance(done); }
  void end() override { progress_.end(); }
  void message(Level level, std::string_view text) override { progress_.message(level, text); }

 private:
  Progress& progress_;
  std::string name_;
};

/// A material that was fitted, and what it was fitted as.
struct Solution {
  ModelVariant combination;
  Material material;
  CordFrictions cords;
};

CordFrictions cords_of(const StudyResult& result) {
  CordFrictions cords;
  for (const ParameterEstimate& cord : result.nuisance) cords[cord.name] = cord.value;
  return cords;
}

/// The solutions of one model's variants that another contains, but for those that are contained
/// in one of these: linear-isotropic in linear-orthotropic.
std::vector<SheetStart> starts_of(const ModelVariant& wanted,
                                  const std::vector<Solution>& solutions) {
  const auto contained = [&](const Solution& smaller, const SheetVariant& larger) {
    return smaller.combination.model.name == wanted.model.name &&
           is_contained(smaller.combination.variant, larger);
  };
  std::vector<SheetStart> starts;
  for (const Solution& solution : solutions) {
    if (!contained(solution, wanted.variant)) continue;
    bool between = false;
    for (const Solution& other : solutions) {
      between = between || (&other != &solution && contained(other, wanted.variant) &&
                            contained(solution, other.combination.variant));
    }
    if (between) continue;
    starts.push_back({solution.combination.variant.name, solution.material, solution.cords});
  }
  return starts;
}

}  // namespace

void fit_sheet_models(const Study& study, const std::vector<ModelVariant>& combinations,
                      const RunContext& context, const std::function<void(const ModelFit&)>& done) {
  if (study.fit.loss != RobustLoss::none) {
    throw InputError({study.file, 0, "fit.loss"}, "models are compared by least squares alone",
                     "none");
  }
  std::vector<Solution> solutions;
  std::exception_ptr first_failure;
  for (const ModelVariant& combination : combinations) {
    NamedProgress progress(context.progress, combination.name());
    const RunContext named{progress, context.stop, context.threads, context.seed, context.journal};
    ModelFit fit{combination, {}, with_model(study, combination), {}};
    const auto fail = [&](const std::exception& error) {
      fit.failure = error.what();
      if (!first_failure) first_failure = std::current_exception();
    };
    try {
      fit.result = fit_sheet_study(fit.study, named, starts_of(combination, solutions));
      warn_of_bounds(fit.result);
      conclude_fit(fit.study, fit.result);
      solutions.push_back({combination, fit.result.material, cords_of(fit.result)});
    } catch (const InputError& error) {
      fail(error);
    } catch (const SolverError& error) {
      fail(error);
    }
    done(fit);
  }
  if (solutions.empty() && first_failure) std::rethrow_exception(first_failure);
}

}  // namespace pliant
