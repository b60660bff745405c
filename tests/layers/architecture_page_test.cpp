// The folders and what each of them uses: as linked (src/CMakeLists.txt), as told
// (docs/architecture.md), and as included.

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layers/source_rules.h"

namespace pliant::source_rules {
namespace {

using ::testing::ElementsAre;
using ::testing::ElementsAreArray;
using ::testing::IsEmpty;
using ::testing::Pair;

/// A folder and those that it uses, in the order of the text.
using Folder = std::pair<std::string, std::vector<std::string>>;

std::string text_of(const std::string& path) {
  std::ifstream stream(std::string(PLIANT_SOURCE_DIR) + "/" + path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> words_of(const std::string& text) {
  static const std::regex word("[a-z_]+");
  std::vector<std::string> words;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
    words.push_back(it->str());
  }
  return words;
}

template <class Uses>
std::vector<Folder> folders_matching(const std::string& text, const std::regex& pattern,
                                     Uses uses) {
  std::vector<Folder> folders;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it) {
    folders.emplace_back((*it)[1].str(), words_of(uses((*it)[2].str())));
  }
  return folders;
}

std::vector<std::string> names_of(const std::vector<Folder>& folders) {
  std::vector<std::string> names;
  for (const Folder& folder : folders) names.push_back(folder.first);
  return names;
}

/// Those of the sentence `a stack of libraries, lowest first: base, io.`
std::vector<std::string> told_order(const std::string& page) {
  static const std::regex sentence(R"(a stack of libraries, lowest first:([a-z,\s]*)\.)");
  std::smatch match;
  return std::regex_search(page, match, sentence) ? words_of(match[1].str())
                                                  : std::vector<std::string>();
}

/// Those of `pliant_library(NAME DEPENDS ... PACKAGES ...)`.
std::vector<Folder> linked_folders(const std::string& cmake) {
  static const std::regex library(R"(\npliant_library\((\w+)([^)]*)\))");
  return folders_matching("\n" + cmake, library, [](const std::string& arguments) {
    const size_t begin = arguments.find("DEPENDS"), end = arguments.find("PACKAGES");
    if (begin == std::string::npos || begin > end) return std::string();
    return arguments.substr(begin, end == std::string::npos ? end : end - begin);
  });
}

/// Those of the table `| folder | uses | what is in it |`.
std::vector<Folder> told_folders(const std::string& page) {
  static const std::regex row(R"(\n\| ([a-z]+) \| ?([a-z, ]*)\|[^\n]*)");
  std::vector<Folder> folders =
      folders_matching(page, row, [](const std::string& uses) { return uses; });
  std::erase_if(folders, [](const Folder& folder) { return folder.first == "folder"; });
  return folders;
}

TEST(ArchitecturePage, TellsTheFoldersAndWhatTheyUseAsTheyAreLinked) {
  const std::vector<Folder> linked = linked_folders(text_of("src/CMakeLists.txt"));
  EXPECT_GT(linked.size(), 9u);
  EXPECT_EQ(told_folders(text_of("docs/architecture.md")), linked);
}

TEST(ArchitecturePage, OrderIsThatOfTheRuleAndOfThePageForContributors) {
  const std::vector<std::string> told = names_of(told_folders(text_of("docs/architecture.md")));
  EXPECT_THAT(layers(), ElementsAreArray(told));
  EXPECT_THAT(told_order(text_of("CONTRIBUTING.md")), ElementsAreArray(told));
}

TEST(ArchitecturePage, FoldersIncludeOnlyWhatTheyAreLinkedTo) {
  std::map<std::string, std::set<std::string>> allowed;
  for (const auto& [folder, uses] : linked_folders(text_of("src/CMakeLists.txt"))) {
    allowed[folder] = {uses.begin(), uses.end()};
    allowed[folder].insert(folder);
  }
  static const std::regex include(R"(#include "pliant/([a-z]+)/)");
  for (const SourceFile& source : source_files(PLIANT_SOURCE_DIR, "src/pliant")) {
    const std::string folder = source.path.substr(11, source.path.find('/', 11) - 11);
    for (std::sregex_iterator it(source.text.begin(), source.text.end(), include), end; it != end;
         ++it) {
      EXPECT_TRUE(allowed[folder].contains((*it)[1].str()))
          << source.path << " includes " << (*it)[1].str() << ", to which it is not linked";
    }
  }
}

TEST(FolderTables, AreRead) {
  EXPECT_THAT(linked_folders("pliant_library(base\n  PACKAGES fmt::fmt)\n"
                             "pliant_library(mesh\n  DEPENDS base io\n  PACKAGES a::b)\n"),
              ElementsAre(Pair("base", IsEmpty()), Pair("mesh", ElementsAre("base", "io"))));
  EXPECT_THAT(told_folders("\n| folder | uses | what |\n|---|---|---|\n| base | | errors, io |\n"
                           "| mesh | base, io | x |\n"),
              ElementsAre(Pair("base", IsEmpty()), Pair("mesh", ElementsAre("base", "io"))));
  EXPECT_THAT(told_order("`src/` is a stack of libraries, lowest first: base,\nio. A folder"),
              ElementsAre("base", "io"));
}

}  // namespace
}  // namespace pliant::source_rules
