#include "pliant/estimation/stated_options.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/name_pattern.h"

namespace pliant {

namespace {

template <class T>
void add_unmatched(const std::map<std::string, T>& options, const char* field,
                   const std::vector<std::string>& names, std::vector<std::string>& sentences) {
  for (const auto& option : options) {
    const std::string& key = option.first;
    const bool matched = std::ranges::any_of(names, [&](const std::string& name) {
      // COMPONENT.k stands for all control values.
      return matches(key, name) || matches(key, name.substr(0, name.find('[')));
    });
    if (!matched) {
      sentences.push_back(fmt::format(
          "{} of {} has no effect: no parameter of this fit has that name", field, key));
    }
  }
}

}  // namespace

std::vector<std::string> unmatched_options(const FitOptions& options,
                                           const std::vector<std::string>& names) {
  std::vector<std::string> sentences;
  add_unmatched(options.bounds, "fit.bounds", names, sentences);
  add_unmatched(options.fix, "fit.fix", names, sentences);
  add_unmatched(options.priors, "fit.priors", names, sentences);
  return sentences;
}

std::vector<std::string> stated_options(const FitOptions& options) {
  std::vector<std::string> sentences;
  if (options.monotone_stress) {
    sentences.emplace_back(
        "no elastic stress falls where strain rises (fit.monotone_stress): stiffness curves that "
        "would make it fall were not allowed, whatever the data say; standard errors are those "
        "without this");
  }
  if (options.loss != RobustLoss::none) {
    sentences.push_back(fmt::format(
        "residuals count by the loss of {} (fit.loss): rows beyond {:.3g} standard "
        "deviations count less, and the noise is that of the others",
        options.loss == RobustLoss::huber ? "Huber" : "Cauchy", loss_scale(options.loss)));
  }
  for (const auto& [name, value] : options.fix) {
    sentences.push_back(
        fmt::format("{} is {:.6g} by the study (fit.fix, SI units), not estimated", name, value));
  }
  for (const auto& [name, bounds] : options.bounds) {
    sentences.push_back(
        fmt::format("{} lies between {:.6g} and {:.6g} by the study (fit.bounds, SI units)", name,
                    bounds.first, bounds.second));
  }
  for (const auto& [name, prior] : options.priors) {
    sentences.push_back(
        fmt::format("{} was expected to be {:.6g} +- {:.3g} (fit.priors, SI units): estimates lie "
                    "between that and what "
                    "the data alone would say, nearer to what is known better",
                    name, prior.mean, prior.sd));
  }
  return sentences;
}

}  // namespace pliant
