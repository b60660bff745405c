#include "pliant/capture/dic_views.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/errors.h"
#include "pliant/capture/bundle_adjustment.h"
#include "pliant/capture/calibration_file.h"
#include "pliant/capture/frame_moments.h"
#include "pliant/capture/pixel_fields.h"
#include "pliant/measurement/data_source.h"

namespace pliant {
namespace {

Quadrilateral read_corners(const Value& value) {
  const std::vector<Value> items = value.items();
  if (items.size() != 4) {
    value.fail("are not four places",
               "[column, row] of the sample's corners, from that of least u and v along weft and "
               "around");
  }
  Quadrilateral corners;
  for (Eigen::Index k = 0; k < 4; ++k) {
    corners.col(k) = read_pixel(items[static_cast<std::size_t>(k)]);
  }
  return corners;
}

constexpr const char* kTogether =
    "pictures that all cameras have taken together: one of each for every frame";

void read_files(const Value& value, DicViews& views) {
  Fields fields = value.fields();
  for (const auto& [name, files] : fields.all()) {
    views.names.push_back(name);
    views.files.push_back(read_data_source(files).files);
    const std::size_t own = views.files.back().size(), first = views.files.front().size();
    if (own != first) {
      files.fail(fmt::format("has {} pictures, and {} has {}", own, views.names.front(), first),
                 kTogether);
    }
    require_same_moments(files, views.files.back(), views.files.front(), kTogether);
  }
  if (views.names.size() < 2) {
    value.fail("names less than two cameras", "two or more; of one, see `labels` and `scale`");
  }
}

}  // namespace

DicViews read_views(const Value& value) {
  Fields fields = value.fields();
  DicViews views;
  const Value calibration = fields.require("calibration");
  views.calibration = {path_beside(calibration, kExpectedCalibration), "", calibration.location()};
  read_files(fields.require("pictures"), views);
  views.corners = read_corners(fields.require("corners"));
  read_patches(fields, views.patch, views.step);
  fields.finish();
  return views;
}

void refuse_calibration(const std::string& file, const std::string& why) {
  throw InputError(
      {file, 0, "views.calibration"}, "does not fit the first pictures: " + why,
      "a calibration of these cameras where they stand now, none exchanged, moved or refocused");
}

void resolve_views(DicViews& views) {
  const CalibratedRig rig = read_calibration(views.calibration.file);
  std::vector<Eigen::Index> numbers;  // of the cameras among those of the calibration
  for (const std::string& name : views.names) {
    const auto found = std::ranges::find(rig.names, name);
    if (found == rig.names.end()) {
      throw InputError(views.calibration.where, fmt::format("has no camera {}", quoted_value(name)),
                       fmt::format("the names of its cameras: {}", fmt::join(rig.names, ", ")));
    }
    const auto camera = found - rig.names.begin();
    views.cameras.push_back(rig.cameras[static_cast<std::size_t>(camera)]);
    for (int k = 0; k < kCameraNumbers; ++k) numbers.push_back(kCameraNumbers * camera + k);
  }
  views.covariance = rig.covariance(numbers, numbers);
  views.down = rig.gravity;
}

}  // namespace pliant
