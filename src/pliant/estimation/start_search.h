#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace pliant {

/// Where the starts of one search have led.
struct StartRecord {
  std::string component;     ///< whose numbers were looked for, or `all`
  std::string search;        ///< what was looked for: stiffness, friction, ...
  std::string unit;          ///< of the ends
  std::vector<double> ends;  ///< root mean square of the differences where each start has led;
                             ///< infinite where it has no prediction
  int reached_best = 0;      ///< that led to within 0.1 % of the least cost
  /// Whether each start was followed, though one without hope not to its end. Else they were
  /// compared where they begin, and only the best was followed.
  bool followed = true;
};

/// What to say of a record whose best end no other start has led to; nothing where others have, or
/// where there was one start or one that was followed.
std::string lone_start(const StartRecord& record);

struct StartOptions {
  /// Costs that differ by less are alike.
  double exact = 0;
  /// Of starts in an order: so many in a row that lead to clearly more than the least cost leave
  /// out the rest.
  int patience = std::numeric_limits<int>::max();
  /// So many that lead to the least cost leave out the rest.
  int enough = std::numeric_limits<int>::max();
};

/// Follows a start, counted from 0.
/// @param least  cost that others have led to so far
/// @return the cost where it has led; infinite where it has no prediction
using FollowStart = std::function<double(std::size_t start, double least)>;

/// What came of several starts.
struct StartSearch {
  std::vector<double> costs;  ///< where each has led, in their order
  std::size_t best = 0;       ///< the first with the least of them
  int reached_best = 0;       ///< that led to within 0.1 % of it

  /// Whether any start has a prediction.
  bool found() const;
};

/// Follows start after start; fits of strips and of sheets search this way. What a start is the
/// caller knows, and how far following it is worth the time.
StartSearch search_from(std::size_t starts, const FollowStart& follow,
                        const StartOptions& options = {});

}  // namespace pliant
