#include "pliant/material/addend/rubber_addends.h"

#include "pliant/material/density/rubber_energies.h"

namespace pliant {
namespace {

constexpr double kAnySign = -1e6;  // of the data's units: as good as no bound

template <EnergyFunction kEnergy, bool kLinear = false>
std::unique_ptr<ParametricDensity> density(int strain, const Eigen::VectorXd& values) {
  return std::make_unique<ClosedFormDensity>(strain, kEnergy, values, kLinear);
}

AddendParameter coefficient(std::string_view name, std::string_view meaning, int power) {
  return {.name = name,
          .meaning = meaning,
          .stress = 1,
          .strain = 1 - power,
          .scales = true,
          .smallest = kAnySign};
}

AddendParameter modulus(std::string_view name, std::string_view meaning) {
  return {.name = name, .meaning = meaning, .stress = 1, .scales = true, .step = 0.2};
}

}  // namespace

const AddendKind& linear_addend() {
  static const AddendKind kind{.name = "linear",
                               .description = "an energy proportional to the strain",
                               .parameters = {coefficient("c", "energy per strain", 1)},
                               .starts = {{1}},
                               .density = density<linear_energy, true>};
  return kind;
}

const AddendKind& polynomial_addend() {
  static const AddendKind kind{
      .name = "polynomial",
      .description = "an energy that is a cubic of the strain",
      .parameters = {coefficient("c1", "energy per strain", 1),
                     coefficient("c2", "energy per square of the strain", 2),
                     coefficient("c3", "energy per cube of the strain", 3)},
      .starts = {{1, 0, 0}},
      .density = density<polynomial_energy, true>};
  return kind;
}

const AddendKind& ogden_addend() {
  static const AddendKind kind{.name = "ogden",
                               .description = "a power of the stretch",
                               .parameters = {modulus("mu", "shear modulus of a power of stretch"),
                                              {.name = "alpha",
                                               .meaning = "power of the stretch",
                                               .smallest = -20,
                                               .largest = 20,
                                               .step = 0.5}},
                               .starts = {{1, 1.5}, {0.1, 4}, {0.1, -2}},
                               .density = density<ogden_energy>};
  return kind;
}

const AddendKind& arruda_boyce_addend() {
  static const AddendKind kind{.name = "arruda-boyce",
                               .description = "chains that lock (series of five terms)",
                               .parameters = {modulus("mu", "shear modulus of free chains"),
                                              {.name = "lock",
                                               .meaning = "stretch at which chains lock",
                                               .smallest = 1.01,
                                               .largest = 100,
                                               .step = 0.5}},
                               .starts = {{1, 3}, {0.3, 6}},
                               .density = density<arruda_boyce_energy>};
  return kind;
}

const AddendKind& exponential_addend() {
  static const AddendKind kind{.name = "exponential",
                               .description = "an energy that grows exponentially with the strain",
                               .parameters = {modulus("c", "energy per strain at rest"),
                                              {.name = "b",
                                               .meaning = "how fast it grows",
                                               .strain = -1,
                                               .smallest = 1e-6,
                                               .largest = 60,
                                               .step = 0.5}},
                               .starts = {{1, 0.5}, {0.1, 3}},
                               .density = density<exponential_energy>};
  return kind;
}

}  // namespace pliant
