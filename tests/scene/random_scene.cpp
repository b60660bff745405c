#include "scene/random_scene.h"

#include <cmath>

#include <Eigen/Core>
#include <fmt/format.h>

namespace pliant::test {
namespace {

constexpr double kSide = 60;    // of a sheet, mm
constexpr double kPleat = 7.5;  // deep, mm

}  // namespace

RandomScene::RandomScene(std::uint64_t seed) : random_(seed) {
  folder_.write("needles.obj", needles());
  folder_.write("pleats.obj", pleats());
  text_ = "cloth:\n";
  add_sheets();
  add_clips();
  add_bodies();
  text_ += fmt::format("contact: {{thickness: 0.5 mm, friction: {}}}\n", chance(0.5) ? 0 : 0.4);
  const double step = chance(0.3) ? 2 : chance(0.5) ? 5 : 15;
  text_ += fmt::format("time: {{step: {} ms, duration: {} ms, adaptive: {}}}\n", step, 8 * step,
                       chance(0.2));
}

/// An OBJ file in mm of a sheet, some of whose vertices are pulled onto the diagonals beside them,
/// but for a little.
std::string RandomScene::needles() {
  constexpr int kNodes = 5;
  constexpr double kCell = kSide / (kNodes - 1);
  const double left = std::pow(10, random_.uniform(-3, -1));
  std::string text;
  for (int j = 0; j < kNodes; ++j) {
    for (int i = 0; i < kNodes; ++i) {
      const bool pulled = i % 3 == 1 && j % 3 == 1;
      const double shift = pulled ? (1 - left) * kCell / 2 : 0;
      text += fmt::format("v {} {} 0\n", i * kCell - shift, j * kCell + shift);
    }
  }
  for (int j = 0; j + 1 < kNodes; ++j) {
    for (int i = 0; i + 1 < kNodes; ++i) {
      const int low = 1 + j * kNodes + i, high = low + kNodes;
      text += fmt::format("f {0} {1} {3}\nf {0} {3} {2}\n", low, low + 1, high, high + 1);
    }
  }
  return text;
}

/// An OBJ file in mm of a sheet that is flat at rest, in pleats that hardly open.
std::string RandomScene::pleats() {
  constexpr int kAlong = 9, kAcross = 4;  // vertices
  static_assert(kPleat * (kAlong - 1) == kSide);
  const double opening = M_PI / 180 * std::pow(10, random_.uniform(0, 1.5));
  const double way = kPleat * std::sin(opening / 2), height = kPleat * std::cos(opening / 2);
  std::string text;
  for (int j = 0; j < kAcross; ++j) {
    const double y = kSide * j / (kAcross - 1);
    for (int i = 0; i < kAlong; ++i) {
      text += fmt::format("v {} {} {}\nvt {} {}\n", kSide / 2 + way * (i - (kAlong - 1) / 2.), y,
                          i % 2 * height, kPleat * i, y);
    }
  }
  for (int j = 0; j + 1 < kAcross; ++j) {
    for (int i = 0; i + 1 < kAlong; ++i) {
      const int low = 1 + j * kAlong + i, high = low + kAlong;
      text += fmt::format("f {0}/{0} {1}/{1} {3}/{3}\nf {0}/{0} {3}/{3} {2}/{2}\n", low, low + 1,
                          high, high + 1);
    }
  }
  return text;
}

std::string RandomScene::mesh() {
  if (chance(0.2)) {
    ingredients_.insert(kPleats);
    top_ += 1e-3 * kPleat;
    return "{file: pleats.obj, unit: mm}";
  }
  if (chance(0.3)) {
    ingredients_.insert(kNeedles);
    return "{file: needles.obj, unit: mm, rest: shape}";
  }
  const char* nodes = chance(0.4) ? "4x4" : chance(0.5) ? "2x12" : "9x3";
  return fmt::format("{{grid: {0} mm x {0} mm, nodes: {1}}}", kSide, nodes);
}

// One in four times fast.
std::string RandomScene::velocity() {
  const bool fast = chance(0.25);
  if (fast) ingredients_.insert(kFast);
  const double along = random_.uniform(-1, 1), across = random_.uniform(-1, 1);
  const double down = fast ? random_.uniform(5, 30) : random_.uniform(0, 5);
  return fmt::format("velocity: [{}, {}, {}]", along, across, chance(0.5) ? down : -down);
}

void RandomScene::add_sheets() {
  sheets_ = 1 + static_cast<int>(random_.uniform(0, 3));
  for (int k = 0; k < sheets_; ++k) {
    if (k > 0) {
      const double gap = std::pow(10, random_.uniform(-4.3, -2.7));
      if (gap < 1e-4) ingredients_.insert(kThin);
      top_ += gap;
    }
    const double height = top_;
    text_ += fmt::format("  - {{name: sheet{}, mesh: {}, material: jersey.json,\n", k, mesh());
    text_ += fmt::format(
        "     place: {{rotate: {{axis: [0, 0, 1], angle: {} deg}}, translate: [{}, {}, {}]}}",
        random_.uniform(-20, 20), random_.uniform(-0.04, -0.02), random_.uniform(-0.04, -0.02),
        height);
    text_ += (chance(0.5) ? ", " + velocity() : "") + "}\n";
  }
}

/// @param way  that it goes at most along each axis (m)
std::string RandomScene::motion(double way) {
  const double duration = random_.uniform(10, 60);  // ms
  const Eigen::Vector3d shift(random_.uniform(-way, way), random_.uniform(-way, way),
                              random_.uniform(-way, way));
  if (shift.norm() > 5e-3 * duration) ingredients_.insert(kFast);
  return fmt::format(
      "motion: {{pivot: [0, 0, 0], keyframes: [{{time: 0 s}}, {{time: {} ms, translate: [{}, {}, "
      "{}],\n     rotate: {{axis: [{}, {}, 1], angle: {} deg}}}}]}}",
      duration, shift.x(), shift.y(), shift.z(), random_.uniform(-1, 1), random_.uniform(-1, 1),
      random_.uniform(-180, 180));
}

// Of the first and the last sheet, where they are wide enough for two.
void RandomScene::add_clips() {
  if (chance(0.4)) return;
  text_ += "clips:\n";
  for (const int sheet : {0, sheets_ - 1}) {
    const bool first = sheet == 0;
    text_ += fmt::format("  - {{name: bar{0}, cloth: sheet{0}, mass: 2 g,\n", first ? 0 : sheet);
    text_ += fmt::format("     within: {{box: {{low: [-1, {}, -1], high: [1, {}, 1]}}}}",
                         first ? -1 : 0.055, first ? 0.005 : 1);
    const bool free = chance(0.4);
    ingredients_.insert(free ? kFreeClips : kLedClips);
    text_ += free ? ", free: true}\n" : ",\n     " + motion(0.05) + "}\n";
    if (sheets_ == 1) break;
  }
}

void RandomScene::add_bodies() {
  const int count = static_cast<int>(random_.uniform(0, 3));
  if (count > 0) text_ += "obstacles:\n";
  for (int k = 0; k < count; ++k) {
    const double height = k == 0 ? top_ + 0.03 : -0.03;
    const double x = random_.uniform(-0.02, 0.02), y = random_.uniform(-0.02, 0.02);
    const double kind = random_.uniform(0, 4);
    std::string shape;
    if (kind < 1) {
      shape = fmt::format("sphere: {{centre: [{}, {}, {}], radius: 15 mm}}", x, y, height);
    } else if (kind < 2) {
      shape = fmt::format(
          "capsule: {{from: [-0.03, {0}, {2}], to: [0.03, {1}, {2}], radius: 5 mm}}", x, y, height);
    } else if (kind < 3) {
      shape = fmt::format("box: {{centre: [{}, {}, {}], size: [0.02, 0.03, 0.03]}}", x, y, height);
    } else {
      folder_.write_ball(fmt::format("ball{}.obj", k), 15, 1e3 * height);
      shape = fmt::format("mesh: {{file: ball{}.obj, unit: mm}}", k);
    }
    const bool led = chance(0.7);
    if (led) ingredients_.insert(kLedBodies);
    text_ += fmt::format("  - {{name: body{}, {}, friction: 0.3{}}}\n", k, shape,
                         led ? ",\n     " + motion(0.2) : "");
  }
}

}  // namespace pliant::test
