#pragma once

#include <vector>

#include <Eigen/Core>

#include "pliant/capture/point_source.h"

namespace pliant {

/// Reads the files of points, one a frame, the first of them at rest. Columns are `x, y` and, with
/// stereo, `z`: with the displacements `u, v, w` of points that stand at x, y, z at rest, or with
/// the `id` of points that stand there in the frame. A point without numbers, or with a negative
/// `sigma`, was lost.
/// @throws InputError for columns that are missing, and frames of fewer than ten points
class PointFrames : public PointSource {
 public:
  explicit PointFrames(const DicFile& dic);

  bool in_space() const override { return in_space_; }
  PointFrame read(int frame) override;

 private:
  struct Table;

  Table read_table(int frame) const;
  PointFrame by_displacement(const Table& table) const;
  PointFrame by_number(const Table& table) const;

  const DicFile& dic_;
  bool in_space_ = false;
  std::map<std::string, Eigen::Vector3d> rest_;  // of numbered points
};

}  // namespace pliant
