// Which law a material of a solid is, and what it is not.

#include "pliant/exchange/standard_law.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/dahl_branch.h"
#include "pliant/material/addend/plasticity.h"

#include "exchange/standard_materials.h"
#include "io/input_error_of.h"

namespace pliant::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

StandardLaw law_of_material(const Material& material) {
  return standard_law(material, "rubber.json");
}

InputError refused(const Material& material) {
  return input_error_of([&] { law_of_material(material); });
}

TEST(StandardLaw, IsKnownByItsComponents) {
  const std::vector<std::string> names{
      "St. Venant-Kirchhoff", "Neo-Hookean",      "Mooney-Rivlin",   "Yeoh",
      "Ogden of 1 term",      "Ogden of 3 terms", "Ogden of 2 terms"};
  const std::vector<NamedMaterial> materials = materials_of_all_tools();
  ASSERT_EQ(materials.size(), names.size());
  for (std::size_t i = 0; i < names.size(); ++i) {
    const StandardLaw law = law_of_material(materials[i].material);
    EXPECT_EQ(name_of(law), names[i]);
    EXPECT_THAT(law.lost, IsEmpty());
  }
}

TEST(StandardLaw, HasTheShearModulusOfTheMaterial) {
  std::vector<Material> materials{solid_of({{"I1-bar", component_of({arruda_boyce(9e4, 1.8)})}})};
  for (const NamedMaterial& named : materials_of_all_tools()) materials.push_back(named.material);
  for (const Material& material : materials) {
    const DeformedPoint rest =
        deformed_point(*solid_density(material).law, Eigen::Matrix3d::Identity());
    const StandardLaw law = law_of_material(material);
    EXPECT_NEAR(shear_modulus(law), rest.tangent(3, 3), 1e-12 * rest.tangent(3, 3));
    // Pressure on a shear: that of the law of shape changes no volume.
    const double lambda = rest.tangent(0, 1);
    if (law.volume.form != VolumeEnergy::Form::none) {
      EXPECT_NEAR(law.volume.bulk, lambda + 2 * shear_modulus(law) / 3, 1e-9 * kBulk);
    }
  }
}

TEST(StandardLaw, OfSquaresOfStretchesIsOfTheInvariantsTerms) {
  // I1-bar - 3 is the sum of s^2 - 1, I2-bar - 3 that of s^-2 - 1.
  const StandardLaw law = law_of_material(solid_of({{"stretch-bar", component_of({ogden(1e4, 3)})},
                                                    {"I1-bar", component_of({linear(2e4)})},
                                                    {"I2-bar", component_of({linear(3e3)})}}));
  const auto& terms = std::get<OgdenLaw>(law.shape).terms;
  ASSERT_EQ(terms.size(), 3U);
  EXPECT_EQ(terms[1].alpha, 2);
  EXPECT_EQ(terms[1].mu, 4e4);
  EXPECT_EQ(terms[2].alpha, -2);
  EXPECT_EQ(terms[2].mu, 6e3);
}

TEST(StandardLaw, AddsTermsOfOnePower) {
  const StandardLaw law =
      law_of_material(solid_of({{"stretch-bar", component_of({ogden(1e4, 3), ogden(2e4, 3)})}}));
  const auto& terms = std::get<OgdenLaw>(law.shape).terms;
  ASSERT_EQ(terms.size(), 1U);
  EXPECT_NEAR(terms[0].mu, 3e4, 1e-9);
}

TEST(StandardLaw, OfGreenStrainsIsOrthotropicStVK) {
  const StandardLaw law = law_of_material(orthotropic_material());
  EXPECT_EQ(name_of(law), "orthotropic St. Venant-Kirchhoff");
  EXPECT_EQ(shear_modulus(law), 0.9e4);
  Material soft = orthotropic_material();
  soft.components["green.xx*green.zz"] = component_of({linear(9e5)});
  EXPECT_THAT(std::string(refused(soft).what()), HasSubstr("do not resist every small strain"));
  soft = orthotropic_material();
  soft.components["green.zz"] = component_of({polynomial(0, 2e4, 100)});
  EXPECT_EQ(refused(soft).where().field, "components.green.zz");
}

TEST(StandardLaw, TellsWhatIsLost) {
  Material material = neo_hookean_solid(5e4, kBulk);
  MaterialComponent& shape = material.components["I1-bar"];
  shape.friction = ComponentFriction{{100, 10, 0.1}, {}};
  shape.addends.push_back({plasticity(), Eigen::Vector2d(1e4, 0.1)});
  material.components["green.xx"] = component_of({Addend(dahl_branch(), Eigen::Vector3d(1, 2, 3))});
  material.components["I2-bar"].status = ComponentStatus::unmeasured;
  material.limits.push_back({{"J"}, 5e3});
  material.damping_fraction = 0.01;
  const StandardLaw law = law_of_material(material);
  EXPECT_EQ(name_of(law), "Neo-Hookean");
  EXPECT_THAT(law.lost, ElementsAre("internal friction of green.xx", "internal friction of I1-bar",
                                    "plasticity of I1-bar, with its elastic range",
                                    "that I2-bar was not measured", "the limit of energy J.limit",
                                    "damping"));
}

TEST(StandardLaw, TellsThatWhatIsKnownOfTheNumbersIsLost) {
  Material material = neo_hookean_solid(5e4, kBulk);
  material.components["J"].status = ComponentStatus::assumed;
  material.components["I1-bar"].range = std::pair(0.0, 3.0);
  material.components["I1-bar"].errors["linear.c"].std_error = 100;
  material.info["lot"] = "A7";
  EXPECT_THAT(law_of_material(material).lost,
              ElementsAre("what is told about the numbers: which are assumed, ranges of the data, "
                          "errors, info"));
}

TEST(StandardLaw, IsNoneWhereAnElasticComponentHasNoCounterpart) {
  const MaterialComponent shape = component_of({linear(5e4)});
  const auto field = [&](const std::string& name, const MaterialComponent& component) {
    Material material = solid_of({{"I1-bar", shape}});
    material.components[name] = component;
    return refused(material).where().field;
  };
  EXPECT_EQ(field("fibre.x", component_of(ScalarCurve::constant(1e4))), "components.fibre.x");
  EXPECT_EQ(field("I1-bar", component_of(ScalarCurve::spline({0, 1}, {1e4, 2e4}))),
            "components.I1-bar.stiffness");
  EXPECT_EQ(
      field("I1-bar", component_of({linear(1), {exponential_addend(), Eigen::Vector2d(1e4, 2)}})),
      "components.I1-bar.addends[1]");
  EXPECT_EQ(field("I2-bar", component_of(ScalarCurve::constant(1e4))), "components.I2-bar");
  EXPECT_EQ(field("I1-bar", component_of({linear(1), arruda_boyce(1e4, 2)})), "components.I1-bar");
  EXPECT_EQ(field("I1-bar", component_of({ogden(1e4, 2)})), "components.I1-bar");
  EXPECT_EQ(field("log-stretch-bar", component_of(ScalarCurve::constant(1e4))),
            "components.log-stretch-bar");
  EXPECT_EQ(field("stretch-bar", component_of({ogden(1e4, 0)})),
            "components.stretch-bar.addends[0]");
  EXPECT_EQ(field("trace", component_of(ScalarCurve::constant(1e4))), "components");
  EXPECT_EQ(field("J", component_of({linear(1e4)})), "components.J");  // stressed at rest
}

TEST(StandardLaw, IsNoneWithoutALawOfTheShape) {
  EXPECT_EQ(refused(solid_of({})).where().field, "components");
  EXPECT_THAT(std::string(refused(with_volume({})).what()), HasSubstr("change of shape"));
  EXPECT_THAT(std::string(refused(stvk_solid(1e5, -1e4)).what()), HasSubstr("not above 0"));
  Material cloth = solid_of({});
  cloth.kind = MaterialKind::cloth;
  EXPECT_EQ(refused(cloth).where().field, "kind");
}

TEST(StandardLaw, OfInvariantsOfCAsksForTheLogarithmThatLeavesRestFreeOfStress) {
  const auto coupled = [](double log) {
    MaterialComponent volume = component_of({linear(log)});
    volume.stiffness = ScalarCurve::constant(kBulk);
    return solid_of({{"I1", component_of({linear(4e4)})},
                     {"I2", component_of({linear(1e4)})},
                     {"log-J", volume}});
  };
  EXPECT_EQ(name_of(law_of_material(coupled(-1.2e5))), "coupled Mooney-Rivlin");
  const InputError error = refused(coupled(-1e5));
  EXPECT_EQ(error.where().field, "components.log-J");
  EXPECT_THAT(std::string(error.what()), HasSubstr("-120000"));
}

TEST(StandardLaw, ChainsArePowersOfTheirInvariant) {
  const ArrudaBoyceLaw law{9e4, 2.8};
  const Material chains = solid_of({{"I1-bar", component_of({arruda_boyce(law.mu, law.lock)})}});
  const std::array<double, 5> powers = powers_of(law);
  for (const Eigen::Matrix3d& f : deformations()) {
    const double x = Invariants(f).i1_bar - 3, energy = energy_of(chains, f);
    double sum = 0;
    for (int i = 5; i >= 1; --i) sum = x * (powers[static_cast<std::size_t>(i - 1)] + sum);
    EXPECT_NEAR(sum, energy, 1e-12 * energy);
  }
}

}  // namespace
}  // namespace pliant::test
