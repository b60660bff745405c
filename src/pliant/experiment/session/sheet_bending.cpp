#include "pliant/experiment/session/sheet_bending.h"

#include <algorithm>

#include "pliant/base/assert.h"
#include "pliant/geometry/hinges.h"

namespace pliant {
namespace {

constexpr std::array kDirections{"bend.weft", "bend.warp", "bend.diagonal"};

}  // namespace

SheetBending::SheetBending(const TriangleMesh& mesh, const Material& material,
                           const std::vector<std::string>& names)
    : converter_(mesh, find_hinges(mesh)) {
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    const std::string component = kDirections[d];
    const auto law = law_of(material, component);
    PLIANT_ASSERT(law.has_value(), "a sheet that is simulated bends in all directions");
    Direction& own = directions_[d];
    const std::vector<std::string> parameters = parameter_names(*law, component);
    for (int i = 0; i < law->stiffness.size() + std::min(law->friction_count(), 2); ++i) {
      const auto found = std::ranges::find(names, parameters[static_cast<std::size_t>(i)]);
      if (found == names.end()) continue;  // friction that no simulation of the session has
      (i < law->stiffness.size() ? own.stiffness : own.friction).push_back(found - names.begin());
    }
    own.at_rest = law->stiffness.weights(0);
  }
}

SheetBending::Hinges SheetBending::hinges(const Eigen::VectorXd& values) const {
  Hinges result{values, Eigen::MatrixXd::Identity(values.size(), values.size())};
  BendingVector at_rest;
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    const Eigen::VectorXd own = values(directions_[d].stiffness);
    at_rest(static_cast<Eigen::Index>(d)) = directions_[d].at_rest.dot(own);
  }
  if (at_rest.minCoeff() <= 0) return result;
  const BendingVector factors = converter_(at_rest).factors;
  const Eigen::Matrix3d factors_by_sheet = converter_.factors_by_sheet(at_rest);
  for (std::size_t d = 0; d < directions_.size(); ++d) {
    const double factor = factors(static_cast<Eigen::Index>(d));
    std::vector<Eigen::Index> scaled = directions_[d].stiffness;
    scaled.insert(scaled.end(), directions_[d].friction.begin(), directions_[d].friction.end());
    for (const Eigen::Index place : scaled) {
      result.values(place) = factor * values(place);
      result.by_values(place, place) = factor;
      for (std::size_t other = 0; other < directions_.size(); ++other) {
        const Direction& by = directions_[other];
        const double change =
            factors_by_sheet(static_cast<Eigen::Index>(d), static_cast<Eigen::Index>(other));
        for (std::size_t i = 0; i < by.stiffness.size(); ++i) {
          result.by_values(place, by.stiffness[i]) +=
              values(place) * change * by.at_rest(static_cast<Eigen::Index>(i));
        }
      }
    }
  }
  return result;
}

Material as_hinges(const Material& sheet, const TriangleMesh& mesh) {
  BendingVector at_rest;
  for (std::size_t d = 0; d < 3; ++d) {
    const auto law = law_of(sheet, kDirections[d]);
    PLIANT_ASSERT(law.has_value(), "a sheet that is simulated bends in all directions");
    at_rest(static_cast<Eigen::Index>(d)) = law->elastic_tangent(0);
  }
  Material hinges = sheet;
  hinges.bending_of = "hinges";
  if (at_rest.minCoeff() <= 0) return hinges;
  const BendingVector factors = bending_conversion(mesh, find_hinges(mesh), at_rest).factors;
  for (std::size_t d = 0; d < 3; ++d) {
    const double factor = factors(static_cast<Eigen::Index>(d));
    MaterialComponent& component = hinges.components.at(kDirections[d]);
    component = scaled(component, factor);
  }
  return hinges;
}

}  // namespace pliant
