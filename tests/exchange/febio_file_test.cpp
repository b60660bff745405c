// The numbers in files of FEBio, by the energies of its theory manual.

#include "pliant/exchange/febio_file.h"

#include <regex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/number_text.h"
#include "pliant/geometry/block_mesh.h"

#include "exchange/standard_materials.h"
#include "io/input_error_of.h"

namespace pliant::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A material as a file tells it.
struct FebioMaterial {
  std::string type;
  std::map<std::string, std::string> texts;

  double at(const std::string& name) const {
    const auto found = texts.find(name);
    return found == texts.end() ? 0 : parse_number(found->second).value();
  }
};

FebioMaterial material_in(const std::string& text) {
  static const std::regex type(R"re(<material id="1" name="[^"]*" type="([^"]*)">)re");
  static const std::regex number(R"re(<(\w+)>([^<]*)</\1>)re");
  FebioMaterial material;
  std::smatch found;
  EXPECT_TRUE(std::regex_search(text, found, type)) << text;
  material.type = found[1];
  for (std::sregex_iterator it(text.begin(), text.end(), number), end; it != end; ++it) {
    material.texts[(*it)[1]] = (*it)[2];
  }
  return material;
}

double volume_energy(const FebioMaterial& material, double j) {
  const std::string model = material.texts.at("pressure_model");
  const double log = std::log(j), k = material.at("k");
  if (model == "default") return k / 2 * log * log;
  if (model == "NIKE3D") return k / 4 * (j * j - 2 * log - 1);
  EXPECT_EQ(model, "Abaqus");
  return k / 2 * (j - 1) * (j - 1);
}

double ogden_energy(const FebioMaterial& material, const Invariants& at, bool uncoupled) {
  double energy =
      uncoupled ? volume_energy(material, at.j) : material.at("cp") / 2 * (at.j - 1) * (at.j - 1);
  for (int i = 1; i <= 6; ++i) {
    const std::string number = std::to_string(i);
    const double c = material.at("c" + number), m = material.at("m" + number);
    if (c == 0) continue;
    energy += uncoupled ? c / (m * m) * Invariants::powers(at.stretches_bar(), m)
                        : c / (m * m) * (Invariants::powers(at.stretches, m) - m * std::log(at.j));
  }
  return energy;
}

double written_energy(const FebioMaterial& material, const Eigen::Matrix3d& f) {
  const Invariants at(f);
  const double c1 = material.at("c1"), c2 = material.at("c2"), log = std::log(at.j);
  if (material.type == "isotropic elastic") {
    return linear_energy_of(material.at("E"), material.at("v"), at);
  }
  if (material.type == "orthotropic elastic") {
    Eigen::Matrix3d compliance = Eigen::Matrix3d::Zero();
    for (int a = 0; a < 3; ++a) {
      const std::string i = std::to_string(a + 1), j = std::to_string((a + 1) % 3 + 1);
      compliance(a, a) = 1 / material.at("E" + i);
      compliance(a, (a + 1) % 3) = compliance((a + 1) % 3, a) =
          -material.at("v" + i + j) / material.at("E" + i);
    }
    return orthotropic_energy_of(compliance.inverse(),
                                 {material.at("G23"), material.at("G31"), material.at("G12")}, at);
  }
  if (material.type == "Mooney-Rivlin") {
    return c1 * (at.i1_bar - 3) + c2 * (at.i2_bar - 3) + volume_energy(material, at.j);
  }
  if (material.type == "coupled Mooney-Rivlin") {
    return c1 * (at.i1 - 3) + c2 * (at.i2 - 3) - 2 * (c1 + 2 * c2) * log +
           material.at("k") / 2 * log * log;
  }
  if (material.type == "Yeoh") {
    double energy = volume_energy(material, at.j);
    for (int i = 1; i <= 6; ++i) {
      energy += material.at("c" + std::to_string(i)) * std::pow(at.i1_bar - 3, i);
    }
    return energy;
  }
  EXPECT_THAT(material.type, ::testing::AnyOf("Ogden", "Ogden unconstrained"));
  return ogden_energy(material, at, material.type == "Ogden");
}

/// Those of FEBio alone.
std::vector<NamedMaterial> materials_of_febio() {
  MaterialComponent volume = component_of({linear(-1.2e5)});
  volume.stiffness = ScalarCurve::constant(kBulk);
  const std::map<std::string, MaterialComponent> shape{{"I1-bar", component_of({linear(5e4)})}};
  const std::map<std::string, MaterialComponent> chains{
      {"I1-bar", component_of({arruda_boyce(9e4, 2.8)})}};
  return {{"LogarithmOfTheVolume", with_volume(shape, "log-J")},
          {"SquareOfTheVolume", with_volume_of_square(shape)},
          {"ArrudaBoyce", with_volume(chains)},
          {"Orthotropic", orthotropic_material()},
          {"CoupledMooneyRivlin", solid_of({{"I1", component_of({linear(4e4)})},
                                            {"I2", component_of({linear(1e4)})},
                                            {"log-J", volume}})},
          {"UnconstrainedOgden",
           with_volume({{"stretch", component_of({ogden(6e4, 1.3), ogden(2e3, -4)})}})}};
}

std::vector<NamedMaterial> materials() {
  std::vector<NamedMaterial> all = materials_of_all_tools();
  for (NamedMaterial& named : materials_of_febio()) all.push_back(std::move(named));
  return all;
}

class FebioFile : public ::testing::TestWithParam<NamedMaterial> {};

TEST_P(FebioFile, HasTheEnergyOfOurs) {
  const Material& material = GetParam().material;
  const ConvertedSolid written = febio_file(to_convert(material));
  EXPECT_THAT(written.lost, IsEmpty());
  for (const Eigen::Matrix3d& f : deformations()) {
    const double energy = test::energy_of(material, f);
    EXPECT_NEAR(written_energy(material_in(written.text), f), energy, 1e-12 * energy)
        << written.text;
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, FebioFile, ::testing::ValuesIn(materials()),
                         [](const auto& one) { return one.param.name; });

TEST(FebioFile, OfAMaterialThatKeepsItsVolumeHasABulkModulusAndSaysSo) {
  const Material material = solid_of({{"I1-bar", component_of({linear(5e4)})}});
  const ConvertedSolid written = febio_file(to_convert(material));
  EXPECT_EQ(material_in(written.text).at("k"), 1e8);
  EXPECT_THAT(written.lost, ElementsAre(HasSubstr("constant volume")));
  EXPECT_THAT(written.text, HasSubstr("<!-- lost: the constant volume"));
}

TEST(FebioFile, HoldsTheMeshWithItsSets) {
  Material material = neo_hookean_solid(5e4, kBulk);
  material.name = "a <soft> one";
  material.density = 1100;
  VolumeMesh mesh = block_of_hexahedra({1, 1, 2}, {1, 1, 2});
  mesh.labels = {1, 7};
  mesh.region_names = {{1, "lower"}};
  mesh.groups = {{"foot", {0, 1, 2, 3}}};
  const std::string text = febio_file(to_convert(material, &mesh)).text;
  EXPECT_THAT(text, HasSubstr("name=\"a &lt;soft> one\" type=\"Mooney-Rivlin\""));
  EXPECT_THAT(text, HasSubstr("<density>1100</density>"));
  EXPECT_THAT(text, HasSubstr("<node id=\"12\">1,1,2</node>"));
  EXPECT_THAT(text, HasSubstr("<Elements type=\"hex8\" name=\"hexahedra\">"));
  EXPECT_THAT(text, HasSubstr("<elem id=\"1\">1,2,4,3,5,6,8,7</elem>"));
  EXPECT_THAT(text, HasSubstr("<NodeSet name=\"foot\">1,2,3,4</NodeSet>"));
  EXPECT_THAT(text, HasSubstr("<ElementSet name=\"lower\">1</ElementSet>"));
  EXPECT_THAT(text, HasSubstr("<ElementSet name=\"region 7\">2</ElementSet>"));
  EXPECT_THAT(text, HasSubstr("<SolidDomain name=\"hexahedra\" mat=\"a &lt;soft> one\"/>"));
  EXPECT_THAT(text, Not(HasSubstr("tet4")));
}

TEST(FebioFile, RefusesWhatFebioDoesNotHave) {
  std::vector<Addend> terms;
  for (int i = 1; i <= 7; ++i) terms.push_back(ogden(1e4, i));
  const auto field = [](const Material& material) {
    return input_error_of([&] { febio_file(to_convert(material)); }).where().field;
  };
  EXPECT_EQ(field(with_volume({{"stretch-bar", component_of(terms)}})), "components.stretch-bar");
  EXPECT_EQ(field(with_volume({{"I1-bar", component_of({polynomial(1e4, 100, 0)})},
                               {"I2-bar", component_of({linear(1e3)})}})),
            "components.I2-bar");
  EXPECT_EQ(field(with_volume({{"I2-bar", component_of({linear(1e3)})}})), "components.I1-bar");
}

}  // namespace
}  // namespace pliant::test
