#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/component_experiment.h"

namespace pliant {

/// A figure of a standard (textile_figure.h) that was read off a loop.
struct LoopFigure {
  std::string name;
  double value = 0;  ///< SI, the mean of the specimens that show it
};

/// The figures of the standards that a record's loop shows, in their order: of pulls those of KES,
/// FAST and ISO 20932-1 at the loads that it comes to, of shear and bending those of KES at the
/// angles and curvatures that its last loop goes through.
/// @param quantity  measured or predicted (SI), what the instrument shows of nothing taken off
std::vector<LoopFigure> loop_figures(const ComponentExperiment& experiment,
                                     const Eigen::VectorXd& quantity);

}  // namespace pliant
