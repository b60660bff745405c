#include "pliant/solver/elastica/point_moment.h"

#include "pliant/material/bending_strain.h"

namespace pliant {
namespace {

using Eigen::Index;

FrictionState state_at(const StripHistory& history, Index point) {
  return {kStrainPerCurvature * history.curvature(point), history.friction(point)};
}

/// Calls `use(addend, its first number of the history, its first parameter)` for those that
/// remember.
template <class Use>
void for_each_memory(const ComponentLaw& law, const Use& use) {
  Index first = 0, parameter = law.first_addend_parameter();
  for (const Addend& addend : law.addends) {
    if (addend.history_size() > 0) use(addend, first, parameter);
    first += addend.history_size();
    parameter += addend.size();
  }
}

Eigen::VectorXd memory_of(const Addend& addend, const StripHistory& history, Index point,
                          Index first) {
  return history.memory.row(point).segment(first, addend.history_size());
}

// d friction stress / d parameters at fixed curvature, the history's part included.
Eigen::RowVectorXd friction_by_parameter(const ComponentLaw& law, const StripHistory& history,
                                         Index point, const FrictionStress& friction) {
  Eigen::RowVectorXd result =
      friction.from_strain * kStrainPerCurvature * history.curvature_by_parameter.row(point) +
      friction.from_stress * history.friction_by_parameter.row(point);
  for (int k = 0; k < law.friction_count(); ++k) {
    result(law.stiffness.size() + k) += friction.parameters[static_cast<size_t>(k)];
  }
  return result;
}

// Work per width and length since the history at `strain`, times the strain of a curvature.
double work_at(const ComponentLaw& law, double strain, const FrictionState& from) {
  double work = law.elastic_energy(strain) - law.elastic_energy(from.strain);
  if (law.friction_law == FrictionLaw::dahl) {
    const DahlParameters dahl{law.friction[0], law.friction[1], law.friction[2]};
    work += friction_work({dahl, dahl}, strain, from);
  }
  return work;
}

void add_memory(const ComponentLaw& law, const StripHistory& history, Index i, double strain,
                bool with_derivatives, PointMoment& point) {
  const double last = kStrainPerCurvature * history.curvature(i);
  for_each_memory(law, [&](const Addend& addend, Index first, Index parameter) {
    const Eigen::VectorXd memory = memory_of(addend, history, i, first);
    const Addend::Answer answer = addend.at(strain, last, memory);
    point.moment += answer.stress;
    point.tangent += kStrainPerCurvature * answer.tangent;
    point.work += answer.stored + answer.work;
    if (!with_derivatives) return;
    const SampleDerivatives by = addend.derivatives(strain, last, memory);
    point.by_parameter +=
        by.stress_by_last(0, 0) * kStrainPerCurvature * history.curvature_by_parameter.row(i);
    point.by_parameter +=
        by.stress_by_history * history.memory_by_parameter[static_cast<size_t>(i)].middleRows(
                                   first, addend.history_size());
    point.by_parameter.segment(parameter, addend.size()) += by.stress_by_parameter;
  });
}

// What the addends of a point remember.
void advance_memory(const ComponentLaw& law, const StripHistory& history, Index i,
                    const StripShape& shape, StripHistory& next) {
  const double last = kStrainPerCurvature * history.curvature(i);
  const double strain = kStrainPerCurvature * shape.curvature(i);
  const bool with_derivatives = shape.curvature_by_parameter.size() > 0;
  for_each_memory(law, [&](const Addend& addend, Index first, Index parameter) {
    const Eigen::VectorXd memory = memory_of(addend, history, i, first);
    next.memory.row(i).segment(first, addend.history_size()) =
        addend.advanced(strain, last, memory).transpose();
    if (!with_derivatives) return;
    const SampleDerivatives by = addend.derivatives(strain, last, memory);
    const auto& before = history.memory_by_parameter[static_cast<size_t>(i)];
    auto after =
        next.memory_by_parameter[static_cast<size_t>(i)].middleRows(first, addend.history_size());
    after = kStrainPerCurvature * (by.next_by_strain * shape.curvature_by_parameter.row(i) +
                                   by.next_by_last * history.curvature_by_parameter.row(i)) +
            by.next_by_history * before.middleRows(first, addend.history_size());
    after.middleCols(parameter, addend.size()) += by.next_by_parameter;
  });
}

}  // namespace

PointMoment point_moment(const ComponentLaw& law, const StripHistory& history, Index i,
                         double curvature, bool with_derivatives) {
  const double strain = kStrainPerCurvature * curvature;
  const FrictionState from = state_at(history, i);
  const FrictionStress friction = law.friction_stress(strain, from);
  PointMoment point;
  point.moment = law.elastic_stress(strain) + friction.stress;
  point.tangent = kStrainPerCurvature * (law.elastic_tangent(strain) + friction.slope);
  point.work = work_at(law, strain, from);
  if (with_derivatives) {
    point.by_parameter = friction_by_parameter(law, history, i, friction);
    point.by_parameter.head(law.parameter_count()) += law.elastic_gradient(strain).transpose();
  }
  if (history.memory.cols() > 0) add_memory(law, history, i, strain, with_derivatives, point);
  point.work /= kStrainPerCurvature;
  return point;
}

StripHistory remembered(const ComponentLaw& law, const StripHistory& history,
                        const StripShape& shape) {
  const bool with_derivatives = shape.curvature_by_parameter.size() > 0;
  StripHistory next;
  next.curvature = shape.curvature;
  next.friction.resize(shape.curvature.size());
  next.memory = history.memory;
  if (with_derivatives) {
    next.curvature_by_parameter = shape.curvature_by_parameter;
    next.friction_by_parameter.resizeLike(shape.curvature_by_parameter);
    next.memory_by_parameter = history.memory_by_parameter;
  }
  for (Index i = 0; i < next.curvature.size(); ++i) {
    const FrictionStress friction =
        law.friction_stress(kStrainPerCurvature * shape.curvature(i), state_at(history, i));
    next.friction(i) = friction.stress;
    if (with_derivatives) {
      next.friction_by_parameter.row(i) =
          friction_by_parameter(law, history, i, friction) +
          kStrainPerCurvature * friction.slope * shape.curvature_by_parameter.row(i);
    }
    if (history.memory.cols() > 0) advance_memory(law, history, i, shape, next);
  }
  return next;
}

}  // namespace pliant
