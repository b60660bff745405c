// What the pages of the documentation lead to, and what sources and templates say of pages, is
// there.

#include <cctype>
#include <map>
#include <regex>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layers/source_rules.h"
#include "support/pages.h"

namespace pliant::source_rules {
namespace {

namespace fs = std::filesystem;
using test::Page;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const fs::path kSource = PLIANT_SOURCE_DIR;

/// The anchor that a heading gets on the pages of GitHub: letters and digits, blanks as hyphens.
std::string anchor_of(const std::string& heading) {
  static const std::regex link(R"(\[([^\]]*)\]\([^)]*\))");
  std::string anchor;
  for (const unsigned char c : std::regex_replace(heading, link, "$1")) {
    if (c == ' ') anchor += '-';
    if (std::isalnum(c) || c == '-' || c == '_' || c >= 0x80)
      anchor += static_cast<char>(std::tolower(c));
  }
  return anchor;
}

std::set<std::string> anchors_of(const Page& page) {
  static const std::regex anchor(R"re((?:^|\n)#+ ([^\n]*)|<a id="([^"]*)">)re");
  const std::string prose = parts_of(page).prose;
  std::set<std::string> anchors;
  for (std::sregex_iterator it(prose.begin(), prose.end(), anchor), end; it != end; ++it) {
    const std::string name = (*it)[2].matched ? (*it)[2].str() : anchor_of((*it)[1]);
    std::string free = name;
    for (int n = 1; anchors.contains(free); ++n) free = name + "-" + std::to_string(n);
    anchors.insert(free);
  }
  return anchors;
}

/// Why a link of a page leads nowhere; empty where it leads somewhere.
std::string fault_of(const std::string& link, const Page& page) {
  const size_t hash = link.find('#');
  const std::string file = link.substr(0, hash);
  const fs::path target =
      file.empty() ? page.path : (page.path.parent_path() / file).lexically_normal();
  if (!file.empty() && !fs::exists(kSource / target)) return "there is no " + target.string();
  if (hash == std::string::npos || target.extension() != ".md") return "";
  const std::string anchor = link.substr(hash + 1);
  const Page leads_to = file.empty() ? page : test::read_page(target);
  if (anchors_of(leads_to).contains(anchor)) return "";
  return target.string() + " has no heading #" + anchor;
}

/// The links of a page that lead nowhere; those to other places of the web are not followed.
std::vector<Offence> broken_links(const Page& page) {
  static const std::regex target(R"re(\]\(([^)\s]+)\)|(?:src|href)="([^"]+)")re");
  const std::string prose = parts_of(page).prose;
  std::vector<Offence> offences;
  for (std::sregex_iterator it(prose.begin(), prose.end(), target), end; it != end; ++it) {
    const std::string link = (*it)[1].matched ? (*it)[1] : (*it)[2];
    if (link.starts_with("http") || link.starts_with("mailto:")) continue;
    const std::string fault = fault_of(link, page);
    if (fault.empty()) continue;
    const auto line = std::count(prose.begin(), prose.begin() + it->position(), '\n') + 1;
    offences.push_back({page.path.string(), static_cast<int>(line), link + ": " + fault});
  }
  return offences;
}

/// Pages that a text names as docs/... and that are not there.
std::vector<std::string> missing_pages(const std::string& text) {
  static const std::regex name(R"(\bdocs/[\w./-]*\w)");
  std::vector<std::string> missing;
  for (std::sregex_iterator it(text.begin(), text.end(), name), end; it != end; ++it) {
    if (!fs::exists(kSource / it->str())) missing.push_back(it->str());
  }
  return missing;
}

TEST(Links, OfPagesLeadToFilesAndHeadings) {
  const std::vector<Page> pages = test::documentation();
  EXPECT_GT(pages.size(), 20U);
  std::vector<Offence> offences;
  for (const Page& page : pages) {
    const std::vector<Offence> found = broken_links(page);
    offences.insert(offences.end(), found.begin(), found.end());
  }
  EXPECT_TRUE(offences.empty()) << describe(offences);
}

TEST(Links, OfSourcesAndTemplatesNamePagesThatAreThere) {
  int files = 0;
  for (const char* folder : {"src", "apps", "examples", "materials", "cmake", "web"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      static const std::set<fs::path> kinds{".h", ".cpp", ".yaml", ".csv", ".md", ".cmake", ".js"};
      if (entry.path().string().find("node_modules") != std::string::npos) continue;
      if (!kinds.contains(entry.path().extension())) continue;
      const Page file = test::read_page(entry.path().lexically_relative(kSource));
      EXPECT_THAT(missing_pages(file.text), IsEmpty()) << file.path;
      ++files;
    }
  }
  EXPECT_GT(files, 300);
}

TEST(LinkRule, FindsMissingFilesAndHeadingsAndLeavesCodeAlone) {
  const Page page{"docs/made-up.md",
                  "# One, two\n[a](#one-two) [b](#three) [c](no.md)\n"
                  "![d](../README.md#contributing)\n[e](https://example.org/no)\n"
                  "```\n# three\n[f](none.md)\n```\n"};
  std::vector<std::string> faults;
  for (const Offence& offence : broken_links(page)) faults.push_back(offence.what);
  EXPECT_THAT(faults, ElementsAre("#three: docs/made-up.md has no heading #three",
                                  "no.md: there is no docs/no.md",
                                  "../README.md#contributing: README.md has no heading "
                                  "#contributing"));
  EXPECT_THAT(missing_pages("// see docs/none.md and docs/schema."), ElementsAre("docs/none.md"));
}

TEST(LinkRule, NamesAnchorsAsTheyAreShown) {
  EXPECT_EQ(anchor_of("fit.json and evaluation.json"), "fitjson-and-evaluationjson");
  EXPECT_EQ(anchor_of("study/1: measurements, `and` more"), "study1-measurements-and-more");
  const Page twice{"docs/made-up.md", "## a\n## a\n<a id=\"b\"></a>\n"};
  EXPECT_THAT(anchors_of(twice), ElementsAre("a", "a-1", "b"));
}

}  // namespace
}  // namespace pliant::source_rules
