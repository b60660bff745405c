// `import` of photographs by a program that was built without OpenCV, GdkPixbuf or LibTIFF; CMake
// takes this file in place of import_photos.cpp then.

#include "pliant/base/errors.h"

#include "apps/pliant/import_photos.h"

namespace pliant {

ImportedStudy import_photo_files(const std::vector<std::string>& files, const PhotoArguments&) {
  throw InputError(
      {files.front()},
      "is a photograph; this program was built without OpenCV, GdkPixbuf or LibTIFF",
      "a build where they are installed (libopencv-imgproc-dev, libgdk-pixbuf-2.0-dev, "
      "libtiff-dev)");
}

ReadPicture picture_reader() { return {}; }

}  // namespace pliant
