#include "pliant/estimation/model_comparison.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/estimation/judgement.h"

namespace pliant {
namespace {

/// Misfits within this factor of each other are not told apart.
constexpr double kAlikeMisfits = 1.05;

struct ModelName {
  std::string_view model, title, in_sentence;
};
constexpr std::array<ModelName, 3> kModels = {
    {{"soft-constraint", "Soft constraints", "soft constraints"},
     {"stvk", "St. Venant-Kirchhoff", "St. Venant-Kirchhoff"},
     {"springs", "Springs", "springs"}}};

const ModelName* name_of_model(const std::string& model) {
  const auto* found = std::ranges::find(kModels, model, &ModelName::model);
  return found == kModels.end() ? nullptr : found;
}

/// `nonlinear-orthotropic` with something else between its words.
std::string joined_by(std::string_view between, std::string_view variant) {
  const std::size_t dash = variant.find('-');
  if (dash == std::string_view::npos) return std::string(variant);
  return fmt::format("{}{}{}", variant.substr(0, dash), between, variant.substr(dash + 1));
}

using Fits = std::vector<const ComparedFit*>;

Fits found_fits(const ModelComparison& comparison) {
  Fits fits;
  for (const ComparedFit& fit : comparison.fits) {
    if (fit.misfit) fits.push_back(&fit);
  }
  return fits;
}

const ComparedFit& best_of(const Fits& fits) {
  return **std::ranges::min_element(fits, {}, [](const ComparedFit* fit) { return *fit->misfit; });
}

std::string titles(const Fits& fits) {
  std::vector<std::string> names;
  for (const ComparedFit* fit : fits) names.push_back(fit_title(*fit));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The best, and those that are as good.
std::string best_sentence(const Fits& fits) {
  const ComparedFit& best = best_of(fits);
  std::string text = fmt::format("The fitted sessions are followed best by {}, with a misfit of {}",
                                 fit_title(best), in_percent(*best.misfit / 100));
  Fits alike;
  for (const ComparedFit* fit : fits) {
    if (fit != &best && *fit->misfit <= kAlikeMisfits * *best.misfit) alike.push_back(fit);
  }
  if (fits.size() == 1) return text + ". ";
  if (alike.empty()) return text + "; none of the others comes within 5 % of that. ";
  constexpr std::size_t kMost = 2;
  if (alike.size() <= kMost) {
    text += fmt::format("; {} {} within 5 % of that. ", titles(alike),
                        alike.size() == 1 ? "comes" : "come");
  } else if (alike.size() == fits.size() - 1) {
    text += "; all others come within 5 % of that. ";
  } else {
    text += fmt::format("; {} of the {} others come within 5 % of that. ", alike.size(),
                        fits.size() - 1);
  }
  const auto fewest = *std::ranges::min_element(
      alike, {}, [](const ComparedFit* fit) { return fit->parameters.value_or(0); });
  if (fewest->parameters && best.parameters && *fewest->parameters < *best.parameters) {
    text += fmt::format("The simplest of these is {}, with {} parameters instead of {}. ",
                        fit_title(*fewest), *fewest->parameters, *best.parameters);
  }
  return text;
}

using Differs = std::function<bool(const ComparedFit& smaller, const ComparedFit& larger)>;

/// Misfit of each fit over that of the fit that differs from it in one freedom.
std::vector<double> ratios(const Fits& fits, const Differs& differs) {
  std::vector<double> found;
  for (const ComparedFit* smaller : fits) {
    for (const ComparedFit* larger : fits) {
      if (smaller->model != larger->model || !differs(*smaller, *larger)) continue;
      if (*larger->misfit > 0) found.push_back(*smaller->misfit / *larger->misfit);
    }
  }
  std::ranges::sort(found);
  return found;
}

/// `1.2 to 3.4 times`
std::string in_times(const std::vector<double>& factors) {
  const std::string low = format_number(factors.front(), 2);
  const std::string high = format_number(factors.back(), 2);
  return low == high ? low + " times" : low + " to " + high + " times";
}

/// What a freedom is worth.
/// @param without  "Weft and warp with one curve"
/// @param alike    what follows where it is worth nothing
std::string freedom_sentence(const std::vector<double>& factors, const std::string& without,
                             const std::string& alike) {
  if (factors.empty()) return {};
  if (factors.back() <= kAlikeMisfits) return alike;
  return fmt::format("{} leave {} the misfit{}. ", without, in_times(factors),
                     factors.front() > 1.5 ? ": they fail this cloth" : "");
}

bool contains(const ComparedFit& larger, const ComparedFit& smaller) {
  return larger.model == smaller.model && larger.variant != smaller.variant &&
         larger.is_nonlinear() >= smaller.is_nonlinear() &&
         larger.is_orthotropic() >= smaller.is_orthotropic();
}

/// More freedom cannot fit worse, unless a search has missed the better solution.
std::string nested_sentence(const Fits& fits) {
  constexpr double kRounding = 1e-9;
  std::vector<std::string> worse;
  bool any = false;
  for (const ComparedFit* larger : fits) {
    for (const ComparedFit* smaller : fits) {
      if (!contains(*larger, *smaller)) continue;
      any = true;
      if (*larger->misfit > (1 + kRounding) * *smaller->misfit) {
        worse.push_back(fit_title(*larger) + " than " + variant_title(smaller->variant) + " ones");
      }
    }
  }
  if (!any) return {};
  if (worse.empty()) return "No variant is worse than one that it contains. ";
  return fmt::format("A search has missed a better solution: worse are {}. ",
                     fmt::join(worse, ", "));
}

/// The fits with the least and the largest error of a session; null without any.
std::pair<const ComparedFit*, const ComparedFit*> extremes(const Fits& fits, std::size_t session) {
  Fits known;
  for (const ComparedFit* fit : fits) {
    if (fit->error(session)) known.push_back(fit);
  }
  if (known.empty()) return {nullptr, nullptr};
  const auto [least, largest] =
      std::ranges::minmax_element(known, {}, [&](const auto* fit) { return *fit->error(session); });
  return {*least, *largest};
}

/// Where fits of like misfit differ: what counts little in it may matter for a use.
std::string difference_sentence(const ModelComparison& comparison, const Fits& fits) {
  constexpr double kNotable = 1.5;
  double most = kNotable;
  std::string text;
  for (std::size_t s = 0; s < comparison.sessions.size(); ++s) {
    const auto [least, largest] = extremes(fits, s);
    if (comparison.sessions[s].validation || !least || *least->error(s) <= 0) continue;
    const double ratio = *largest->error(s) / *least->error(s);
    if (ratio <= most) continue;
    most = ratio;
    const std::string& unit = comparison.sessions[s].unit;
    text = fmt::format("Of the fitted sessions {} differs most: from {} {} ({}) to {} {} ({}). ",
                       comparison.sessions[s].name, format_number(*least->error(s), 3), unit,
                       fit_title(*least), format_number(*largest->error(s), 3), unit,
                       fit_title(*largest));
  }
  return text;
}

std::string prediction_sentence(const ModelComparison& comparison, const Fits& fits) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> parts;
  for (std::size_t s = 0; s < comparison.sessions.size(); ++s) {
    const ComparedFit* best = comparison.sessions[s].validation ? extremes(fits, s).first : nullptr;
    if (!best || parts.size() == kMost) continue;
    parts.push_back(fmt::format("{} by {} ({} {})", comparison.sessions[s].name, fit_title(*best),
                                format_number(*best->error(s), 3), comparison.sessions[s].unit));
  }
  if (parts.empty() || fits.size() == 1) return {};
  return fmt::format(
      "Of what was not fitted {}: {}. ",
      parts.size() == 1 ? "one session is predicted best" : "sessions are predicted best",
      fmt::join(parts, ", "));
}

std::string failure_sentence(const ModelComparison& comparison) {
  const auto failed = std::ranges::count_if(
      comparison.fits, [](const ComparedFit& fit) { return !fit.failure.empty(); });
  Fits stopped;
  for (const ComparedFit& fit : comparison.fits) {
    if (fit.failure.empty() && !fit.converged) stopped.push_back(&fit);
  }
  std::string text;
  if (failed > 0) text = fmt::format("{} of {} fits failed. ", failed, comparison.fits.size());
  if (!stopped.empty()) text += fmt::format("Not converged: {}. ", titles(stopped));
  return text;
}

}  // namespace

std::string verdict(const ModelComparison& comparison) {
  const Fits fits = found_fits(comparison);
  if (fits.empty()) return "No fit has a result.";
  std::string text = best_sentence(fits);
  text += freedom_sentence(
      ratios(fits,
             [](const ComparedFit& smaller, const ComparedFit& larger) {
               return !smaller.is_orthotropic() && larger.is_orthotropic() &&
                      smaller.is_nonlinear() == larger.is_nonlinear();
             }),
      "Isotropic variants, which take weft and warp as one,",
      "Isotropic variants fit as well: these sessions do not tell weft from warp. ");
  text += freedom_sentence(
      ratios(fits,
             [](const ComparedFit& smaller, const ComparedFit& larger) {
               return !smaller.is_nonlinear() && larger.is_nonlinear() &&
                      smaller.is_orthotropic() == larger.is_orthotropic();
             }),
      "Linear variants, whose stiffnesses do not change with strain,",
      "Linear variants fit as well: these sessions do not show that stiffness changes with "
      "strain. ");
  text += difference_sentence(comparison, fits) + nested_sentence(fits) +
          prediction_sentence(comparison, fits) + failure_sentence(comparison);
  text.pop_back();
  return text;
}

std::string model_title(const std::string& model) {
  const ModelName* name = name_of_model(model);
  return name ? std::string(name->title) : model;
}

std::string variant_title(const std::string& variant) { return joined_by(", ", variant); }

std::string fit_title(const ComparedFit& fit) {
  const ModelName* name = name_of_model(fit.model);
  return fmt::format("{} {}", joined_by(" ", fit.variant), name ? name->in_sentence : fit.model);
}

}  // namespace pliant
