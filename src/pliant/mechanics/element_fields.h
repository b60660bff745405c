#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// What the elements of a potential can show of an accepted state.
class ElementFields {
 public:
  virtual ~ElementFields() = default;

  /// Names of the fields: "strain.COMPONENT", then "friction.COMPONENT".
  virtual std::vector<std::string> field_names() const = 0;
  /// One row a field, one column an element.
  /// @param history  the potential's, see System::history_of
  virtual Eigen::MatrixXd field_values(const double* history) const = 0;
  /// Points of the elements, one column each.
  virtual Eigen::MatrixXi element_points() const = 0;
  /// Rest measures of the elements (m^2).
  virtual Eigen::VectorXd element_sizes() const = 0;
};

}  // namespace pliant
