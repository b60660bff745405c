#include "pliant/estimation/sheet/sheet_problem.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "pliant/base/assert.h"
#include "pliant/base/parallel.h"
#include "pliant/base/stopwatch.h"
#include "pliant/estimation/monotone_stress.h"
#include "pliant/estimation/sheet/lost_frames.h"
#include "pliant/estimation/sheet/sheet_options.h"
#include "pliant/experiment/session/make_predictor.h"

namespace pliant {
namespace {

/// Root mean square of what a test measures: forces, or how far nodes have moved from rest.
double measured_size(const SheetTest& test) {
  double sum = 0;
  for (int frame = 0; frame < test.frame_count(); ++frame) {
    SheetShape rest;
    rest.positions = test.session().rest.positions;
    rest.clip_forces =
        Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(test.session().clips.size()));
    sum += (test.measured(frame) - test.predicted(frame, rest)).squaredNorm();
  }
  return std::max(std::sqrt(sum / test.rows()), 1e-12);
}

/// Tests of one kind weigh alike: a newton is a newton.
std::vector<double> first_scales(const std::vector<const SheetTest*>& tests) {
  std::vector<double> scales(tests.size(), 0);
  for (std::size_t i = 0; i < tests.size(); ++i) {
    for (const SheetTest* other : tests) {
      const bool alike = (other->objective() == SheetObjective::positions) ==
                         (tests[i]->objective() == SheetObjective::positions);
      if (alike) scales[i] = std::max(scales[i], measured_size(*other));
    }
  }
  return scales;
}

}  // namespace

SheetProblem::SheetProblem(std::vector<const SheetTest*> tests, const Material& material,
                           std::vector<ComponentGroup> groups, std::vector<double> strains,
                           const RunContext& context, const CordFrictions& cords,
                           const FitOptions& options, bool with_cords)
    : tests_(std::move(tests)),
      material_(material),
      groups_(std::move(groups)),
      unknowns_(unknowns_of(material, groups_, strains, shortest_edge(*tests_.front()))),
      scales_(first_scales(tests_)),
      start_(values_of(material, groups_)),
      monotone_stress_(options.monotone_stress),
      context_(context) {
  PLIANT_ASSERT(!tests_.empty(), "a fit has data");
  for (const SheetTest* test : tests_) {
    predictors_.push_back(make_predictor(test->session(), material));
    places_.push_back(places_in(*predictors_.back()));
  }
  for (const SheetTest* test : tests_) {
    const std::vector<SheetUnknown> own =
        with_cords ? cord_unknowns(*test) : std::vector<SheetUnknown>();
    std::vector<int>& places = cords_.emplace_back(own.size());
    std::iota(places.begin(), places.end(), static_cast<int>(unknowns_.size()));
    unknowns_.insert(unknowns_.end(), own.begin(), own.end());
    if (own.empty()) continue;
    start_.conservativeResize(static_cast<Eigen::Index>(unknowns_.size()));
    start_(places) = cord_widths(*test, cords);
  }
  apply_options(options, unknowns_);
  priors_ = priors_of(unknowns_);
  for (std::size_t u = 0; u < unknowns_.size(); ++u) {
    double& value = start_(static_cast<Eigen::Index>(u));
    value = std::clamp(value, unknowns_[u].lower, unknowns_[u].upper);
  }
}

SheetProblem::Places SheetProblem::places_in(const SheetPredictor& predictor) const {
  const std::vector<std::string>& names = predictor.parameter_names();
  Places places;
  for (std::size_t u = 0; u < unknowns_.size(); ++u) {
    for (const std::string& parameter : unknowns_[u].parameters) {
      const auto found = std::ranges::find(names, parameter);
      if (found == names.end()) continue;  // friction, where frames are equilibria of their own
      places.parameters.push_back(static_cast<int>(found - names.begin()));
      places.unknowns.push_back(static_cast<int>(u));
    }
  }
  return places;
}

void SheetProblem::begin_at(const SheetGuesses& guesses) {
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    const auto found = guesses.find(tests_[t]->name());
    if (found != guesses.end()) predictors_[t]->begin_at(found->second);
  }
}

void SheetProblem::keep(SheetGuesses& guesses) const {
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    std::vector<Eigen::Matrix3Xd> own = predictors_[t]->guesses();
    if (!own.empty()) guesses[tests_[t]->name()] = std::move(own);
  }
}

Eigen::VectorXd SheetProblem::widths(std::size_t test, const Eigen::VectorXd& values) const {
  if (cords_[test].empty()) return cord_widths(*tests_[test], {});
  return values(cords_[test]);
}

void SheetProblem::keep_cords(const Eigen::VectorXd& values, CordFrictions& cords) const {
  for (const std::vector<int>& places : cords_) {
    for (const int place : places) {
      cords[unknowns_[static_cast<std::size_t>(place)].name] = values(place);
    }
  }
}

int SheetProblem::measured_rows() const {
  int rows = 0;
  for (const SheetTest* test : tests_) rows += test->rows();
  return rows;
}

double SheetProblem::rms(const LeastSquaresSummary& solution) const {
  double squares = 2 * solution.cost;
  for (const SheetPrior& prior : priors_) {
    squares -= std::pow(prior_weight() * prior.miss(solution.parameters), 2);
  }
  double weights = 0;
  for (const SheetTest* test : tests_) {
    for (int frame = 0; frame < test->frame_count(); ++frame) {
      weights += test->weights(frame).sum();
    }
  }
  return scales_.front() * std::sqrt(std::max(squares, 0.0) / weights);
}

Material SheetProblem::material_at(const Eigen::VectorXd& values) const {
  Material material = material_;
  set_values(material, groups_, values);
  return material;
}

std::optional<std::vector<SheetShape>> SheetProblem::predict(std::size_t test,
                                                             const Eigen::VectorXd& values,
                                                             bool derivatives, int threads) const {
  const Stopwatch watch;
  auto shapes = shapes_of(test, values, derivatives, threads);
  seconds_ += watch.seconds();
  return shapes;
}

Eigen::VectorXd SheetProblem::parameters_of(std::size_t test, const Eigen::VectorXd& values) const {
  const Places& places = places_[test];
  Eigen::VectorXd parameters = predictors_[test]->parameters();
  parameters(places.parameters) = values(places.unknowns);
  return parameters;
}

std::vector<int> SheetProblem::lost_frames(std::size_t test, int threads) const {
  const Stopwatch watch;
  const auto shapes =
      predictors_[test]->predict_each(parameters_of(test, start_), {}, threads, context_.stop);
  seconds_ += watch.seconds();
  return pliant::lost_frames(shapes);
}

std::optional<std::vector<SheetShape>> SheetProblem::shapes_of(std::size_t test,
                                                               const Eigen::VectorXd& values,
                                                               bool derivatives,
                                                               int threads) const {
  auto shapes = predictors_[test]->predict(
      parameters_of(test, values), derivatives ? places_[test].parameters : std::vector<int>{},
      threads, context_.stop);
  if (!shapes) return shapes;
  const Eigen::VectorXd loops = widths(test, values);
  const bool by_cords = derivatives && !cords_[test].empty();
  for (int frame = 0; frame < tests_[test]->frame_count(); ++frame) {
    add_cord_drags(tests_[test]->cords(), loops, by_cords, frame,
                   (*shapes)[static_cast<std::size_t>(frame)]);
  }
  return shapes;
}

bool SheetProblem::evaluate(const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                            Eigen::MatrixXd* jacobian) const {
  const int count = static_cast<int>(tests_.size());
  std::vector<std::optional<std::vector<SheetShape>>> shapes(tests_.size());
  const Stopwatch watch;
  parallel_for(count, context_.threads, [&](int t) {
    const auto test = static_cast<std::size_t>(t);
    shapes[test] =
        shapes_of(test, values, jacobian != nullptr, std::max(context_.threads / count, 1));
  });
  seconds_ += watch.seconds();
  Eigen::Index row = 0;
  if (jacobian) jacobian->setZero(residual.size(), values.size());
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    if (!shapes[t]) return false;
    const SheetTest& test = *tests_[t];
    for (int frame = 0; frame < test.frame_count(); ++frame) {
      const SheetShape& shape = (*shapes[t])[static_cast<std::size_t>(frame)];
      const int rows = test.rows(frame);
      const Eigen::VectorXd weights = test.weights(frame) / scales_[t];
      residual.segment(row, rows) =
          weights.cwiseProduct(test.predicted(frame, shape) - test.measured(frame));
      if (jacobian) {
        const Eigen::MatrixXd by_parameter = weights.asDiagonal() * test.jacobian(frame, shape);
        Eigen::Index column = 0;
        for (const std::vector<int>* unknowns : {&places_[t].unknowns, &cords_[t]}) {
          for (const int unknown : *unknowns) {
            jacobian->block(row, unknown, rows, 1) += by_parameter.col(column++);
          }
        }
      }
      row += rows;
    }
  }
  for (const SheetPrior& prior : priors_) {
    residual(row) = prior_weight() * prior.miss(values);
    if (jacobian) {
      for (const auto& [unknown, factor] : prior.sum) {
        (*jacobian)(row, unknown) = prior_weight() * factor / prior.sd;
      }
    }
    ++row;
  }
  return true;
}

Eigen::MatrixXd SheetProblem::tangents() const {
  Eigen::MatrixXd all(0, static_cast<Eigen::Index>(unknowns_.size()));
  Eigen::Index first = 0;
  for (const ComponentGroup& group : groups_) {
    const ComponentLaw law = law_of(material_, group);
    const Eigen::MatrixXd own = elastic_tangents(law.stiffness, 0);
    const Eigen::Index above = all.rows();
    all.conservativeResize(above + own.rows(), Eigen::NoChange);
    all.bottomRows(own.rows()).setZero();
    all.block(above, first, own.rows(), own.cols()) = own;
    first += law.parameter_count();
  }
  return all;
}

LeastSquaresProblem SheetProblem::least_squares() const {
  LeastSquaresProblem problem;
  problem.evaluate = [this](const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                            Eigen::MatrixXd* jacobian) {
    return evaluate(values, residual, jacobian);
  };
  problem.residuals = measured_rows() + static_cast<int>(priors_.size());
  if (monotone_stress_) problem.not_negative = tangents();
  const auto count = static_cast<Eigen::Index>(unknowns_.size());
  problem.lower.resize(count);
  problem.upper.resize(count);
  problem.scale.resize(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const SheetUnknown& unknown = unknowns_[static_cast<std::size_t>(i)];
    problem.lower(i) = unknown.lower;
    problem.upper(i) = unknown.upper;
    problem.scale(i) = unknown.scale;
  }
  return problem;
}

int SheetProblem::free_unknowns(std::size_t test) const {
  std::set<int> free;
  for (const int unknown : places_[test].unknowns) {
    const SheetUnknown& own = unknowns_[static_cast<std::size_t>(unknown)];
    if (own.lower < own.upper) free.insert(unknown);
  }
  return static_cast<int>(free.size());
}

EquilibriumWork SheetProblem::work() const {
  EquilibriumWork sum;
  for (std::size_t t = 0; t < predictors_.size(); ++t) {
    EquilibriumWork own = predictors_[t]->work();
    own.counts.differences = own.counts.differentiated * free_unknowns(t);
    sum += own;
  }
  sum.seconds = sum.seconds.on_the_clock(seconds_);
  return sum;
}

}  // namespace pliant
