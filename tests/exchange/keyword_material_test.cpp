// The numbers in keyword files, by the formulas of the tools' manuals.

#include "pliant/exchange/keyword_material.h"

#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/number_text.h"

#include "exchange/standard_materials.h"
#include "io/input_error_of.h"

namespace pliant::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A keyword with the numbers below it.
struct Keyword {
  std::string head;
  std::vector<double> numbers;

  bool is(const std::string& word) const { return head.find(word) != std::string::npos; }
};

Keyword law_in(const std::string& text) {
  Keyword law;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("*")) {
      if (line.find("ELASTIC") != std::string::npos) law.head = line;
      continue;
    }
    if (law.head.empty()) continue;  // of another keyword
    std::istringstream cells(line);
    int count = 0;
    for (std::string cell; std::getline(cells, cell, ','); ++count) {
      EXPECT_LE(trimmed(cell).size(), 20U) << cell;
      law.numbers.push_back(parse_number(trimmed(cell)).value());
    }
    EXPECT_LE(count, 8) << line;
  }
  return law;
}

/// sum (J - 1)^2i / D_i; a D of 0 leaves its power out (Abaqus).
double volume_energy(const double* d, int count, double j) {
  double energy = 0;
  for (int i = 1; i <= count; ++i) {
    if (d[i - 1] != 0) energy += std::pow(j - 1, 2 * i) / d[i - 1];
  }
  return energy;
}

/// Its coefficients in the order C10, C01, C20, C11, C02, C30, ...
double polynomial_energy(const std::vector<double>& numbers, int order, const Invariants& at) {
  double energy = 0;
  std::size_t next = 0;
  for (int power = 1; power <= order; ++power) {
    for (int second = 0; second <= power; ++second) {
      energy += numbers[next++] * std::pow(at.i1_bar - 3, power - second) *
                std::pow(at.i2_bar - 3, second);
    }
  }
  return energy + volume_energy(&numbers[next], order, at.j);
}

double ogden_energy(const std::vector<double>& numbers, const Invariants& at) {
  const std::size_t terms = numbers.size() / 3;
  double energy = volume_energy(&numbers[2 * terms], static_cast<int>(terms), at.j);
  for (std::size_t i = 0; i < terms; ++i) {
    const double mu = numbers[2 * i], alpha = numbers[2 * i + 1];
    energy += 2 * mu / (alpha * alpha) * Invariants::powers(at.stretches_bar(), alpha);
  }
  return energy;
}

double chain_energy(const std::vector<double>& numbers, const Invariants& at) {
  const double mu = numbers[0], lock = numbers[1], d = numbers[2];
  const double c[] = {1.0 / 2, 1.0 / 20, 11.0 / 1050, 19.0 / 7000, 519.0 / 673750};
  double energy = d == 0 ? 0 : ((at.j * at.j - 1) / 2 - std::log(at.j)) / d;
  for (int i = 1; i <= 5; ++i) {
    energy += mu * c[i - 1] / std::pow(lock, 2 * i - 2) * (std::pow(at.i1_bar, i) - std::pow(3, i));
  }
  return energy;
}

double written_energy(const Keyword& law, const Eigen::Matrix3d& f) {
  const Invariants at(f);
  const std::vector<double>& n = law.numbers;
  if (law.is("NEO HOOKE")) return n[0] * (at.i1_bar - 3) + volume_energy(&n[1], 1, at.j);
  if (law.is("MOONEY-RIVLIN")) return polynomial_energy(n, 1, at);
  if (law.is("POLYNOMIAL, N=3")) return polynomial_energy(n, 3, at);
  if (law.is("YEOH")) {
    const double x = at.i1_bar - 3;
    return x * (n[0] + x * (n[1] + x * n[2])) + volume_energy(&n[3], 3, at.j);
  }
  if (law.is("OGDEN")) return ogden_energy(n, at);
  if (law.is("ARRUDA-BOYCE")) return chain_energy(n, at);
  if (law.is("TYPE=ORTHO")) {
    Eigen::Matrix3d normal;
    normal << n[0], n[1], n[3], n[1], n[2], n[4], n[3], n[4], n[5];
    return orthotropic_energy_of(normal, {n[8], n[7], n[6]}, at);
  }
  if (law.is("*ELASTIC")) return linear_energy_of(n[0], n[1], at);
  ADD_FAILURE() << law.head;
  return NAN;
}

void expect_equal_energy(const Material& material, const ConvertedSolid& written,
                         const std::vector<Eigen::Matrix3d>& where) {
  const Keyword law = law_in(written.text);
  for (const Eigen::Matrix3d& f : where) {
    const double energy = test::energy_of(material, f);
    EXPECT_NEAR(written_energy(law, f), energy, 1e-12 * energy) << written.text;
  }
}

class KeywordMaterial : public ::testing::TestWithParam<NamedMaterial> {};

TEST_P(KeywordMaterial, HasTheEnergyOfOurs) {
  const Material& material = GetParam().material;
  for (const KeywordTool tool : {KeywordTool::abaqus, KeywordTool::calculix}) {
    const ConvertedSolid written = keyword_material(to_convert(material), tool);
    expect_equal_energy(material, written, deformations());
    const bool is_rate_law = tool == KeywordTool::abaqus && GetParam().name == "StVK";
    EXPECT_EQ(written.lost.size(), is_rate_law ? 1U : 0U);
  }
}

INSTANTIATE_TEST_SUITE_P(Laws, KeywordMaterial, ::testing::ValuesIn(materials_of_all_tools()),
                         [](const auto& one) { return one.param.name; });

TEST(KeywordMaterial, HasTheEnergyOfOrthotropicBodies) {
  const Material material = orthotropic_material();
  for (const KeywordTool tool : {KeywordTool::abaqus, KeywordTool::calculix}) {
    expect_equal_energy(material, keyword_material(to_convert(material), tool), deformations());
  }
}

TEST(KeywordMaterial, HasTheEnergyOfChainsWithTheVolumeThatTheyHaveThere) {
  const Material material =
      with_volume_of_square({{"I1-bar", component_of({arruda_boyce(9e4, 2.8)})}});
  const ConvertedSolid written = keyword_material(to_convert(material), KeywordTool::calculix);
  EXPECT_THAT(written.lost, IsEmpty());
  expect_equal_energy(material, written, deformations());
}

TEST(KeywordMaterial, HasTheEnergyOfPowersBesideI2) {
  const Material material = with_volume({{"I1-bar", component_of({polynomial(4e4, -2e3, 900)})},
                                         {"I2-bar", component_of({linear(6e3)})}});
  const ConvertedSolid written = keyword_material(to_convert(material), KeywordTool::calculix);
  EXPECT_THAT(written.text, HasSubstr("*HYPERELASTIC, POLYNOMIAL, N=3\n"));
  expect_equal_energy(material, written, deformations());
}

TEST(KeywordMaterial, ThatKeepsItsVolumeDoesSoInAbaqusAndNearlyInCalculix) {
  const Material material = solid_of({{"I1-bar", component_of({linear(5e4)})}});
  const ConvertedSolid abaqus = keyword_material(to_convert(material), KeywordTool::abaqus);
  EXPECT_THAT(abaqus.text, HasSubstr("NEO HOOKE\n50000, 0\n"));
  EXPECT_THAT(abaqus.lost, IsEmpty());
  const ConvertedSolid calculix = keyword_material(to_convert(material), KeywordTool::calculix);
  EXPECT_THAT(calculix.text, HasSubstr("NEO HOOKE\n50000, 1e-06\n"));  // 2 / (20 x 1e5 Pa)
  EXPECT_THAT(calculix.lost, ElementsAre(HasSubstr("constant volume")));
  expect_equal_energy(material, calculix, isochoric_deformations());
}

TEST(KeywordMaterial, OfAnotherEnergyOfTheVolumeSaysSoAndAgreesToSecondOrder) {
  const std::map<std::string, MaterialComponent> shape{{"I1-bar", component_of({linear(5e4)})}};
  const std::map<std::string, MaterialComponent> chains{
      {"I1-bar", component_of({arruda_boyce(9e4, 2.8)})}};
  MaterialComponent spline = component_of(ScalarCurve::spline({-0.2, 0, 0.2}, {kBulk, kBulk, 0}));
  std::vector<Material> materials{with_volume(shape, "log-J"), with_volume_of_square(shape),
                                  with_volume(chains), with_volume(shape)};
  materials.back().components["J"] = spline;
  for (const Material& material : materials) {
    const ConvertedSolid written = keyword_material(to_convert(material), KeywordTool::calculix);
    EXPECT_THAT(written.lost, ElementsAre(HasSubstr("form of the volume's energy")));
    expect_equal_energy(material, written, isochoric_deformations());
    for (const double j : {1 - 1e-3, 1 + 1e-3}) {
      const Eigen::Matrix3d f = std::cbrt(j) * Eigen::Matrix3d::Identity();
      EXPECT_NEAR(written_energy(law_in(written.text), f), test::energy_of(material, f),
                  kBulk * 1e-9);  // (J - 1)^3
    }
  }
}

TEST(KeywordMaterial, TellsTheDensityWhereItIsKnown) {
  Material material = neo_hookean_solid(5e4, kBulk);
  EXPECT_THAT(keyword_material(to_convert(material), KeywordTool::abaqus).text,
              ::testing::Not(HasSubstr("DENSITY")));
  material.density = 1100;
  EXPECT_THAT(keyword_material(to_convert(material), KeywordTool::abaqus).text,
              HasSubstr("*DENSITY\n1100\n"));
}

TEST(KeywordMaterial, RefusesWhatTheToolDoesNotHave) {
  const auto refused = [](const Material& material, KeywordTool tool) {
    return input_error_of([&] { keyword_material(to_convert(material), tool); });
  };
  const auto terms = [](int count) {
    std::vector<Addend> addends;
    for (int i = 1; i <= count; ++i) addends.push_back(ogden(1e4, i));
    return with_volume({{"stretch-bar", component_of(addends)}});
  };
  keyword_material(to_convert(terms(4)), KeywordTool::abaqus);
  EXPECT_EQ(refused(terms(4), KeywordTool::calculix).where().field, "components.stretch-bar");
  EXPECT_EQ(refused(terms(7), KeywordTool::abaqus).where().field, "components.stretch-bar");
  const Material free = with_volume({{"stretch", component_of({ogden(1e4, 2)})}});
  EXPECT_EQ(refused(free, KeywordTool::abaqus).where().field, "components.stretch");
  // CalculiX takes D = 2 / bulk below 1e-10 as not given.
  const Material stiff = neo_hookean_solid(1e9, 2.1e10);
  keyword_material(to_convert(stiff), KeywordTool::abaqus);
  const InputError error = refused(stiff, KeywordTool::calculix);
  EXPECT_EQ(error.where().file, "rubber.json");
  EXPECT_THAT(std::string(error.what()), HasSubstr("below 1e-10"));
}

TEST(KeywordNumber, HasTwentyCharactersAtMostAndThirteenDigitsAtLeast) {
  for (const double value : {-1.2345678901234567e-105, 1 / 3.0, -2e22 / 7, 1100.0, 1e-5 / 3}) {
    const std::string text = keyword_number(value);
    EXPECT_LE(text.size(), 20U) << text;
    EXPECT_NEAR(parse_number(text).value(), value, 5e-13 * std::abs(value));
  }
  EXPECT_EQ(keyword_number(0.1), "0.1");
}

TEST(KeywordName, HasLettersDigitsAndUnderscores) {
  EXPECT_EQ(keyword_name("soft rubber, 2"), "SOFT_RUBBER__2");
  EXPECT_EQ(keyword_name("40 Shore"), "M40_SHORE");
  EXPECT_EQ(keyword_name(""), "M");
  EXPECT_EQ(keyword_name(std::string(200, 'x')).size(), 79U);
}

}  // namespace
}  // namespace pliant::test
