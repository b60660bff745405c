#pragma once

#include <optional>
#include <vector>

#include "pliant/capture/dic_file.h"
#include "pliant/capture/still_reading.h"

namespace pliant {

/// What a tester's log says at each frame (SI).
struct FrameLog {
  std::vector<double> force;      ///< NaN of frames that the log does not cover (`start`), or whose
                                  ///< rows are NaN
  std::vector<double> extension;  ///< likewise; empty where the log has none
  std::vector<double> time;       ///< by the log's clock; empty where it tells none
  std::vector<std::optional<FrameStand>> stands;  ///< where the file tells how long frames stand
};

/// What load cells say at each frame (SI).
struct CellLog {
  std::vector<std::vector<double>> pull;  ///< of each cell by frame, as of FrameLog::force
  std::vector<double> time;
  std::vector<std::optional<FrameStand>> stands;
  double error = 0;  ///< of a pull, root mean square, as its spread tells it (N); 0: unknown
};

/// The log's rows as they stand.
/// @throws InputError
FrameLog read_log_rows(const DicForces& forces);

/// The log's rows, one a frame, or interpolated where the frames' rate is stated.
/// @param moments  of the frames, see moments_by_names
/// @param start    of the first frame by the log's clock (s), with a rate
/// @throws InputError where rows and frames do not go together
FrameLog log_of_frames(FrameLog rows, const DicForces& forces, const std::vector<int>& moments,
                       double start);

/// The columns of the cells, tare and slope taken off.
struct CellRows {
  std::vector<double> time;               ///< empty where the log tells none
  std::vector<std::vector<double>> pull;  ///< of each cell

  /// Of all cells at once (N).
  std::vector<double> total() const;
};

/// @throws InputError
CellRows read_cell_rows(const DicForces& forces);

/// As log_of_frames.
/// @throws InputError
CellLog cells_at_frames(const CellRows& rows, const DicForces& forces,
                        const std::vector<int>& moments, double start);

}  // namespace pliant
