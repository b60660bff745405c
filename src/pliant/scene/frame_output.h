#pragma once

#include <algorithm>
#include <vector>

#include "pliant/io/fields.h"
#include "pliant/scene/stepping.h"

namespace pliant {

enum class FrameFormat { ply, vtu, pc2 };

/// Values at the vertices that frames carry beside positions.
enum class FrameField {
  strain,    ///< of every component
  friction,  ///< stress of internal friction of every component
};

/// `output` of a scene/1 file.
struct FrameOutput {
  double every = 0;  ///< s, from one frame to the next; frames stand at 0, every, 2 every, ...
  std::vector<FrameFormat> formats{FrameFormat::ply};
  std::vector<FrameField> fields;

  bool has(FrameFormat format) const {
    return std::find(formats.begin(), formats.end(), format) != formats.end();
  }
};

/// @param value  nothing where the scene says nothing of output
/// @throws InputError, also for frames that fall between steps of constant size
FrameOutput read_frame_output(const std::optional<Value>& value, const Stepping& stepping);

/// Steps of constant size from one frame to the next.
int steps_per_frame(const FrameOutput& output, const Stepping& stepping);

}  // namespace pliant
