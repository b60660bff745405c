#include "pliant/experiment/session/sheet_bending.h"

#include <gtest/gtest.h>

#include "pliant/base/random.h"
#include "pliant/material/addend/dahl_branch.h"

#include "support/cloth_sheet.h"
#include "support/evaluate_system.h"

namespace pliant {
namespace {

/// An orthotropic sheet whose bending rubs, in one direction with two branches.
Material sheet() {
  Material material = test::linear_cloth(100, 30, 0);
  material.bending_of = "sheet";
  material.components["bend.weft"] =
      test::component(ScalarCurve::affine(4e-6, 1e-9), DahlParameters{2e-4, 1e-6, 8});
  material.components["bend.warp"] =
      test::component(ScalarCurve::affine(8e-6, 2e-9), DahlParameters{6e-4, 2e-6, 20});
  MaterialComponent diagonal =
      test::component(ScalarCurve::affine(5e-6, 1e-9), DahlParameters{2e-4, 1e-6, 12});
  diagonal.addends = {{dahl_branch(), Eigen::Vector3d(1e-4, 1e-6, 60)}};
  material.components["bend.diagonal"] = diagonal;
  return material;
}

struct Numbers {
  std::vector<std::string> names;
  std::vector<double> values;

  Eigen::VectorXd vector() const {
    return Eigen::Map<const Eigen::VectorXd>(values.data(), std::ssize(values));
  }
};

Numbers numbers_of(const Material& material) {
  Numbers numbers;
  for (const char* name : {"stretch.warp", "bend.weft", "bend.warp", "bend.diagonal"}) {
    const ComponentLaw law = *law_of(material, name);
    const std::vector<std::string> names = parameter_names(law, name);
    const Eigen::VectorXd values = law.parameters();
    numbers.names.insert(numbers.names.end(), names.begin(), names.end());
    numbers.values.insert(numbers.values.end(), values.begin(), values.end());
  }
  return numbers;
}

TriangleMesh mesh() { return regular_grid(0.1, 0.1, 9, 9); }

TEST(SheetBending, GivesTheNumbersOfTheHinges) {
  const Numbers sheet_numbers = numbers_of(sheet());
  const SheetBending bending(mesh(), sheet(), sheet_numbers.names);
  const Eigen::VectorXd expected = numbers_of(as_hinges(sheet(), mesh())).vector();
  const Eigen::VectorXd found = bending.hinges(sheet_numbers.vector());
  EXPECT_TRUE(found.isApprox(expected, 1e-12));
  EXPECT_FALSE(found.isApprox(sheet_numbers.vector(), 0.1));
}

TEST(SheetBending, KnowsTheDerivativesOfTheNumbersOfFrictionToo) {
  const Numbers numbers = numbers_of(sheet());
  const SheetBending bending(mesh(), sheet(), numbers.names);
  const Eigen::VectorXd at = numbers.vector();
  const Eigen::VectorXd hinges = bending.hinges(at);
  const Eigen::MatrixXd by_values = bending.hinges_by_values(at);
  for (Eigen::Index j = 0; j < at.size(); ++j) {
    // Another step than that of the differences inside; either has an error of its square.
    const Eigen::VectorXd step = 3e-3 * at(j) * Eigen::VectorXd::Unit(at.size(), j);
    const Eigen::VectorXd change = bending.hinges(at + step) - bending.hinges(at - step);
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      // As relative changes: numbers of hinges have sizes from 1e-9 to 100.
      const double difference = change(i) / (2 * 3e-3 * hinges(i));
      const double own = by_values(i, j) * at(j) / hinges(i);
      EXPECT_NEAR(difference, own, 2e-4) << numbers.names[i] << " by " << numbers.names[j];
    }
  }
}

// Whoever asks for a sheet gets the same hinges.
TEST(SheetBending, IsWhatAClothOfASheetBendsBy) {
  const auto forces = [](const Material& material) {
    test::ClothSheet cloth(mesh(), material);
    cloth.system.finish();
    State state = cloth.system.initial_state();
    RandomStream random(5);
    Configuration at = state.configuration;
    const auto shake = [&] {
      for (double& x : at.positions.reshaped()) x += 0.001 * (random.uniform() - 0.5);
    };
    shake();
    test::accept(cloth.system, state, at);
    shake();
    return test::gradient_of(cloth.system, at, state);
  };
  const Eigen::Matrix3Xd expected = forces(as_hinges(sheet(), mesh()));
  EXPECT_LT((forces(sheet()) - expected).norm(), 1e-12 * expected.norm());
}

}  // namespace
}  // namespace pliant
