#pragma once

#include <array>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/bending_conversion.h"
#include "pliant/material/material.h"

namespace pliant {

/// The numbers of a material that bends as a sheet, as those of the hinges of one mesh.
///
/// The law of each direction is multiplied by its factor of `BendingConversion`, which depends on
/// the stiffness at rest in all three, and its friction is put on the scale of strain of its slip,
/// which depends on all of their numbers; what does not bend stays as it is. How factors and slip
/// change by the numbers is found by differences.
class SheetBending {
 public:
  /// @param names  of the numbers, in the order of their values
  SheetBending(const TriangleMesh& mesh, const Material& material,
               const std::vector<std::string>& names);

  /// @param values  with a stiffness at rest above zero in all directions; where one is not, hinges
  ///                have the sheet's numbers
  Eigen::VectorXd hinges(const Eigen::VectorXd& values) const;
  /// Their derivatives by the values, a row for each of them.
  Eigen::MatrixXd hinges_by_values(const Eigen::VectorXd& values) const;

 private:
  struct Direction {
    ComponentLaw law;
    std::vector<Eigen::Index> places;  // of its numbers among the values; -1: in no simulation
    // A number of hinges is that of the sheet times these powers of factor and slip.
    Eigen::VectorXd factor_powers, slip_powers;
  };
  // What the laws of hinges change by, by one of the values.
  struct Change {
    Eigen::Index place = 0;
    BendingVector factors, slip;
  };

  BendingLaws laws(const Eigen::VectorXd& values) const;
  BendingConversion conversion(const BendingLaws& laws) const;
  std::vector<Change> changes(const BendingLaws& laws, const BendingVector& factors) const;

  BendingConverter converter_;
  std::array<Direction, 3> directions_;
  bool rubs_ = false;  // whether simulations have friction of bending
};

/// The same material as that of the hinges of a mesh, for small curvature.
Material as_hinges(const Material& sheet, const TriangleMesh& mesh);

}  // namespace pliant
