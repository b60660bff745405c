#include "pliant/capture/fixed_tags.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"

namespace pliant {
namespace {

constexpr double kOff = 0.3;  // ten times what corners miss (pixels)

double farthest_corner(const DetectedTag& a, const DetectedTag& b) {
  return (a.corners - b.corners).colwise().norm().maxCoeff();
}

}  // namespace

FixedTags::FixedTags(const std::vector<int>& codes, const GreyPicture& first,
                     const TagsByCode& tags, const std::string& file) {
  for (const int code : codes) {
    if (tags.twice.contains(code)) {
      throw InputError({file}, fmt::format("shows the fixed tag {} more than once", code),
                       "a code for each tag");
    }
    if (const auto tag = tags.once.find(code); tag != tags.once.end()) {
      first_.push_back(tag->second);
    }
  }
  if (!first_.empty()) return;
  require_unmirrored(first, codes, file);
  throw InputError({file}, fmt::format("shows none of the fixed tags {}", fmt::join(codes, ", ")),
                   "one of them at least, whole, in focus and with some white around it");
}

std::string FixedTags::doubt(const TagsByCode& tags) const {
  const DetectedTag* worst = nullptr;
  double most = -1;
  for (const DetectedTag& tag : first_) {
    const auto now = tags.once.find(tag.code);
    if (now == tags.once.end()) continue;
    const double off = farthest_corner(tag, now->second);
    if (off > most) {
      most = off;
      worst = &tag;
    }
  }
  if (!worst) return "shows none of the fixed tags that were there at first";
  if (most < kOff) return {};
  return fmt::format(
      "shows the fixed tag {} {:.1f} pixels off where it was at first: the camera was moved or "
      "refocused, its pictures are stabilised, or the tag did not stand still",
      worst->code, most);
}

}  // namespace pliant
