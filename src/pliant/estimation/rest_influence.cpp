#include "pliant/estimation/rest_influence.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"

namespace pliant {
namespace {

/// A strip that may rest in several shapes.
struct BistableStrip {
  std::size_t experiment = 0;
  double setting = 0;                   // m
  std::vector<char> rows;               // of its experiment: those of its profiles
  std::size_t profiles = 0, moved = 0;  // its own, and those of them in another shape
};

std::vector<BistableStrip> bistable_strips(const ComponentProblem& problem, const LawFit& fit) {
  std::vector<BistableStrip> found;
  for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
    const ComponentExperiment& experiment = *problem.experiments()[e];
    if (!experiment.info().test.is_released) continue;
    const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
    const auto shapes =
        experiment.shapes(fit.law, fit.nuisance.segment(problem.first_nuisance(e), count));
    if (!shapes) continue;
    for (const double setting : shapes->ambiguous) {
      BistableStrip strip{e, setting, std::vector<char>(problem.used(e).size(), 0)};
      for (const ProfileLine& profile : shapes->measured) {
        if (profile.setting != setting) continue;
        std::fill_n(strip.rows.begin() + profile.first_row, profile.x.size(), 1);
        ++strip.profiles;
      }
      strip.moved = static_cast<std::size_t>(std::ranges::count(shapes->elsewhere, setting));
      found.push_back(std::move(strip));
    }
  }
  return found;
}

ComponentProblem without_strip(const ComponentProblem& problem, const BistableStrip& strip) {
  return problem.restricted_to([&](std::size_t experiment, std::size_t row) {
    return experiment != strip.experiment || !strip.rows[row];
  });
}

// What the law's numbers are without a strip where they move by more than half a standard error.
std::string changes(const LawFit& fit, const LawFit& without, const Eigen::VectorXd& std_error) {
  std::string text;
  for (Eigen::Index i = 0; i < fit.law.parameter_count(); ++i) {
    const double with = fit.solution.parameters(i), now = without.solution.parameters(i);
    if (!(std::abs(now - with) > std_error(i) / 2)) continue;
    const Unknown& unknown = fit.unknowns[static_cast<std::size_t>(i)];
    text += fmt::format("{}{} {:.3g} {} in place of {:.3g}", text.empty() ? "" : ", ", unknown.name,
                        now, unknown.unit, with);
  }
  return text;
}

}  // namespace

LawFit better_by_rests(const ComponentProblem& problem, const LawFit& fit) {
  constexpr int kMostRounds = 3;
  constexpr double kBetter = 1e-3;  // share of the cost
  LawFit best = fit;
  for (int round = 0; round < kMostRounds; ++round) {
    const double before = best.solution.cost;
    for (const BistableStrip& strip : bistable_strips(problem, best)) {
      const ComponentProblem others = without_strip(problem, strip);
      if (others.used_rows() <= free_count(best.unknowns)) continue;
      const LawFit tried = refit(problem, refit(others, best));
      if (tried.solution.cost < (1 - kBetter) * best.solution.cost) best = tried;
    }
    if (best.solution.cost == before) break;
  }
  best.starts = fit.starts;
  return best;
}

RestInfluence influence_of_rests(const ComponentProblem& problem, const LawFit& fit,
                                 const Eigen::VectorXd& std_error) {
  RestInfluence influence;
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(fit.solution.parameters.size());
  for (const BistableStrip& strip : bistable_strips(problem, fit)) {
    const ComponentProblem others = without_strip(problem, strip);
    std::string changed = "no other strip tells the law";
    if (others.used_rows() > free_count(fit.unknowns)) {
      const LawFit without = refit(others, fit);
      squares += (without.solution.parameters - fit.solution.parameters).cwiseAbs2();
      changed = changes(fit, without, std_error);
    }
    if (changed.empty()) continue;
    influence.warnings.push_back(fmt::format(
        "{}: the strip of the radius {} may rest in more than one shape ({} of its {} profiles lie "
        "in another than a quiet release ends in), and without it: {}",
        problem.experiments()[strip.experiment]->info().name, millimetres(strip.setting),
        strip.moved, strip.profiles, changed));
  }
  if (squares.maxCoeff() > 0) influence.shift = squares.cwiseSqrt();
  return influence;
}

}  // namespace pliant
