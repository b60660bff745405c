#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Geometry>

#include "pliant/experiment/session/virtual/options.h"

namespace pliant {

/// How a clip moves in the plane of the sheet: it turns about a point and is shifted.
struct PlaneMotion {
  double turn = 0;                                  ///< rad
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();  ///< of the point (m)
};

/// A clip of a virtual test, in the axes of the rectangle that the sheet is.
struct TestClip {
  std::string name;
  Eigen::AlignedBox2d holds;           ///< the cloth that it clamps
  std::vector<Eigen::Vector2d> cords;  ///< where they are attached, outside of the cloth
  Eigen::Vector2d pivot;               ///< that it turns about
  std::function<PlaneMotion(double load)> motion;
};

/// The clips of a test, none of one on a table. Under the load 0 they stretch the sheet by its
/// initial strain alone, under 1 as far as the test goes; in the corner-pull the other pair of
/// corners is pulled under -1.
std::vector<TestClip> test_clips(const VirtualSession& options);

/// The load of each frame: from turn to turn at even speed, each turn in a frame of its own.
std::vector<double> frame_loads(const VirtualSession& options);

}  // namespace pliant
