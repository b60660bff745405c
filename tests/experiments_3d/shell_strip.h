#pragma once

#include <functional>
#include <vector>

#include <Eigen/Core>

#include "pliant/geometry/hinges.h"
#include "pliant/geometry/triangle_mesh.h"
#include "pliant/material/material.h"
#include "pliant/mechanics/system.h"

namespace pliant::test {

/// A cloth whose hinges across a strip along warp bend as `bending` says, and whose strips do
/// nothing else: its diagonals hardly bend. Otherwise vertices would move out of the cylinder
/// between two hinges, and a narrow strip would curve across itself as well.
Material bending_along_warp(const ComponentLaw& bending, double density);

/// A cloth that bends alike in all directions.
Material bending_all_ways(const ComponentLaw& bending, double density);

/// How a strip along warp is meshed.
struct StripGrid {
  double length = 0;  ///< from the clamp to the free end (m)
  double width = 0;   ///< m
  int rows = 0;       ///< of vertices, from the clamp to the free end
  int columns = 0;    ///< of cells, across

  /// Distance between rows (m). The clamp stands amid two rows that it holds: the first hinge that
  /// bends has all of its rest area in the strip, from the clamp to one cell on.
  double cell() const { return length / (rows - 0.5); }
};

/// What a strip does before it is let go. A sheet that is rolled from flat relaxes on the way.
enum class StripStart { bent, flat };

/// A strip as a discrete shell in space: the same problem as `Elastica`. The clamp is the origin,
/// its direction +x, gravity pulls along -y, and the width is along z.
class ShellStrip {
 public:
  /// Bent from flat, all of it.
  /// @param curvature  1/m; 0: flat
  /// @param start      bent: it begins on the cylinder; flat: it is still to be rolled
  ShellStrip(const StripGrid& grid, const Material& material, double curvature,
             StripStart start = StripStart::bent);

  /// Takes away the moments that hold the strip in its first shape, all together, in equal steps,
  /// as `Elastica::released` does.
  /// @return where the middles of the rows are, at `places()` (m)
  std::vector<Eigen::Vector2d> released(int steps);
  /// The same after rolling a flat strip, without weight, by moments that grow in equal steps.
  std::vector<Eigen::Vector2d> rolled_and_released(int steps_rolled, int steps);
  /// Lets the weight grow from nothing instead, in equal steps; for a flat strip.
  std::vector<Eigen::Vector2d> loaded(int steps);

  /// Distances of the rows from the clamp along the strip (m); the last one is the length.
  std::vector<double> places() const;

 private:
  int row_count() const { return grid_.rows + 1; }  // with the one behind the clamp
  std::vector<int> row(int number) const;
  Eigen::Vector2d middle(const Eigen::Matrix3Xd& positions, int number) const;
  Eigen::Matrix3Xd bent_positions(double curvature) const;
  Eigen::Matrix3Xd weight() const;
  double hanging_moment(const Eigen::Matrix3Xd& positions, int number) const;
  void hold(const ComponentLaw& law, double curvature, StripStart start);
  /// Shares of the moments that roll the strip, of those that carry its weight, and of the weight.
  struct Loads {
    double rolling = 0, carrying = 0, weight = 0;
  };
  std::vector<Eigen::Vector2d> follow(int steps, const std::function<Loads(int step)>& loads);
  void add_moments(const std::function<double(const Hinge&)>& moment);

  StripGrid grid_;
  TriangleMesh mesh_;
  System system_;
};

}  // namespace pliant::test
