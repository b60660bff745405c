#pragma once

namespace pliant {

/// What equilibria have cost.
struct EquilibriumCounts {
  int equilibria = 0;      ///< found
  int iterations = 0;      ///< of Newton's method
  int factors = 0;         ///< of Hessians, derivatives included
  int unstable = 0;        ///< differentiated with a convex stand-in of their Hessian
  int differentiated = 0;  ///< equilibria whose derivatives were taken
  int differences = 0;  ///< equilibria that forward differences would have needed beside, one for
                        ///< each unknown where derivatives were taken

  EquilibriumCounts& operator+=(const EquilibriumCounts& other) {
    equilibria += other.equilibria;
    iterations += other.iterations;
    factors += other.factors;
    unstable += other.unstable;
    differentiated += other.differentiated;
    differences += other.differences;
    return *this;
  }
};

/// Where the time of predictions goes (s).
struct EquilibriumSeconds {
  double search = 0;       ///< for equilibria
  double derivatives = 0;  ///< of equilibria that were found

  /// Threads that work at once share out the seconds that pass on the clock.
  EquilibriumSeconds on_the_clock(double passed) const {
    const double all = search + derivatives;
    if (all <= 0) return {passed, 0};
    return {passed * search / all, passed * derivatives / all};
  }

  EquilibriumSeconds& operator+=(const EquilibriumSeconds& other) {
    search += other.search;
    derivatives += other.derivatives;
    return *this;
  }
};

/// What predictions have cost.
struct EquilibriumWork {
  EquilibriumCounts counts;
  EquilibriumSeconds seconds;

  EquilibriumWork& operator+=(const EquilibriumWork& other) {
    counts += other.counts;
    seconds += other.seconds;
    return *this;
  }
};

}  // namespace pliant
