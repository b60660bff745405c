#pragma once

#include <string>
#include <vector>

#include "pliant/base/run_context.h"
#include "pliant/capture/calibration_board.h"
#include "pliant/capture/point_source.h"
#include "pliant/capture/rig_file.h"

namespace pliant {

/// A picture for calibration and what was found in it.
struct RigPicture {
  std::string file;
  int camera = 0;
  int shot = 0;  ///< pictures of one shot were taken at the same time
  int columns = 0, rows = 0;
  PictureFindings findings;
  std::string left_out;      ///< the reason; empty: it is used
  bool contradicts = false;  ///< left out since other pictures say otherwise
};

/// Reads all pictures of a rig and looks for its boards, on as many threads as the context says.
/// Pictures that cannot be read, show no board or have another size than most of their camera are
/// left out, with the reason.
/// @throws InputError where a camera has no picture left
std::vector<RigPicture> find_boards_in_pictures(const RigFile& rig, const ReadPicture& read_picture,
                                                const RunContext& context);

/// Leaves out what cannot be used, as above.
void judge_pictures(const RigFile& rig, std::vector<RigPicture>& pictures);

}  // namespace pliant
