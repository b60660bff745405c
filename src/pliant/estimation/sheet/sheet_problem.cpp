#include "pliant/estimation/sheet/sheet_problem.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"

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
                           std::vector<ComponentGroup> groups, const RunContext& context)
    : tests_(std::move(tests)),
      material_(material),
      groups_(std::move(groups)),
      unknowns_(unknowns_of(material, groups_)),
      scales_(first_scales(tests_)),
      context_(context) {
  PLIANT_ASSERT(!tests_.empty(), "a fit has data");
  for (const SheetTest* test : tests_) {
    equilibria_.push_back(std::make_unique<SheetEquilibria>(test->session(), material));
  }
  const std::vector<std::string>& names = equilibria_.front()->parameter_names();
  for (std::size_t u = 0; u < unknowns_.size(); ++u) {
    for (const std::string& parameter : unknowns_[u].parameters) {
      const auto found = std::ranges::find(names, parameter);
      PLIANT_ASSERT(found != names.end(), "an unknown is a parameter of the sheet");
      parameters_.push_back(static_cast<int>(found - names.begin()));
      unknown_of_.push_back(static_cast<int>(u));
    }
  }
}

void SheetProblem::begin_at(const SheetGuesses& guesses) {
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    const auto found = guesses.find(tests_[t]);
    if (found != guesses.end()) equilibria_[t]->begin_at(found->second);
  }
}

void SheetProblem::keep(SheetGuesses& guesses) const {
  for (std::size_t t = 0; t < tests_.size(); ++t) guesses[tests_[t]] = equilibria_[t]->guesses();
}

Eigen::VectorXd SheetProblem::start() const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(unknowns_.size()));
  Eigen::Index next = 0;
  for (const ComponentGroup& group : groups_) {
    const Eigen::VectorXd own = control_values(material_, group);
    values.segment(next, own.size()) = own;
    next += own.size();
  }
  return values;
}

Material SheetProblem::material_at(const Eigen::VectorXd& values) const {
  Material material = material_;
  set_values(material, groups_, values);
  return material;
}

std::optional<std::vector<SheetShape>> SheetProblem::predict(std::size_t test,
                                                             const Eigen::VectorXd& values,
                                                             bool derivatives) const {
  SheetEquilibria& equilibria = *equilibria_[test];
  Eigen::VectorXd parameters = equilibria.parameters();
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    parameters(parameters_[k]) = values(unknown_of_[k]);
  }
  return equilibria.predict(parameters, derivatives ? parameters_ : std::vector<int>{},
                            context_.threads, context_.stop);
}

bool SheetProblem::evaluate(const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                            Eigen::MatrixXd* jacobian) const {
  Eigen::Index row = 0;
  if (jacobian) jacobian->setZero(residual.size(), values.size());
  for (std::size_t t = 0; t < tests_.size(); ++t) {
    const SheetTest& test = *tests_[t];
    const auto shapes = predict(t, values, jacobian != nullptr);
    if (!shapes) return false;
    for (int frame = 0; frame < test.frame_count(); ++frame) {
      const SheetShape& shape = (*shapes)[static_cast<std::size_t>(frame)];
      const int rows = test.rows(frame);
      residual.segment(row, rows) =
          (test.predicted(frame, shape) - test.measured(frame)) / scales_[t];
      if (jacobian) {
        const Eigen::MatrixXd by_parameter = test.jacobian(frame, shape) / scales_[t];
        for (std::size_t k = 0; k < parameters_.size(); ++k) {
          jacobian->block(row, unknown_of_[k], rows, 1) +=
              by_parameter.col(static_cast<Eigen::Index>(k));
        }
      }
      row += rows;
    }
  }
  return true;
}

LeastSquaresProblem SheetProblem::least_squares() const {
  LeastSquaresProblem problem;
  problem.evaluate = [this](const Eigen::VectorXd& values, Eigen::VectorXd& residual,
                            Eigen::MatrixXd* jacobian) {
    return evaluate(values, residual, jacobian);
  };
  for (const SheetTest* test : tests_) problem.residuals += test->rows();
  const Eigen::VectorXd values = start();
  problem.lower = Eigen::VectorXd::Zero(values.size());
  problem.upper = Eigen::VectorXd::Constant(values.size(), 1e12);
  problem.scale = Eigen::VectorXd::Constant(values.size(), std::max(values.maxCoeff(), 1e-12));
  return problem;
}

EquilibriumCounts SheetProblem::counts() const {
  EquilibriumCounts sum;
  for (const auto& equilibria : equilibria_) {
    const EquilibriumCounts& own = equilibria->counts();
    sum.equilibria += own.equilibria;
    sum.iterations += own.iterations;
    sum.factors += own.factors;
    sum.unstable += own.unstable;
  }
  return sum;
}

}  // namespace pliant
