#include "pliant/study/blank_fields.h"

#include <map>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

struct Blank {
  int line;
  std::string path;
  std::string hint;
};

void find_blanks(const Node& node, const std::string& path, std::string_view field,
                 std::vector<Blank>& blanks) {
  // Under `columns` a blank may carry the unit.
  const bool blank =
      node.text == kBlank || (field == "columns" && node.text.find(kBlank) != std::string::npos);
  if (node.kind == Node::Kind::scalar && blank) {
    blanks.push_back({node.line, path, blank_hint(field)});
  }
  for (const Node::Field& child : node.fields) {
    const std::string below = path.empty() ? child.key : path + "." + child.key;
    find_blanks(child.value, below, field == "columns" ? field : child.key, blanks);
  }
  for (std::size_t i = 0; i < node.items.size(); ++i) {
    find_blanks(node.items[i], fmt::format("{}[{}]", path, i), field, blanks);
  }
}

}  // namespace

std::string blank_hint(std::string_view field) {
  static const std::map<std::string_view, std::string> hints{
      {"direction", "warp, weft or bias (45 degrees)"},
      {"length", "the length of the strip between the clamps, e.g. 100 mm"},
      {"width", "the width of the strip, e.g. 50 mm"},
      {"density", "the mass of a piece of the fabric divided by its area, e.g. 150 g/m^2"},
      {"mode", "uniaxial, equibiaxial, planar or biaxial"},
      {"side", "up or down: the way in which the strip buckles"},
      {"columns", "the header or number of its column, and its unit: Load (N), 2 (N)"}};
  const auto found = hints.find(field);
  return found == hints.end() ? "its value" : found->second;
}

void refuse_blanks(const Document& document) {
  std::vector<Blank> blanks;
  find_blanks(document.root, "", "", blanks);
  if (blanks.empty()) return;
  std::vector<std::string> texts;
  for (const Blank& blank : blanks) {
    texts.push_back(fmt::format("line {}: {} ({})", blank.line, blank.path, blank.hint));
  }
  throw InputError({document.file, blanks.front().line},
                   fmt::format("{} {} left blank ({})", blanks.size(),
                               blanks.size() == 1 ? "field is" : "fields are", kBlank),
                   fmt::format("{}", fmt::join(texts, "; ")));
}

}  // namespace pliant
