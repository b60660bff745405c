#include "pliant/study/virtual_cameras.h"

#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

/// A share of white, up to a tenth.
double read_share(const Value& value) {
  constexpr double kMost = 0.1;
  const double share = value.quantity_from_zero(Dimension::fraction);
  if (share > kMost) value.fail("drowns the picture", "at most 10 %");
  return share;
}

}  // namespace

VirtualCameras read_virtual_cameras(const Value& value) {
  constexpr double kSteepest = 1.0;      // rad
  constexpr double kWidestBlur = 5;      // pixels
  constexpr double kNearest = 0.05;      // m
  constexpr double kLatestStart = 3600;  // s
  Fields fields = value.fields();
  VirtualCameras cameras;
  if (auto v = fields.optional("count")) cameras.count = v->integer(2, 8);
  if (auto v = fields.optional("picture")) {
    std::tie(cameras.columns, cameras.rows) = read_counts(*v, 64, 8192);
  }
  if (auto v = fields.optional("pixel")) cameras.pixel = v->positive_quantity(Dimension::length);
  if (auto v = fields.optional("distance")) {
    cameras.distance = v->positive_quantity(Dimension::length);
    if (cameras.distance < kNearest) v->fail("is within the sheet's reach", "at least 50 mm");
  }
  if (auto v = fields.optional("angle")) {
    cameras.angle = v->positive_quantity(Dimension::angle);
    if (cameras.angle > kSteepest) v->fail("is too flat", "at most 57 deg off the sheet's normal");
  }
  if (auto v = fields.optional("blur")) {
    cameras.blur = v->number();
    if (!(cameras.blur >= 0 && cameras.blur <= kWidestBlur)) {
      v->fail("is no blur of a lens", "0 to 5 pixels");
    }
  }
  if (auto v = fields.optional("read_noise")) cameras.read_noise = read_share(*v);
  if (auto v = fields.optional("shot_noise")) cameras.shot_noise = read_share(*v);
  if (auto v = fields.optional("bits")) cameras.bits = v->integer(6, 16);
  if (auto v = fields.optional("gloss")) {
    cameras.gloss = v->quantity_from_zero(Dimension::fraction);
    if (cameras.gloss > 1) v->fail("is more than the light", "at most 100 %");
  }
  if (auto v = fields.optional("cell_noise")) {
    cameras.cell_noise = v->quantity_from_zero(Dimension::force);
  }
  if (auto v = fields.optional("log_start")) {
    cameras.log_start = v->quantity_from_zero(Dimension::time);
    if (cameras.log_start > kLatestStart) v->fail("is late", "at most an hour");
  }
  if (auto v = fields.optional("boards")) cameras.boards = v->integer(5, 200);
  fields.finish();
  return cameras;
}

}  // namespace pliant
