#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <sys/types.h>

#include "pliant/render/image.h"
#include "pliant/render/render.h"

namespace pliant {

/// A film that ffmpeg makes of pictures as they are drawn. The file is complete or not there.
class MovieFile {
 public:
  /// Starts ffmpeg.
  /// @param file  ends in .mp4; one that is there is replaced by `commit`
  /// @param rate  pictures a second
  /// @throws InputError where there is no ffmpeg, for another kind of file, and for a folder that
  ///         is not there
  MovieFile(std::filesystem::path file, const PictureSize& size, double rate);
  /// Ends ffmpeg and removes what it wrote, unless it was put into place.
  ~MovieFile();
  MovieFile(const MovieFile&) = delete;
  MovieFile& operator=(const MovieFile&) = delete;

  /// Adds a picture of the size given at the start.
  /// @throws OutputError with what ffmpeg says, where it gave up
  void add(const Image& picture);

  /// Puts the film into place.
  /// @throws OutputError as `add`
  void commit();

 private:
  void start(const PictureSize& size, double rate);
  void end();
  [[noreturn]] void fail();

  std::filesystem::path file_;
  std::filesystem::path part_;  // what ffmpeg writes to
  std::FILE* messages_;         // of ffmpeg
  std::FILE* pictures_ = nullptr;
  pid_t process_ = 0;
  int status_ = 0;
};

}  // namespace pliant
