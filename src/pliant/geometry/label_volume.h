#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// A box of voxels, each with the label of what it is of: a segmented image. Label 0 is outside.
struct LabelVolume {
  Eigen::Vector3i size = Eigen::Vector3i::Zero();      ///< voxels along each axis
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< column a: from a voxel to the next along
                                                       ///< axis a
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();    ///< the middle of the first voxel
  std::vector<int> labels;                             ///< along the first axis first

  /// The label at a place: of those of the eight voxels around it the one with the largest sum of
  /// trilinear weights, so that surfaces have no steps; 0 outside the box of their middles.
  int at(const Eigen::Vector3d& place) const;
};

/// Reads a .nrrd file of whole numbers in three dimensions (as 3D Slicer and ITK write them), its
/// lengths as they stand in the file.
/// @throws InputError
LabelVolume read_label_volume(const std::filesystem::path& path);

}  // namespace pliant
