#include "pliant/estimation/apparatus_shares.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/estimation/experiment_result.h"

namespace pliant {
namespace {

/// A number of the apparatus: how its name ends, and what it is called.
struct ApparatusNumber {
  const char* suffix;
  const char* name;
};

constexpr ApparatusNumber kApparatusNumbers[] = {
    {".slip", "slip"}, {".compliance", "compliance"}, {".rest_length_change", "rest length"}};

/// The fit of a component with some numbers held at zero; nothing where there are none.
std::optional<LawFit> fit_without(const ComponentProblem& problem, const LawFit& fit,
                                  const char* suffix) {
  LawFit without = fit;
  bool any = false;
  for (std::size_t i = 0; i < without.unknowns.size(); ++i) {
    Unknown& unknown = without.unknowns[i];
    if (unknown.of_material || unknown.fixed || !unknown.name.ends_with(suffix)) continue;
    unknown.hold(0);
    without.solution.parameters(static_cast<Eigen::Index>(i)) = 0;
    any = true;
  }
  if (!any) return std::nullopt;
  return refit(problem, without);
}

std::vector<std::string> misfits(const ComponentProblem& problem, const LawFit& with,
                                 const LawFit& without) {
  std::vector<std::string> texts;
  for (std::size_t e = 0; e < problem.experiments().size(); ++e) {
    const ComponentExperiment& experiment = *problem.experiments()[e];
    const auto percent = [&](const LawFit& fit) {
      const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
      return compare(experiment, fit.law, fit.nuisance.segment(problem.first_nuisance(e), count))
          .rms_percent;
    };
    texts.push_back(fmt::format("{} {:.2f} % of its peak for {:.2f} %", experiment.info().name,
                                percent(without), percent(with)));
  }
  return texts;
}

/// The number of the law that changes most, by its own standard errors.
std::string largest_change(const ComponentFit& component, const LawFit& without) {
  const LawFit& with = component.fit;
  Eigen::Index most = 0;
  double largest = -1;
  for (Eigen::Index i = 0; i < with.law.parameter_count(); ++i) {
    const double error = component.uncertainty.std_error(i);
    const double change =
        std::abs(without.solution.parameters(i) - with.solution.parameters(i)) / error;
    if (!std::isfinite(change) || change <= largest) continue;
    largest = change;
    most = i;
  }
  const Unknown& unknown = with.unknowns[static_cast<std::size_t>(most)];
  return fmt::format("{} would be {:.4g} for {:.4g} {}, {:.1f} standard errors away", unknown.name,
                     without.solution.parameters(most), with.solution.parameters(most),
                     unknown.unit, std::max(largest, 0.0));
}

}  // namespace

std::vector<std::string> apparatus_shares(const ComponentProblem& problem,
                                          const ComponentFit& fit) {
  std::vector<std::string> sentences;
  for (const ApparatusNumber& number : kApparatusNumbers) {
    const auto without = fit_without(problem, fit.fit, number.suffix);
    if (!without) continue;
    sentences.push_back(fmt::format("{} without {}: {}; {}", fit.component, number.name,
                                    fmt::join(misfits(problem, fit.fit, *without), ", "),
                                    largest_change(fit, *without)));
  }
  return sentences;
}

}  // namespace pliant
