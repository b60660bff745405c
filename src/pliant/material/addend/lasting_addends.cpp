#include "pliant/material/addend/lasting_addends.h"

#include <cmath>

#include "pliant/material/density/maxwell_density.h"
#include "pliant/material/density/rate_friction.h"
#include "pliant/material/density/set_density.h"
#include "pliant/material/density/softening_density.h"

namespace pliant {
namespace {

template <class Law>
std::unique_ptr<ParametricDensity> of_two(int strain, const Eigen::VectorXd& values) {
  return std::make_unique<Law>(strain, values(0), values(1));
}

AddendParameter stiffness(std::string_view meaning) {
  return {.name = "k", .meaning = meaning, .stress = 1, .strain = -1, .scales = true, .step = 0.2};
}

}  // namespace

const AddendKind& softening_addend() {
  static const AddendKind kind{
      .name = "softening",
      .description = "elasticity that the largest strain so far takes away (Mullins)",
      .parameters = {stiffness("stiffness that strain takes away"),
                     {.name = "breaking",
                      .meaning = "largest strain that leaves 1/e of it",
                      .strain = 1,
                      .smallest = 1e-2,
                      .largest = 10,
                      .step = 0.1}},
      .starts = {{0.3, 0.1}, {0.3, 0.3}, {0.3, 1}},
      .density = of_two<SofteningDensity>,
      // Where the stress of the links that are left falls fastest, at twice their breaking strain.
      .fall = [](const Eigen::VectorXd& values) { return values(0) * std::exp(-2.0); }};
  return kind;
}

const AddendKind& set_addend() {
  static const AddendKind kind{
      .name = "set",
      .description = "elasticity that is felt on the way back alone (permanent set)",
      .parameters = {stiffness("stiffness on the way back from the largest strain")},
      .starts = {{0.1}},
      .density = [](int strain,
                    const Eigen::VectorXd& values) -> std::unique_ptr<ParametricDensity> {
        return std::make_unique<SetDensity>(strain, values(0));
      }};
  return kind;
}

const AddendKind& maxwell_addend() {
  static const AddendKind kind{
      .name = "maxwell",
      .description = "a stress that relaxes with time (a spring and a dashpot in series)",
      .parameters = {stiffness("stiffness of what relaxes"),
                     {.name = "time",
                      .meaning = "time in which a held stress falls to 1/e",
                      .time = 1,
                      .smallest = 1e-4,
                      .largest = 100,
                      .step = 0.1}},
      .starts = {{0.3, 0.01}, {0.3, 0.1}, {0.3, 1}},
      .density = of_two<MaxwellDensity>,
      .flows = true};
  return kind;
}

const AddendKind& rate_friction_addend() {
  static const AddendKind kind{
      .name = "rate-friction",
      .description = "friction whose maximum grows with the logarithm of the rate of strain",
      .parameters = {{.name = "a",
                      .meaning = "its maximum at zero strain, at the slowest rate (1e-6 a second)",
                      .stress = 1,
                      .scales = true,
                      .step = 0.2},
                     {.name = "b",
                      .meaning = "growth of its maximum with strain",
                      .stress = 1,
                      .strain = -1,
                      .scales = true,
                      .step = 0.2},
                     {.name = "tau",
                      .meaning = "strain over which it builds up",
                      .strain = 1,
                      .smallest = 1e-3,
                      .largest = 3,
                      .step = 0.1},
                     {.name = "growth",
                      .meaning = "share by which it grows where the rate grows e times",
                      .largest = 10,
                      .step = 0.05}},
      .starts = {{0.05, 0.05, 0.02, 0.05}, {0.05, 0.05, 0.1, 0.05}, {0.05, 0.05, 0.5, 0.05}},
      .density = [](int strain,
                    const Eigen::VectorXd& values) -> std::unique_ptr<ParametricDensity> {
        return std::make_unique<RateFriction>(strain, values);
      },
      .friction = true,
      .flows = true,
      // At a thousand strains a second.
      .fall =
          [](const Eigen::VectorXd& values) {
            return values(1) * (1 + values(3) * std::log(1e9));
          }};
  return kind;
}

}  // namespace pliant
