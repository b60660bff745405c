#include "pliant/scene/keyframe_fields.h"

#include <fmt/format.h>

#include "pliant/io/vector_fields.h"
#include "pliant/scene/rotation_fields.h"

namespace pliant {
namespace {

Interpolation read_interpolation(Fields& fields) {
  const auto value = fields.optional("interpolation");
  const bool smooth = value && value->choice({"linear", "smooth"}) == "smooth";
  return smooth ? Interpolation::smooth : Interpolation::linear;
}

/// Reads the time of the next keyframe.
void read_time(Fields& keyframe, std::vector<double>& times) {
  const Value value = keyframe.require("time");
  const double time = value.quantity(Dimension::time);
  if (!times.empty() && time <= times.back()) {
    value.fail(fmt::format("{} comes after {}: keyframes out of order",
                           format_quantity(time, Dimension::time),
                           format_quantity(times.back(), Dimension::time)),
               "times that strictly increase");
  }
  times.push_back(time);
}

/// The list `keyframes`, which is not empty.
std::vector<Value> read_keyframes(Fields& fields) {
  const Value list = fields.require("keyframes");
  std::vector<Value> keyframes = list.items();
  if (keyframes.empty()) list.fail("is empty", "at least one keyframe");
  return keyframes;
}

}  // namespace

Motion read_motion(const Value& value) {
  Fields fields = value.fields();
  Motion motion;
  if (auto v = fields.optional("pivot")) motion.pivot = read_vector(*v);
  motion.interpolation = read_interpolation(fields);
  Rotation before;
  for (const Value& item : read_keyframes(fields)) {
    Fields keyframe = item.fields();
    read_time(keyframe, motion.times);
    MotionKeyframe read;
    Rotation rotation;
    if (auto v = keyframe.optional("translate")) read.translation = read_vector(*v);
    if (auto v = keyframe.optional("rotate")) rotation = read_rotation(*v);
    read.rotation = rotation.quaternion();
    if (!motion.keyframes.empty()) read.turn = turn_between(before, rotation);
    before = rotation;
    motion.keyframes.push_back(read);
    keyframe.finish();
  }
  fields.finish();
  return motion;
}

KeyframedVector read_keyframed_vector(const Value& value) {
  if (!value.is_mapping()) return KeyframedVector::constant(read_vector(value));
  Fields fields = value.fields();
  KeyframedVector vector;
  vector.interpolation = read_interpolation(fields);
  for (const Value& item : read_keyframes(fields)) {
    Fields keyframe = item.fields();
    read_time(keyframe, vector.times);
    vector.values.push_back(read_vector(keyframe.require("value")));
    keyframe.finish();
  }
  fields.finish();
  return vector;
}

}  // namespace pliant
