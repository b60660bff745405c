#include "pliant/estimation/law_growth.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "pliant/estimation/addend_starts.h"
#include "pliant/estimation/growth_measure.h"
#include "pliant/estimation/linear_start.h"
#include "pliant/material/addend/dahl_branch.h"

namespace pliant {
namespace {

constexpr double kExact = 1e-6;  // of the noise first assumed: as good as none
constexpr int kPatience = 2;     // steps that growth goes on without one that is worth it

/// A law that growth has fitted.
struct GrownLaw {
  LawFit fit;
  FittedModel model;
};

class LawGrowth {
 public:
  LawGrowth(const ComponentProblem& problem, const ComponentLaw& form, const GrowthLimits& limits,
            const FitOptions& options)
      : problem_(problem),
        form_(form),
        limits_(limits),
        options_(options),
        even_(is_even(component_of(problem))),
        strains_(data_strains(problem, even_)) {
    if (limits.control_points > 1 || limits.branches > 1) {
      measure_ = measure_of_growth(problem, strains_, form, options, even_);
    }
  }

  GrownFit run() {
    GrownLaw accepted = first();
    note(accepted, true);
    GrownLaw front = accepted;
    GrowthEnd end = GrowthEnd::not_worth_it;
    for (int idle = 0; idle < kPatience;) {
      if (accepted.model.rms <= kExact) {
        end = GrowthEnd::accurate;
        break;
      }
      std::vector<GrownLaw> richer = steps_from(front.fit);
      if (richer.empty()) {
        if (idle == 0) end = GrowthEnd::most;
        break;
      }
      const auto best = std::ranges::max_element(
          richer, {}, [&](const GrownLaw& law) { return growth_gain(accepted.model, law.model); });
      front = *best;
      const bool worth = is_worth(accepted.model, front.model, kExact);
      for (const GrownLaw& law : richer) note(law, worth && &law == &*best);
      idle = worth ? 0 : idle + 1;
      if (worth) accepted = front;
    }
    return {in_order(accepted.fit), std::move(stages_), end};
  }

 private:
  bool points_grow() const { return limits_.control_points > 0; }

  int branches_of(const ComponentLaw& law) const {
    if (law.friction_law == FrictionLaw::none) return 0;
    return 1 + static_cast<int>(law.addends.size() - form_.addends.size());
  }

  bool has_grown_branches(const ComponentLaw& law) const { return branches_of(law) > 1; }

  void note(const GrownLaw& law, bool accepted) {
    stages_.push_back({points_grow() ? law.fit.law.stiffness.size() : 0, branches_of(law.fit.law),
                       law.fit.rms, accepted});
  }

  GrownLaw judged(LawFit fit) const {
    const double mean_square = 2 * fit.solution.cost / problem_.used_rows();
    const double explicable = std::max(mean_square - measure_.unexplained, measure_.least);
    const int placed = points_grow() ? std::max(fit.law.stiffness.size() - 2, 0) : 0;
    const FittedModel model{std::sqrt(explicable), free_count(fit.unknowns), placed, measure_.rows};
    return {std::move(fit), model};
  }

  GrownLaw first() const {
    if (!points_grow()) return judged(fit_law(problem_, form_, options_));
    return judged(
        fit_law(problem_, on_knots(form_, {even_ ? 0.0 : strains_.high}, even_), options_));
  }

  std::vector<GrownLaw> steps_from(const LawFit& fit) const {
    std::vector<GrownLaw> richer;
    if (auto finer = with_point(fit)) richer.push_back(judged(std::move(*finer)));
    if (auto branched = with_branch(fit)) richer.push_back(judged(std::move(*branched)));
    return richer;
  }

  /// Nothing where there may be no more.
  std::optional<LawFit> with_point(const LawFit& fit) const {
    const ComponentLaw& law = fit.law;
    if (law.stiffness.size() >= limits_.control_points) return std::nullopt;
    const std::vector<double> knots = split_knots(problem_, law, strains_);
    if (std::ssize(knots) == law.stiffness.size()) return std::nullopt;
    const LawStart finer{refined(law, knots), fit.nuisance};
    if (!has_grown_branches(law)) return fit_law(problem_, finer.law, options_, {finer});
    std::vector<LawStart> starts{finer};
    for (const double factor : {1.0, 0.3, 3.0}) {
      starts.push_back({linear_start(problem_, finer.law, factor * law.friction[2]).law});
    }
    return fit_law_from(problem_, starts, options_);
  }

  /// Nothing where there may be no more.
  std::optional<LawFit> with_branch(const LawFit& fit) const {
    const ComponentLaw& law = fit.law;
    if (law.friction_law != FrictionLaw::dahl || branches_of(law) >= limits_.branches) {
      return std::nullopt;
    }
    ComponentLaw branch{ScalarCurve::none()};
    branch.addends.emplace_back(dahl_branch(), Eigen::Vector3d::Ones());
    std::vector<LawStart> starts;
    for (const ComponentLaw& begun : addend_starts(branch, problem_.scale())) {
      ComponentLaw more = law;
      more.addends.push_back(begun.addends.front());
      starts.push_back({linear_start(problem_, more, law.friction[2]).law, fit.nuisance});
    }
    return fit_law_from(problem_, starts, options_);
  }

  /// The same law, its branches sorted by tau: which is called the component's own, and which an
  /// addend, the data do not say. What a study says of one by its name keeps it in its place.
  LawFit in_order(const LawFit& fit) const {
    ComponentLaw sorted = fit.law;
    std::vector<Addend*> addends;
    for (Addend& addend : sorted.addends) {
      if (&addend.kind() == &dahl_branch()) addends.push_back(&addend);
    }
    const bool named =
        !options_.fix.empty() || !options_.bounds.empty() || !options_.priors.empty();
    if (fit.law.friction_law != FrictionLaw::dahl || addends.empty() || named) return fit;
    std::vector<Eigen::Vector3d> branches{
        {fit.law.friction[0], fit.law.friction[1], fit.law.friction[2]}};
    for (const Addend* addend : addends) branches.emplace_back(addend->values());
    const auto tau = [](const Eigen::Vector3d& branch) { return branch(2); };
    if (std::ranges::is_sorted(branches, {}, tau)) return fit;
    std::ranges::sort(branches, {}, tau);
    std::ranges::copy(branches.front(), sorted.friction.begin());
    for (std::size_t b = 1; b < branches.size(); ++b) {
      *addends[b - 1] = Addend(dahl_branch(), branches[b]);
    }
    LawFit again = fit_law_from(problem_, {{sorted, fit.nuisance}}, options_);
    again.starts = fit.starts;
    return again;
  }

  const ComponentProblem& problem_;
  ComponentLaw form_;
  GrowthLimits limits_;
  const FitOptions& options_;
  bool even_;
  DataStrains strains_;
  GrowthMeasure measure_;
  std::vector<GrowthStage> stages_;
};

}  // namespace

GrownFit grow_law(const ComponentProblem& problem, const ComponentLaw& form,
                  const GrowthLimits& limits, const FitOptions& options) {
  return LawGrowth(problem, form, limits, options).run();
}

}  // namespace pliant
