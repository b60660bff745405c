#pragma once

#include <cstddef>
#include <cstdint>

#include "pliant/base/stopwatch.h"

namespace pliant {

/// What a search takes: seconds by what they go to, each second in one phase, and tests.
struct SearchCosts {
  double assembly = 0;   ///< forces and Hessians
  double equations = 0;  ///< their factors and solutions
  double energies = 0;   ///< where the search looks, without Hessians
  double pairs = 0;      ///< looking for what is near, whatever asks for it
  double ways = 0;       ///< how far points may go
  double history = 0;    ///< what is remembered of the step, and its work
  /// Ways that were tested for what is met on them: of pairs of surfaces, and of points beside a
  /// convex body.
  std::int64_t way_tests = 0;

  SearchCosts& operator+=(const SearchCosts& other) {
    assembly += other.assembly;
    equations += other.equations;
    energies += other.energies;
    pairs += other.pairs;
    ways += other.ways;
    history += other.history;
    way_tests += other.way_tests;
    return *this;
  }
};

inline void count_way_tests(std::size_t tests, SearchCosts* costs) {
  if (costs) costs->way_tests += static_cast<std::int64_t>(tests);
}

/// Adds the time that it lives to a phase, but for what goes to pairs meanwhile.
class Timed {
 public:
  /// @param costs  null: nobody wants to know
  Timed(SearchCosts* costs, double SearchCosts::*phase)
      : costs_(costs), phase_(phase), pairs_before_(costs ? costs->pairs : 0) {}
  ~Timed() {
    if (costs_) costs_->*phase_ += watch_.seconds() - (costs_->pairs - pairs_before_);
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  SearchCosts* costs_;
  double SearchCosts::*phase_;
  double pairs_before_;
  Stopwatch watch_;
};

}  // namespace pliant
