#include <string>

#include <gtest/gtest.h>

#include "pliant/io/document.h"

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;

InputError json_error(const std::string& text) {
  return input_error_of([&] { parse_json(text, "m.json"); });
}

TEST(Json, BecomesATreeWithLines) {
  const Document document = parse_json(R"({
  "name": "a\u00e9",
  "values": [1, -2.50,
    1e3],
  "on": true, "none": null,
  "deep": {"x": 12345678901234567890123}
})",
                                       "m.json");
  const auto& fields = document.root.fields;
  ASSERT_EQ(fields.size(), 5U);
  EXPECT_EQ(document.root.line, 1);
  EXPECT_EQ(fields[0].value.text, "a\xC3\xA9");
  EXPECT_TRUE(fields[0].value.quoted);
  EXPECT_EQ(fields[1].value.line, 3);
  EXPECT_EQ(fields[1].value.items[1].text, "-2.50");
  EXPECT_FALSE(fields[1].value.items[1].quoted);
  EXPECT_EQ(fields[1].value.items[2].line, 4);
  EXPECT_EQ(fields[2].value.text, "true");
  EXPECT_EQ(fields[3].value.kind, Node::Kind::null);
  EXPECT_EQ(fields[4].value.fields[0].value.text, "12345678901234567890123");
  EXPECT_EQ(fields[4].value.line, 6);
}

TEST(Json, CountsTheLineOfANumberThatEndsItsLine) {
  const Document document = parse_json("[\n1\n,\n2\n]", "m.json");
  EXPECT_EQ(document.root.items[0].line, 2);
  EXPECT_EQ(document.root.items[1].line, 4);
}

TEST(Json, RefusesTruncatedTextAndNamesItsLastLine) {
  const InputError error = json_error("{\n  \"a\": [1, 2,\n  3");
  EXPECT_EQ(error.where().file, "m.json");
  EXPECT_EQ(error.where().line, 3);
  EXPECT_NE(error.problem().find("unexpected end of input"), std::string::npos);
}

TEST(Json, RefusesAHundredThousandBracketsWithoutRecursing) {
  EXPECT_EQ(json_error(std::string(100'000, '[')).problem(), "nested too deeply");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_EQ(json_error(objects).problem(), "nested too deeply");
  EXPECT_NO_THROW(parse_json(std::string(64, '[') + std::string(64, ']'), "m.json"));
}

TEST(Json, RefusesAKeyGivenTwiceAndNamesBothLines) {
  EXPECT_STREQ(json_error("{\"k\": 1,\n\"k\": 2}").what(),
               "m.json:2: k: given twice (first in line 1)");
}

TEST(Json, RefusesWhatTheGrammarDoesNotHave) {
  EXPECT_EQ(json_error("{}\n{}").where().line, 2);
  EXPECT_EQ(json_error("{\"a\": 1,\n}").where().line, 2);
  for (const char* text : {"NaN", "[Infinity]", "[1e999]", "{a: 1}", "['x']", "[01]", "// c\n1",
                           "\"\\ud800\"", "[\"\n\"]"}) {
    EXPECT_EQ(json_error(text).where().file, "m.json") << text;
  }
  json_error("\"a\\u0000b\"");
}

TEST(Json, RefusesANumberThatOverflowsWhereItStands) {
  EXPECT_STREQ(json_error("{\"a\": {\n\"b\": [1, {\"c\": 1e400}]}}").what(),
               "m.json:2: a.b[1].c: \"1e400\" is not a finite number; expected a number");
  EXPECT_STREQ(json_error("[0, -1e999]").what(),
               "m.json:1: [1]: \"-1e999\" is not a finite number; expected a number");
}

TEST(Json, RefusesAnEmptyFile) {
  EXPECT_EQ(json_error("").problem(), "the file is empty");
  EXPECT_EQ(json_error(" \n").problem(), "the file is empty");
  EXPECT_EQ(parse_json("null", "m.json").root.kind, Node::Kind::null);
}

TEST(Json, FileMayHaveAByteOrderMark) {
  const TemporaryFolder folder;
  const auto path = folder.write("m.json", "\xEF\xBB\xBF{\"a\": 1}");
  EXPECT_EQ(read_json(path).root.fields[0].value.text, "1");
  EXPECT_EQ(input_error_of([&] { read_json(folder.path()); }).problem(), "is a directory");
}

}  // namespace
}  // namespace pliant
