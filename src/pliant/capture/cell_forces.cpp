#include "pliant/capture/cell_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/capture/log_doubts.h"

namespace pliant {
namespace {

std::string name_of(const DicCell& cell) {
  return fmt::format("the cell of the cord {} of the clip {}", cell.cord, cell.clip);
}

}  // namespace

CellForces::CellForces(const DicFile& dic)
    : LoggedForces(dic), rows_(read_cell_rows(forces())), lines_(moments().size()) {
  place_by_stated_start();
}

void CellForces::place(double start) {
  CellRows rows = rows_;
  for (std::vector<double>& pull : rows.pull) pull = without_limit(std::move(pull));
  cells_ = cells_at_frames(rows, forces(), moments(), start);
  log_.time = cells_.time;
  log_.stands = cells_.stands;
}

void CellForces::see_cords(int frame, std::vector<std::optional<CordLine>> lines) {
  lines_[static_cast<std::size_t>(frame)] = std::move(lines);
}

std::optional<double> CellForces::noise() const {
  double squares = 0;
  int count = 0;
  for (std::size_t f = 0; f < lines_.size(); ++f) {
    for (std::size_t i = 0; i < lines_[f].size(); ++i) {
      const double pull = cells_.pull[i][f];
      if (!lines_[f][i] || std::isnan(pull)) continue;
      const double aside = pull * lines_[f][i]->error;
      squares += (cells_.error * cells_.error + 2 * aside * aside) / 3;
      ++count;
    }
  }
  if (count == 0 || cells_.error == 0) return std::nullopt;
  const auto cords = static_cast<double>(cells_.pull.size());
  return std::sqrt(squares / count * cords / static_cast<double>(dic().clips.size()));
}

// Light cloth is pulled by less than the usual bound, which would pass cells that are exchanged.
double CellForces::balance_bound() const {
  constexpr double kShare = 0.05, kNoises = 5;  // of the largest pull; of the noise
  double largest = 0;
  for (std::size_t i = 0; i < cells_.pull.size(); ++i) largest = std::max(largest, largest_pull(i));
  const double bound = std::max(kShare * largest, kNoises * noise().value_or(0));
  return bound > 0 ? std::min(bound, kCordFriction) : kCordFriction;
}

bool CellForces::is_free(int frame) const {
  return std::ranges::none_of(lines_[static_cast<std::size_t>(frame)],
                              [](const auto& line) { return line.has_value(); });
}

std::vector<double> CellForces::ways_of_cords() const {
  const auto all_seen = [](const auto& lines) {
    return !lines.empty() &&
           std::ranges::all_of(lines, [](const auto& line) { return line.has_value(); });
  };
  const auto first = std::ranges::find_if(lines_, all_seen);
  std::vector<double> ways;
  for (const auto& lines : lines_) {
    ways.push_back(all_seen(lines) ? 0 : std::numeric_limits<double>::quiet_NaN());
    if (std::isnan(ways.back())) continue;
    for (std::size_t i = 0; i < lines.size(); ++i) {
      ways.back() += lines[i]->direction.dot(lines[i]->from - (*first)[i]->from);
    }
  }
  return ways;
}

LoggedForces::Together CellForces::together(const std::vector<double>& /*ways*/) const {
  return {{rows_.time, rows_.total(), /*goes_straight=*/false, forces().still.value_or(0)},
          ways_of_cords(),
          "the ways of the cords"};
}

double CellForces::largest_pull(std::size_t cell) const {
  double most = 0;
  for (const double pull : cells_.pull[cell]) {
    if (!std::isnan(pull)) most = std::max(most, std::abs(pull));
  }
  return most;
}

bool CellForces::pulls(std::size_t cell, std::size_t frame) const {
  constexpr double kHardly = 0.05;  // of the largest pull
  return std::abs(cells_.pull[cell][frame]) > kHardly * largest_pull(cell);
}

std::vector<std::string> CellForces::warnings(const std::vector<double>& /*ways*/) const {
  std::vector<std::string> warnings;
  for (std::size_t i = 0; i < forces().cells.size(); ++i) {
    const DicCell& cell = forces().cells[i];
    const std::string name = name_of(cell);
    const std::string limit = limit_doubt(rows_.pull[i]);
    if (!limit.empty()) warnings.push_back(name + " " + limit);
    for (std::size_t f = 0; f < lines_.size() && !lines_[f].empty() && !lines_[f][i]; ++f) {
      if (!pulls(i, f)) continue;
      warnings.push_back(
          fmt::format("{} reads {} in frame {}, before its cord was pointed at: is its tare right?",
                      name, format_quantity(cells_.pull[i][f], Dimension::force, 3), f));
      break;
    }
  }
  return warnings;
}

std::string CellForces::add_forces(SessionFrame& frame, std::size_t number,
                                   const std::vector<HeldPlace>& /*held*/) const {
  const std::vector<std::optional<CordLine>>& lines = lines_[number];
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const DicCell& cell = forces().cells[i];
    const double pull = cells_.pull[i][number];
    if (std::isnan(pull) && !is_beyond(number, rows_.time)) {
      return fmt::format("has {} at its limit, or not connected", name_of(cell));
    }
    if (!lines[i]) {
      if (!pulls(i, number)) continue;
      return fmt::format("is pulled by the cord {} of the clip {}, which is pointed at later",
                         cell.cord, cell.clip);
    }
    if (std::isnan(pull)) return kBeyondLog;
    frame.cords[dic().clip_number(cell.clip)].push_back(
        {cell.cord, lines[i]->from, pull * lines[i]->direction});
  }
  return {};
}

}  // namespace pliant
