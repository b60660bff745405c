#include "pliant/material/addend/plasticity.h"

#include "pliant/material/density/plastic_density.h"

namespace pliant {
namespace {

std::unique_ptr<ParametricDensity> density(int strain, const Eigen::VectorXd& values) {
  return std::make_unique<PlasticDensity>(strain, PlasticParameters::of(values));
}

AddendParameter stiffness() {
  return {.name = "k",
          .meaning = "stiffness of an elastic range",
          .stress = 1,
          .strain = -1,
          .scales = true,
          .smallest = 1e-4,
          .step = 0.2};
}

AddendParameter yield() {
  return {.name = "yield",
          .meaning = "largest elastic strain, where yield begins",
          .strain = 1,
          .smallest = 1e-3,
          .largest = 3,
          .step = 0.1};
}

}  // namespace

const AddendKind& plasticity() {
  static const AddendKind kind{.name = "plastic",
                               .description = "an elastic range, and yield beyond it",
                               .parameters = {stiffness(), yield()},
                               .starts = {{1, 0.05}, {0.5, 0.2}, {0.5, 0.5}},
                               .density = density};
  return kind;
}

const AddendKind& saturating_plasticity() {
  static const AddendKind kind{
      .name = "saturating-plastic",
      .description = "an elastic range, and yield beyond it up to a largest plastic strain",
      .parameters = {stiffness(),
                     yield(),
                     {.name = "saturation",
                      .meaning = "largest plastic strain",
                      .strain = 1,
                      .smallest = 1e-3,
                      .largest = 3,
                      .step = 0.1}},
      .starts = {{1, 0.05, 0.3}, {0.5, 0.2, 0.3}, {0.5, 0.5, 0.3}},
      .density = density};
  return kind;
}

}  // namespace pliant
