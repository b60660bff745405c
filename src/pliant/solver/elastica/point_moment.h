#pragma once

#include <Eigen/Core>

#include "pliant/solver/elastica/elastica.h"

namespace pliant {

/// The moment of a material point of a strip, which came to its curvature in one stretch.
struct PointMoment {
  double moment = 0;                // N
  double tangent = 0;               // d moment / d curvature (N m)
  double work = 0;                  // per width and length, since the history (N/m)
  Eigen::RowVectorXd by_parameter;  // d moment / d parameters at this curvature, by the history
                                    // too; empty unless asked for
};

PointMoment point_moment(const ComponentLaw& law, const StripHistory& history, Eigen::Index point,
                         double curvature, bool with_derivatives);

/// What friction and addends remember after a stretch that ended at `shape`, with derivatives where
/// the shape has them.
StripHistory remembered(const ComponentLaw& law, const StripHistory& history,
                        const StripShape& shape);

}  // namespace pliant
