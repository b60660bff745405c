#include "pliant/estimation/figure_reader.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace pliant {
namespace {

constexpr double kStep = 1e-4;  // of a parameter, for differences: far above rounding, far below it

}  // namespace

FigureReader::FigureReader(const Material& material, std::string name, const ErrorOfLaw& error_of)
    : name_(std::move(name)), component_(material.components.at(name_)), error_of_(error_of) {}

void FigureReader::add(const char* name, const char* unit, const FigureReading& read, double from,
                       double to, std::optional<double> at) {
  const std::optional<double> value = read(component_);
  if (!value || !std::isfinite(*value)) return;
  all_.push_back({name_, name, unit, *value, at, error(read), is_beyond(from, to)});
}

// Of what the data cover; their ends count as met by a hundredth.
bool FigureReader::is_beyond(double from, double to) const {
  if (!component_.range) return true;
  const auto [low, high] = *component_.range;
  const double slack = 0.01 * high;
  return from < low - slack || to > high + slack;
}

std::optional<CurveError> FigureReader::error(const FigureReading& read) const {
  // Of friction that differs between the sides the parameters are twice as many.
  if (!error_of_ || (component_.friction && component_.friction->negative)) return std::nullopt;
  const ComponentLaw law = law_of(component_);
  const Eigen::VectorXd steps = steps_of(law);
  Eigen::VectorXd gradient(law.parameter_count());
  for (Eigen::Index i = 0; i < gradient.size(); ++i) {
    // What is zero may not be less.
    const double back = law.parameters()(i) == 0 ? 0 : steps(i);
    const auto up = read_with(law, i, steps(i), read), down = read_with(law, i, -back, read);
    if (!up || !down) return std::nullopt;
    gradient(i) = (*up - *down) / (steps(i) + back);
  }
  return gradient.allFinite() ? error_of_(gradient) : std::nullopt;
}

std::optional<double> FigureReader::read_with(const ComponentLaw& law, Eigen::Index parameter,
                                              double step, const FigureReading& read) const {
  Eigen::VectorXd parameters = law.parameters();
  parameters(parameter) += step;
  MaterialComponent moved = component_;
  set_law(moved, law.with_parameters(parameters));
  return read(moved);
}

// A parameter that is zero moves by a share of the largest one of its unit.
Eigen::VectorXd FigureReader::steps_of(const ComponentLaw& law) const {
  const std::vector<std::string> units = parameter_units(law, units_of(name_));
  const Eigen::VectorXd parameters = law.parameters();
  Eigen::VectorXd steps = kStep * parameters.cwiseAbs();
  for (Eigen::Index i = 0; i < steps.size(); ++i) {
    for (Eigen::Index j = 0; j < steps.size() && parameters(i) == 0; ++j) {
      const bool alike = units[static_cast<std::size_t>(i)] == units[static_cast<std::size_t>(j)];
      if (alike) steps(i) = std::max(steps(i), kStep * std::abs(parameters(j)));
    }
    if (steps(i) == 0) steps(i) = kStep;
  }
  return steps;
}

}  // namespace pliant
