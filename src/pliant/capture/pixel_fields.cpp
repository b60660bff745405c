#include "pliant/capture/pixel_fields.h"

namespace pliant {

Eigen::Vector2d read_pixel(const Value& value) {
  const std::vector<Value> items = value.items();
  if (items.size() != 2) value.fail("is no place", "[column, row] of a pixel");
  return {items[0].number(), items[1].number()};
}

void read_patches(Fields& fields, int& patch, int& step) {
  constexpr int kLeast = 9, kMost = 201;
  if (auto v = fields.optional("patch")) {
    patch = v->integer(kLeast, kMost);
    if (patch % 2 == 0) v->fail("is even", "an odd number of pixels: a patch has a middle");
  }
  if (auto v = fields.optional("step")) step = v->integer(1, kMost);
}

}  // namespace pliant
