#include "pliant/capture/tester_forces.h"

#include <cmath>
#include <utility>

#include "pliant/base/errors.h"
#include "pliant/capture/log_doubts.h"

namespace pliant {

TesterForces::TesterForces(const DicFile& dic) : LoggedForces(dic), rows_(read_log_rows(forces())) {
  place_by_stated_start();
}

LoggedForces::Together TesterForces::together(const std::vector<double>& ways) const {
  if (rows_.extension.empty()) {
    throw InputError(forces().data.where, "has no column of the extension to find its clock by",
                     kStatedStart);
  }
  return {{rows_.time, rows_.extension, /*goes_straight=*/true, forces().still.value_or(0)},
          ways,
          "the clip " + forces().clip};
}

std::vector<std::string> TesterForces::warnings(const std::vector<double>& ways) const {
  std::vector<std::string> warnings;
  const std::string limit = limit_doubt(rows_.force);
  if (!limit.empty()) warnings.push_back("the log of the forces " + limit);
  const std::string extension = extension_doubt(log_.extension, ways);
  if (!extension.empty()) warnings.push_back(extension);
  return warnings;
}

void TesterForces::place(double start) {
  FrameLog rows = rows_;
  rows.force = without_limit(std::move(rows.force));
  log_ = log_of_frames(std::move(rows), forces(), moments(), start);
}

std::string TesterForces::add_forces(SessionFrame& frame, std::size_t number,
                                     const std::vector<HeldPlace>& held) const {
  const double force = log_.force[number];
  if (std::isnan(force)) {
    return is_beyond(number, rows_.time) ? kBeyondLog
                                         : "has the tester's cell at its limit, or not connected";
  }
  const auto add = [&](std::size_t c, const Eigen::Vector3d& by) {
    const Eigen::Vector3d middle = frame.positions(Eigen::all, held[c].edge).rowwise().mean();
    frame.cords[c].push_back({"", middle, by});
  };
  const std::size_t pulled = dic().clip_number(forces().clip);
  add(pulled, force * held[pulled].outward);
  // What answers it is at the only other clip.
  if (held.size() == 2) add(1 - pulled, -force * held[pulled].outward);
  return {};
}

}  // namespace pliant
