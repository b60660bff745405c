#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/quantity.h"
#include "pliant/capture/dic_session.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

std::string forces_of(const DicFile& dic) {
  if (dic.table) return "its own weight, over the edge of a table";
  if (!dic.forces) return "not known";
  if (!dic.forces->is_tester()) return "of cords";
  return "on " + dic.forces->clip;
}

}  // namespace

FileInfo dic_info(const std::filesystem::path& path) {
  const DicFile dic = read_dic(path);
  FileInfo info = begin_info(path, "dic/1");
  info.json["test"] = dic.test;
  info.lines.push_back(labelled("test", dic.test));
  info.lines.push_back(labelled(
      "sample", fmt::format("{} x {}", format_quantity(dic.sample.width, Dimension::length),
                            format_quantity(dic.sample.height, Dimension::length))));
  info.lines.push_back(labelled("forces", forces_of(dic)));
  // To track points in pictures takes longer than to say what they are.
  if (dic.views) {
    const std::size_t frames = dic.views->files.front().size();
    info.json["frames"] = frames;
    info.json["cameras"] = dic.views->names;
    info.lines.push_back(labelled(
        "pictures", fmt::format("{} of each of {}", frames, fmt::join(dic.views->names, ", "))));
    return info;
  }
  if (dic.pictures) {
    info.json["frames"] = dic.pictures->files.size();
    info.lines.push_back(labelled("pictures", fmt::format("{}", dic.pictures->files.size())));
    return info;
  }
  const DicSession made = make_dic_session(dic);
  const int frames = made.frame_count();
  info.json["frames"] = frames;
  info.json["spacing"] = made.spacing;
  info.json["point_noise"] = made.point_noise;
  info.lines.push_back(
      labelled("points", fmt::format("{} frames, points {} apart", frames,
                                     format_quantity(made.spacing, Dimension::length, 3))));
  if (made.middle) {
    info.json["strain"] = made.middle->strain;
    info.lines.push_back(labelled("strain", fmt::format("{:.2f} % of the middle at the end",
                                                        100 * made.middle->strain.back())));
  }
  return info;
}

}  // namespace pliant
