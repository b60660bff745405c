#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/estimation/problem.h"
#include "pliant/estimation/statistics/experiment_noise.h"

namespace pliant {

/// Which unknowns each part of a problem tells: those whose last stage takes it. Empty: all tell
/// all.
using ToldUnknowns = std::vector<std::vector<char>>;

/// How the parts of a problem scatter about its solution, and what their rows count for that.
struct MeasuredNoise {
  std::vector<ExperimentNoise> of;        ///< each part
  std::vector<Eigen::VectorXd> weight;    ///< of its rows: 1 / (sd sqrt(L)), or what else they
                                          ///< count; 0 where left out; with a robust loss less for
                                          ///< what is far off
  std::vector<Eigen::VectorXd> scatter;   ///< sd sqrt(L) of weighted rows: 1 unless they count
                                          ///< otherwise than by noise
  std::vector<Eigen::VectorXd> row_sd;    ///< sd, with what noise of the length adds
  std::vector<PredictedRows> rows;        ///< with derivatives
  std::vector<Eigen::VectorXd> leverage;  ///< of each row
  Eigen::MatrixXd inverse_slope;          ///< of the free unknowns
};

/// Measures noise, correlation length and leverage until they settle ([Seber1989] for the nonlinear
/// case: leverages are those of the linearised problem).
/// @param problem  rows of weight zero do not count, whatever the other weights
/// @throws SolverError where the values predict nothing
MeasuredNoise measure_noise(const Problem& problem, const Eigen::VectorXd& values,
                            const ToldUnknowns& told = {});

/// Unknowns that a search is free to move.
std::vector<Eigen::Index> free_unknowns(const std::vector<Unknown>& unknowns);

}  // namespace pliant
