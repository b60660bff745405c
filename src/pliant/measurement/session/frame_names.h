#pragma once

#include <filesystem>
#include <string>

#include "pliant/io/fields.h"

namespace pliant {

/// What the frames of a session are called: a file name with the frame's number in it.
class FrameNames {
 public:
  /// `frames/%04d.ply`: one `%d` or `%0Nd` in the name of a PLY file.
  /// @throws InputError
  static FrameNames read(const Value& value);

  /// The name of a frame, as the pattern has it.
  std::string name(int frame) const;
  /// Its file.
  std::filesystem::path file(int frame) const { return folder_ / name(frame); }

  /// Number of frames: files of such names, numbered from 0.
  /// @throws InputError where there are none, or one is missing between others
  int count() const;

 private:
  std::filesystem::path folder_;  // of the document
  std::string before_, after_;    // the number
  int digits_ = 1;                // at least
  Location where_;
};

}  // namespace pliant
