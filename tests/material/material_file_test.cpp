#include "pliant/material/material_file.h"

#include <filesystem>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/material/addend/addend_registry.h"

#include "io/temporary_folder.h"
#include "support/refusal.h"

namespace pliant {
namespace {

using test::Refusal;
using test::TemporaryFolder;
using ::testing::ElementsAre;

Material read_text(const std::string& text) {
  const TemporaryFolder folder;
  return read_material(folder.write("fabric.json", text));
}

/// A file with one component, given on line 6.
std::string with_component(const std::string& name, const std::string& component) {
  return fmt::format(
      "{{\"pliant\": \"material/1\",\n\"name\": \"jersey\",\n\"kind\": \"cloth\",\n"
      "\"density\": 0.15,\n\"components\": {{\n\"{}\": {}\n}}}}",
      name, component);
}

std::string with_friction(const std::string& friction) {
  return with_component(
      "stretch.warp",
      R"({"stiffness": {"curve": "constant", "value": 3}, "friction": )" + friction + "}");
}

MaterialComponent read_component(const std::string& name, const std::string& component) {
  return read_text(with_component(name, component)).components.at(name);
}

// The example of the documented format.
constexpr const char* kExample = R"({"pliant": "material/1", "name": "spandex", "kind": "cloth",
 "density": 0.157, "membrane": "stvk", "bending": "discrete-shells", "bending_of": "sheet",
 "components": {
   "stretch.weft":  {"stiffness": {"curve": "hermite", "strain": [0, 0.1, 0.2], "value": [10, 12, 40]}, "status": "measured", "range": [0, 0.2]},
   "stretch.warp":  {"stiffness": {"curve": "affine", "k1": 4.42, "k2": 32.19},
                     "friction": {"law": "dahl", "a": 0.40, "b": 4.84, "tau": 0.088}, "status": "measured", "range": [0, 0.9]},
   "shear":         {"stiffness": {"curve": "constant", "value": 3.0}, "status": "assumed"},
   "bend.weft":     {"stiffness": {"curve": "constant", "value": 6.2e-6}},
   "bend.warp":     {"status": "unmeasured"}, "bend.diagonal": {"status": "unmeasured"}},
 "damping": {"fraction": 0.05},
 "provenance": {"study": "...", "study_sha256": "...", "command": "...", "pliant_version": "...", "created": "..."}})";

TEST(MaterialFile, ReadsTheDocumentedExample) {
  const Material material = read_text(kExample);
  EXPECT_EQ(material.name, "spandex");
  EXPECT_EQ(material.density, 0.157);
  EXPECT_EQ(material.membrane, MembraneMeasure::stvk);
  EXPECT_EQ(material.bending_of, "sheet");
  EXPECT_EQ(material.damping_fraction, 0.05);
  EXPECT_EQ(material.provenance.size(), 5U);

  const MaterialComponent& weft = material.components.at("stretch.weft");
  EXPECT_EQ(weft.stiffness->kind(), CurveKind::hermite);
  EXPECT_THAT(weft.stiffness->knots(), ElementsAre(0, 0.1, 0.2));
  EXPECT_THAT(weft.stiffness->values(), ElementsAre(10, 12, 40));
  EXPECT_EQ(weft.range, std::make_pair(0.0, 0.2));
  EXPECT_FALSE(weft.friction);

  const MaterialComponent& warp = material.components.at("stretch.warp");
  EXPECT_THAT(warp.stiffness->values(), ElementsAre(4.42, 32.19));
  EXPECT_EQ(warp.friction->positive.a, 0.40);
  EXPECT_EQ(warp.friction->positive.b, 4.84);
  EXPECT_EQ(warp.friction->positive.tau, 0.088);
  EXPECT_FALSE(warp.friction->negative);

  EXPECT_EQ(material.components.at("shear").status, ComponentStatus::assumed);
  EXPECT_EQ(material.components.at("bend.weft").status, ComponentStatus::measured);
  EXPECT_EQ(material.components.at("bend.warp").status, ComponentStatus::unmeasured);
  EXPECT_FALSE(material.components.at("bend.warp").stiffness);
}

TEST(MaterialFile, GivesTheLawOfAComponentThatWasMeasuredOrAssumed) {
  const Material material = read_text(kExample);
  const auto law = law_of(material, "stretch.warp");
  ASSERT_TRUE(law);
  EXPECT_THAT(law->parameters(), ElementsAre(4.42, 32.19, 0.40, 4.84, 0.088));
  EXPECT_EQ(law_of(material, "stretch.weft")->friction_law, FrictionLaw::none);
  EXPECT_TRUE(law_of(material, "shear"));
  EXPECT_FALSE(law_of(material, "bend.warp"));
  EXPECT_FALSE(law_of(material, "stretch.bias"));
}

/// Every kind of curve and friction, with numbers that have no short decimal.
Material awkward_material() {
  Material material;
  material.name = "Jersey \"3:1\" \\ grün";
  material.density = 0.1 + 0.2;
  material.membrane = MembraneMeasure::soft_constraint;
  material.bending_of = "hinges";
  material.damping_fraction = 1.0 / 3;
  material.info = {{"lot", "A7\nB"}};
  material.provenance = {{"command", "pliant fit x.yaml"}};
  auto& components = material.components;
  components["stretch.weft"].stiffness = ScalarCurve::constant(4.9406564584124654e-324);
  components["stretch.warp"].stiffness = ScalarCurve::affine(1e300 / 3, -1.0 / 7);
  components["stretch.warp"].friction =
      ComponentFriction{{1.0 / 3, 2.0 / 3, 1e-17 / 3}, DahlParameters{0, 0, 0.1 + 0.7}};
  components["stretch.warp"].status = ComponentStatus::assumed;
  components["stretch.warp"].range = {-1e-17, 1.0 / 3};
  components["shear"].stiffness = ScalarCurve::hermite({0, 1.0 / 3}, {5, 1.0 / 9}, true);
  components["bend.weft"].stiffness = ScalarCurve::hermite({-1.0 / 3, 0.1}, {5e-6, 1e-6 / 9});
  components["bend.weft"].friction = ComponentFriction{{1e-5 / 3, 0, 7.67}, {}};
  components["bend.warp"].status = ComponentStatus::unmeasured;
  return material;
}

void expect_same(const DahlParameters& a, const DahlParameters& b) {
  EXPECT_EQ(a.a, b.a);
  EXPECT_EQ(a.b, b.b);
  EXPECT_EQ(a.tau, b.tau);
}

TEST(MaterialFile, ReadsBackWhatItWroteBitForBit) {
  const Material material = awkward_material();
  const Material back = read_text(material_text(material));
  EXPECT_EQ(material_text(back), material_text(material));
  EXPECT_EQ(back.name, material.name);
  EXPECT_EQ(back.density, material.density);
  EXPECT_EQ(back.membrane, material.membrane);
  EXPECT_EQ(back.bending_of, material.bending_of);
  EXPECT_EQ(back.damping_fraction, material.damping_fraction);
  EXPECT_EQ(back.info, material.info);
  EXPECT_EQ(back.provenance, material.provenance);
  ASSERT_EQ(back.components.size(), material.components.size());
  for (const auto& [name, component] : material.components) {
    SCOPED_TRACE(name);
    const MaterialComponent& other = back.components.at(name);
    EXPECT_EQ(other.status, component.status);
    EXPECT_EQ(other.range, component.range);
    ASSERT_EQ(other.stiffness.has_value(), component.stiffness.has_value());
    if (component.stiffness) {
      EXPECT_EQ(other.stiffness->kind(), component.stiffness->kind());
      EXPECT_EQ(other.stiffness->even(), component.stiffness->even());
      EXPECT_EQ(other.stiffness->knots(), component.stiffness->knots());
      EXPECT_EQ(other.stiffness->values(), component.stiffness->values());
    }
    ASSERT_EQ(other.friction.has_value(), component.friction.has_value());
    if (component.friction) {
      expect_same(other.friction->positive, component.friction->positive);
      ASSERT_EQ(other.friction->negative.has_value(), component.friction->negative.has_value());
      if (component.friction->negative) {
        expect_same(*other.friction->negative, *component.friction->negative);
      }
    }
  }
}

TEST(MaterialFile, AnUnknownDensityStaysUnknown) {
  Material material = awkward_material();
  material.density = 0;
  EXPECT_EQ(read_text(material_text(material)).density, 0);
}

TEST(MaterialFile, FrictionMayDifferBySide) {
  const Material material = read_text(with_friction(
      R"({"law": "dahl", "positive": {"a": 1, "b": 2, "tau": 3}, "negative": {"a": 4, "b": 5, "tau": 6}})"));
  const ComponentFriction& friction = *material.components.at("stretch.warp").friction;
  EXPECT_EQ(friction.positive.b, 2);
  ASSERT_TRUE(friction.negative);
  EXPECT_EQ(friction.negative->a, 4);
  EXPECT_EQ(friction.negative->tau, 6);
}

TEST(MaterialFile, CurvesOfShearAndBendingThatStartAtZeroAreMirrored) {
  const std::string from_zero =
      R"({"stiffness": {"curve": "hermite", "strain": [0, 0.2], "value": [1, 2]}})";
  const std::string both_signs =
      R"({"stiffness": {"curve": "hermite", "strain": [-0.1, 0.2], "value": [1, 2]}})";
  for (const char* name : {"shear", "bend.weft", "bend.diagonal"}) {
    EXPECT_TRUE(read_component(name, from_zero).stiffness->even()) << name;
    EXPECT_FALSE(read_component(name, both_signs).stiffness->even()) << name;
  }
  EXPECT_FALSE(read_component("stretch.warp", from_zero).stiffness->even());
}

TEST(MaterialFile, LeavesOutEverythingOptional) {
  const Material material =
      read_text(R"({"pliant": "material/1", "name": "x", "kind": "cloth", "components": {}})");
  EXPECT_EQ(material.density, 0);
  EXPECT_EQ(material.membrane, MembraneMeasure::stvk);
  EXPECT_FALSE(material.damping_fraction);
  EXPECT_TRUE(material.components.empty());
}

/// A solid with limits, which stand on line 5.
std::string with_limits(const std::string& limits) {
  return R"({"pliant": "material/1", "name": "rubber", "kind": "solid",
 "components": {"I1-bar": {"addends": [{"law": "linear", "c": 2e5}]},
   "J": {"stiffness": {"curve": "constant", "value": 2e6}},
   "fibre.x": {"status": "unmeasured"}},
 "limits": )" +
         limits + "}";
}

TEST(MaterialFile, KeepsLimitsOfEnergy) {
  Material material = read_text(with_limits(R"([{"of": ["J", "I1-bar"], "energy": 4e3,
      "errors": {"energy": {"determined": "within 10 %", "std_error": 120}}}])"));
  ASSERT_EQ(material.limits.size(), 1u);
  const EnergyLimit& limit = material.limits.front();
  EXPECT_THAT(limit.of, ElementsAre("I1-bar", "J"));  // in the order of components
  EXPECT_EQ(limit_name(limit.of), "I1-bar+J.limit");
  EXPECT_EQ(limit.energy, 4e3);
  EXPECT_EQ(limit.errors.at("energy").std_error, 120);
  EXPECT_EQ(material_text(read_text(material_text(material))), material_text(material));
}

TEST(MaterialFile, AddendsMayStandBesideAStiffnessOrAlone) {
  const std::string branch = R"({"law": "dahl", "a": 0.4, "b": 2, "tau": 0.1})";
  const MaterialComponent beside =
      read_component("stretch.warp", R"({"stiffness": {"curve": "constant", "value": 3},
                                         "addends": [)" +
                                         branch + ", " + branch + "]}");
  EXPECT_EQ(beside.addends.size(), 2u);
  EXPECT_EQ(beside.addends[1].values(), Eigen::Vector3d(0.4, 2, 0.1));
  const MaterialComponent alone = read_component("shear", R"({"addends": [)" + branch + "]}");
  EXPECT_EQ(alone.status, ComponentStatus::measured);
  EXPECT_EQ(law_of(alone).parameter_count(), 3);
  EXPECT_EQ(read_component("shear", R"({"addends": []})").status, ComponentStatus::unmeasured);
}

TEST(MaterialFile, WritesAddendsAsItReadsThem) {
  Material material;
  material.name = "knit";
  MaterialComponent& component = material.components["stretch.warp"];
  component.stiffness = ScalarCurve::none();
  component.addends = {{*find_addend_kind("dahl"), Eigen::Vector3d(0.1, 1.0 / 3, 0.7)}};
  const MaterialComponent read = read_text(material_text(material)).components.at("stretch.warp");
  EXPECT_EQ(read.stiffness->kind(), CurveKind::none);
  EXPECT_EQ(read.addends.front().values(), component.addends.front().values());
}

// --- what is refused, and where ---

class MaterialFileRefusal : public ::testing::TestWithParam<Refusal> {};

TEST(MaterialFile, KeepsWhatAFitKnowsOfItsNumbers) {
  Material material = read_text(kExample);
  std::map<std::string, NumberError>& errors = material.components.at("stretch.warp").errors;
  errors["k1"] = {0.03, {}, Determination::within_10_percent, "weights 60 %, cycles 40 %"};
  errors["friction.b"] = {{}, 0.3, Determination::none, ""};
  const MaterialComponent read = read_text(material_text(material)).components.at("stretch.warp");
  ASSERT_EQ(read.errors.size(), 2U);
  EXPECT_EQ(read.errors.at("k1").std_error, 0.03);
  EXPECT_EQ(read.errors.at("k1").determined, Determination::within_10_percent);
  EXPECT_EQ(read.errors.at("k1").told_by, "weights 60 %, cycles 40 %");
  EXPECT_EQ(read.errors.at("friction.b").limit, 0.3);
  EXPECT_FALSE(read.errors.at("friction.b").std_error.has_value());
}

TEST_P(MaterialFileRefusal, NamesFileLineAndField) {
  const TemporaryFolder folder;
  const auto path = folder.write("fabric.json", GetParam().text);
  expect_refused(GetParam(), path, read_material);
}

std::string with_addend(const std::string& addend) {
  return with_component("shear", R"({"addends": [)" + addend + "]}");
}

std::string with_curve(const std::string& curve) {
  return with_component("shear", R"({"stiffness": )" + curve + "}");
}

const Refusal kRefusals[] = {
    {"UnknownKey",
     "{\"pliant\": \"material/1\",\n\"name\": \"x\",\n\"kind\": \"cloth\",\n"
     "\"desity\": 1,\n\"components\": {}}",
     4, "desity", "did you mean \"density\"?"},
    {"UnknownVersion", R"({"pliant": "material/2", "name": "x"})", 1, "pliant", "unknown version"},
    {"AnotherDocument", R"({"pliant": "study/1", "name": "x"})", 1, "pliant", "material/1"},
    {"NoType", R"({"name": "x"})", 1, "pliant", "is missing"},
    {"NoName", R"({"pliant": "material/1", "kind": "cloth", "components": {}})", 1, "name",
     "is missing"},
    {"UnknownComponent", with_component("stretch.wrap", "{}"), 6, "components.stretch.wrap",
     "did you mean \"stretch.warp\"?"},
    {"NegativeDensity", R"({"pliant": "material/1", "name": "x", "kind": "cloth", "density": -1})",
     1, "density", "not positive"},
    {"ErrorOfNoNumber",
     with_component("shear",
                    R"({"stiffness": {"curve": "constant", "value": 1},
"errors": {"k1": {"determined": "weak"}}})"),
     7, "components.shear.errors.k1", "one of k"},
    {"UnknownGrade",
     with_component("shear",
                    R"({"stiffness": {"curve": "constant", "value": 1},
"errors": {"k": {"determined": "well"}}})"),
     7, "components.shear.errors.k.determined", "within 10 %"},
    {"UnknownCurve", with_curve(R"({"curve": "hermit"})"), 6, "components.shear.stiffness.curve",
     "did you mean \"hermite\"?"},
    {"CurveWithoutNumbers", with_curve(R"({"curve": "affine", "k1": 1})"), 6,
     "components.shear.stiffness.k2", "is missing"},
    {"KeyOfAnotherCurve", with_curve(R"({"curve": "constant", "value": 1, "k1": 2})"), 6,
     "components.shear.stiffness.k1", "unknown key"},
    {"StrainsThatRepeat",
     with_curve(R"({"curve": "hermite", "strain": [0, 0.1, 0.1], "value": [1, 2, 3]})"), 6,
     "components.shear.stiffness.strain", "does not increase"},
    {"MoreValuesThanStrains",
     with_curve(R"({"curve": "hermite", "strain": [0, 0.1], "value": [1, 2, 3]})"), 6,
     "components.shear.stiffness.value", "has 3 values"},
    {"NoStrains", with_curve(R"({"curve": "hermite", "strain": [], "value": []})"), 6,
     "components.shear.stiffness.strain", "is empty"},
    {"TextForANumber", with_curve(R"({"curve": "constant", "value": "stiff"})"), 6,
     "components.shear.stiffness.value", "stiff"},
    {"NegativeA", with_friction(R"({"law": "dahl", "a": -0.1, "b": 0, "tau": 1})"), 6,
     "components.stretch.warp.friction.a", "is negative"},
    {"NegativeB", with_friction(R"({"law": "dahl", "a": 0.1, "b": -1, "tau": 1})"), 6,
     "components.stretch.warp.friction.b", "is negative"},
    {"ZeroTau", with_friction(R"({"law": "dahl", "a": 0.1, "b": 0, "tau": 0})"), 6,
     "components.stretch.warp.friction.tau", "is not positive"},
    {"UnknownLaw", with_friction(R"({"law": "dahlia", "a": 0.1, "b": 0, "tau": 1})"), 6,
     "components.stretch.warp.friction.law", "did you mean \"dahl\"?"},
    {"UnknownAddend", with_addend(R"({"law": "dahlia", "a": 1, "b": 0, "tau": 1})"), 6,
     "components.shear.addends[0].law", "did you mean \"dahl\"?"},
    {"AddendWithoutItsNumber", with_addend(R"({"law": "dahl", "a": 1, "b": 0})"), 6,
     "components.shear.addends[0].tau", "is missing"},
    {"AddendWithAForeignNumber",
     with_addend(R"({"law": "dahl", "a": 1, "b": 0, "tau": 1, "alpha": 2})"), 6,
     "components.shear.addends[0].alpha", "unknown key"},
    {"NegativeNumberOfAnAddend", with_addend(R"({"law": "dahl", "a": -1, "b": 0, "tau": 1})"), 6,
     "components.shear.addends[0].a", "is negative"},
    {"ZeroWhereAnAddendNeedsMore", with_addend(R"({"law": "dahl", "a": 1, "b": 0, "tau": 0})"), 6,
     "components.shear.addends[0].tau", "is not positive"},
    {"OneSideOfFriction",
     with_friction(R"({"law": "dahl", "positive": {"a": 1, "b": 2, "tau": 3}})"), 6,
     "components.stretch.warp.friction.negative", "is missing"},
    {"BothFormsOfFriction",
     with_friction(
         R"({"law": "dahl", "a": 1, "positive": {"a": 1, "b": 2, "tau": 3}, "negative": {"a": 1, "b": 2, "tau": 3}})"),
     6, "components.stretch.warp.friction.a", "unknown key"},
    {"MeasuredWithoutStiffness", with_component("shear", R"({"status": "measured"})"), 6,
     "components.shear.status", "without a stiffness"},
    {"UnknownStatus", with_component("shear", R"({"status": "guessed"})"), 6,
     "components.shear.status", "guessed"},
    {"RangeFromHighToLow",
     with_component("shear",
                    R"({"stiffness": {"curve": "constant", "value": 1}, "range": [0.2, 0.1]})"),
     6, "components.shear.range", "is no range"},
    {"NegativeDamping",
     "{\"pliant\": \"material/1\", \"name\": \"x\", \"kind\": \"cloth\", \"components\": {},\n"
     "\"damping\": {\"fraction\": -0.1}}",
     2, "damping.fraction", "is negative"},
    {"FunctionOfAnotherStrain",
     "{\"pliant\": \"material/1\", \"name\": \"x\", \"kind\": \"cloth\", \"membrane\": "
     "\"spring\",\n"
     "\"components\": {\"area\": {\"stiffness\": {\"curve\": \"constant\", \"value\": 1}}}}",
     2, "components", "a function of Green's strain, and the membrane is `spring`"},
    {"TermWrittenInAnotherWay",
     with_component("stretch.weft*shear@0.10/0~0.1/0.1",
                    R"({"addends": [{"law": "linear", "c": 1}]})"),
     6, "components.stretch.weft*shear@0.10/0~0.1/0.1", "stretch.weft*shear@0.1/0~0.1/0.1"},
    {"MemoryOfPrincipalStretches",
     with_component("principal.stretch",
                    R"({"addends": [{"law": "dahl", "a": 1, "b": 0, "tau": 1}]})"),
     6, "components.principal.stretch", "remembers, on principal stretches"},
    {"UnknownMeasure",
     "{\"pliant\": \"material/1\", \"name\": \"x\", \"kind\": \"cloth\",\n\"membrane\": \"stvkk\"}",
     2, "membrane", "did you mean \"stvk\"?"},
};

const Refusal kRefusedLimits[] = {
    {"LimitAtRest", with_limits(R"([{"of": ["J"], "energy": 0}])"), 5, "limits[0].energy",
     "the energy of the material at rest"},
    {"LimitOfNothing", with_limits(R"([{"of": ["fibre.x"], "energy": 1}])"), 5, "limits[0].of",
     "no law"},
    {"LimitTwice", with_limits(R"([{"of": ["J"], "energy": 1}, {"of": ["J"], "energy": 2}])"), 5,
     "limits[1].of[0]", "in two limits"},
    {"LimitOfCloth", with_limits(R"([{"of": ["shear"], "energy": 1}])"), 5, "limits[0].of[0]",
     "shear"},
};

INSTANTIATE_TEST_SUITE_P(OfLimits, MaterialFileRefusal, ::testing::ValuesIn(kRefusedLimits),
                         test::name_of_refusal);

INSTANTIATE_TEST_SUITE_P(Of, MaterialFileRefusal, ::testing::ValuesIn(kRefusals),
                         test::name_of_refusal);

}  // namespace
}  // namespace pliant
