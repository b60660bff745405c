#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "pliant/io/document.h"

#include "input_error_of.h"
#include "temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;

InputError yaml_error(const std::string& text) {
  return input_error_of([&] { parse_yaml(text, "study.yaml"); });
}

TEST(Yaml, BecomesATreeWithLines) {
  const Document document = parse_yaml(R"(# a study
name: "12"
lot: 12
list: [1, 2]
empty:
nested:
  - {a: b}
  - |
    two
    lines
)",
                                       "study.yaml");
  const auto& fields = document.root.fields;
  ASSERT_EQ(fields.size(), 5U);
  EXPECT_EQ(document.root.kind, Node::Kind::mapping);
  EXPECT_EQ(fields[0].value.text, "12");
  EXPECT_TRUE(fields[0].value.quoted);
  EXPECT_FALSE(fields[1].value.quoted);
  EXPECT_EQ(fields[1].value.line, 3);
  EXPECT_EQ(fields[2].value.items[1].text, "2");
  EXPECT_EQ(fields[3].value.kind, Node::Kind::null);
  const Node& nested = fields[4].value;
  EXPECT_EQ(nested.line, 6);  // of its key
  EXPECT_EQ(nested.items[0].line, 7);
  EXPECT_EQ(nested.items[0].fields[0].key, "a");
  EXPECT_EQ(nested.items[1].text, "two\nlines\n");
}

TEST(Yaml, ReplacesAliasesByWhatTheyStandFor) {
  const Document document = parse_yaml("a: &x {k: 1}\nb: *x\nc: &y 5\nd: [*y, *x]\n", "f");
  const auto& fields = document.root.fields;
  EXPECT_EQ(fields[1].value.fields[0].value.text, "1");
  EXPECT_EQ(fields[1].value.line, 2);
  EXPECT_EQ(fields[3].value.items[0].text, "5");
  EXPECT_EQ(fields[3].value.items[1].fields[0].key, "k");
}

TEST(Yaml, RefusesAnAliasBomb) {
  std::string bomb = "a0: &a0 [x, x, x, x, x, x, x, x, x, x]\n";
  for (int i = 1; i < 12; ++i) {
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [";
    for (int j = 0; j < 10; ++j) bomb += "*a" + std::to_string(i - 1) + ", ";
    bomb += "]\n";
  }
  const InputError error = yaml_error(bomb);
  EXPECT_NE(error.problem().find("alias bomb"), std::string::npos);
  EXPECT_GT(error.where().line, 1);
}

TEST(Yaml, RefusesManyAliasesOfALongText) {
  std::string bomb = "a: &a " + std::string(100'000, 'x') + "\nb: [";
  for (int i = 0; i < 10'000; ++i) bomb += "*a, ";
  bomb += "]\n";
  EXPECT_EQ(yaml_error(bomb).where().line, 2);
}

TEST(Yaml, RefusesAliasesToThemselvesAndToNothing) {
  EXPECT_EQ(yaml_error("a: &x [*x]\n").where().line, 1);
  EXPECT_EQ(yaml_error("b: 1\na: *x\n").where().line, 2);
}

TEST(Yaml, RefusesAKeyGivenTwiceAndNamesBothLines) {
  const InputError error = yaml_error("name: a\nlength: 1\nname: b\n");
  EXPECT_STREQ(error.what(), "study.yaml:3: name: given twice (first in line 1)");
}

TEST(Yaml, RefusesDeepNesting) {
  EXPECT_EQ(yaml_error(std::string(65, '[') + std::string(65, ']')).problem(), "nested too deeply");
  EXPECT_NO_THROW(parse_yaml(std::string(64, '[') + std::string(64, ']'), "f"));
  yaml_error(std::string(100'000, '['));
  yaml_error("a: &x " + std::string(40, '[') + std::string(40, ']') +
             "\nb: " + std::string(40, '[') + "*x" + std::string(40, ']'));
}

TEST(Yaml, RefusesWhatADocumentHasNoUseFor) {
  EXPECT_EQ(yaml_error("a: 1\n---\nb: 2\n").problem(), "a second document in the file");
  EXPECT_EQ(yaml_error("a: &x {b: 1}\nc:\n  <<: *x\n").problem(), "a merge key (<<)");
  EXPECT_EQ(yaml_error("a: !!str 1\n").where().line, 1);
  EXPECT_EQ(yaml_error("[1, 2]: 3\n").problem(), "a list or mapping as a key");
  EXPECT_EQ(yaml_error("a: \"\\0\"\n").problem(), "a NUL character in a text");
}

TEST(Yaml, RefusesAnEmptyFile) {
  for (const char* text : {"", "\n\n", "# only a comment\n", "---\n", "~\n"}) {
    EXPECT_EQ(yaml_error(text).problem(), "the file is empty") << text;
  }
}

TEST(Yaml, NamesTheLineOfASyntaxError) {
  EXPECT_EQ(yaml_error("a: 1\nb: [1, 2\nc: 3\n").where().file, "study.yaml");
  EXPECT_EQ(yaml_error("a: 1\n\tb: 2\n").where().line, 2);
}

TEST(Yaml, RefusesAQuoteThatTheEndOfTheFileCutsOff) {
  EXPECT_EQ(yaml_error("a: 1\nb: \"open\n").where().line, 2);
  EXPECT_EQ(yaml_error("\xC3\xA9: 1\nb: 'it''s\n\n").where().line, 2);
  EXPECT_EQ(yaml_error("b: [\"a\", \"open \\\"").where().line, 1);
  EXPECT_EQ(parse_yaml("b: 'it''s'\nc: \"a \\\\\"\n", "f").root.fields[0].value.text, "it's");
}

TEST(Yaml, FileIsReadInUtf16) {
  const TemporaryFolder folder;
  const auto path = folder.write("s.yaml", std::string_view("\xFF\xFE"
                                                            "a\0:\0 \0\xE9\0\n\0",
                                                            12));
  EXPECT_EQ(read_yaml(path).root.fields[0].value.text, "\xC3\xA9");
}

TEST(Yaml, FileMustBeAFileOfReasonableSize) {
  const TemporaryFolder folder;
  EXPECT_EQ(input_error_of([&] { read_yaml(folder.path()); }).problem(), "is a directory");
  const auto huge = folder.write("huge.yaml", "");
  std::filesystem::resize_file(huge, std::uintmax_t{1} << 30);
  EXPECT_EQ(input_error_of([&] { read_yaml(huge); }).problem(), "the file is too large");
}

}  // namespace
}  // namespace pliant
