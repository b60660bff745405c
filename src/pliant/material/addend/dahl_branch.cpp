#include "pliant/material/addend/dahl_branch.h"

#include "pliant/material/density/dahl_friction.h"

namespace pliant {

const AddendKind& dahl_branch() {
  static const AddendKind kind{
      .name = "dahl",
      .description = "a further branch of Dahl friction",
      .parameters = {{.name = "a",
                      .meaning = "friction of a further branch at zero strain",
                      .stress = 1,
                      .scales = true,
                      .step = 0.2},
                     {.name = "b",
                      .meaning = "growth of its friction with strain",
                      .stress = 1,
                      .strain = -1,
                      .scales = true,
                      .step = 0.2},
                     {.name = "tau",
                      .meaning = "strain over which its friction builds up",
                      .strain = 1,
                      .smallest = 1e-3,
                      .largest = 3,
                      .step = 0.1}},
      .starts = {{0.05, 0.05, 0.02}, {0.05, 0.05, 0.1}, {0.05, 0.05, 0.5}},
      .density = [](int strain,
                    const Eigen::VectorXd& values) -> std::unique_ptr<ParametricDensity> {
        return std::make_unique<DahlFriction>(strain,
                                              DahlParameters{values(0), values(1), values(2)});
      },
      .friction = true,
      .fall = [](const Eigen::VectorXd& values) { return values(1); }};
  return kind;
}

}  // namespace pliant
