#include "pliant/estimation/component_problem.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

// First guess of a residual's size, as a share of the measured range.
constexpr double kFirstNoiseShare = 0.01;
constexpr double kSmallestNoiseShare = 1e-9;  // noise-free data still has a weight

bool measures_length(const ComponentExperiment& experiment) {
  const std::string& kind = experiment.info().quantity.kind;
  return kind == "length" || kind == "distance";
}

std::optional<double> stated_noise(const ComponentExperiment& experiment) {
  const ExperimentInfo& info = experiment.info();
  return measures_length(experiment) ? info.length_noise : info.force_noise;
}

// Mean square of the used rows.
double mean_square(const Eigen::VectorXd& values, const std::vector<char>& used) {
  double sum = 0;
  int count = 0;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    if (!used[static_cast<size_t>(i)]) continue;
    sum += values(i) * values(i);
    ++count;
  }
  return count == 0 ? 0 : sum / count;
}

RowNoise make_noise(const ComponentExperiment& experiment, const std::vector<char>& used, double sd,
                    const Eigen::VectorXd& from_length) {
  RowNoise noise;
  noise.stated = stated_noise(experiment).has_value();
  noise.sd = (from_length.array().square() + sd * sd).sqrt();
  noise.typical = std::sqrt(mean_square(noise.sd, used));
  return noise;
}

}  // namespace

ComponentProblem::ComponentProblem(std::vector<const ComponentExperiment*> experiments)
    : experiments_(std::move(experiments)) {
  PLIANT_ASSERT(!experiments_.empty(), "a component is estimated from at least one experiment");
  smallest_strain_ = 1e300;
  for (const ComponentExperiment* experiment : experiments_) {
    first_nuisance_.push_back(nuisance_count_);
    nuisance_count_ += static_cast<int>(experiment->nuisance().size());
    used_.push_back(experiment->info().used);
    const std::vector<char>& used = used_.back();
    used_rows_ += static_cast<int>(std::count(used.begin(), used.end(), 1));
    const MeasuredPath& path = experiment->path();
    for (size_t i = 0; i < path.strain.size(); ++i) {
      if (!used[i]) continue;
      peak_stress_ = std::max(peak_stress_, std::abs(path.force[i] / path.factor[i]));
      largest_strain_ = std::max(largest_strain_, std::abs(path.strain[i]));
      const bool from_zero = !path.starts_flat.empty() && path.starts_flat[i];
      smallest_strain_ = std::min(smallest_strain_, from_zero ? 0.0 : std::abs(path.strain[i]));
    }
    const double sd =
        stated_noise(*experiment).value_or(kFirstNoiseShare * experiment->reference());
    noise_.push_back(make_noise(*experiment, used, sd, Eigen::VectorXd::Zero(experiment->rows())));
  }
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
  std::vector<Unknown> all = unknowns_of(shape, {component}, {peak_stress_, largest_strain_});
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

double ComponentProblem::update_noise(const ComponentLaw& law, const Eigen::VectorXd& nuisance) {
  double change = 0;
  for (size_t e = 0; e < experiments_.size(); ++e) {
    const ComponentExperiment& experiment = *experiments_[e];
    const auto count = static_cast<Eigen::Index>(experiment.nuisance().size());
    const auto prediction =
        experiment.predict(law, nuisance.segment(first_nuisance_[e], count), false);
    if (!prediction) continue;
    Eigen::VectorXd from_length = Eigen::VectorXd::Zero(experiment.rows());
    if (!measures_length(experiment) && prediction->length_gain.size() > 0) {
      from_length = experiment.info().length_noise.value_or(0) * prediction->length_gain;
    }
    const std::vector<char>& used = used_[e];
    const double smallest = kSmallestNoiseShare * experiment.reference();
    const double unexplained = mean_square(prediction->value - experiment.measured(), used) -
                               mean_square(from_length, used);
    const double sd =
        stated_noise(experiment).value_or(std::sqrt(std::max(unexplained, smallest * smallest)));
    const double before = noise_[e].typical;
    noise_[e] = make_noise(experiment, used, sd, from_length);
    change = std::max(change, std::abs(noise_[e].typical - before) / before);
  }
  return change;
}

Problem ComponentProblem::problem(const ComponentLaw& shape, std::vector<Unknown> unknowns) const {
  std::vector<ProblemPart> parts;
  for (size_t e = 0; e < experiments_.size(); ++e) {
    const std::vector<char>& used = used_[e];
    Eigen::VectorXd weight = Eigen::VectorXd::Zero(noise_[e].sd.size());
    for (Eigen::Index i = 0; i < weight.size(); ++i) {
      if (used[static_cast<size_t>(i)]) weight(i) = 1 / noise_[e].sd(i);
    }
    parts.push_back({experiments_[e], experiments_[e]->predictor(shape), std::move(weight)});
  }
  return {std::move(parts), std::move(unknowns), {}};
}

}  // namespace pliant
