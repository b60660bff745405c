#include "pliant/estimation/judgement.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/estimation/fit_result.h"
#include "pliant/estimation/verdict.h"
#include "pliant/experiment/registry.h"
#include "pliant/experiment/session/lost_frames.h"

namespace pliant {
namespace {

constexpr double kHardlyALoop = 0.02;  // of the work of loading: less is noise rather than friction
constexpr double kReservation = 3;     // times what is accepted: more is no use

/// Rows of a table that take part; empty where what is measured has no span of its own, such as
/// distances from a profile and repeated readings.
struct ComparedRows {
  Eigen::ArrayXd measured, predicted;
};

ComparedRows compared_rows(const ExperimentResult& e) {
  const bool repeats = facts_of_test(e.type).bends_by_weight;  // readings of one length
  if (repeats || e.quantity.kind == "distance") return {};
  if (e.measured.size() != e.predicted.size()) return {};
  std::vector<Eigen::Index> rows;
  for (Eigen::Index i = 0; i < e.measured.size(); ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (row >= e.used.size() || e.used[row]) rows.push_back(i);
  }
  return {e.measured(rows).array(), e.predicted(rows).array()};
}

double span_of(const Eigen::ArrayXd& values) { return values.maxCoeff() - values.minCoeff(); }

/// A figure of an experiment over what is accepted of it, and how it is told.
struct Figure {
  double excess = 0;
  std::string reason;
};

// Of what the best model that knows nothing of the material leaves beyond noise: where weight alone
// makes a force, that is more than a constant. Noise that is a third of it leaves nothing to judge.
std::optional<double> explained_share(const ExperimentResult& e, const ComparedRows& rows) {
  constexpr double kTellable = 3;
  const double noise = std::pow(e.noise_floor.value_or(0), 2);
  const double error = (rows.predicted - rows.measured).square().mean();
  const double unknowing = e.limp_rms ? std::pow(*e.limp_rms, 2)
                                      : (rows.measured - rows.measured.mean()).square().mean();
  if (unknowing <= kTellable * kTellable * noise) return std::nullopt;
  return 1 - std::max(error - noise, 0.0) / (unknowing - noise);
}

std::string_view reference_of(const ExperimentResult& e) {
  if (facts_of_test(e.type).bends_by_weight) return "the mean overhang";
  if (facts_of_test(e.type).has_unknown_zero) return "the span of the force";
  if (e.quantity.kind == "distance") return e.sheet ? "the sheet's side" : "the strip's length";
  if (e.quantity.kind == "reading") return "the largest reading";
  return e.quantity.kind == "length" ? "the range of the lengths" : "the peak";
}

/// Forces and moments per width below a tenth of a newton in mN, as reports have them.
std::string with_unit(double value, double size, const MeasuredQuantity& quantity) {
  constexpr double kSmall = 0.1;
  const bool milli = quantity.unit == "N" && size * quantity.per_si < kSmall;
  return fmt::format("{:.3g} {}", value * quantity.per_si * (milli ? 1e3 : 1),
                     milli ? "mN" : quantity.unit);
}

ExperimentJudgement judged(const ExperimentResult& e, const Acceptance& accept) {
  ExperimentJudgement own;
  own.experiment = e.name;
  own.predicted = e.role == ExperimentRole::validate;
  own.errors["rms"] = e.points == 0 ? INFINITY : e.rms_percent / 100;
  std::vector<Figure> figures{
      {e.rms_percent / 100 / accept.rms,
       fmt::format("RMS error {} of {} (accepted: {})", in_percent(e.rms_percent / 100),
                   reference_of(e), in_percent(accept.rms))}};
  if (e.points == 0) figures.push_back({INFINITY, "nothing of it can be predicted"});
  const std::size_t missing = e.sheet ? e.sheet->missing_frames().size() : 0;
  if (missing > 0 && e.points > 0) {
    const auto frames = static_cast<double>(e.sheet->measured.frame_count());
    figures.push_back({static_cast<double>(missing) > kLostShare * frames ? INFINITY : kReservation,
                       fmt::format("{} of its frames have no equilibrium", missing)});
  }
  const ComparedRows rows = compared_rows(e);
  if (rows.measured.size() > 2 && span_of(rows.measured) > 0) {
    const double measured = span_of(rows.measured), predicted = span_of(rows.predicted);
    own.span_ratio = predicted / measured;
    own.errors["span"] = std::abs(*own.span_ratio - 1);
    figures.push_back({own.errors["span"] / accept.span,
                       fmt::format("the measured span of {} is predicted as {}",
                                   with_unit(measured, measured, e.quantity),
                                   with_unit(predicted, measured, e.quantity))});
    own.explained = explained_share(e, rows);
  }
  if (own.explained) {
    own.errors["unexplained"] = 1 - *own.explained;
    figures.push_back(
        {own.errors["unexplained"] / accept.unexplained,
         fmt::format("{} of {} is explained (accepted: {})",
                     in_percent(std::max(*own.explained, 0.0)),
                     e.limp_rms ? "what a strip without stiffness leaves" : "the variance",
                     in_percent(1 - accept.unexplained))});
  }
  if (e.measured_loop && e.predicted_loop) {
    const double measured = e.measured_loop->loop_loss, predicted = e.predicted_loop->loop_loss;
    if (measured >= kHardlyALoop) own.loop_ratio = predicted / measured;
    own.errors["loop"] = std::abs(predicted - measured) / std::max(measured, kHardlyALoop);
    figures.push_back({own.errors["loop"] / accept.loop,
                       fmt::format("the loop loses {}, predicted {}", in_percent(measured),
                                   in_percent(predicted))});
  }
  for (Figure& figure : figures) {
    if (std::isnan(figure.excess)) figure.excess = INFINITY;
  }
  std::ranges::stable_sort(figures, std::greater(), &Figure::excess);
  own.excess = figures.front().excess;
  for (Figure& figure : figures) {
    if (!(figure.excess <= 1)) own.reasons.push_back(std::move(figure.reason));
  }
  return own;
}

std::vector<CriterionJudgement> criteria_of(const std::vector<ExperimentJudgement>& experiments,
                                            const Acceptance& accept) {
  std::vector<CriterionJudgement> criteria;
  for (const auto& [key, limit] : limits_of(accept)) {
    CriterionJudgement& own = criteria.emplace_back();
    own.key = key;
    own.limit = limit;
    for (const ExperimentJudgement& e : experiments) {
      const auto error = e.errors.find(key);
      if (error == e.errors.end()) continue;
      const double value = std::isnan(error->second) ? INFINITY : error->second;
      if (own.worst && value <= *own.worst) continue;
      own.worst = value;
      own.experiment = e.experiment;
    }
  }
  return criteria;
}

std::string_view words_of(std::string_view key) {
  if (key == "rms") return "RMS error";
  if (key == "span") return "error of the span";
  if (key == "loop") return "error of the loop's loss";
  return "variance not explained";
}

Fitness fitness_of(double excess) {
  if (excess <= 1) return Fitness::fit;
  return excess <= kReservation ? Fitness::reservations : Fitness::unfit;
}

std::string worst_of(const std::vector<ExperimentJudgement>& experiments) {
  const ExperimentJudgement& worst = experiments.front();
  return fmt::format("{}: {}", worst.experiment, fmt::join(worst.reasons, "; "));
}

/// " in bend.warp" where what is no use are some components among others.
std::string where_unfit(const StudyResult& result, const Judgement& judgement) {
  std::set<std::string> unfit, all;
  for (const ExperimentResult& e : result.experiments) {
    all.insert(e.component);
    const auto own =
        std::ranges::find(judgement.experiments, e.name, &ExperimentJudgement::experiment);
    if (own->fitness() == Fitness::unfit) unfit.insert(e.component);
  }
  if (unfit.empty() || unfit.contains("") || unfit.size() == all.size()) return {};
  return fmt::format(" in {}", fmt::join(unfit, ", "));
}

/// " Left out, for no fit tells them: force offset, initial friction."
std::string left_out_sentence(const StudyResult& result) {
  std::set<std::string> numbers;
  for (const LeftOut& e : result.left_out) numbers.insert(e.numbers.begin(), e.numbers.end());
  if (numbers.empty()) return {};
  return fmt::format(" Left out, for no fit tells them: {}.", fmt::join(numbers, ", "));
}

std::string headline_of(const StudyResult& result, const Judgement& judgement, bool validated,
                        bool evaluation) {
  if (judgement.experiments.empty()) return "There is no experiment to judge the material by.";
  const bool missed = !judgement.experiments.front().reasons.empty();
  std::string text;
  switch (judgement.fitness) {
    case Fitness::fit:
      text = "Fit for use within the range of the data.";
      break;
    case Fitness::reservations:
      text = "Fit for use with reservations.";
      if (missed) text += " " + worst_of(judgement.experiments) + ".";
      break;
    case Fitness::unfit:
      text = "Not fit for use" + where_unfit(result, judgement) + ".";
      if (missed) text += " " + worst_of(judgement.experiments) + ".";
      break;
  }
  if (!result.converged) text += " The fit did not converge.";
  if (!result.questions.empty()) text += " Units, sizes or the fabric are in question.";
  if (!result.skipped.empty()) text += " Not all experiments are predicted.";
  text += left_out_sentence(result);
  if (!validated && !evaluation) text += " No experiment was kept to validate it.";
  return text;
}

}  // namespace

std::string in_percent(double share) {
  constexpr double kNothing = 1e-6;  // what rounding leaves of zero
  if (std::abs(share) >= 1) return fmt::format("{:.0f} %", 100 * share);
  return fmt::format("{:.2g} %", std::abs(share) < kNothing ? 0 : 100 * share);
}

std::string_view name_of(Fitness fitness) {
  switch (fitness) {
    case Fitness::fit:
      return "fit";
    case Fitness::reservations:
      return "reservations";
    case Fitness::unfit:
      return "unfit";
  }
  return "";
}

std::vector<std::pair<std::string_view, double>> limits_of(const Acceptance& accept) {
  return {{"rms", accept.rms},
          {"span", accept.span},
          {"loop", accept.loop},
          {"unexplained", accept.unexplained}};
}

std::string CriterionJudgement::text() const {
  if (!worst) {
    return fmt::format("{} (limit {}): no experiment tells it", words_of(key), in_percent(limit));
  }
  return fmt::format("{} {} ({}; limit {}): {}", words_of(key),
                     std::isinf(*worst) ? "without end" : in_percent(*worst), experiment,
                     in_percent(limit), passed() ? "pass" : "fail");
}

Fitness ExperimentJudgement::fitness() const { return fitness_of(excess); }

Judgement judge(const StudyResult& result, const Acceptance& accept, bool evaluation) {
  Judgement judgement;
  for (const ExperimentResult& e : result.experiments) {
    judgement.experiments.push_back(judged(e, accept));
  }
  std::ranges::stable_sort(judgement.experiments, std::greater(), &ExperimentJudgement::excess);
  judgement.criteria = criteria_of(judgement.experiments, accept);
  const bool validated =
      std::ranges::any_of(judgement.experiments, &ExperimentJudgement::predicted);
  if (!judgement.experiments.empty()) {
    judgement.fitness = judgement.experiments.front().fitness();
  }
  const bool doubtful = !result.questions.empty() || !result.skipped.empty();
  if (judgement.fitness == Fitness::fit && (!validated || doubtful)) {
    judgement.fitness = Fitness::reservations;
  }
  if (!result.converged) judgement.fitness = Fitness::unfit;
  judgement.headline = headline_of(result, judgement, validated, evaluation);
  judgement.details = verdict(result, accept, evaluation);
  judgement.undetermined = undetermined_with_reasons(result, evaluation);
  return judgement;
}

}  // namespace pliant
