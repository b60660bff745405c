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
/// k, a and b of each direction are multiplied by its factor of `BendingConversion`, which depends
/// on the stiffness at rest in all three; tau and what does not bend stay as they are. The factors
/// change by the numbers as dk_hinge = G^-1 dk_sheet, G being what the sheet shows by its hinges.
class SheetBending {
 public:
  /// @param names  of the numbers, in the order of their values
  SheetBending(const TriangleMesh& mesh, const Material& material,
               const std::vector<std::string>& names);

  struct Hinges {
    Eigen::VectorXd values;
    Eigen::MatrixXd by_values;  ///< values x values
  };
  /// @param values  with a stiffness at rest above zero in all directions; where one is not, hinges
  ///                have the sheet's numbers
  Hinges hinges(const Eigen::VectorXd& values) const;

 private:
  struct Direction {
    std::vector<Eigen::Index> stiffness;  // places of the control values
    std::vector<Eigen::Index> friction;   // of a and b
    Eigen::VectorXd at_rest;              // share of each control value in the stiffness at rest
  };

  BendingConverter converter_;
  std::array<Direction, 3> directions_;
};

/// The same material as that of the hinges of a mesh, for small curvature.
Material as_hinges(const Material& sheet, const TriangleMesh& mesh);

}  // namespace pliant
