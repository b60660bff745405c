#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/problem.h"
#include "pliant/estimation/statistics/estimating_sums.h"

namespace pliant {

/// Of the free unknowns, which a part tells; empty: all.
/// @param told  of each part and unknown, or empty
std::vector<char> told_of(const std::vector<std::vector<char>>& told, std::size_t part,
                          const std::vector<Eigen::Index>& free);

/// Changes of the free unknowns that matter: their scales.
Eigen::VectorXd units_of(const std::vector<Unknown>& unknowns,
                         const std::vector<Eigen::Index>& free);

/// The equations that the free unknowns of a problem solve: a group for each frame of each part,
/// and the priors.
/// @param rows    of each part, with derivatives
/// @param weight   of the rows: 1 / (sd sqrt(L)), or what they count otherwise
/// @param scatter  sd sqrt(L) of the weighted rows
EstimatingSums estimating_sums(const Problem& problem, const std::vector<PredictedRows>& rows,
                               const std::vector<Eigen::VectorXd>& weight,
                               const std::vector<Eigen::VectorXd>& scatter,
                               const std::vector<Eigen::Index>& free,
                               const std::vector<std::vector<char>>& told);

/// The same of a prediction whose rows are not stored: each frame is added up as it comes, which is
/// what problems of very many rows need.
/// @return nothing where the laws cannot carry the loads
std::optional<EstimatingSums> predicted_sums(const Problem& problem, const Eigen::VectorXd& values,
                                             const std::vector<Eigen::VectorXd>& weight,
                                             const std::vector<Eigen::Index>& free,
                                             const std::vector<std::vector<char>>& told);

/// The specimen of each group, numbered over all parts, and the cycle (two frames of a specimen).
struct GroupLabels {
  std::vector<int> cycle, specimen;
};
GroupLabels labels_of(const Problem& problem);

}  // namespace pliant
