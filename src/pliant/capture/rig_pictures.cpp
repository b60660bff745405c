#include "pliant/capture/rig_pictures.h"

#include <map>
#include <mutex>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"

namespace pliant {
namespace {

std::vector<RigPicture> listed_pictures(const RigFile& rig) {
  std::vector<RigPicture> pictures;
  int first_shot = 0;
  for (const RigPictureSet& set : rig.pictures) {
    std::size_t shots = 0;
    for (int c = 0; c < std::ssize(set.files); ++c) {
      shots = std::max(shots, set.files[c].size());
      for (int i = 0; i < std::ssize(set.files[c]); ++i) {
        RigPicture picture;
        picture.file = set.files[c][i].string();
        picture.camera = c;
        picture.shot = first_shot + i;
        pictures.push_back(std::move(picture));
      }
    }
    first_shot += static_cast<int>(shots);
  }
  return pictures;
}

void look_into(RigPicture& picture, const RigFile& rig, const ReadPicture& read_picture) {
  constexpr int kLeastSide = 32;
  try {
    const GreyPicture grey = read_picture(picture.file);
    picture.columns = static_cast<int>(grey.cols());
    picture.rows = static_cast<int>(grey.rows());
    if (std::min(picture.columns, picture.rows) < kLeastSide) {
      picture.left_out = "is too small";
      return;
    }
    picture.findings = find_boards(grey, rig.boards);
    picture.left_out = picture.findings.problem;
  } catch (const InputError& error) {
    picture.left_out = error.problem();
  }
}

std::pair<int, int> commonest_size(const std::vector<RigPicture>& pictures, int camera) {
  std::map<std::pair<int, int>, int> sizes;
  for (const RigPicture& picture : pictures) {
    if (picture.camera == camera && picture.columns > 0) ++sizes[{picture.columns, picture.rows}];
  }
  if (sizes.empty()) return {0, 0};
  return std::ranges::max_element(sizes, {}, [](const auto& size) { return size.second; })->first;
}

}  // namespace

void judge_pictures(const RigFile& rig, std::vector<RigPicture>& pictures) {
  for (int c = 0; c < std::ssize(rig.cameras); ++c) {
    const auto [columns, rows] = commonest_size(pictures, c);
    int left = 0, taken = 0;
    std::string reason;
    for (RigPicture& picture : pictures) {
      if (picture.camera != c) continue;
      ++taken;
      if (picture.columns > 0 && (picture.columns != columns || picture.rows != rows)) {
        picture.left_out = fmt::format("is of {} x {} pixels, and others of this camera of {} x {}",
                                       picture.columns, picture.rows, columns, rows);
      }
      if (picture.left_out.empty()) {
        ++left;
      } else if (reason.empty()) {
        reason = fmt::format("{} {}", picture.file, picture.left_out);
      }
    }
    if (left > 0) continue;
    throw InputError(
        rig.cameras[c].where,
        taken == 0 ? "has no pictures in `calibration.pictures`"
                   : fmt::format("has no picture that could be used of {}: {}", taken, reason),
        "pictures of the boards that `calibration.boards` describes");
  }
}

std::vector<RigPicture> find_boards_in_pictures(const RigFile& rig, const ReadPicture& read_picture,
                                                const RunContext& context) {
  std::vector<RigPicture> pictures = listed_pictures(rig);
  const int count = static_cast<int>(pictures.size());
  ProgressTask task(context.progress, "boards in pictures", count);
  std::mutex reporting;
  int done = 0;
  parallel_for(count, context.threads, [&](int i) {
    context.stop.throw_if_requested();
    look_into(pictures[i], rig, read_picture);
    const std::scoped_lock lock(reporting);
    task.advance(++done);
  });
  judge_pictures(rig, pictures);
  return pictures;
}

}  // namespace pliant
