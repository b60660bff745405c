#include "pliant/capture/tag_detector.h"

#include <algorithm>
#include <cstdint>
#include <memory>

#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include "pliant/base/assert.h"
#include "pliant/base/errors.h"
#include "pliant/base/parallel.h"

namespace pliant {
namespace {

using TagFamily = std::unique_ptr<apriltag_family_t, decltype(&tag36h11_destroy)>;
using TagFinder = std::unique_ptr<apriltag_detector_t, decltype(&apriltag_detector_destroy)>;
using TagImage = std::unique_ptr<image_u8_t, decltype(&image_u8_destroy)>;
using TagList = std::unique_ptr<zarray_t, decltype(&apriltag_detections_destroy)>;

// The library's places count from the corner of the first pixel.
constexpr double kLibraryOffset = 0.5;

TagFamily tag_family() { return {tag36h11_create(), tag36h11_destroy}; }

TagImage tag_image(const GreyPicture& picture) {
  TagImage image(
      image_u8_create(static_cast<unsigned>(picture.cols()), static_cast<unsigned>(picture.rows())),
      image_u8_destroy);
  for (Eigen::Index row = 0; row < picture.rows(); ++row) {
    for (Eigen::Index column = 0; column < picture.cols(); ++column) {
      const float level = std::clamp(picture(row, column), 0.0f, 1.0f) * 255.0f + 0.5f;
      image->buf[row * image->stride + column] = static_cast<std::uint8_t>(level);
    }
  }
  return image;
}

DetectedTag detected_tag(const apriltag_detection_t& found) {
  DetectedTag tag;
  tag.code = found.id;
  tag.margin = found.decision_margin;
  tag.wrong_cells = found.hamming;
  for (int i = 0; i < 4; ++i) {
    tag.corners.col(i) = Eigen::Vector2d(found.p[i][0], found.p[i][1]).array() - kLibraryOffset;
  }
  return tag;
}

}  // namespace

TagCorners DetectedTag::corners_by(const CameraModel& camera) const {
  return corners_by_lens(of_lines, camera);
}

std::vector<DetectedTag> detect_tags(const GreyPicture& picture,
                                     const TagDetectorOptions& options) {
  const TagFamily family = tag_family();
  const TagFinder finder(apriltag_detector_create(), apriltag_detector_destroy);
  finder->quad_decimate = static_cast<float>(options.reduced);
  finder->refine_edges = false;  // our own edges are nearer, and small tags are read better so
  apriltag_detector_add_family_bits(finder.get(), family.get(), options.most_wrong_cells);
  const TagImage image = tag_image(picture);
  const TagList found(apriltag_detector_detect(finder.get(), image.get()),
                      apriltag_detections_destroy);
  std::vector<DetectedTag> tags;
  for (int i = 0; i < zarray_size(found.get()); ++i) {
    apriltag_detection_t* detection = nullptr;
    zarray_get(found.get(), i, &detection);
    const double least =
        detection->hamming < 2 ? options.least_margin : options.least_margin_of_two;
    if (detection->decision_margin < least) continue;
    tags.push_back(detected_tag(*detection));
  }
  if (tags.empty()) return tags;
  for (DetectedTag& tag : tags) {
    const EdgeCorners edges = corners_by_edges(picture, tag.corners);
    tag.corners = edges.corners;
    tag.of_lines = edges.of_lines;
  }
  std::ranges::stable_sort(tags, {}, &DetectedTag::code);
  return tags;
}

std::vector<DetectedTag> detect_tags_of(const std::vector<int>& codes, const GreyPicture& picture) {
  constexpr int kHalf = 2;
  std::vector<DetectedTag> tags = detect_tags(picture, {.reduced = kHalf});
  const bool has_all = std::ranges::all_of(codes, [&](int code) {
    return std::ranges::find(tags, code, &DetectedTag::code) != tags.end();
  });
  return has_all ? tags : detect_tags(picture);
}

std::set<int> mirrored_codes(const GreyPicture& picture) {
  std::set<int> codes;
  for (const DetectedTag& tag : detect_tags(picture.rowwise().reverse())) codes.insert(tag.code);
  return codes;
}

void require_unmirrored(const GreyPicture& picture, const std::vector<int>& codes,
                        const std::string& file) {
  const std::set<int> mirrored = mirrored_codes(picture);
  if (std::ranges::none_of(codes, [&](int code) { return mirrored.contains(code); })) return;
  throw InputError({file}, "is mirrored: its labels can be read from behind alone",
                   "pictures as the sample looks; cameras of a phone's screen side mirror theirs");
}

TagsByCode tags_by_code(const std::vector<DetectedTag>& tags) {
  TagsByCode result;
  for (const DetectedTag& tag : tags) {
    if (!result.once.emplace(tag.code, tag).second) result.twice.insert(tag.code);
  }
  for (const int code : result.twice) result.once.erase(code);
  return result;
}

std::vector<TagsByCode> detect_tags(const std::vector<GreyPicture>& pictures,
                                    const std::vector<CameraModel>& cameras, int threads) {
  std::vector<TagsByCode> tags(pictures.size());
  parallel_for(static_cast<int>(pictures.size()), threads, [&](int c) {
    const auto picture = static_cast<std::size_t>(c);
    tags[picture] = tags_by_code(detect_tags(pictures[picture]));
    for (auto& [code, tag] : tags[picture].once) tag.corners = tag.corners_by(cameras[picture]);
  });
  return tags;
}

GreyPicture tag_cells(int code) {
  PLIANT_ASSERT(code >= 0 && code < kTagCodes, "a code of the family");
  const TagFamily family = tag_family();
  const TagImage image(apriltag_to_image(family.get(), code), image_u8_destroy);
  const int border = (family->total_width - family->width_at_border) / 2;
  GreyPicture cells(family->width_at_border, family->width_at_border);
  for (int row = 0; row < cells.rows(); ++row) {
    for (int column = 0; column < cells.cols(); ++column) {
      const auto place = (row + border) * image->stride + column + border;
      cells(row, column) = image->buf[place] > 0 ? 1.0f : 0.0f;
    }
  }
  return cells;
}

}  // namespace pliant
