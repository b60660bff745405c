#include "pliant/experiment/hanging/hanging_weights.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/hanging/weight_path.h"
#include "pliant/experiment/strip_figures.h"

namespace pliant {
namespace {

// Weights come as forces (weight_N) or as masses (weight_g).
std::vector<double> read_weights(const DataRows& data) {
  const std::string unit = data.quantity_unit("weight");
  if (!unit_scale(unit, Dimension::mass)) return data.quantity("weight", Dimension::force);
  std::vector<double> weights = data.quantity("weight", Dimension::mass);
  for (double& weight : weights) weight *= kStandardGravity;
  return weights;
}

double half_mass(const HangingWeightsSpec& spec, const ClothFacts& cloth) {
  return cloth.density * (spec.length * spec.width) / 2;
}

// Of clip and half of the cloth (N).
double added_weight(const HangingWeightsSpec& spec, const ClothFacts& cloth) {
  return (spec.clip_mass + half_mass(spec, cloth)) * kStandardGravity;
}

void require_increasing_steps(const DataRows& data, const std::vector<SpecimenRows>& specimens) {
  const auto steps = data.optional_integers("step");
  if (!steps) return;
  const auto repeats = data.optional_integers("repeat");
  const auto peaks = data.optional_quantity("peak", Dimension::force);
  for (const SpecimenRows& specimen : specimens) {
    for (int i = specimen.first + 1; i < specimen.first + specimen.count; ++i) {
      const auto now = static_cast<size_t>(i);
      const bool same_cycle = (!repeats || (*repeats)[now] == (*repeats)[now - 1]) &&
                              (!peaks || (*peaks)[now] == (*peaks)[now - 1]);
      if (!same_cycle || (*steps)[now] > (*steps)[now - 1]) continue;
      throw InputError(data.location(i, "step"),
                       fmt::format("step {} comes after step {}", (*steps)[now], (*steps)[now - 1]),
                       "steps that increase within a cycle: rows in the order measured");
    }
  }
}

/// Grams hang with as many grams-force.
std::string unit_of_weights(const DataRows& data) {
  const std::string unit = data.quantity_unit("weight");
  return unit_scale(unit, Dimension::mass) ? unit + "f" : unit;
}

std::vector<std::string> questions_of(const HangingWeights& weights, const ExperimentSpec& spec,
                                      const DataRows& data, const PulledRows& rows,
                                      double density) {
  StripFigures strip(*spec.test, density);
  const auto weight = strip.column("weight", Dimension::force, unit_of_weights(data));
  const double largest = std::ranges::max(read_weights(data));
  strip.add(figures::kHungWeight, largest, {{weight}});
  if (const double mass = spec_of<HangingWeightsSpec>(spec).clip_mass; mass > 0) {
    const auto clip = strip.field("clip_mass", Dimension::mass, mass);
    strip.add(figures::kClip, mass, {{clip}});
    strip.add(figures::kClipShare, mass * kStandardGravity / largest, {{clip}, {weight, -1}});
  }
  const auto other_slip = strip.add_pull(rows, weight);
  return first_asked({swap_question(weights, "length", "weight"), other_slip, strip.question()});
}

}  // namespace

HangingWeights::HangingWeights(const HangingWeightsSpec& spec, const std::vector<double>& weights,
                               const ClothFacts& cloth)
    : geometry_{spec.length, spec.width, cloth.membrane} {
  const double added = added_weight(spec, cloth);
  for (const double weight : weights) force_.push_back(weight + added);
  starts_rested_.assign(force_.size(), 0);
  starts_rested_.front() = 1;
  measured_ = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(force_.size()));
}

HangingWeights::HangingWeights(const ExperimentSpec& spec, const DataRows& data,
                               const ClothFacts& cloth)
    : HangingWeights(spec_of<HangingWeightsSpec>(spec), read_weights(data), cloth) {
  const auto& own = spec_of<HangingWeightsSpec>(spec);
  specimens_ = data.specimens();
  const std::vector<double> weights = read_weights(data);
  const std::vector<double> lengths = data.quantity("length", Dimension::length);
  require_rows(specimens_, data, 3);
  require_positive(lengths, data, "length");
  require_change(weights, data, "weight");
  require_increasing_steps(data, specimens_);

  const auto repeats = data.optional_integers("repeat");
  for (const SpecimenRows& s : specimens_) starts_rested_[static_cast<size_t>(s.first)] = 1;
  if (own.rested && repeats) {
    for (size_t i = 1; i < force_.size(); ++i) {
      if ((*repeats)[i] != (*repeats)[i - 1]) starts_rested_[i] = 1;
    }
  }

  measured_ = Eigen::Map<const Eigen::VectorXd>(lengths.data(), static_cast<int>(lengths.size()));
  info_ = describe_experiment(spec, data, {"length_mm", "length", "mm", 1e3});
  read_path();
  warn_of_order(data, own.rested);
  if (own.rest_length == RestLength::unknown && spec.role == ExperimentRole::fit) {
    free_rest_length();
    info_.handled.emplace_back("the rest length is estimated along (nuisance parameter)");
  }
  info_.handled.push_back(fmt::format(
      "weights drive the path and count as exact; clip ({:.4g} g) and half of the cloth ({:.4g} g) "
      "add {:.4g} N to each",
      own.clip_mass * 1e3, half_mass(own, cloth) * 1e3, added_weight(own, cloth)));
  if (cloth.density == 0) {
    info_.warnings.push_back("no density is given: the cloth's own weight is left out");
  }
  info_.questions = questions_of(*this, spec, data,
                                 {.column = "length",
                                  .unit = data.quantity_unit("length"),
                                  .length = lengths,
                                  .force = force_},
                                 cloth.density);
  const auto shortest = std::min_element(lengths.begin(), lengths.end());
  if (info_.questions.empty() && *shortest < 0.95 * own.length) {
    info_.warnings.push_back(
        fmt::format("the shortest length, {}, is far below the gauge length, {}",
                    millimetres(*shortest), millimetres(own.length)));
  }
}

// Tables may be sorted by peaks, each hung several times.
void HangingWeights::warn_of_order(const DataRows& data, bool rested) {
  const auto repeats = data.optional_integers("repeat");
  if (!repeats || rested) return;
  const auto peaks = data.optional_quantity("peak", Dimension::force);
  const auto higher = [&](std::size_t row) { return peaks && (*peaks)[row] > (*peaks)[row - 1]; };
  if (auto warning = backward_count("repeat", *repeats, specimens_, higher)) {
    info_.warnings.push_back(std::move(*warning));
  }
}

// One of each specimen, within 10 % of the stated length.
void HangingWeights::free_rest_length() {
  const double change = 0.1 * geometry_.gauge_length;
  for (size_t s = 0; s < specimens_.size(); ++s) {
    nuisance_.push_back(
        {nuisance_name(info_, s, "rest_length_change"), "m", 0, -change, change, 0.1 * change});
  }
}

std::unique_ptr<ComponentExperiment> HangingWeights::with_free_length() const {
  if (!nuisance_.empty()) return nullptr;
  auto copy = std::make_unique<HangingWeights>(*this);
  copy->free_rest_length();
  return copy;
}

void HangingWeights::read_path() {
  int anchor = 0, direction = 1, specimen = -1;
  for (int i = 0; i < rows(); ++i) {
    const auto row = static_cast<size_t>(i);
    if (starts_rested_[row]) {
      anchor = i;
      direction = 1;
    } else if (force_[row] != force_[row - 1]) {
      const int now = force_[row] > force_[row - 1] ? 1 : -1;
      if (now != direction) anchor = i - 1;
      direction = now;
    }
    if (specimen + 1 < static_cast<int>(specimens_.size()) &&
        specimens_[static_cast<size_t>(specimen + 1)].first == i) {
      ++specimen;
    }
    path_.strain.push_back(strain_at(geometry_, measured_(i)));
    path_.force.push_back(force_[row]);
    path_.factor.push_back(force_factor(geometry_, path_.strain.back()));
    path_.direction.push_back(direction);
    path_.anchor.push_back(anchor);
    path_.specimen.push_back(specimen);
  }
}

std::optional<Prediction> HangingWeights::predict(const ComponentLaw& law,
                                                  const Eigen::VectorXd& nuisance,
                                                  bool with_jacobian) const {
  auto hung = hang_weights(law, geometry_, force_, starts_rested_, with_jacobian);
  if (!hung) return std::nullopt;
  Prediction prediction{
      std::move(hung->length), std::move(hung->jacobian), std::move(hung->strain), {}};
  if (nuisance.size() == 0) return prediction;
  const Eigen::Index of_law = law.parameter_count();
  if (with_jacobian) prediction.jacobian.conservativeResize(rows(), of_law + nuisance.size());
  for (Eigen::Index s = 0; s < nuisance.size(); ++s) {
    const SpecimenRows& own = specimens_[static_cast<size_t>(s)];
    const double factor = 1 + nuisance(s) / geometry_.gauge_length;
    auto length = prediction.value.segment(own.first, own.count);
    if (with_jacobian) {
      auto by = prediction.jacobian.middleRows(own.first, own.count);
      by.leftCols(of_law) *= factor;
      by.rightCols(nuisance.size()).setZero();
      by.col(of_law + s) = length / geometry_.gauge_length;
    }
    length *= factor;
  }
  return prediction;
}

std::optional<LoopSeries> HangingWeights::loop(const Eigen::VectorXd& length) const {
  return LoopSeries{length, Eigen::Map<const Eigen::VectorXd>(force_.data(), rows()),
                    geometry_.width, geometry_.gauge_length};
}

}  // namespace pliant
