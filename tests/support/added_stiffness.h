#pragma once

#include <memory>

#include "pliant/material/addend/addend_kind.h"
#include "pliant/material/density/stiffness_density.h"

namespace pliant::test {

/// An elastic addend whose answer is known: the stiffness k1 + k2 |strain|.
inline const AddendKind& added_stiffness() {
  static const AddendKind kind{
      .name = "added",
      .description = "an affine stiffness",
      .parameters = {{.name = "k1", .meaning = "", .stress = 1, .strain = -1, .scales = true},
                     {.name = "k2", .meaning = "", .stress = 1, .strain = -2, .scales = true}},
      .starts = {{1, 0.1}},
      .density = [](int strain, const Eigen::VectorXd& k) -> std::unique_ptr<ParametricDensity> {
        return std::make_unique<StiffnessDensity>(strain, ScalarCurve::affine(k(0), k(1)));
      }};
  return kind;
}

}  // namespace pliant::test
