#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "pliant/study/results.h"

namespace pliant::report {

/// How the printed page one is shared out, so that it stays one page of A4.
struct PageBudget {
  std::size_t experiments = 0;  ///< rows of the table of agreement
  std::size_t facts = 0;        ///< of the fabric and its test
  std::size_t loops = 0;        ///< figures of loops
  int height_of_loops = 0;      ///< of all of them together (px)
};

/// The most facts and experiments that leave the loops enough height, which take the rest.
/// @param verdict_length  characters of the verdict, headline included
/// @param facts           that there are
/// @param other_tables    rows of each table that stands there in place of that of agreement
PageBudget page_budget(const Results& results, std::size_t verdict_length, std::size_t facts,
                       const std::vector<std::size_t>& other_tables = {});

/// The warnings beside the questions: the first of them, which stand on page one, or the others,
/// so that each comes once.
std::vector<std::string> warnings_of(const Results& results, bool on_page_one);

}  // namespace pliant::report
