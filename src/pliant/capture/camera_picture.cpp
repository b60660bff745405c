#include "pliant/capture/camera_picture.h"

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {

GreyPicture read_camera_picture(const ReadPicture& read_picture, const std::filesystem::path& file,
                                const CameraModel& camera) {
  GreyPicture read = read_picture(file);
  if (read.rows() == camera.rows && read.cols() == camera.columns) return read;
  throw InputError({file.string()},
                   fmt::format("is {} x {} pixels, and those of its camera's calibration {} x {}",
                               read.cols(), read.rows(), camera.columns, camera.rows),
                   "pictures of that camera, neither cut nor turned nor made smaller");
}

}  // namespace pliant
