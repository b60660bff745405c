#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// What the load cell of a cord shows of the cord's own friction, per newton of the width of its
/// loop: half of it more while the cord pulls its clip along, half of it less while it gives way,
/// and as much as last while it is still.
struct CordDrag {
  int clip = 0;
  std::string cord;          ///< its name, else its number among the cords of the clip, from 1
  Eigen::Matrix3Xd forces;   ///< along the cord, one column a frame; zero where it was not measured
  Eigen::Matrix3Xd moments;  ///< of them about the middle of the clip's vertices (m)
  std::vector<char> certain;  ///< whether noise leaves no doubt which way it moves, for each frame
};

/// The drags of all cords of a session, clip by clip.
///
/// A cord moves with its clip, along its own pull; reversals of less than six standard deviations
/// of the noise of that way, and of less than 0.15 mm, do not count. In the first frame it has
/// pulled the sheet taut.
std::vector<CordDrag> cord_drags(const Session& session);

/// Adds the drags of cords to what pulls at clips in the predicted shape of a frame.
/// @param widths       of the loop of each cord (N)
/// @param derivatives  derivatives by the widths are appended to those of the shape
void add_cord_drags(const std::vector<CordDrag>& cords, const Eigen::VectorXd& widths,
                    bool derivatives, int frame, SheetShape& shape);

}  // namespace pliant
