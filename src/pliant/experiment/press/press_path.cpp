#include "pliant/experiment/press/press_path.h"

#include <cmath>
#include <cstdint>

#include <boost/math/tools/toms748_solve.hpp>

#include "pliant/base/assert.h"
#include "pliant/solver/equilibrium_derivatives.h"
#include "pliant/solver/within_limits.h"

namespace pliant {
namespace {

constexpr double kStep = 0.25;      // of an edge
constexpr double kFarthest = 0.95;  // of the body's extent
constexpr int kFewIterations = 20, kManyIterations = 200;
constexpr int kHalvings = 6;    // of a step that leads nowhere
constexpr double kNear = 1e-6;  // of an area and of an edge: the rest is linear

double dot(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) { return a.cwiseProduct(b).sum(); }

// Of one field with each of several.
Eigen::RowVectorXd dot_each(const Eigen::Matrix3Xd& a, const Eigen::MatrixXd& each) {
  return Eigen::Map<const Eigen::RowVectorXd>(a.data(), a.size()) * each;
}

}  // namespace

PressPath::PressPath(const PressedBody& body, BodyPathOptions options)
    : PressPath(body, std::move(options), Workspace(body.system())) {}

PressPath::PressPath(const PressedBody& body, BodyPathOptions options, Workspace workspace)
    : body_(body),
      options_(std::move(options)),
      workspace_(std::move(workspace)),
      travel_(body.clear_travel()) {
  const Controls controls = body.controls(travel_);
  State rest = body.system().initial_state(options_.parameters);
  state_ = rest;
  // What the contact remembers is where the indenter stands clear of the body.
  body.system().advance_history(rest.configuration, {rest, options_.parameters, controls},
                                state_.history);
  history_by_ = Eigen::MatrixXd::Zero(state_.history.size(), std::ssize(options_.by));
}

PressPath::PressPath(const PressedBody& body, BodyPathOptions options, Workspace workspace,
                     PressStand from)
    : body_(body),
      options_(std::move(options)),
      workspace_(std::move(workspace)),
      state_(std::move(from.state)),
      travel_(from.point.travel),
      point_(std::move(from.point)) {
  PLIANT_ASSERT(!body.remembers(), "a law that remembers comes from rest");
  history_by_ = Eigen::MatrixXd::Zero(state_.history.size(), std::ssize(options_.by));
}

std::optional<PressPath::Trial> PressPath::trial(double travel) {
  return trial_near(state_.configuration, travel, kManyIterations);
}

// What is in the indenter's way since the last step is moved on with it.
std::optional<PressPath::Trial> PressPath::trial_near(Configuration guess, double travel,
                                                      int max_iterations) {
  const Controls controls = body_.controls(travel);
  const auto moved =
      body_.system().made_way(guess.positions, {state_, options_.parameters, controls});
  if (!moved) return std::nullopt;
  guess.positions += *moved;
  return trial_from(std::move(guess), travel, max_iterations);
}

// Begins where the area before was found to be passed: there but for what friction remembers since.
std::optional<PressPath::Trial> PressPath::trial_of_stop(double travel) {
  if (ahead_.travel == travel && ahead_.at.positions.size() > 0) {
    if (auto found = trial_from(ahead_.at, travel, kManyIterations)) return found;
  }
  return trial(travel);
}

std::optional<PressPath::Trial> PressPath::trial_from(Configuration guess, double travel,
                                                      int max_iterations) {
  const Controls controls = body_.controls(travel);
  const NewtonOptions newton{
      .tolerance = body_.tolerance(), .max_iterations = max_iterations, .stop = options_.stop};
  const NewtonSummary found = minimize_within_limits(
      body_.system(), {state_, options_.parameters, controls}, newton, workspace_, guess);
  counts_.iterations += found.iterations;
  counts_.factors += found.factorizations;
  if (!found.converged) return std::nullopt;
  ++counts_.equilibria;
  const double area = body_.area(guess.positions, travel).value;
  return Trial{travel, std::move(guess), area};
}

std::optional<PressPath::Trial> PressPath::trial_between(const Trial& low, const Trial& high,
                                                         double travel) {
  const double share = (travel - low.travel) / (high.travel - low.travel);
  Configuration guess = low.at;
  guess.positions += share * (high.at.positions - low.at.positions);
  auto found = trial_from(std::move(guess), travel, kManyIterations);
  return found ? found : trial(travel);
}

// A stop at the next multiple of the step beyond where the path stands.
double PressPath::next_stop(int way) const {
  const double step = kStep * body_.edge();
  const double steps = travel_ / step;
  constexpr double kRounding = 1e-9;
  return step * (way > 0 ? std::floor(steps + kRounding) + 1 : std::ceil(steps - kRounding) - 1);
}

std::optional<PressPoint> PressPath::step(double travel, int halvings) {
  if (const auto found = trial(travel)) return accept(*found);
  if (halvings == kHalvings) return std::nullopt;
  if (!step((travel_ + travel) / 2, halvings + 1)) return std::nullopt;
  return step(travel, halvings + 1);
}

// To where the last step begins that ends at `travel`.
bool PressPath::walk(double travel) {
  const int way = travel > travel_ ? 1 : -1;
  for (double stop = next_stop(way); way * (travel - stop) > 0; stop = next_stop(way)) {
    if (!step(stop, 0)) return false;
  }
  return true;
}

std::optional<PressPoint> PressPath::go_to_travel(double travel) {
  return walk(travel) ? step(travel, 0) : std::nullopt;
}

std::optional<PressPoint> PressPath::go_to_area(double area) {
  if (auto found = go_by_secants(area)) return found;
  const double farthest = kFarthest * body_.extent();
  Trial here{travel_, state_.configuration, body_.area(positions(), travel_).value};
  const int way = area > here.area ? 1 : -1;
  while (travel_ < farthest) {
    double stop = std::max(next_stop(way), body_.clear_travel());
    auto next = trial_of_stop(stop);
    for (int halvings = 0; !next && halvings < kHalvings; ++halvings) {
      stop = (travel_ + stop) / 2;
      next = trial(stop);
    }
    if (!next) return std::nullopt;
    if (way * (next->area - area) >= 0) {
      ahead_ = *next;
      const auto found = way > 0 ? trial_of_area(area, std::move(here), std::move(*next))
                                 : trial_of_area(area, std::move(*next), std::move(here));
      return found ? accept(*found, area) : std::nullopt;
    }
    if (stop == body_.clear_travel()) return std::nullopt;
    if (!accept(*next)) return std::nullopt;
    here = std::move(*next);
  }
  return std::nullopt;
}

// Near enough for the rest to be linear.
std::optional<PressPath::Trial> PressPath::trial_of_area(double area, Trial low, Trial high) {
  if (low.area == area) return low;
  if (high.area == area) return high;
  std::uintmax_t most = 40;
  bool all_found = true;
  const auto beyond = [&](double travel) {
    auto found = all_found ? trial_between(low, high, travel) : std::nullopt;
    all_found = found.has_value();
    if (!found) return 0.0;  // ends the search
    const double excess = found->area - area;
    (excess < 0 ? low : high) = std::move(*found);
    return std::abs(excess) < kNear * area ? 0 : excess;
  };
  const auto near = [&](double a, double b) { return b - a < kNear * body_.edge(); };
  boost::math::tools::toms748_solve(beyond, low.travel, high.travel, low.area - area,
                                    high.area - area, near, most);
  if (!all_found) return std::nullopt;
  return area - low.area < high.area - area ? low : high;
}

std::optional<PressPoint> PressPath::settle_at_travel(const Eigen::VectorXd& change) {
  Configuration guess = state_.configuration;
  if (change.size() > 0) guess.positions.reshaped() += point_.motion.positions_by * change;
  const auto found = trial_near(std::move(guess), travel_, kFewIterations);
  return found ? accept(*found) : std::nullopt;
}

std::optional<PressPoint> PressPath::settle_at_area(const Eigen::VectorXd& change) {
  Configuration guess = state_.configuration;
  double travel = travel_;
  if (change.size() > 0) {
    guess.positions.reshaped() += point_.motion.positions_by * change;
    travel += point_.motion.travel_by * change;
  }
  const double area = point_.area;
  const auto found = trial_by_secants(area, std::move(guess), travel);
  return found ? accept(*found, area) : std::nullopt;
}

// From an area that was set before, where nothing hangs on the way.
std::optional<PressPoint> PressPath::go_by_secants(double area) {
  const PressMotion& motion = point_.motion;
  if (body_.remembers() || motion.area_by_travel == 0) return std::nullopt;
  const double way = (area - point_.area) / motion.area_by_travel;
  if (!(std::abs(way) < kStep * body_.edge())) return std::nullopt;
  Configuration guess = state_.configuration;
  guess.positions += way * motion.positions_by_travel;
  const auto found = trial_by_secants(area, std::move(guess), travel_ + way);
  return found ? accept(*found, area) : std::nullopt;
}

// The first by the derivative where the path stands.
std::optional<PressPath::Trial> PressPath::trial_by_secants(double area, Configuration guess,
                                                            double travel) {
  constexpr int kMost = 8;
  Eigen::Matrix3Xd by_travel = point_.motion.positions_by_travel;
  double area_by_travel = point_.motion.area_by_travel;
  auto here = trial_near(std::move(guess), travel, kFewIterations);
  for (int secants = 0; here; ++secants) {
    const double lacks = area - here->area, way = lacks / area_by_travel;
    if (std::abs(lacks) < kNear * area) return here;
    if (secants == kMost || !(std::abs(way) < kStep * body_.edge())) return std::nullopt;
    guess = here->at;
    guess.positions += way * by_travel;
    auto next = trial_near(std::move(guess), here->travel + way, kFewIterations);
    if (!next) return std::nullopt;
    by_travel = (next->at.positions - here->at.positions) / way;
    area_by_travel = (next->area - here->area) / way;
    here = std::move(next);
  }
  return std::nullopt;
}

// An equilibrium that nothing can be said of but where it is does not count as found.
std::optional<PressPoint> PressPath::accept(const Trial& trial, std::optional<double> area) {
  const Controls controls = body_.controls(trial.travel);
  const Evaluation of_contact{trial.at, body_.system().history_of(body_.contact(), state_), nullptr,
                              controls};
  PressPoint point{trial.travel, body_.force(of_contact), trial.area, {}, {}};
  const bool in_motion = !options_.by.empty() || area;
  if (in_motion && !differentiate(trial, area, point)) return std::nullopt;
  State next = state_;
  body_.system().advance_history(trial.at, {state_, options_.parameters, controls}, next.history);
  next.configuration = trial.at;
  std::swap(state_, next);
  travel_ = trial.travel;
  point_ = std::move(point);
  return point_;
}

bool PressPath::differentiate(const Trial& trial, const std::optional<double>& area,
                              PressPoint& point) {
  const System& system = body_.system();
  const Controls controls = body_.controls(trial.travel);
  const Conditions under{state_, options_.parameters, controls};
  const Objective objective(system, under);
  Eigen::Matrix3Xd gradient;
  ++counts_.factors;
  if (!factorize_at(objective, trial.at, gradient, workspace_)) return false;
  Eigen::MatrixXd positions_by =
      differentiate_equilibrium(objective, trial.at, options_.by, history_by_, *workspace_.solver,
                                /*with_forces=*/false)
          .positions;
  const Evaluation of_contact{trial.at, system.history_of(body_.contact(), state_), nullptr,
                              controls};
  // The contact's forces as the indenter moves on, which are also those by which its own force
  // changes with the points.
  const Eigen::Matrix3Xd by_travel = body_.change_by_travel(of_contact);
  point.force_by = dot_each(by_travel, positions_by);
  point.motion.travel_by = Eigen::RowVectorXd::Zero(positions_by.cols());
  const Coordinates& coordinates = system.coordinates();
  Eigen::Matrix3Xd& positions_by_travel = point.motion.positions_by_travel;
  positions_by_travel = coordinates.motion(
      trial.at, workspace_.solver->solve_all(-coordinates.reduce(trial.at, by_travel)).col(0));
  if (area) {
    const SmoothedArea touching = body_.area(trial.at.positions, trial.travel);
    const double force_by_travel =
        dot(by_travel, positions_by_travel) - body_.direction().dot(by_travel.rowwise().sum());
    const double area_by_travel =
        dot(touching.by_position, positions_by_travel) + touching.by_travel;
    const Eigen::RowVectorXd travel_by =
        -dot_each(touching.by_position, positions_by) / area_by_travel;
    point.force_by += force_by_travel * travel_by;
    point.force += force_by_travel * (*area - trial.area) / area_by_travel;
    point.area = *area;
    positions_by += positions_by_travel.reshaped() * travel_by;
    point.motion.travel_by = travel_by;
    point.motion.area_by_travel = area_by_travel;
  }
  system.advance_sensitivity(trial.at, under, options_.by, positions_by, history_by_);
  point.motion.positions_by = std::move(positions_by);
  return true;
}

}  // namespace pliant
