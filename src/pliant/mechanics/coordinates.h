#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/math/block_matrix.h"
#include "pliant/mechanics/controls.h"
#include "pliant/mechanics/state.h"

namespace pliant {

/// Generalised coordinates of a system: each point is free, moved from outside, or part of a rigid
/// clip. Unknowns come in threes, the block rows of the Hessian: first the free points, then for
/// each free clip its translation and its rotation (a rotation vector in world axes, about the
/// clip's origin, from where the clip is).
class Coordinates {
 public:
  /// All points free.
  explicit Coordinates(int points);

  /// The point's position comes from outside.
  void prescribe(int point);
  /// The same for one axis (0, 1, 2) of a free point.
  void prescribe_axis(int point, int axis);
  /// Makes a clip of points, with its origin at their mean. A prescribed clip's pose comes from
  /// outside.
  /// @return its number
  int add_clip(const std::vector<int>& points, bool prescribed);

  int points() const { return static_cast<int>(owner_.size()); }
  int clips() const { return static_cast<int>(clips_.size()); }
  bool clip_is_prescribed(int clip) const;
  const std::vector<int>& clip_points(int clip) const;
  /// Block row of a free clip's translation; that of its rotation follows.
  int clip_row(int clip) const { return clips_[static_cast<size_t>(clip)].row; }
  /// Largest distance of a clip's points from its origin (m).
  double clip_radius(int clip, const Configuration& at) const;
  bool is_free(int point) const { return row(point) >= 0; }
  bool is_prescribed(int point) const;
  /// Whether it is prescribed, or an axis of it.
  bool is_led(int point) const;
  /// The clip that a point belongs to; -1 for none.
  int clip_of(int point) const { return std::max(owner_[static_cast<size_t>(point)], -1); }

  /// Block row of a free point; -1 for any other.
  int row(int point) const { return rows_[static_cast<size_t>(point)]; }
  int block_rows() const { return block_rows_; }
  Eigen::Index unknowns() const { return 3 * block_rows_; }

  /// Numbers the unknowns; to be called after the last change, before all that follows.
  void number();

  /// Poses of the clips whose points are at `positions`, unrotated, and the places of the points in
  /// their clips.
  Configuration initial_configuration(const Eigen::Matrix3Xd& positions);

  /// The pattern of a Hessian in the unknowns from pairs of points that it couples.
  std::shared_ptr<const BlockPattern> pattern(
      const std::vector<std::pair<int, int>>& couplings) const;

  /// dE / d unknowns from dE / d points; zero for axes that are prescribed.
  Eigen::VectorXd reduce(const Configuration& at, const Eigen::Matrix3Xd& gradient) const;

  /// How the points move with the unknowns, to first order: one column a point.
  Eigen::Matrix3Xd motion(const Configuration& at, const Eigen::VectorXd& change) const;

  /// Adds d2E / (d point i d point j), i != j or i = j, to a Hessian in the unknowns. A pair of
  /// different points is added once, for both orders.
  void add_coupling(const Configuration& at, int i, int j, const Eigen::Matrix3d& value,
                    BlockMatrix& hessian) const;

  /// Adds d2E / (d point i d point j) of an energy that depends on the difference of two points,
  /// and what follows of it for each of the two, where they are not both free.
  void add_difference(const Configuration& at, int i, int j, const Eigen::Matrix3d& value,
                      BlockMatrix& hessian) const;
  /// The same for all pairs of free points, whose blocks alone were added to: the diagonal blocks
  /// of what does not change with a translation. To be called once.
  void complete_diagonals(BlockMatrix& hessian) const;

  /// Adds factor u u^T to a Hessian in the unknowns, u being zero but at four different points.
  void add_outer_product(const Configuration& at, double factor, const std::array<int, 4>& points,
                         const Eigen::Matrix<double, 3, 4>& u, BlockMatrix& hessian) const;

  /// Adds what the forces on the points of clips contribute to the Hessian because a rotation moves
  /// points along arcs.
  void add_rotation_terms(const Configuration& at, const Eigen::Matrix3Xd& gradient,
                          BlockMatrix& hessian) const;

  /// Takes the axes that are prescribed out of a Hessian: their rows and columns become those of a
  /// diagonal matrix.
  void decouple_prescribed_axes(BlockMatrix& hessian) const;

  /// Gives stiffness to rotations that move no point: of a clip that holds one point, and about
  /// the line of a clip whose points are on one. No force acts on them.
  void hold_neutral_rotations(const Configuration& at, BlockMatrix& hessian) const;

  /// The configuration after a change of the unknowns.
  Configuration moved(const Configuration& from, const Eigen::VectorXd& change) const;

  /// Puts a clip, with its points, into a pose.
  void place_clip(int clip, const Pose& pose, Configuration& configuration) const;

  /// Puts what is prescribed where the controls say.
  void apply(const Controls& controls, Configuration& configuration) const;

 private:
  struct Clip {
    std::vector<int> points;
    Eigen::Matrix3Xd local;  // places of the points in the clip, m
    bool prescribed = false;
    int row = -1;  // of its translation; that of its rotation follows
  };
  // How a point follows one block row: x' = matrix * (change of the row's unknowns).
  struct Dependence {
    int row = 0;
    Eigen::Matrix3d matrix;
  };
  struct Dependences {
    int count = 0;
    Dependence entry[2];
  };

  Dependences dependences(const Configuration& at, int point) const;

  struct HeldAxis {
    int point = 0, axis = 0;
  };

  static constexpr int kFree = -1, kPrescribed = -2;
  std::vector<int> owner_;  // kFree, kPrescribed or the number of a clip
  std::vector<int> rows_;
  std::vector<Clip> clips_;
  std::vector<HeldAxis> held_axes_;
  int block_rows_ = 0;
};

}  // namespace pliant
