#include "real/real_capture.h"

#include <algorithm>

#include "pliant/imaging/photo.h"

#include "io/temporary_folder.h"

namespace pliant::test {
namespace {

GreyPicture read_grey(const std::filesystem::path& file) { return read_photo(file); }

}  // namespace

RigCalibration calibrated(const std::string& board, const std::string& cameras,
                          const std::string& pictures) {
  const TemporaryFolder folder;
  folder.write("board.yaml", "pliant: pattern/1\nchessboard: " + board + "\n");
  const auto file = folder.write("rig.yaml", "pliant: rig/1\ncameras: " + cameras +
                                                 "\ncalibration:\n  boards: board.yaml\n"
                                                 "  pictures: " +
                                                 pictures + "\n");
  const RigFile rig = read_rig(file);
  RunContext context;
  context.threads = 2;
  return calibrate_rig(rig, find_boards_in_pictures(rig, read_grey, context), context);
}

int left_out_pictures(const RigCalibration& found) {
  return static_cast<int>(std::ranges::count_if(
      found.pictures, [](const RigPicture& picture) { return !picture.left_out.empty(); }));
}

}  // namespace pliant::test
