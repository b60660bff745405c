#include "pliant/experiment/session/sheet_bending.h"

#include <algorithm>
#include <cmath>

#include "pliant/geometry/hinges.h"

namespace pliant {
namespace {

constexpr std::array kDirections{"bend.weft", "bend.warp", "bend.diagonal"};

// The power of two in each number of a law of hinges whose sheet's numbers are ones.
Eigen::VectorXd powers(const ComponentLaw& law, double factor, double slip) {
  const ComponentLaw ones = law.with_parameters(Eigen::VectorXd::Ones(law.parameter_count()));
  return hinge_law(ones, factor, slip).parameters().array().log() / std::log(2);
}

}  // namespace

SheetBending::SheetBending(const TriangleMesh& mesh, const Material& material,
                           const std::vector<std::string>& names)
    : converter_(mesh, find_hinges(mesh)) {
  const BendingLaws laws = bending_laws(material);
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    const ComponentLaw& law = laws[d];
    Direction& own = directions_[d];
    own = {law, {}, powers(law, 2, 1), powers(law, 1, 2)};
    const std::vector<std::string> parameters = parameter_names(law, kDirections[d]);
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const auto found = std::ranges::find(names, parameters[i]);
      // No simulation of some sessions has friction.
      own.places.push_back(found == names.end() ? -1 : found - names.begin());
      rubs_ = rubs_ || (found != names.end() && own.slip_powers(static_cast<Eigen::Index>(i)) != 0);
    }
  }
}

BendingLaws SheetBending::laws(const Eigen::VectorXd& values) const {
  BendingLaws laws;
  for (std::size_t d = 0; d < laws.size(); ++d) {
    const Direction& own = directions_[d];
    Eigen::VectorXd numbers = own.law.parameters();
    for (Eigen::Index i = 0; i < numbers.size(); ++i) {
      const Eigen::Index place = own.places[static_cast<std::size_t>(i)];
      if (place >= 0) numbers(i) = values(place);
    }
    laws[d] = own.law.with_parameters(numbers);
  }
  return laws;
}

BendingConversion SheetBending::conversion(const BendingLaws& laws) const {
  return rubs_ ? converter_(laws) : converter_(stiffness_at_rest(laws));
}

std::vector<SheetBending::Change> SheetBending::changes(const BendingLaws& laws,
                                                        const BendingVector& factors) const {
  constexpr double kStep = 1e-3;  // of a number; slip is found to 1e-8
  const BendingVector at_rest = stiffness_at_rest(laws);
  const Eigen::Matrix3d factors_by_sheet = converter_.factors_by_sheet(at_rest);
  std::vector<Change> changes;
  for (std::size_t d = 0; d < laws.size(); ++d) {
    const Eigen::VectorXd numbers = laws[d].parameters();
    for (Eigen::Index i = 0; i < numbers.size(); ++i) {
      const Eigen::Index place = directions_[d].places[static_cast<std::size_t>(i)];
      if (place < 0 || numbers(i) == 0) continue;
      const double step = kStep * numbers(i);
      const auto stepped = [&](double size) {
        BendingLaws other = laws;
        other[d] =
            laws[d].with_parameters(numbers + size * Eigen::VectorXd::Unit(numbers.size(), i));
        BendingConversion moved;
        moved.factors = factors + factors_by_sheet * (stiffness_at_rest(other) - at_rest);
        if (rubs_) moved.slip = converter_.slip(other, moved.factors);
        return moved;
      };
      const BendingConversion more = stepped(step), less = stepped(-step);
      changes.push_back({place, (more.factors - less.factors) / (2 * step),
                         (more.slip - less.slip) / (2 * step)});
    }
  }
  return changes;
}

Eigen::VectorXd SheetBending::hinges(const Eigen::VectorXd& values) const {
  Eigen::VectorXd result = values;
  const BendingLaws sheet = laws(values);
  if (stiffness_at_rest(sheet).minCoeff() <= 0) return result;
  const BendingConversion to = conversion(sheet);
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    const auto direction = static_cast<Eigen::Index>(d);
    const Eigen::VectorXd numbers =
        hinge_law(sheet[d], to.factors(direction), to.slip(direction)).parameters();
    for (Eigen::Index i = 0; i < numbers.size(); ++i) {
      const Eigen::Index place = directions_[d].places[static_cast<std::size_t>(i)];
      if (place >= 0) result(place) = numbers(i);
    }
  }
  return result;
}

Eigen::MatrixXd SheetBending::hinges_by_values(const Eigen::VectorXd& values) const {
  Eigen::MatrixXd result = Eigen::MatrixXd::Identity(values.size(), values.size());
  const BendingLaws sheet = laws(values);
  if (stiffness_at_rest(sheet).minCoeff() <= 0) return result;
  const BendingConversion to = conversion(sheet);
  const std::vector<Change> by = changes(sheet, to.factors);
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    const auto direction = static_cast<Eigen::Index>(d);
    const double factor = to.factors(direction), slip = to.slip(direction);
    const Direction& own = directions_[d];
    for (Eigen::Index i = 0; i < own.factor_powers.size(); ++i) {
      const Eigen::Index place = own.places[static_cast<std::size_t>(i)];
      if (place < 0) continue;
      const double scale =
          std::pow(factor, own.factor_powers(i)) * std::pow(slip, own.slip_powers(i));
      result(place, place) = scale;
      for (const Change& change : by) {
        result(place, change.place) += scale * values(place) *
                                       (own.factor_powers(i) / factor * change.factors(direction) +
                                        own.slip_powers(i) / slip * change.slip(direction));
      }
    }
  }
  return result;
}

Material as_hinges(const Material& sheet, const TriangleMesh& mesh) {
  Material hinges = sheet;
  hinges.bending_of = "hinges";
  const BendingLaws laws = bending_laws(sheet);
  if (stiffness_at_rest(laws).minCoeff() <= 0) return hinges;
  const BendingConversion conversion = BendingConverter(mesh, find_hinges(mesh))(laws);
  for (std::size_t d = 0; d < laws.size(); ++d) {
    const auto direction = static_cast<Eigen::Index>(d);
    MaterialComponent& component = hinges.components.at(kDirections[d]);
    const double factor = conversion.factors(direction);
    component = scaled(with_hinge_strains(component, factor, conversion.slip(direction)), factor);
  }
  return hinges;
}

}  // namespace pliant
