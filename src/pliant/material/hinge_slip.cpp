#include "pliant/material/hinge_slip.h"

#include <cmath>

#include "pliant/material/addend/dahl_branch.h"
#include "pliant/material/bending_strain.h"
#include "pliant/material/bounded_factors.h"

namespace pliant {
namespace {

void lengthen(DahlParameters& dahl, double slip) {
  dahl.a *= slip;
  dahl.tau *= slip;
}

void lengthen(std::vector<Addend>& addends, double factor, double slip) {
  for (Addend& addend : addends) {
    if (addend.is_elastic()) continue;
    const double scale = addend.is_friction() ? slip : 1 / factor;
    Eigen::VectorXd values = addend.values();
    const std::vector<AddendParameter>& parameters = addend.kind().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const int power = parameters[i].stress + parameters[i].strain;
      values(static_cast<Eigen::Index>(i)) *= std::pow(scale, power);
    }
    addend = {addend.kind(), values};
  }
}

std::vector<DahlParameters> branches(const ComponentLaw& law) {
  std::vector<DahlParameters> result;
  if (law.friction_law == FrictionLaw::dahl) {
    result.push_back({law.friction[0], law.friction[1], law.friction[2]});
  }
  for (const Addend& addend : law.addends) {
    if (&addend.kind() != &dahl_branch()) continue;
    const Eigen::VectorXd& values = addend.values();
    result.push_back({values(0), values(1), values(2)});
  }
  return result;
}

// A quarter of what friction with b = 0 takes on a closed loop between -strain and strain.
double loop_loss(const std::vector<DahlParameters>& friction, double strain) {
  double loss = 0;
  for (const DahlParameters& dahl : friction) {
    loss += dahl.a * (strain - dahl.tau * std::tanh(strain / dahl.tau));
  }
  return loss;
}

double stress_from_rest(const ComponentLaw& law, double strain) {
  double stress = law.elastic_stress(strain) + law.friction_stress(strain, {}).stress;
  for (const Addend& addend : law.addends) {
    if (addend.is_elastic()) continue;
    stress += addend.at(strain, 0, Eigen::VectorXd::Zero(addend.history_size())).stress;
  }
  return stress;
}

BendingLaws with_hinge_strains(BendingLaws laws, const BendingVector& factors,
                               const BendingVector& slip) {
  for (std::size_t c = 0; c < laws.size(); ++c) {
    const auto i = static_cast<Eigen::Index>(c);
    laws[c] = pliant::with_hinge_strains(laws[c], factors(i), slip(i));
  }
  return laws;
}

// What hinges lose on loops in each direction, by component.
RigidityShares loop_losses(const std::vector<BentHinge>& hinges, const BendingLaws& laws,
                           const BendingVector& factors) {
  RigidityShares losses = RigidityShares::Zero();
  for (std::size_t c = 0; c < laws.size(); ++c) {
    const auto component = static_cast<Eigen::Index>(c);
    const std::vector<DahlParameters> friction = branches(laws[c]);
    if (friction.empty()) continue;
    for (const BentHinge& hinge : hinges) {
      const double weight = hinge.area * hinge.parts(component) * factors(component);
      if (weight <= 0) continue;
      for (Eigen::Index d = 0; d < losses.rows(); ++d) {
        const double strain = kStrainPerCurvature * kSlipCurvature * std::abs(hinge.bends(d));
        losses(d, component) += weight * loop_loss(friction, strain);
      }
    }
  }
  return losses;
}

Eigen::Vector4d sheet_losses(const BendingLaws& sheet) {
  constexpr double kStrain = kStrainPerCurvature * kSlipCurvature;
  const auto loss = [&](std::size_t component) {
    return loop_loss(branches(sheet[component]), kStrain);
  };
  return {loss(0), loss(1), loss(2), loss(2)};
}

}  // namespace

ComponentLaw with_hinge_strains(ComponentLaw law, double factor, double slip) {
  if (law.friction_law == FrictionLaw::dahl) {
    DahlParameters dahl{law.friction[0], law.friction[1], law.friction[2]};
    lengthen(dahl, slip);
    law.friction = {dahl.a, dahl.b, dahl.tau};
  }
  lengthen(law.addends, factor, slip);
  return law;
}

MaterialComponent with_hinge_strains(MaterialComponent component, double factor, double slip) {
  if (component.friction) {
    lengthen(component.friction->positive, slip);
    if (component.friction->negative) lengthen(*component.friction->negative, slip);
  }
  lengthen(component.addends, factor, slip);
  component.errors.clear();
  return component;
}

ComponentLaw hinge_law(const ComponentLaw& sheet, double factor, double slip) {
  MaterialComponent component;
  set_law(component, with_hinge_strains(sheet, factor, slip));
  return law_of(scaled(component, factor));
}

// A fixed point: the shape and how fast friction builds up follow from the slip, and the losses are
// proportional to it beside that. Half of each change is taken, as more slip moves the shape to
// where it takes less.
BendingVector hinge_slip(const BendingLaws& sheet, const BendingVector& factors,
                         const Eigen::Vector4d& direction_weights, const BentShape& shape) {
  constexpr int kMaxIterations = 60;
  constexpr double kTolerance = 1e-8;
  const Eigen::Vector4d targets = sheet_losses(sheet);
  Eigen::Vector4d scale = Eigen::Vector4d::Zero();  // directions without friction ask for nothing
  for (Eigen::Index d = 0; d < scale.size(); ++d) {
    if (targets(d) > 0) scale(d) = std::sqrt(direction_weights(d)) / targets(d);
  }
  BendingVector slip = BendingVector::Ones();
  if (scale.isZero(0)) return slip;
  for (int i = 0; i < kMaxIterations; ++i) {
    const BendingLaws laws = with_hinge_strains(sheet, factors, slip);
    const std::vector<BentHinge> hinges = shape([&](int component, double strain) {
      return factors(component) *
             stress_from_rest(laws[static_cast<std::size_t>(component)], strain);
    });
    const RigidityShares by_slip =
        scale.asDiagonal() * loop_losses(hinges, laws, factors) * slip.cwiseInverse().asDiagonal();
    BendingVector next = bounded_factors(by_slip, scale.cwiseProduct(targets));
    for (Eigen::Index c = 0; c < next.size(); ++c) {
      if (by_slip.col(c).isZero(0)) next(c) = 1;
    }
    const BendingVector change = (next - slip) / 2;
    slip += change;
    if (change.norm() < kTolerance) break;
  }
  return slip;
}

}  // namespace pliant
