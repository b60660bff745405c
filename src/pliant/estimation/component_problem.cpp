#include "pliant/estimation/component_problem.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/experiment/row_times.h"

namespace pliant {
namespace {

// First guess of a residual's size, as a share of the measured range.
constexpr double kFirstNoiseShare = 0.01;

double first_noise(const ComponentExperiment& experiment) {
  return experiment.info().stated_noise().value_or(kFirstNoiseShare * experiment.reference());
}

}  // namespace

ComponentProblem::ComponentProblem(std::vector<const ComponentExperiment*> experiments,
                                   StopToken stop, RobustLoss loss, Journal& journal, int threads)
    : experiments_(std::move(experiments)),
      stop_(stop),
      loss_(loss),
      journal_(&journal),
      threads_(threads) {
  PLIANT_ASSERT(!experiments_.empty(), "a component is estimated from at least one experiment");
  double seconds = 0;
  for (const ComponentExperiment* experiment : experiments_) {
    first_nuisance_.push_back(nuisance_count_);
    nuisance_count_ += static_cast<int>(experiment->nuisance().size());
    used_.push_back(experiment->info().used);
    const std::vector<char>& used = used_.back();
    used_rows_ += static_cast<int>(std::count(used.begin(), used.end(), 1));
    seconds = std::max(seconds, duration_of(experiment->info()));
    const MeasuredPath& path = experiment->path();
    for (size_t i = 0; i < path.strain.size(); ++i) {
      if (!used[i]) continue;
      peak_stress_ = std::max(peak_stress_, std::abs(path.force[i] / path.factor[i]));
      largest_strain_ = std::max(largest_strain_, std::abs(path.strain[i]));
    }
    weight_.push_back(Eigen::VectorXd::Constant(experiment->rows(), 1 / first_noise(*experiment)));
  }
  if (seconds > 0) seconds_ = seconds;
}

std::optional<ComponentProblem> ComponentProblem::easy_part() const {
  std::vector<std::shared_ptr<const ComponentExperiment>> parts;
  std::vector<const ComponentExperiment*> experiments = experiments_;
  for (const ComponentExperiment*& experiment : experiments) {
    std::shared_ptr<const ComponentExperiment> part = experiment->easy_part();
    if (!part) continue;
    experiment = part.get();
    parts.push_back(std::move(part));
  }
  if (parts.empty()) return std::nullopt;
  ComponentProblem easy(experiments, stop_, loss_, *journal_, threads_);
  easy.parts_ = std::move(parts);
  return easy;
}

ComponentProblem ComponentProblem::restricted_to(const RowChoice& takes) const {
  ComponentProblem part = *this;
  part.used_rows_ = 0;
  for (size_t e = 0; e < experiments_.size(); ++e) {
    for (size_t i = 0; i < used_[e].size(); ++i) {
      part.used_[e][i] = used_[e][i] && takes(e, i);
      part.used_rows_ += part.used_[e][i];
    }
  }
  return part;
}

ComponentProblem ComponentProblem::restricted_to(size_t experiment, int specimen) const {
  return restricted_to([&](size_t e, size_t row) {
    return e == experiment && experiments_[e]->path().specimen[row] == specimen;
  });
}

std::vector<Unknown> ComponentProblem::unknowns(const ComponentLaw& shape,
                                                const FitOptions& options) const {
  const std::string& component = experiments_.front()->info().component;
  std::vector<Unknown> all = unknowns_of(shape, {component}, scale());
  for (const ComponentExperiment* experiment : experiments_) {
    const std::vector<Unknown> own = unknowns_of(*experiment);
    all.insert(all.end(), own.begin(), own.end());
  }
  apply_options(options, all);
  // Without friction the state of friction means nothing.
  for (Unknown& unknown : all) {
    const bool of_state = unknown.of_friction && !unknown.of_material;
    if (of_state && shape.friction_law == FrictionLaw::none) unknown.hold(0);
  }
  return all;
}

double ComponentProblem::take_noise(const MeasuredNoise& noise) {
  double change = 0;
  for (size_t e = 0; e < experiments_.size(); ++e) {
    if (noise.weight[e].maxCoeff() <= 0) continue;  // no row of it takes part
    const Eigen::ArrayXd counts = (noise.weight[e].array() > 0).cast<double>();
    const Eigen::ArrayXd before = counts * weight_[e].array();
    change = std::max(change,
                      (noise.weight[e].array() - before).matrix().norm() / before.matrix().norm());
    weight_[e] = noise.weight[e];
  }
  return change;
}

Problem ComponentProblem::problem(const ComponentLaw& shape, std::vector<Unknown> unknowns) const {
  std::vector<ProblemPart> parts;
  for (size_t e = 0; e < experiments_.size(); ++e) {
    const std::vector<char>& used = used_[e];
    Eigen::VectorXd weight = weight_[e];
    for (Eigen::Index i = 0; i < weight.size(); ++i) {
      if (!used[static_cast<size_t>(i)]) weight(i) = 0;
    }
    parts.push_back({experiments_[e], experiments_[e]->predictor(shape), std::move(weight)});
  }
  Problem problem(std::move(parts), std::move(unknowns), {threads_, stop_});
  problem.set_loss(loss_);
  return problem;
}

}  // namespace pliant
