#include "pliant/measurement/tester_preamble.h"

#include <algorithm>
#include <set>

#include "pliant/base/letter_case.h"
#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"

namespace pliant {
namespace {

struct Label {
  std::string_view field;
  std::vector<std::string_view> words;      ///< in lower case; the surest first
  std::optional<Dimension> dimension = {};  ///< none: a text
};

const std::vector<Label>& labels() {
  static const std::vector<Label> labels{
      {"length",
       {"gauge length",
        "gage length",
        "initial gauge length",
        "initial length",
        "original length",
        "grip separation",
        "initial grip separation",
        "grip to grip separation",
        "jaw separation",
        "clamp distance",
        "nominal gauge length",
        "einspannlänge",
        "einspannlaenge",
        "messlänge",
        "messlaenge",
        "anfangsmesslänge",
        "ausgangslänge",
        "klemmenabstand",
        "einspannabstand",
        "freie einspannlänge",
        "einspannlänge bei startposition",
        "l0",
        "length"},
       Dimension::length},
      {"width",
       {"specimen width", "sample width", "strip width", "width", "probenbreite", "streifenbreite",
        "breite", "b0"},
       Dimension::length},
      {"pretension",
       {"preload", "pre-load", "pre load", "pretension", "pre-tension", "vorkraft",
        "vorspannkraft"},
       Dimension::force},
      {"speed",
       {"test speed", "crosshead speed", "testing speed", "speed", "rate", "test rate",
        "prüfgeschwindigkeit", "pruefgeschwindigkeit", "geschwindigkeit"}},
      {"direction",
       {"direction", "specimen direction", "sample direction", "test direction", "orientation",
        "richtung", "probenrichtung", "prüfrichtung", "entnahmerichtung"}},
      {"material",
       {"material", "fabric", "sample name", "sample", "product", "werkstoff", "artikel"}},
      {"specimen",
       {"specimen label", "specimen id", "specimen name", "specimen", "sample id",
        "probenbezeichnung", "probe", "probe nr", "proben-nr"}},
      {"operator", {"operator", "operator name", "user", "bediener", "prüfer"}},
      {"date", {"test date", "date", "start date", "prüfdatum", "datum"}},
      {"standard", {"test standard", "standard", "test method", "method", "prüfnorm", "norm"}}};
  return labels;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// What separates a label, its value and its unit.
std::string_view without_separators(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t;:,=\"|");
  return first == std::string_view::npos ? std::string_view() : text.substr(first);
}

/// A unit at the beginning: in brackets, or a word.
std::string leading_unit(std::string_view text) {
  if (text.starts_with("in ")) text.remove_prefix(3);
  const bool bracket = !text.empty() && (text.front() == '(' || text.front() == '[');
  if (bracket) text.remove_prefix(1);
  const std::size_t end = text.find_first_of(bracket ? ")]" : ";,\t\"|");
  return std::string(trimmed(text.substr(0, end)));
}

/// What stands behind the number of a label, as that of a ramp in `Rate 1";"20 mm/min"`.
std::string_view without_ordinal(std::string_view text) {
  const std::size_t end = text.find_first_not_of("0123456789");
  if (end == 0 || end > 2 || end == std::string_view::npos) return text;
  const std::string_view rest = without_separators(text.substr(end));
  const std::string_view between = text.substr(end, text.size() - end - rest.size());
  const bool is_next_cell = between.find_first_of("\";:=\t|") != std::string_view::npos;
  const bool is_number = !rest.empty() && rest.front() >= '0' && rest.front() <= '9';
  return is_next_cell && is_number ? rest : text;
}

/// What follows the symbol that a standard gives a size, as in `Probenbreite b0;50;mm`.
std::string_view without_symbol(std::string_view words) {
  const bool is_symbol = words.size() > 2 && is_letter(words[0]) && words[1] == '0' &&
                         !is_letter(words[2]) && !(words[2] >= '0' && words[2] <= '9');
  return is_symbol ? trimmed(words.substr(2)) : words;
}

/// What follows a label at the beginning of a line; none where another word does.
std::optional<std::string_view> after_label(std::string_view line, std::string_view label) {
  if (!lower_case(line.substr(0, label.size())).starts_with(label)) return std::nullopt;
  const std::string_view rest = line.substr(label.size());
  const std::string_view words = without_symbol(trimmed(rest));
  if (words.empty() || is_letter(rest.front())) return std::nullopt;
  const bool goes_on = is_letter(words.front()) && !words.starts_with("in ");
  return goes_on ? std::nullopt : std::optional(without_ordinal(words));
}

struct NumberAndUnit {
  double number;
  std::string unit;
};

/// 100 and "mm" of `;100,0;mm` or `(mm);100`; none where no number stands there.
std::optional<NumberAndUnit> number_and_unit(std::string_view text) {
  std::string unit;
  if (text.front() == '(' || text.front() == '[' || text.starts_with("in ")) {
    unit = leading_unit(text);
    const std::size_t end = text.find_first_of(")];,\t\":=|");
    text = end == std::string_view::npos ? std::string_view() : text.substr(end + 1);
  }
  text = without_separators(text);
  const std::size_t end = std::min(text.find_first_not_of("+-.,0123456789eE"), text.size());
  std::string number(text.substr(0, end));
  while (number.ends_with(',')) number.pop_back();
  std::ranges::replace(number, ',', '.');
  const std::optional<double> value = parse_number(number);
  if (!value) return std::nullopt;
  if (unit.empty()) unit = leading_unit(without_separators(text.substr(number.size())));
  return NumberAndUnit{*value, unit};
}

/// "100 mm" of `;100,0;mm`; none where no number or no unit of the dimension stands there.
std::optional<std::string> told_quantity(std::string_view text, Dimension dimension) {
  const std::optional<NumberAndUnit> told = number_and_unit(text);
  if (!told || !unit_conversion(told->unit, dimension)) return std::nullopt;
  return format_number(told->number) + " " + told->unit;
}

/// The words of a line after its label, quotes and separators aside.
std::string told_text(std::string_view text) {
  std::string words;
  for (const char c : without_separators(text)) {
    const bool separator = c == ';' || c == '\t' || c == '"' || c == '|';
    if (!separator) {
      words += c;
    } else if (!words.ends_with(' ')) {
      words += ' ';
    }
  }
  const std::string_view trim = trimmed(words);
  return std::string(trim.substr(0, trim.find_last_not_of(" ,") + 1));
}

/// "20 mm/min" of `"20.00","mm/min"`; speeds are told, not computed with, so any unit will do.
std::string told_speed(std::string_view text) {
  const std::optional<NumberAndUnit> told = number_and_unit(text);
  return told ? std::string(trimmed(format_number(told->number) + " " + told->unit))
              : told_text(text);
}

std::optional<std::string> told_value(const Label& label, std::string_view line) {
  for (const std::string_view word : label.words) {
    const auto rest = after_label(line, word);
    if (!rest) continue;
    std::string value = label.dimension ? told_quantity(*rest, *label.dimension).value_or("")
                        : label.field == "direction" ? told_direction(*rest)
                        : label.field == "speed"     ? told_speed(*rest)
                                                     : told_text(*rest);
    if (!value.empty()) return value;
  }
  return std::nullopt;
}

/// A specimen is often named after its direction: `Specimen label;warp 1`.
void add_direction_of_name(std::vector<TesterFact>& facts) {
  if (find_fact(facts, "direction")) return;
  for (const char* field : {"specimen", "material"}) {
    const TesterFact* name = find_fact(facts, field);
    const std::string direction = name ? told_direction(name->value) : std::string();
    if (direction.empty()) continue;
    facts.push_back({"direction", direction, name->written, name->line});
    return;
  }
}

}  // namespace

std::vector<TesterFact> tester_facts(std::string_view preamble) {
  std::vector<TesterFact> facts;
  int number = 0;
  while (!preamble.empty()) {
    ++number;
    const std::size_t end = std::min(preamble.find_first_of("\r\n"), preamble.size());
    const std::string_view line = preamble.substr(0, end);
    preamble.remove_prefix(end);
    preamble.remove_prefix(preamble.starts_with("\r\n") ? 2 : preamble.empty() ? 0 : 1);
    const std::string_view words =
        line.substr(std::min(line.find_first_not_of(" \t;,\"#"), line.size()));
    for (const Label& label : labels()) {
      if (find_fact(facts, label.field)) continue;
      if (auto value = told_value(label, words)) {
        facts.push_back({std::string(label.field), *value, std::string(trimmed(line)), number});
        break;
      }
    }
  }
  add_direction_of_name(facts);
  return facts;
}

const TesterFact* find_fact(std::span<const TesterFact> facts, std::string_view field) {
  const auto found = std::ranges::find(facts, field, &TesterFact::field);
  return found == facts.end() ? nullptr : &*found;
}

std::string told_direction(std::string_view text) {
  static const std::vector<std::pair<std::string, std::set<std::string>>> words{
      {"warp", {"warp", "wale", "wales", "kette", "kettrichtung", "lengthwise", "längs", "laengs"}},
      {"weft",
       {"weft", "course", "courses", "fill", "filling", "schuss", "schussrichtung", "crosswise",
        "quer"}},
      {"bias", {"bias", "diagonal", "diag"}}};
  std::set<std::string> found;
  std::string word;
  for (const char c : lower_case(text) + " ") {
    if (is_letter(c)) {
      word += c;
      continue;
    }
    for (const auto& [direction, names] : words) {
      if (names.contains(word)) found.insert(direction);
    }
    word.clear();
  }
  return found.size() == 1 ? *found.begin() : std::string();
}

}  // namespace pliant
