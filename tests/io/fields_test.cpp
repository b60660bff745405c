#include "pliant/io/fields.h"

#include <string>

#include <gtest/gtest.h>

#include "input_error_of.h"

namespace pliant {
namespace {

using test::input_error_of;

const Document& study() {
  static const Document document = parse_yaml(R"(pliant: study/1
name: spandex
density: 0.157 kg/m^2
bare: 12
nothing:
on: true
gravity: [0, 0, -9.81]
experiments:
  - {name: a, clip_mass: 20 g}
  - name: b
    clip_mass: 20 gram
    rows: 7
)",
                                              "study.yaml");
  return document;
}

Value value_of(const char* key) { return Value(study()).fields().require(key); }
Fields experiment(std::size_t i) { return value_of("experiments").items()[i].fields(); }

TEST(Value, IsReadAsWhatTheSchemaSaysItIs) {
  EXPECT_EQ(value_of("name").text(), "spandex");
  EXPECT_DOUBLE_EQ(value_of("density").quantity(Dimension::area_density), 0.157);
  EXPECT_EQ(value_of("bare").number(), 12.0);
  EXPECT_EQ(value_of("bare").integer(0, 12), 12);
  EXPECT_TRUE(value_of("on").flag());
  EXPECT_EQ(value_of("gravity").numbers(), (std::vector<double>{0, 0, -9.81}));
  EXPECT_EQ(value_of("name").choice({"cotton", "spandex"}), "spandex");
  EXPECT_EQ(parse_json("\"1.5\"", "f").root.text, "1.5");
  const Document quoted_number = parse_json("\"1.5\"", "f");
  EXPECT_EQ(Value(quoted_number).number(), 1.5);
}

TEST(Value, ErrorNamesFileLineAndDottedPath) {
  const InputError error =
      input_error_of([] { experiment(1).require("clip_mass").quantity(Dimension::mass); });
  EXPECT_STREQ(error.what(),
               "study.yaml:11: experiments[1].clip_mass: \"20 gram\": \"gram\" is no unit of mass; "
               "expected a mass with its unit (kg, g, mg, lb, oz)");
  EXPECT_EQ(error.where().field, "experiments[1].clip_mass");
  EXPECT_EQ(error.where().line, 11);
}

TEST(Value, ThatIsMissingIsLookedForAmongKeysThatNobodyAskedFor) {
  const Document document = parse_yaml("directon: warp\nwidth: 5 cm\n", "study.yaml");
  Fields fields = Value(document).fields();
  EXPECT_EQ(input_error_of([&] { fields.require("direction").text(); }).problem(),
            "is missing (did you mean it by `directon`?)");
  fields.optional("width");
  EXPECT_EQ(input_error_of([&] { fields.require("widths").text(); }).problem(), "is missing");
}

TEST(Value, RefusesADimensionalFieldWithoutUnit) {
  const InputError error = input_error_of([] { value_of("bare").quantity(Dimension::length); });
  EXPECT_EQ(error.problem(), "\"12\" has no unit");
  EXPECT_EQ(error.expected(), "a length with its unit (m, cm, mm, um, in)");
  EXPECT_EQ(error.where().line, 4);
}

TEST(Value, RefusesOtherKinds) {
  EXPECT_EQ(input_error_of([] { value_of("experiments").text(); }).problem(), "is a list");
  EXPECT_EQ(input_error_of([] { value_of("name").items(); }).problem(), "is a single value");
  EXPECT_EQ(input_error_of([] { value_of("gravity").fields(); }).problem(), "is a list");
  EXPECT_EQ(input_error_of([] { value_of("name").number(); }).problem(),
            "\"spandex\" is not a finite number");
  EXPECT_EQ(input_error_of([] { value_of("name").flag(); }).expected(), "true or false");
  EXPECT_EQ(input_error_of([] { value_of("bare").integer(0, 11); }).expected(),
            "a whole number from 0 to 11");
}

TEST(Value, RefusesNanAndInfWhereverNumbersAreRead) {
  const Document document = parse_yaml("[1, .nan, nan, Inf, 1e999]", "f.yaml");
  const InputError error = input_error_of([&] { Value(document).numbers(); });
  EXPECT_EQ(error.where().field, "[1]");
  const std::vector<Value> items = Value(document).items();
  for (std::size_t i = 1; i < items.size(); ++i) {
    input_error_of([&] { items[i].number(); });
    input_error_of([&] { items[i].integer(-10, 10); });
  }
}

TEST(Value, NamesTheNearestChoice) {
  const InputError error = input_error_of([] { value_of("name").choice({"spandes", "cotton"}); });
  EXPECT_EQ(error.problem(), "\"spandex\" (did you mean \"spandes\"?)");
  EXPECT_EQ(error.expected(), "\"spandes\" or \"cotton\"");
}

TEST(Fields, TellsWhatIsMissingOrEmpty) {
  const InputError missing = input_error_of([] { experiment(0).require("data").text(); });
  EXPECT_STREQ(missing.what(), "study.yaml:9: experiments[0].data: is missing; expected a text");
  const InputError empty = input_error_of([] { value_of("nothing").number(); });
  EXPECT_STREQ(empty.what(), "study.yaml:5: nothing: has no value; expected a number");
  EXPECT_FALSE(Value(study()).fields().optional("nothing"));
  EXPECT_FALSE(Value(study()).fields().optional("absent"));
}

TEST(Fields, TellsOfWhatIsMissingWhatItShouldBe) {
  const auto expected = [](auto read) {
    const InputError error = input_error_of([&] { read(value_of("absent")); });
    EXPECT_EQ(error.problem(), "is missing");
    EXPECT_EQ(error.where().line, 1);
    return error.expected();
  };
  EXPECT_EQ(expected([](const Value& v) { v.quantity(Dimension::time); }),
            "a time with its unit (s, ms, us, min, h)");
  EXPECT_EQ(expected([](const Value& v) { v.positive_quantity(Dimension::number); }), "a number");
  EXPECT_EQ(expected([](const Value& v) { v.choice({"a", "b"}); }), "\"a\" or \"b\"");
  EXPECT_EQ(expected([](const Value& v) { v.integer(1, 9); }), "a whole number from 1 to 9");
  EXPECT_EQ(expected([](const Value& v) { v.flag(); }), "true or false");
  EXPECT_EQ(expected([](const Value& v) { v.items(); }), "a list");
  EXPECT_EQ(expected([](const Value& v) { v.numbers(); }), "a list of numbers");
  EXPECT_EQ(expected([](const Value& v) { v.fields(); }), "a mapping (KEY: VALUE)");
  EXPECT_EQ(expected([](const Value& v) { v.text("a mesh file"); }), "a mesh file");
  EXPECT_TRUE(value_of("absent").is_null());
}

TEST(Fields, RefusesAKeyThatWasNeverAskedForAndNamesTheNearest) {
  Fields fields = experiment(1);
  fields.require("name");
  fields.optional("row");
  fields.optional("clip_mass");
  const InputError error = input_error_of([&] { fields.finish(); });
  EXPECT_STREQ(error.what(),
               "study.yaml:12: experiments[1].rows: unknown key (did you mean \"row\"?); expected "
               "\"clip_mass\", \"name\" or \"row\"");
  fields.optional("rows");
  EXPECT_NO_THROW(fields.finish());
}

TEST(Fields, AllCountAsAskedFor) {
  Fields fields = experiment(0);
  const auto all = fields.all();
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(all[1].first, "clip_mass");
  EXPECT_EQ(all[1].second.location().field, "experiments[0].clip_mass");
  EXPECT_EQ(fields.keys(), (std::vector<std::string>{"name", "clip_mass"}));
  EXPECT_NO_THROW(fields.finish());
}

InputError type_error(const std::string& text) {
  const Document document = parse_yaml(text, "f.yaml");
  return input_error_of([&] {
    Fields fields = Value(document).fields();
    require_document(fields, "study", 1);
  });
}

TEST(RequireDocument, ChecksTypeAndVersion) {
  Fields fields = Value(study()).fields();
  EXPECT_NO_THROW(require_document(fields, "study", 1));
  EXPECT_STREQ(type_error("a: 1\n").what(), "f.yaml:1: pliant: is missing; expected \"study/1\"");
  EXPECT_EQ(type_error("a: 1\npliant: scene/1\n").problem(), "this is a \"scene/1\" document");
  EXPECT_EQ(type_error("pliant: scene/1\n").where().line, 1);
  EXPECT_EQ(type_error("pliant: study/2\n").problem(), "unknown version \"2\"");
  EXPECT_EQ(type_error("pliant: study\n").problem(), "unknown version \"\"");
}

TEST(DocumentType, IsThePliantField) {
  EXPECT_EQ(document_type(study()), "study/1");
  EXPECT_EQ(document_type(parse_json("[1]", "f")), std::nullopt);
  EXPECT_EQ(document_type(parse_json("{\"a\": 1}", "f")), std::nullopt);
}

}  // namespace
}  // namespace pliant
