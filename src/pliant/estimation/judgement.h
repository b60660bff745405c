#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant {

struct StudyResult;

/// How large the errors of an experiment may be (`accept:` of a study).
struct Acceptance {
  double rms = 0.05;          ///< RMS error over the peak (the range of the lengths, the length)
  double span = 0.1;          ///< difference of the predicted span of what is measured from 1
  double loop = 0.3;          ///< difference of the predicted loss of the loop from 1; of a loop
                              ///< that loses less than 2 % as if it lost that
  double unexplained = 0.05;  ///< share of what is measured, beyond noise, that is not predicted
};

/// The limits by their keys in a study, in their order.
std::vector<std::pair<std::string_view, double>> limits_of(const Acceptance& accept);

/// Whether a material may be used within the range of its data.
enum class Fitness { fit, reservations, unfit };

std::string_view name_of(Fitness fitness);

/// How well an experiment is predicted, by its own scale.
struct ExperimentJudgement {
  std::string experiment;
  bool predicted = false;                        ///< nothing was fitted to it
  double excess = 0;                             ///< the worst of its figures over what is accepted
  std::optional<double> span_ratio, loop_ratio;  ///< predicted over measured
  /// Share of the mean square about the mean, or about what a material without any stiffness does,
  /// noise taken out of both; nothing where that is hardly more than noise.
  std::optional<double> explained;
  std::vector<std::string> reasons;           ///< figures that are not accepted, the worst first
  std::map<std::string_view, double> errors;  ///< by the keys of the limits; those that it has

  /// Up to three times what is accepted is a reservation.
  Fitness fitness() const;
};

/// A limit of the study, and the experiment that comes nearest to it or exceeds it most.
struct CriterionJudgement {
  std::string_view key;
  double limit = 0;
  std::optional<double> worst;  ///< none where no experiment has such an error
  std::string experiment;

  bool passed() const { return !worst || *worst <= limit; }
  /// "RMS error 1.8 % (warp; limit 3 %): pass".
  std::string text() const;
};

/// What the errors of a fit or an evaluation allow to be said of its material.
struct Judgement {
  Fitness fitness = Fitness::reservations;
  std::string headline;                          ///< one or two sentences
  std::string details;                           ///< what the numbers say, below it
  std::vector<std::string> undetermined;         ///< by the data, with reasons
  std::vector<ExperimentJudgement> experiments;  ///< the worst first
  std::vector<CriterionJudgement> criteria;      ///< as `limits_of` has them
};

/// "1.8 %" of 0.018.
std::string in_percent(double share);

/// Judges all experiments of a result. A fit that did not converge is not fit for use; one of which
/// nothing was kept for validation has that for a reservation.
/// @param evaluation  nothing was fitted
Judgement judge(const StudyResult& result, const Acceptance& accept, bool evaluation);

}  // namespace pliant
