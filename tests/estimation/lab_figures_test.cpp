#include "pliant/estimation/lab_figures.h"

#include <cmath>

#include <gtest/gtest.h>

namespace pliant {
namespace {

constexpr double kRounding = 1e-9;
constexpr double kDifferences = 1e-5;  // of errors: by central differences of smooth figures

Material cloth(const std::string& name, ScalarCurve stiffness, double end) {
  Material material;
  material.density = 0.15;
  material.components[name].stiffness = std::move(stiffness);
  material.components[name].range = {0.0, end};
  return material;
}

/// Errors of independent parameters.
ErrorOfLaw with_errors(const Eigen::VectorXd& sd) {
  return [sd](const Eigen::VectorXd& by_law) -> std::optional<CurveError> {
    const double error = by_law.cwiseProduct(sd).norm();
    return CurveError{error, 1.96 * error};
  };
}

const LabFigure* find(const std::vector<LabFigure>& figures, const std::string& name) {
  for (const LabFigure& figure : figures) {
    if (figure.name == name) return &figure;
  }
  return nullptr;
}

TEST(LabFigures, ASecantModulusIsForcePerWidthOverExtension) {
  const double k1 = 40, k2 = 90;
  const Material material = cloth("stretch.warp", ScalarCurve::affine(k1, k2), 0.48);
  const auto figures =
      lab_figures(material, "stretch.warp", with_errors(Eigen::Vector2d(0.8, 3.0)));
  const LabFigure& secant = *find(figures, "secant_modulus");
  // The range ends at sqrt(1 + 2 0.48) - 1 = 40 % of extension; a half of it is round.
  ASSERT_NEAR(*secant.at, 0.2, kRounding);
  const double e = 0.2, strain = (1.2 * 1.2 - 1) / 2, per_strain = strain * (1 + e) / e;
  EXPECT_NEAR(secant.value, (k1 + k2 * strain) * per_strain, kRounding * secant.value);
  EXPECT_NEAR(secant.error->std_error, std::hypot(0.8, 3.0 * strain) * per_strain,
              kDifferences * secant.error->std_error);
  EXPECT_NEAR(*figures.at(2).at, 0.4, kRounding) << "the second is that of the end";
}

TEST(LabFigures, OfARigidLawOfSmallStrainsAreItsStiffness) {
  Material material = cloth("stretch.weft", ScalarCurve::constant(25), 0.3);
  material.membrane = MembraneMeasure::soft_constraint;  // its strain is the extension
  const auto figures = lab_figures(material, "stretch.weft", {});
  for (const char* name : {"stiffness_at_rest", "secant_modulus"}) {
    EXPECT_NEAR(find(figures, name)->value, 25, kRounding * 25) << name;
    EXPECT_FALSE(find(figures, name)->error) << "no errors are known";
  }
  EXPECT_EQ(find(figures, "loop_width"), nullptr) << "without friction there is no loop";
}

TEST(LabFigures, OfAContractionIsPoissonsRatio) {
  const Material material = cloth("contraction.warp", ScalarCurve::affine(0.2, 0.8), 0.48);
  const auto figures =
      lab_figures(material, "contraction.warp", with_errors(Eigen::Vector2d(0.01, 0.05)));
  ASSERT_EQ(figures.size(), 2U);
  // The range ends at 40 % of extension.
  EXPECT_NEAR(*figures[0].at, 0.2, kRounding);
  const double strain = (1.2 * 1.2 - 1) / 2;
  EXPECT_NEAR(figures[0].value, (0.2 + 0.8 * strain) * strain / 0.2, kRounding);
  EXPECT_NEAR(figures[0].error->std_error, std::hypot(0.01, 0.05 * strain) * strain / 0.2,
              kDifferences);
  EXPECT_NEAR(*figures[1].at, 0.4, kRounding);
}

// A sheet K_x E_x^2 / 2 + K_y E_y^2 / 2 + c E_x E_y, of which nothing is carried at free edges.
TEST(LabFigures, StripsThatNarrowTellTheCouplingOfTheirSheet) {
  const double weft = 90, warp = 200, coupling = 50;
  Material material =
      cloth("stretch.weft", ScalarCurve::constant(weft - coupling * coupling / warp), 0.3);
  material.membrane = MembraneMeasure::soft_constraint;  // its strain is the extension
  const auto give = [&](const char* name, double stiffness) {
    material.components[name].stiffness = ScalarCurve::constant(stiffness);
    material.components[name].range = {0.0, 0.3};
  };
  give("stretch.warp", warp - coupling * coupling / weft);
  give("contraction.weft", coupling / warp);
  give("contraction.warp", coupling / weft);
  for (const char* name : {"contraction.weft", "contraction.warp"}) {
    const auto figures = lab_figures(material, name, {});
    ASSERT_NE(find(figures, "coupling"), nullptr) << name;
    EXPECT_NEAR(find(figures, "coupling")->value, coupling, kRounding * coupling) << name;
  }
  give("contraction.warp", 2.5);
  EXPECT_EQ(find(lab_figures(material, "contraction.warp", {}), "coupling"), nullptr)
      << "no elastic sheet narrows so";
}

TEST(LabFigures, OfAMetricOfTrianglesAreNoneThatInstrumentsRead) {
  const Material material = cloth("area", ScalarCurve::constant(25), 0.3);
  const auto figures = lab_figures(material, "area", {});
  ASSERT_EQ(figures.size(), 1u);
  EXPECT_EQ(figures.front().name, "stiffness_at_rest");
  EXPECT_TRUE(lab_figures(cloth("stretch.weft*shear", ScalarCurve::constant(25), 0.3),
                          "stretch.weft*shear", {})
                  .empty());
}

TEST(LabFigures, TheLoopIsTwiceTheSaturatedFrictionWide) {
  Material material = cloth("shear", ScalarCurve::constant(30), std::sin(0.14));
  material.components["shear"].friction = ComponentFriction{{1.5, 0, 1e-3}, {}};
  const auto figures = lab_figures(material, "shear", with_errors(Eigen::Vector4d(1, 0.02, 0, 0)));
  const LabFigure& width = *find(figures, "loop_width");
  EXPECT_NEAR(*width.at, 0.07, kRounding);
  EXPECT_NEAR(width.value, 2 * 1.5, kRounding);  // 0.07 / tau = 70: what is left is e^-70
  EXPECT_NEAR(width.error->std_error, 2 * 0.02, kDifferences * 0.04);
}

// A preloaded strip says nothing of what is below its data, one that ends early nothing above.
TEST(LabFigures, AreMarkedWhereThereAreNoData) {
  const auto beyond = [](const std::string& component, double low, double high) {
    Material material = cloth(component, ScalarCurve::constant(30), high);
    material.components[component].range->first = low;
    material.components[component].friction = ComponentFriction{{1, 0, 1e-3}, {}};
    std::vector<std::string> names;
    for (const LabFigure& figure : lab_figures(material, component, {})) {
      if (figure.beyond_range) names.push_back(figure.name);
    }
    return names;
  };
  using Names = std::vector<std::string>;
  // The strip comes to 20 gf/cm at 37 % extension, a Green strain of 0.44, and not to 100 within
  // half again of its range.
  EXPECT_EQ(beyond("stretch.warp", 0, 0.4), Names{"fast_E20"});
  EXPECT_EQ(beyond("stretch.warp", 0.3, 0.4),
            (Names{"stiffness_at_rest", "secant_modulus", "loop_width", "fast_E5", "fast_E20"}));
  EXPECT_EQ(beyond("bend.warp", 0, 3 * 120), Names{"kes_B"});
  EXPECT_EQ(beyond("bend.warp", 0, 3 * 80), (Names{"kes_B", "kes_2HB"}));
}

TEST(LabFigures, OfBendingAreTheKawabataNumbersAndTheBendingLength) {
  const double k = 3e-6, a = 2e-4;
  Material material = cloth("bend.warp", ScalarCurve::constant(k), 750);
  material.components["bend.warp"].friction = ComponentFriction{{a, 0, 1.0}, {}};
  Eigen::Vector4d sd(1e-7, 4e-6, 0, 0);
  const auto figures = lab_figures(material, "bend.warp", with_errors(sd));
  EXPECT_NEAR(find(figures, "rigidity_at_rest")->value, 3 * k, kRounding * k);
  EXPECT_NEAR(find(figures, "kes_B")->value, 3 * k, kRounding * k);
  EXPECT_NEAR(find(figures, "kes_B")->error->std_error, 3 * sd(0), kDifferences * sd(0));
  EXPECT_NEAR(find(figures, "kes_2HB")->value, 2 * a, kRounding * a);
  EXPECT_NEAR(find(figures, "kes_2HB")->error->std_error, 2 * sd(1), kDifferences * sd(1));
  EXPECT_FALSE(find(figures, "kes_B")->beyond_range);
}

TEST(LabFigures, ABendingLengthGrowsWithTheCubeRootOfTheRigidity) {
  const double k = 3e-6, sd = 1e-7;
  const Material material = cloth("bend.weft", ScalarCurve::constant(k), 150);
  const auto figures =
      lab_figures(material, "bend.weft", with_errors(Eigen::VectorXd::Constant(1, sd)));
  const LabFigure& length = *find(figures, "bending_length");
  EXPECT_NEAR(length.value, std::cbrt(3 * k / (0.15 * 9.80665)), 2e-4 * length.value);
  // The root of the overhang is found to a thousandth of the step that the differences take.
  EXPECT_NEAR(length.error->std_error, length.value * sd / k / 3, 2e-3 * length.error->std_error);
  EXPECT_TRUE(find(figures, "kes_B")->beyond_range) << "measured to 50 1/m, read to 150 1/m";
}

TEST(LabFigures, WhatTheDataDoesNotSeeHasNoError) {
  const Material material = cloth("stretch.warp", ScalarCurve::affine(40, 90), 0.48);
  const ErrorOfLaw unseen = [](const Eigen::VectorXd& by_law) -> std::optional<CurveError> {
    if (std::abs(by_law(1)) > 0) return std::nullopt;
    return CurveError{by_law(0), 2 * by_law(0)};
  };
  const auto figures = lab_figures(material, "stretch.warp", unseen);
  EXPECT_TRUE(find(figures, "stiffness_at_rest")->error);
  EXPECT_FALSE(find(figures, "secant_modulus")->error);
}

TEST(LabFigures, HingesOfAMeshAreNoSheet) {
  Material material = cloth("bend.weft", ScalarCurve::constant(3e-6), 150);
  material.bending_of = "hinges";
  EXPECT_TRUE(lab_figures(material, "bend.weft", {}).empty());
}

}  // namespace
}  // namespace pliant
