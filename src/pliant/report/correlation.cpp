#include "pliant/report/correlation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pliant::report {
namespace {

/// Below this, estimates of two components count as independent.
constexpr double kNegligible = 0.005;

struct Estimate {
  const ResultParameter* parameter;
  std::size_t index;  ///< in the covariance
};

std::vector<Estimate> free_estimates(const Results& results) {
  std::vector<Estimate> estimates;
  std::size_t index = 0;
  for (const auto* list : {&results.parameters, &results.nuisance}) {
    for (const ResultParameter& p : *list) {
      if (!p.fixed && p.identified) estimates.push_back({&p, index});
      ++index;
    }
  }
  return estimates;
}

double correlation(const std::vector<std::vector<double>>& covariance, std::size_t i,
                   std::size_t j) {
  const double variances = covariance[i][i] * covariance[j][j];
  if (!(covariance[i][i] > 0.0) || !(covariance[j][j] > 0.0)) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  return i == j ? 1.0 : std::clamp(covariance[i][j] / std::sqrt(variances), -1.0, 1.0);
}

CorrelationBlock make_block(const Results& results, std::string title,
                            const std::vector<Estimate>& estimates) {
  CorrelationBlock block{std::move(title), {}, {}};
  for (const Estimate& row : estimates) {
    const ResultParameter& p = *row.parameter;
    const bool named = p.experiment.empty() || p.name.starts_with(p.experiment);
    block.names.push_back(named ? p.name : p.name + " (" + p.experiment + ")");
    block.values.emplace_back();
    for (const Estimate& column : estimates) {
      block.values.back().push_back(correlation(results.covariance, row.index, column.index));
    }
  }
  return block;
}

bool components_are_independent(const Results& results, const std::vector<Estimate>& estimates) {
  for (const Estimate& a : estimates) {
    for (const Estimate& b : estimates) {
      if (a.parameter->component == b.parameter->component) continue;
      if (std::abs(correlation(results.covariance, a.index, b.index)) > kNegligible) return false;
    }
  }
  return true;
}

}  // namespace

std::vector<CorrelationBlock> correlation_blocks(const Results& results) {
  if (results.covariance.empty()) return {};
  const std::vector<Estimate> estimates = free_estimates(results);
  if (!components_are_independent(results, estimates)) {
    return {make_block(results, "All components", estimates)};
  }
  std::vector<std::vector<Estimate>> groups;  // in the order of the parameters
  for (const Estimate& estimate : estimates) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& members) {
      return members.front().parameter->component == estimate.parameter->component;
    });
    if (group == groups.end()) group = groups.insert(group, std::vector<Estimate>{});
    group->push_back(estimate);
  }
  std::vector<CorrelationBlock> blocks;
  for (const std::vector<Estimate>& members : groups) {
    if (members.size() < 2) continue;
    blocks.push_back(make_block(results, members.front().parameter->component, members));
  }
  return blocks;
}

}  // namespace pliant::report
