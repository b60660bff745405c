#include "pliant/estimation/start_search.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace pliant {
namespace {

constexpr double kReachedShare = 1e-3;
constexpr double kPlateau = 1.1;  // of the least cost: what is changed may not matter yet

}  // namespace

std::string lone_start(const StartRecord& record) {
  if (!record.followed || record.ends.size() < 2 || record.reached_best != 1) return {};
  return fmt::format(
      "{}: of {} starts one alone led to the fit: there may be a better one that none found",
      record.component, record.ends.size());
}

bool StartSearch::found() const { return !costs.empty() && std::isfinite(costs[best]); }

StartSearch search_from(std::size_t starts, const FollowStart& follow,
                        const StartOptions& options) {
  StartSearch search;
  double least = std::numeric_limits<double>::infinity();
  int worse = 0;  // in a row
  for (std::size_t start = 0;
       start < starts && worse < options.patience && search.reached_best < options.enough;
       ++start) {
    const double cost = follow(start, least);
    search.costs.push_back(cost);
    worse = std::isinf(least) || cost < kPlateau * least ? 0 : worse + 1;
    if (cost < least) {
      least = cost;
      search.best = start;
    }
    if (!search.found()) continue;
    search.reached_best = static_cast<int>(std::ranges::count_if(search.costs, [&](double own) {
      return own <= least * (1 + kReachedShare) + options.exact;
    }));
  }
  return search;
}

}  // namespace pliant
