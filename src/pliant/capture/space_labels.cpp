#include "pliant/capture/space_labels.h"

#include <algorithm>
#include <iterator>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/capture/sighted_pose.h"
#include "pliant/capture/triangulation.h"

namespace pliant {
namespace {

constexpr double kCornerNoise = 0.03;  // pixels
constexpr double kOff = 0.5;           // what calibration and corners miss is less (pixels)

std::optional<Eigen::Matrix<double, 3, 4>> corners_of(const std::vector<CameraModel>& cameras,
                                                      const std::vector<TagsByCode>& tags,
                                                      int code) {
  Eigen::Matrix<double, 3, 4> corners;
  for (Eigen::Index k = 0; k < 4; ++k) {
    std::vector<Sighting> sightings;
    for (std::size_t c = 0; c < cameras.size(); ++c) {
      const auto tag = tags[c].once.find(code);
      if (tag == tags[c].once.end()) continue;
      sightings.push_back({&cameras[c], tag->second.corners.col(k), kCornerNoise});
    }
    const auto point = triangulate(sightings);
    if (!point) return std::nullopt;
    corners.col(k) = point->point;
  }
  return corners;
}

}  // namespace

SpaceLabels::SpaceLabels(const DicFile& dic, const std::vector<GreyPicture>& first,
                         const SeenTags& tags)
    : dic_(dic) {
  require_labels(first, tags);
  first_ = corners(tags);
  for (const DicClip& clip : dic_.clips) {
    for (const int code : clip.labels) {
      if (first_.contains(code)) continue;
      refuse_calibration(
          dic_.file, fmt::format("lines of sight to the label {} of the clip {} do not meet", code,
                                 clip.name));
    }
  }
}

void SpaceLabels::require_labels(const std::vector<GreyPicture>& first,
                                 const SeenTags& tags) const {
  constexpr const char* kOnce =
      "each label once in a picture, whole, in focus and with some white around it";
  const auto& files = dic_.views->files;
  const std::vector<int> codes = dic_.label_codes();
  for (std::size_t c = 0; c < first.size(); ++c) {
    const bool shows_none = tags[c].once.empty() && tags[c].twice.empty();
    if (shows_none) require_unmirrored(first[c], codes, files[c].front().string());
  }
  for (const DicClip& clip : dic_.clips) {
    for (const int code : clip.labels) {
      int cameras = 0;
      for (std::size_t c = 0; c < tags.size(); ++c) {
        cameras += tags[c].once.contains(code);
        if (!tags[c].twice.contains(code)) continue;
        throw InputError(
            {files[c].front().string()},
            fmt::format("shows the label {} of the clip {} more than once", code, clip.name),
            kOnce);
      }
      if (cameras >= 2) continue;
      throw InputError(
          {files.front().front().string()},
          fmt::format("the label {} of the clip {} is not seen by two cameras in their first "
                      "pictures",
                      code, clip.name),
          kOnce);
    }
  }
}

std::map<int, SpaceLabels::Corners> SpaceLabels::corners(const SeenTags& tags) const {
  std::map<int, Corners> found;
  for (const DicClip& clip : dic_.clips) {
    for (const int code : clip.labels) {
      if (const auto seen = corners_of(dic_.views->cameras, tags, code)) found[code] = *seen;
    }
  }
  return found;
}

LabelledMotions SpaceLabels::motions(const SeenTags& seen) {
  const std::map<int, Corners> now = corners(seen);
  LabelledMotions motions;
  for (const DicClip& clip : dic_.clips) {
    motions.clips.emplace_back();
    if (clip.labels.empty()) continue;
    if (std::ranges::none_of(clip.labels, [&](int code) { return now.contains(code); })) {
      motions.missing = missing(clip, seen);
      return motions;
    }
    motions.clips.back() = pose_of(clip.labels, now, seen);
  }
  for (std::size_t i = 0; i < motions.clips.size(); ++i) {
    if (motions.clips[i]) note_misses(dic_.clips[i].labels, *motions.clips[i], seen);
  }
  return motions;
}

std::string SpaceLabels::missing(const DicClip& clip, const SeenTags& tags) const {
  for (const int code : clip.labels) {
    for (std::size_t c = 0; c < tags.size(); ++c) {
      if (!tags[c].twice.contains(code)) continue;
      return fmt::format("shows the label {} of the clip {} more than once to {}", code, clip.name,
                         dic_.views->names[c]);
    }
  }
  return fmt::format("shows no label of the clip {} to two cameras", clip.name);
}

Pose SpaceLabels::pose_of(const std::vector<int>& codes, const std::map<int, Corners>& now,
                          const SeenTags& tags) const {
  std::vector<int> both;
  std::ranges::copy_if(codes, std::back_inserter(both),
                       [&](int code) { return now.contains(code); });
  Eigen::Matrix3Xd from(3, 4 * std::ssize(both)), to(3, from.cols());
  for (Eigen::Index i = 0; i < std::ssize(both); ++i) {
    from.middleCols<4>(4 * i) = first_.at(both[static_cast<std::size_t>(i)]);
    to.middleCols<4>(4 * i) = now.at(both[static_cast<std::size_t>(i)]);
  }
  const Eigen::Matrix4d rigid = Eigen::umeyama(from, to, /*with_scaling=*/false);
  const Pose start{Eigen::Quaterniond(Eigen::Matrix3d(rigid.topLeftCorner<3, 3>())).normalized(),
                   rigid.topRightCorner<3, 1>()};
  std::vector<BodySighting> sightings;
  for (const int code : codes) {
    for (std::size_t c = 0; c < tags.size(); ++c) {
      const auto tag = tags[c].once.find(code);
      if (tag == tags[c].once.end()) continue;
      for (Eigen::Index k = 0; k < 4; ++k) {
        sightings.push_back(
            {&dic_.views->cameras[c], first_.at(code).col(k), tag->second.corners.col(k)});
      }
    }
  }
  return sighted_pose(sightings, start, kCornerNoise);
}

void SpaceLabels::note_misses(const std::vector<int>& codes, const Pose& pose,
                              const SeenTags& tags) {
  for (const int code : codes) {
    std::vector<LabelSightings>& sightings = sightings_[code];
    sightings.resize(tags.size());
    for (std::size_t c = 0; c < tags.size(); ++c) {
      const auto tag = tags[c].once.find(code);
      if (tag == tags[c].once.end()) continue;
      double miss = 0;
      for (Eigen::Index k = 0; k < 4; ++k) {
        const auto shown = dic_.views->cameras[c].project(pose.apply(first_.at(code).col(k)));
        if (shown) miss = std::max(miss, (tag->second.corners.col(k) - *shown).norm());
      }
      ++sightings[c].seen;
      sightings[c].off += miss > kOff;
      sightings[c].worst = std::max(sightings[c].worst, miss);
    }
  }
}

SpaceLabels::OffLabels SpaceLabels::off_labels(const DicClip& clip,
                                               std::optional<std::size_t> camera) const {
  OffLabels count;
  for (const int code : clip.labels) {
    const int before = count.off;
    for (std::size_t c = 0; c < dic_.views->cameras.size(); ++c) {
      const LabelSightings* label = camera.value_or(c) == c ? sightings_of(code, c) : nullptr;
      count.seen += label != nullptr;
      count.off += label && label->is_off();
    }
    count.labels += count.off > before;
  }
  return count;
}

const LabelSightings* SpaceLabels::sightings_of(int code, std::size_t camera) const {
  const auto found = sightings_.find(code);
  if (found == sightings_.end() || found->second[camera].seen == 0) return nullptr;
  return &found->second[camera];
}

// Two labels or more are elsewhere than it is, for most cameras that see its labels.
bool SpaceLabels::is_torn(const DicClip& clip) const {
  const OffLabels count = off_labels(clip, std::nullopt);
  return count.labels >= 2 && 2 * count.off > count.seen;
}

// It sees most labels elsewhere than other cameras do, of two clips or more.
bool SpaceLabels::is_moved(std::size_t camera) const {
  int seen = 0, off = 0, clips = 0;
  for (const DicClip& clip : dic_.clips) {
    const OffLabels own = off_labels(clip, camera);
    seen += own.seen;
    off += own.off;
    clips += own.off > 0;
  }
  return clips >= 2 && 2 * off > seen;
}

std::vector<std::string> SpaceLabels::warnings() const {
  const auto& names = dic_.views->names;
  std::vector<std::string> moved;
  for (std::size_t c = 0; c < names.size(); ++c) {
    if (is_moved(c)) moved.push_back(names[c]);
  }
  if (!moved.empty()) {
    return {fmt::format(
        "{} sees most labels elsewhere than their clips are: was a camera moved, refocused or "
        "stabilised since it was calibrated, or do labels stand at other clips?",
        fmt::join(moved, ", "))};
  }
  std::vector<std::string> warnings;
  for (const DicClip& clip : dic_.clips) {
    if (is_torn(clip)) {
      warnings.push_back(
          fmt::format("the labels {} of the clip {} do not move as one: are they all on it?",
                      fmt::join(clip.labels, ", "), clip.name));
      continue;
    }
    for (const int code : clip.labels) {
      for (std::size_t c = 0; c < names.size(); ++c) {
        const LabelSightings* label = sightings_of(code, c);
        if (!label || !label->is_off()) continue;
        warnings.push_back(fmt::format(
            "{} sees the label {} of the clip {} elsewhere than the clip is, by up to {:.2g} "
            "pixels, in {} of {} frames: keep cords and shadows off it",
            names[c], code, clip.name, label->worst, label->off, label->seen));
      }
    }
  }
  return warnings;
}

}  // namespace pliant
