#pragma once

#include <filesystem>

#include "pliant/capture/camera_model.h"
#include "pliant/capture/point_source.h"

namespace pliant {

/// A picture of a calibrated camera.
/// @throws InputError where it has another size than those by which the camera was calibrated
GreyPicture read_camera_picture(const ReadPicture& read_picture, const std::filesystem::path& file,
                                const CameraModel& camera);

}  // namespace pliant
