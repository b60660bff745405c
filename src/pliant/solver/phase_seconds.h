#pragma once

#include "pliant/base/stopwatch.h"

namespace pliant {

/// What the time of a search goes to (s).
struct PhaseSeconds {
  double assembly = 0;   ///< forces and Hessians
  double equations = 0;  ///< their factors and solutions
  double energies = 0;   ///< where the search looks, without Hessians
  double ways = 0;       ///< what is near, and how far points may go
  double history = 0;    ///< what is remembered of the step, and its work

  PhaseSeconds& operator+=(const PhaseSeconds& other) {
    assembly += other.assembly;
    equations += other.equations;
    energies += other.energies;
    ways += other.ways;
    history += other.history;
    return *this;
  }
};

/// Adds the time that it lives to a phase.
class Timed {
 public:
  /// @param seconds  null: nobody wants to know
  Timed(PhaseSeconds* seconds, double PhaseSeconds::*phase) : seconds_(seconds), phase_(phase) {}
  ~Timed() {
    if (seconds_) seconds_->*phase_ += watch_.seconds();
  }
  Timed(const Timed&) = delete;
  Timed& operator=(const Timed&) = delete;

 private:
  PhaseSeconds* seconds_;
  double PhaseSeconds::*phase_;
  Stopwatch watch_;
};

}  // namespace pliant
