// The materials that come with the project have the numbers of [T] Tables 5.1 and 5.2.

#include <filesystem>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "pliant/material/material_file.h"

namespace pliant {
namespace {

struct Published {
  const char* name;
  const char* component;
  double density, k1, k2, a, b, tau;
};

// Table 5.2 gives stiffness in 1e-7 N m and maximum stress in 1e-4 N.
constexpr double kStiffnessUnit = 1e-7;
constexpr double kStressUnit = 1e-4;

Published bent(const char* name, double density, double k1, double k2, double a, double b,
               double tau) {
  return {name,
          "bend.warp",
          density,
          k1 * kStiffnessUnit,
          k2 * kStiffnessUnit,
          a * kStressUnit,
          b * kStressUnit,
          tau};
}

const Published kPublished[] = {
    {"cotton", "stretch.warp", 0.143, 135.6, 64.03, 2.22, 3.16, 0.006},
    {"spandex", "stretch.warp", 0.157, 4.42, 32.19, 0.40, 4.84, 0.088},
    {"polyester", "stretch.warp", 0.121, 26.62, 3.64, 2.10, 5.41, 0.031},
    bent("felt", 0.208, 145.3, 0.15, 5.12, 0.15, 29.9),
    bent("doublecloth", 0.255, 62.19, 0.07, 12.84, 0.05, 7.67),
    bent("paper", 0.075, 479.7, 0.47, 0.04, 0.64, 10.2),
};

const std::filesystem::path kFolder = std::filesystem::path(PLIANT_SOURCE_DIR) / "materials";

class PublishedMaterials : public ::testing::TestWithParam<Published> {};

TEST_P(PublishedMaterials, HaveTheNumbersOfTheirTable) {
  const Published& expected = GetParam();
  const Material material = read_material(kFolder / (std::string(expected.name) + ".json"));
  EXPECT_EQ(material.name, expected.name);
  EXPECT_DOUBLE_EQ(material.density, expected.density);
  EXPECT_EQ(material.membrane, MembraneMeasure::stvk);
  EXPECT_FALSE(material.provenance.empty());
  const auto law = law_of(material, expected.component);
  ASSERT_TRUE(law);
  EXPECT_EQ(law->stiffness.kind(), CurveKind::affine);
  EXPECT_EQ(law->friction_law, FrictionLaw::dahl);
  const Eigen::VectorXd parameters = law->parameters();
  EXPECT_DOUBLE_EQ(parameters(0), expected.k1);
  EXPECT_DOUBLE_EQ(parameters(1), expected.k2);
  EXPECT_DOUBLE_EQ(parameters(2), expected.a);
  EXPECT_DOUBLE_EQ(parameters(3), expected.b);
  EXPECT_DOUBLE_EQ(parameters(4), expected.tau);
}

TEST_P(PublishedMaterials, HaveNothingThatWasNotMeasured) {
  const Material material = read_material(kFolder / (std::string(GetParam().name) + ".json"));
  for (const auto& [name, component] : material.components) {
    const bool measured = name == GetParam().component;
    EXPECT_EQ(component.status, measured ? ComponentStatus::measured : ComponentStatus::unmeasured)
        << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Tables, PublishedMaterials, ::testing::ValuesIn(kPublished),
                         [](const auto& instance) { return std::string(instance.param.name); });

TEST(MaterialsFolder, HoldsNothingElse) {
  std::set<std::string> expected, found;
  for (const Published& published : kPublished) expected.insert(published.name);
  for (const auto& entry : std::filesystem::directory_iterator(kFolder)) {
    if (entry.path().extension() == ".json") found.insert(entry.path().stem().string());
  }
  EXPECT_EQ(found, expected);
}

}  // namespace
}  // namespace pliant
