#include "pliant/estimation/solid/sample_growth.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "pliant/estimation/solid/linearised_problem.h"
#include "pliant/estimation/statistics/model_growth.h"
#include "pliant/geometry/spread_points.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

/// Places, by their number in a list.
using Choice = std::vector<std::size_t>;

/// Unknowns of one component, or of a limit: as many of each sample, the samples one after the
/// other, or those that all share.
struct UnknownBlock {
  std::size_t first = 0, count = 0;
  bool differs = false;
};

std::vector<UnknownBlock> blocks_of(const std::vector<Unknown>& unknowns,
                                    const Material& material) {
  std::vector<UnknownBlock> blocks;
  for (std::size_t u = 0; u < unknowns.size(); ++u) {
    if (u == 0 || unknowns[u].owner != unknowns[u - 1].owner) {
      blocks.push_back({u, 0, differs_in(material, unknowns[u].owner)});
    }
    ++blocks.back().count;
  }
  return blocks;
}

/// The unknowns of a choice of samples: what the many unknowns of samples at all places are of
/// them.
struct FewUnknowns {
  Eigen::MatrixXd combinations;    // many x few
  std::vector<std::size_t> alike;  // of the many one with the same bounds
  Eigen::VectorXd begin;
};

/// @param weights  of each sample of the choice at each place: places x choice
FewUnknowns few_of(const std::vector<Unknown>& many, const Material& everywhere,
                   const Choice& choice, const Eigen::MatrixXd& weights) {
  FewUnknowns few;
  few.combinations.setZero(std::ssize(many), std::ssize(many));
  few.begin.resize(std::ssize(many));
  const auto append = [&](std::size_t alike, std::size_t begins_at) {
    const auto next = std::ssize(few.alike);
    few.alike.push_back(alike);
    few.begin(next) = many[begins_at].start;
    return few.combinations.col(next);
  };
  const std::size_t places = everywhere.samples.at.size();
  for (const UnknownBlock& block : blocks_of(many, everywhere)) {
    const std::size_t end = block.first + block.count;
    if (!block.differs) {
      for (std::size_t u = block.first; u < end; ++u)
        append(u, u)(static_cast<Eigen::Index>(u)) = 1;
      continue;
    }
    const std::size_t numbers = block.count / places;  // of each sample
    for (std::size_t k = 0; k < choice.size(); ++k) {
      for (std::size_t u = block.first; u < block.first + numbers; ++u) {
        append(u, u + choice[k] * numbers)(Eigen::seqN(u, places, numbers)) =
            weights.col(static_cast<Eigen::Index>(k));
      }
    }
  }
  few.combinations.conservativeResize(Eigen::NoChange, std::ssize(few.alike));
  few.begin.conservativeResize(std::ssize(few.alike));
  return few;
}

class SampleGrowth {
 public:
  SampleGrowth(SolidProblem& problem, const SampleOptions& options, const MaterialSamples& choices)
      : problem_(problem), options_(options), choices_(choices) {}

  /// The material with one sample more, or of one that is the same everywhere with two, fitted;
  /// nothing where there is none.
  std::optional<Material> one_more(const Material& material, LeastSquaresSummary& solution) const {
    const Material everywhere = sampled_everywhere(material);
    const LinearisedProblem linearised(problem_, everywhere);
    if (!linearised.is_valid()) return std::nullopt;
    std::optional<Material> best;
    double least = INFINITY;
    for (const Choice& choice : larger_choices(material)) {
      const MaterialSamples samples = samples_at(choice, everywhere);
      const LeastSquaresSummary end = solve(linearised, everywhere, choice, samples);
      if (!(end.cost < least)) continue;
      least = end.cost;
      best = material;
      best->samples = samples;
      set_numbers(end.parameters, *best);
    }
    if (best) solution = problem_.solve(*best);
    return best;
  }

 private:
  /// The material with a sample at each place, which are together much as it is.
  Material sampled_everywhere(Material material) const {
    MaterialSamples all = choices_;
    for (SampledComponents& sample : all.at) {
      if (is_heterogeneous(material)) {
        sample.components = means_of(material.samples, weights_at(material.samples, sample.place));
        continue;
      }
      for (const auto& [name, component] : material.components) {
        if (options_.differ_in(name)) sample.components[name] = component;
      }
    }
    material.samples = std::move(all);
    return material;
  }

  /// Those with one place more than the material has samples, two where it has none.
  std::vector<Choice> larger_choices(const Material& material) const {
    Choice own;
    for (const SampledComponents& sample : material.samples.at) {
      const auto place = std::ranges::find(choices_.at, sample.place, &SampledComponents::place);
      own.push_back(static_cast<std::size_t>(place - choices_.at.begin()));
    }
    std::vector<Choice> choices;
    for (std::size_t c = 0; c < choices_.at.size(); ++c) {
      if (std::ranges::find(own, c) != own.end()) continue;
      if (own.empty()) {
        for (std::size_t other = c + 1; other < choices_.at.size(); ++other) {
          choices.push_back({c, other});
        }
        continue;
      }
      choices.push_back(own);
      choices.back().push_back(c);
    }
    return choices;
  }

  MaterialSamples samples_at(const Choice& choice, const Material& everywhere) const {
    MaterialSamples samples;
    std::vector<Eigen::Vector3d> places;
    for (const std::size_t c : choice) {
      samples.at.push_back(everywhere.samples.at[c]);
      places.push_back(samples.at.back().place);
    }
    samples.width = options_.width.value_or(spacing_of_neighbours(places));
    return samples;
  }

  /// The least cost of few samples: with them the numbers at each place are means of theirs.
  LeastSquaresSummary solve(const LinearisedProblem& linearised, const Material& everywhere,
                            const Choice& choice, const MaterialSamples& samples) const {
    Eigen::MatrixXd weights(std::ssize(choices_.at), std::ssize(choice));
    for (std::size_t c = 0; c < choices_.at.size(); ++c) {
      weights.row(static_cast<Eigen::Index>(c)) =
          weights_at(samples, choices_.at[c].place).transpose();
    }
    const FewUnknowns few = few_of(linearised.unknowns(), everywhere, choice, weights);
    return linearised.solve(few.combinations, few.alike, few.begin, problem_.context().stop);
  }

  SolidProblem& problem_;
  const SampleOptions& options_;
  const MaterialSamples& choices_;
};

}  // namespace

GrownSolid with_samples(SolidProblem& problem, const SampleOptions& options,
                        const MaterialSamples& choices, const GrownSolid& uniform) {
  const SampleGrowth growth(problem, options, choices);
  std::map<int, std::pair<Material, LeastSquaresSummary>> fits;
  const auto fit_of = [&](int samples) -> std::optional<FittedModel> {
    if (samples == 1) {
      fits[samples] = {uniform.material, uniform.solution};
    } else {
      LeastSquaresSummary solution;
      auto more = growth.one_more(fits.at(samples - 1).first, solution);
      if (!more || !std::isfinite(solution.cost)) return std::nullopt;
      fits[samples] = {std::move(*more), solution};
    }
    const LeastSquaresSummary& end = fits.at(samples).second;
    return FittedModel{rms_of(end, problem.rows()), static_cast<int>(end.parameters.size()),
                       samples > 1 ? samples : 0, static_cast<double>(problem.rows())};
  };
  const Growth chosen = grow_model(1, options.grown, fit_of);
  GrownSolid grown = uniform;
  grown.stages.clear();
  for (const GrowthStep& step : chosen.steps) {
    grown.stages.push_back({step.points, step.fit.rms, step.accepted});
  }
  grown.stages.back().end = chosen.end;
  std::tie(grown.material, grown.solution) = fits.at(chosen.points);
  return grown;
}

}  // namespace pliant
