#include "pliant/report/page_budget.h"

#include <algorithm>
#include <set>
#include <string>

#include "pliant/material/material.h"
#include "pliant/report/page_one_loops.h"

namespace pliant::report {
namespace {

// Of the style sheet for paper, in px: lines of text, rows of tables, and what headings, legends
// and small print take. Fonts differ in width: lines are counted a little too short.
constexpr int kPage = 1032;  // A4 less its margins
constexpr int kLine = 14, kRow = 18, kFactRow = 28;
constexpr int kLettersOfVerdict = 95, kLettersOfColumn = 48;
constexpr int kTitle = 55, kLoopHeadings = 40, kSignature = 105;
constexpr int kTable = 36, kNotes = 38, kHeading = 20;

constexpr std::size_t kFactsOfRow = 5, kMostFacts = 10;
constexpr std::size_t kMostExperiments = 10, kFewestExperiments = 4;
constexpr std::size_t kLoopsOfRow = 2;
constexpr int kLoopRow = 150, kMostLoops = 460;

int lines_of(std::size_t letters, int letters_of_line) {
  return static_cast<int>(letters) / letters_of_line + 1;
}

int height_of_list(const std::vector<std::string>& sentences, int letters_of_line) {
  int lines = 0;
  for (const std::string& sentence : sentences) {
    lines += lines_of(sentence.size(), letters_of_line);
  }
  return kLine * lines;
}

int height_of_doubts(const Results& results) {
  int height = 0;
  for (const auto* sentences : {&results.questions, &results.skipped}) {
    if (!sentences->empty()) height += kHeading + height_of_list(*sentences, kLettersOfVerdict);
  }
  return height;
}

int height_of_material(const Results& results) {
  std::set<std::string> membranes, bends;
  for (const ResultFigure& figure : results.figures) {
    (is_bending(figure.component) ? bends : membranes).insert(figure.component);
  }
  int height = kHeading + kNotes;
  for (const auto* components : {&membranes, &bends}) {
    if (!components->empty()) height += kTable + kRow * static_cast<int>(components->size());
  }
  return height;
}

int height_of_columns(const Results& results) {
  std::vector<std::string> undetermined = results.judgement.undetermined;
  undetermined.resize(std::min(undetermined.size(), std::size_t{5}));
  return kHeading +
         std::max(height_of_list(warnings_of(results, /*on_page_one=*/true), kLettersOfColumn),
                  height_of_list(undetermined, kLettersOfColumn)) +
         kLine;
}

int rows_of_facts(std::size_t facts) {
  return static_cast<int>((facts + kFactsOfRow - 1) / kFactsOfRow);
}

}  // namespace

std::vector<std::string> warnings_of(const Results& results, bool on_page_one) {
  constexpr std::size_t kOnPageOne = 4;
  const std::vector<std::string>& all = results.warnings;
  const std::size_t first = std::min(results.questions.size(), all.size());
  const std::size_t last = std::min(first + kOnPageOne, all.size());
  const auto at = [&](std::size_t i) { return all.begin() + static_cast<std::ptrdiff_t>(i); };
  return on_page_one ? std::vector(at(first), at(last)) : std::vector(at(last), all.end());
}

PageBudget page_budget(const Results& results, std::size_t verdict_length, std::size_t facts,
                       const std::vector<std::size_t>& other_tables) {
  const std::size_t all_loops = experiments_on_page_one(results).size();
  const std::size_t all_experiments = other_tables.empty() ? results.experiments.size() : 0;
  int tables = other_tables.empty() ? kHeading + kTable + kNotes : 0;
  for (const std::size_t rows : other_tables) {
    tables += kHeading + kTable + kNotes + kRow * static_cast<int>(rows);
  }
  const int fixed = kTitle + kLine * lines_of(verdict_length, kLettersOfVerdict) + kLoopHeadings +
                    height_of_doubts(results) + height_of_material(results) + tables +
                    height_of_columns(results) + kSignature;
  PageBudget budget;
  for (const std::size_t loops : {all_loops, std::min(all_loops, kLoopsOfRow)}) {
    budget = {std::min(all_experiments, kMostExperiments), std::min(facts, kMostFacts), loops, 0};
    const int least = loops > kLoopsOfRow + 1 ? 2 * kLoopRow : kLoopRow;
    const auto left = [&] {
      return kPage - fixed - kFactRow * rows_of_facts(budget.facts) -
             kRow * static_cast<int>(budget.experiments);
    };
    while (left() < least && budget.experiments > kFewestExperiments) --budget.experiments;
    if (left() < least) budget.facts = std::min(facts, kFactsOfRow);
    budget.height_of_loops = std::clamp(left(), least, kMostLoops);
    if (left() >= least) break;
  }
  return budget;
}

}  // namespace pliant::report
