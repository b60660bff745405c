// `import` of photographs by a program that was built without OpenCV; CMake takes this file in
// place of import_photos.cpp then.

#include "pliant/base/errors.h"

#include "apps/pliant/import_photos.h"

namespace pliant {

ImportedStudy import_photo_files(const std::vector<std::string>& files, const PhotoArguments&) {
  throw InputError(
      {files.front()}, "is a photograph; this program was built without OpenCV",
      "a build where it is installed (libopencv-imgproc-dev, libopencv-imgcodecs-dev)");
}

}  // namespace pliant
