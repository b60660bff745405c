#include "pliant/report/model_fits_verdict.h"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "pliant/report/number_format.h"

namespace pliant::report {
namespace {

using Rows = std::vector<const ModelFitRow*>;

Rows found_rows(const ModelFits& fits) {
  Rows rows;
  for (const ModelFitRow& row : fits.rows) {
    if (row.misfit) rows.push_back(&row);
  }
  return rows;
}

const ModelFitRow& best_of(const Rows& rows) {
  return **std::ranges::min_element(rows, {}, [](const ModelFitRow* row) { return *row->misfit; });
}

std::string titles(const Rows& rows) {
  std::vector<std::string> names;
  for (const ModelFitRow* row : rows) names.push_back(fit_title(*row));
  return fmt::format("{}", fmt::join(names, ", "));
}

/// The best, and those that are as good.
std::string best_sentence(const Rows& rows) {
  const ModelFitRow& best = best_of(rows);
  std::string text = fmt::format("The fitted sessions are followed best by {}, with a misfit of {}",
                                 fit_title(best), format_percent(best.misfit));
  Rows alike;
  for (const ModelFitRow* row : rows) {
    if (row != &best && *row->misfit <= kAlike * *best.misfit) alike.push_back(row);
  }
  if (rows.size() == 1) return text + ". ";
  if (alike.empty()) return text + "; none of the others comes within 5 % of that. ";
  constexpr std::size_t kMost = 2;
  if (alike.size() <= kMost) {
    text += fmt::format("; {} {} within 5 % of that. ", titles(alike),
                        alike.size() == 1 ? "comes" : "come");
  } else if (alike.size() == rows.size() - 1) {
    text += "; all others come within 5 % of that. ";
  } else {
    text += fmt::format("; {} of the {} others come within 5 % of that. ", alike.size(),
                        rows.size() - 1);
  }
  const auto fewest = *std::ranges::min_element(
      alike, {}, [](const ModelFitRow* row) { return row->parameters.value_or(0); });
  if (fewest->parameters && best.parameters && *fewest->parameters < *best.parameters) {
    text += fmt::format("The simplest of these is {}, with {} parameters instead of {}. ",
                        fit_title(*fewest), *fewest->parameters, *best.parameters);
  }
  return text;
}

using Differs = std::function<bool(const ModelFitRow& smaller, const ModelFitRow& larger)>;

/// Misfit of each fit over that of the fit that differs from it in one freedom.
std::vector<double> ratios(const Rows& rows, const Differs& differs) {
  std::vector<double> found;
  for (const ModelFitRow* smaller : rows) {
    for (const ModelFitRow* larger : rows) {
      if (smaller->model != larger->model || !differs(*smaller, *larger)) continue;
      if (*larger->misfit > 0) found.push_back(*smaller->misfit / *larger->misfit);
    }
  }
  std::ranges::sort(found);
  return found;
}

/// `1.2 to 3.4 times`
std::string times(const std::vector<double>& factors) {
  const std::string low = format_significant(factors.front(), 2);
  const std::string high = format_significant(factors.back(), 2);
  return low == high ? low + " times" : low + " to " + high + " times";
}

/// What a freedom is worth.
/// @param without  "Weft and warp with one curve"
/// @param alike    what follows where it is worth nothing
std::string freedom_sentence(const std::vector<double>& factors, const std::string& without,
                             const std::string& alike) {
  if (factors.empty()) return {};
  if (factors.back() <= kAlike) return alike;
  return fmt::format("{} leave {} the misfit{}. ", without, times(factors),
                     factors.front() > 1.5 ? ": they fail this cloth" : "");
}

bool contains(const ModelFitRow& larger, const ModelFitRow& smaller) {
  return larger.model == smaller.model && larger.variant != smaller.variant &&
         larger.is_nonlinear() >= smaller.is_nonlinear() &&
         larger.is_orthotropic() >= smaller.is_orthotropic();
}

/// More freedom cannot fit worse, unless a search has missed the better solution.
std::string nested_sentence(const Rows& rows) {
  constexpr double kRounding = 1e-9;
  std::vector<std::string> worse;
  bool any = false;
  for (const ModelFitRow* larger : rows) {
    for (const ModelFitRow* smaller : rows) {
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
std::pair<const ModelFitRow*, const ModelFitRow*> extremes(const Rows& rows, std::size_t session) {
  Rows known;
  for (const ModelFitRow* row : rows) {
    if (row->errors[session]) known.push_back(row);
  }
  if (known.empty()) return {nullptr, nullptr};
  const auto [least, largest] = std::ranges::minmax_element(
      known, {}, [&](const auto* row) { return *row->errors[session]; });
  return {*least, *largest};
}

/// Where fits of like misfit differ: what counts little in it may matter for a use.
std::string difference_sentence(const ModelFits& fits, const Rows& rows) {
  constexpr double kNotable = 1.5;
  double most = kNotable;
  std::string text;
  for (std::size_t s = 0; s < fits.sessions.size(); ++s) {
    const auto [least, largest] = extremes(rows, s);
    if (fits.sessions[s].validation || !least || *least->errors[s] <= 0) continue;
    const double ratio = *largest->errors[s] / *least->errors[s];
    if (ratio <= most) continue;
    most = ratio;
    const std::string& unit = fits.sessions[s].unit;
    text = fmt::format("Of the fitted sessions {} differs most: from {} {} ({}) to {} {} ({}). ",
                       fits.sessions[s].name, format_significant(least->errors[s], 3), unit,
                       fit_title(*least), format_significant(largest->errors[s], 3), unit,
                       fit_title(*largest));
  }
  return text;
}

std::string prediction_sentence(const ModelFits& fits, const Rows& rows) {
  constexpr std::size_t kMost = 3;
  std::vector<std::string> parts;
  for (std::size_t s = 0; s < fits.sessions.size(); ++s) {
    const ModelFitRow* best = fits.sessions[s].validation ? extremes(rows, s).first : nullptr;
    if (!best || parts.size() == kMost) continue;
    parts.push_back(fmt::format("{} by {} ({} {})", fits.sessions[s].name, fit_title(*best),
                                format_significant(best->errors[s], 3), fits.sessions[s].unit));
  }
  if (parts.empty() || rows.size() == 1) return {};
  return fmt::format(
      "Of what was not fitted {}: {}. ",
      parts.size() == 1 ? "one session is predicted best" : "sessions are predicted best",
      fmt::join(parts, ", "));
}

std::string failure_sentence(const ModelFits& fits) {
  const auto failed =
      std::ranges::count_if(fits.rows, [](const ModelFitRow& row) { return !row.failure.empty(); });
  Rows stopped;
  for (const ModelFitRow& row : fits.rows) {
    if (row.failure.empty() && !row.converged) stopped.push_back(&row);
  }
  std::string text;
  if (failed > 0) text = fmt::format("{} of {} fits failed. ", failed, fits.rows.size());
  if (!stopped.empty()) text += fmt::format("Not converged: {}. ", titles(stopped));
  return text;
}

}  // namespace

std::string model_fits_verdict(const ModelFits& fits) {
  const Rows rows = found_rows(fits);
  if (rows.empty()) return "No fit has a result.";
  std::string text = best_sentence(rows);
  text += freedom_sentence(
      ratios(rows,
             [](const ModelFitRow& smaller, const ModelFitRow& larger) {
               return !smaller.is_orthotropic() && larger.is_orthotropic() &&
                      smaller.is_nonlinear() == larger.is_nonlinear();
             }),
      "Isotropic variants, which take weft and warp as one,",
      "Isotropic variants fit as well: these sessions do not tell weft from warp. ");
  text += freedom_sentence(
      ratios(rows,
             [](const ModelFitRow& smaller, const ModelFitRow& larger) {
               return !smaller.is_nonlinear() && larger.is_nonlinear() &&
                      smaller.is_orthotropic() == larger.is_orthotropic();
             }),
      "Linear variants, whose stiffnesses do not change with strain,",
      "Linear variants fit as well: these sessions do not show that stiffness changes with "
      "strain. ");
  text += difference_sentence(fits, rows) + nested_sentence(rows) +
          prediction_sentence(fits, rows) + failure_sentence(fits);
  text.pop_back();
  return text;
}

}  // namespace pliant::report
