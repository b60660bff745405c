#include "pliant/experiment/registry.h"

#include <algorithm>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/io/document.h"

#include "io/input_error_of.h"

namespace pliant {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const TestType& read_name(const std::string& name) {
  const Document document = parse_yaml("type: " + name + "\n", "study.yaml");
  Fields fields = Value(document).fields();
  return read_test_type(fields.require("type"));
}

TEST(Registry, FindsEachTypeByItsOwnName) {
  std::set<std::string_view> names;
  for (const TestType* type : test_types()) {
    EXPECT_EQ(find_test_type(type->name), type);
    EXPECT_EQ(&read_name(std::string(type->name)), type);
    EXPECT_TRUE(names.insert(type->name).second) << type->name;
  }
  EXPECT_EQ(find_test_type("weights"), nullptr);
}

TEST(Registry, KnowsOfEachTypeAllThatTheProgramAsks) {
  for (const TestType* type : test_types()) {
    SCOPED_TRACE(type->name);
    EXPECT_NE(type->read, nullptr);
    EXPECT_NE(type->read_virtual, nullptr);
    // What is read from a table is predicted in one dimension, has an instrument and a template.
    // What is only predicted is a table, too, of a whole material.
    const bool in_rows = !type->facts.measures_sheets, fitted = !type->facts.only_predicted;
    const bool solid = type->facts.measures_solids;  // in several modes, which a study names
    EXPECT_EQ(type->make != nullptr, in_rows && fitted && !solid);
    EXPECT_EQ(type->make_solid != nullptr, solid);
    EXPECT_EQ(type->make_whole != nullptr, !fitted);
    EXPECT_EQ(type->is_table != nullptr, in_rows);
    EXPECT_EQ(!type->channels.empty(), in_rows && fitted);
    EXPECT_EQ(type->facts.deformation.has_value(), in_rows && fitted && !solid);
    EXPECT_EQ(type->template_files.empty(), !in_rows);
    EXPECT_GE(type->template_files.size(), in_rows ? 3u : 0u);
  }
}

TEST(Registry, TemplatesAreAStudyATableAndAProtocol) {
  for (const TestType* type : test_types()) {
    std::set<std::string> endings;
    for (const auto& [name, content] : type->template_files) {
      endings.insert(name.substr(name.find('.')));
      EXPECT_THAT(content, Not(IsEmpty())) << type->name << ", " << name;
    }
    if (endings.empty()) continue;
    endings.erase(".msh");  // of bodies
    EXPECT_EQ(endings, (std::set<std::string>{".yaml", ".csv", ".md"})) << type->name;
  }
  EXPECT_THAT(template_files("nowhere"), IsEmpty());
}

TEST(Registry, WhatBendsByItsWeightNeedsTheDensity) {
  for (const TestType* type : test_types()) {
    EXPECT_TRUE(type->facts.needs_density || !type->facts.bends_by_weight) << type->name;
  }
}

TEST(Registry, RefusesTypesThatAreNotThereYet) {
  const InputError error = test::input_error_of([] { read_name("image-poses"); });
  EXPECT_EQ(error.where().field, "type");
  EXPECT_EQ(error.problem(), "\"image-poses\" is not there yet");
  for (const TestType* type : test_types()) {
    EXPECT_THAT(error.expected(), HasSubstr(std::string(type->name)));
  }
}

TEST(Registry, NamesTheNearestOfUnknownTypes) {
  const InputError error = test::input_error_of([] { read_name("tensile-cycle"); });
  EXPECT_THAT(error.problem(), HasSubstr("did you mean \"tensile-cycles\"?"));
}

TEST(Registry, TellsTheComponentOfATestAndADirection) {
  EXPECT_EQ(component_of_test("tensile-cycles", "warp"), "stretch.warp");
  EXPECT_EQ(component_of_test("tensile-cycles", "30 deg"), "shear") << "an oblique strip";
  EXPECT_EQ(component_of_test("shear-cycles", ""), "shear");
  EXPECT_EQ(component_of_test("lateral-contraction", "bias"), "contraction.bias");
  EXPECT_EQ(component_of_test("cantilever", "bias"), "bend.diagonal");
  EXPECT_EQ(component_of_test("session", ""), "") << "each tells its own";
}

}  // namespace
}  // namespace pliant
