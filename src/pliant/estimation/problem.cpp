#include "pliant/estimation/problem.h"

#include <algorithm>
#include <set>
#include <utility>

#include "pliant/base/parallel.h"
#include "pliant/base/stopwatch.h"

namespace pliant {
namespace {

/// Turns derivatives by parameters into those by unknowns, which may set several.
class ByUnknowns : public FrameSink {
 public:
  /// @param unknowns  of each column of what comes
  /// @param count     of all unknowns; 0: no derivatives are wanted
  ByUnknowns(std::vector<int> unknowns, Eigen::Index count, FrameSink& frames)
      : unknowns_(std::move(unknowns)), count_(count), frames_(frames) {}

  void take(int frame, const PredictedFrame& rows) override {
    PredictedFrame by_unknowns{rows.value, {}, rows.length_gain};
    by_unknowns.by.setZero(count_ > 0 ? rows.value.size() : 0, count_);
    for (std::size_t i = 0; i < unknowns_.size(); ++i) {
      by_unknowns.by.col(unknowns_[i]) += rows.by.col(static_cast<Eigen::Index>(i));
    }
    frames_.take(frame, by_unknowns);
  }

 private:
  std::vector<int> unknowns_;
  Eigen::Index count_;
  FrameSink& frames_;
};

}  // namespace

void set_bounds(const std::vector<Unknown>& unknowns, LeastSquaresProblem& problem) {
  const auto count = static_cast<Eigen::Index>(unknowns.size());
  problem.lower.resize(count);
  problem.upper.resize(count);
  problem.scale.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Unknown& unknown = unknowns[static_cast<std::size_t>(i)];
    problem.lower(i) = unknown.lower;
    problem.upper(i) = unknown.upper;
    problem.scale(i) = unknown.scale;
  }
}

Problem::Problem(std::vector<ProblemPart> parts, std::vector<Unknown> unknowns, Workers workers)
    : parts_(std::move(parts)),
      unknowns_(std::move(unknowns)),
      priors_(priors_of(unknowns_)),
      workers_(std::move(workers)) {
  for (ProblemPart& part : parts_) {
    places_.push_back(places_in(*part.predictor));
    if (part.weight.size() == 0) part.weight = part.experiment->weights();
  }
}

Problem::Places Problem::places_in(const Predictor& predictor) const {
  const std::vector<std::string>& names = predictor.parameters();
  Places places;
  for (const bool free : {true, false}) {
    for (std::size_t u = 0; u < unknowns_.size(); ++u) {
      if ((unknowns_[u].lower < unknowns_[u].upper) != free) continue;
      for (const std::string& parameter : unknowns_[u].parameters) {
        const auto found = std::ranges::find(names, parameter);
        if (found == names.end()) continue;  // a number of another experiment or component
        places.parameters.push_back(static_cast<int>(found - names.begin()));
        places.unknowns.push_back(static_cast<int>(u));
      }
    }
    if (free) places.free = places.parameters.size();
  }
  return places;
}

int Problem::rows() const {
  Eigen::Index rows = 0;
  for (const ProblemPart& part : parts_) rows += (part.weight.array() > 0).count();
  return static_cast<int>(rows);
}

double Problem::emphasis(std::size_t part) const {
  double rows = 0, sum = 0;
  for (const ProblemPart& each : parts_) {
    const double own = each.experiment->weights().sum();
    rows += own;
    sum += own * each.experiment->info().weight;
  }
  return std::sqrt(parts_[part].experiment->info().weight * rows / sum);
}

std::optional<PredictedRows> Problem::predict(std::size_t part, const Eigen::VectorXd& values,
                                              bool derivatives) const {
  const Stopwatch watch;
  auto rows = predict(part, values, derivatives, workers_.threads);
  seconds_ += watch.seconds();
  return rows;
}

bool Problem::predict(std::size_t part, const Eigen::VectorXd& values, FrameSink& frames) const {
  const Stopwatch watch;
  const bool found = predict(part, values, /*derivatives=*/true, workers_.threads, frames);
  seconds_ += watch.seconds();
  return found;
}

std::optional<PredictedRows> Problem::predict(std::size_t part, const Eigen::VectorXd& values,
                                              bool derivatives, int threads) const {
  StoredRows rows(*parts_[part].experiment, derivatives ? values.size() : 0);
  if (!predict(part, values, derivatives, threads, rows)) return std::nullopt;
  return std::move(rows).rows();
}

bool Problem::predict(std::size_t part, const Eigen::VectorXd& values, bool derivatives,
                      int threads, FrameSink& frames) const {
  const Places& places = places_[part];
  Predictor& predictor = *parts_[part].predictor;
  Eigen::VectorXd parameters = predictor.values();
  parameters(places.parameters) = values(places.unknowns);
  const auto free = static_cast<std::ptrdiff_t>(derivatives ? places.free : 0);
  const std::vector<int> by(places.parameters.begin(), places.parameters.begin() + free);
  ByUnknowns by_unknowns({places.unknowns.begin(), places.unknowns.begin() + free},
                         derivatives ? values.size() : 0, frames);
  return predictor.predict(parameters, by, {threads, workers_.stop}, by_unknowns);
}

bool Problem::evaluate(const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                       Eigen::MatrixXd* jacobian) const {
  const int count = static_cast<int>(parts_.size());
  std::vector<std::optional<PredictedRows>> found(parts_.size());
  const Stopwatch watch;
  parallel_for(count, workers_.threads, [&](int p) {
    const auto part = static_cast<std::size_t>(p);
    found[part] = predict(part, values, jacobian != nullptr, std::max(workers_.threads / count, 1));
  });
  seconds_ += watch.seconds();
  if (jacobian) jacobian->setZero(residual.size(), values.size());
  Eigen::Index row = 0;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    if (!found[p]) return false;
    const ProblemPart& part = parts_[p];
    const Eigen::Index rows = part.weight.size();
    residual.segment(row, rows) =
        part.weight.cwiseProduct(found[p]->value - part.experiment->measured());
    if (found[p]->by.size() > 0 && jacobian) {
      jacobian->middleRows(row, rows) = part.weight.asDiagonal() * found[p]->by;
    }
    row += rows;
  }
  for (const SumPrior& prior : priors_) {
    residual(row) = prior.miss(values);
    for (const auto& [unknown, factor] : prior.sum) {
      if (jacobian) (*jacobian)(row, unknown) = factor / prior.sd;
    }
    ++row;
  }
  return true;
}

LeastSquaresProblem Problem::least_squares() const {
  LeastSquaresProblem problem;
  problem.evaluate = [this](const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                            Eigen::MatrixXd* jacobian) {
    return evaluate(values, residual, jacobian);
  };
  problem.residuals = static_cast<int>(priors_.size());
  for (const ProblemPart& part : parts_) problem.residuals += part.experiment->rows();
  problem.not_negative = not_negative_;
  set_bounds(unknowns_, problem);
  return problem;
}

std::vector<Eigen::Matrix3Xd> Problem::guesses(std::size_t part) const {
  return parts_[part].predictor->guesses();
}

void Problem::begin_at(std::size_t part, std::vector<Eigen::Matrix3Xd> guesses) {
  parts_[part].predictor->begin_at(std::move(guesses));
}

EquilibriumWork Problem::work() const {
  EquilibriumWork sum;
  for (std::size_t p = 0; p < parts_.size(); ++p) {
    EquilibriumWork own = parts_[p].predictor->work();
    const auto free = static_cast<std::ptrdiff_t>(places_[p].free);
    const std::set<int> unknowns(places_[p].unknowns.begin(), places_[p].unknowns.begin() + free);
    own.counts.differences = own.counts.differentiated * static_cast<int>(unknowns.size());
    sum += own;
  }
  sum.seconds = sum.seconds.on_the_clock(seconds_);
  return sum;
}

}  // namespace pliant
