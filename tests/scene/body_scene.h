#pragma once

#include <string>

#include <fmt/format.h>

#include "pliant/material/material_file.h"
#include "pliant/scene/simulation.h"

#include "scene/scene_text.h"

namespace pliant::test {

/// Files of bodies, and a scene beside them.
class BodyScene {
 public:
  BodyScene() { folder_.write("jersey.json", kJersey); }

  /// An OBJ file in mm of a ball, open at its lower pole.
  void write_ball(const std::string& file, double radius, double height = 0) const {
    constexpr int kAround = 24, kRings = 12;
    std::string text;
    const auto place = [&](double down, double around) {
      return fmt::format("v {} {} {}\n", radius * std::sin(down) * std::cos(around),
                         radius * std::sin(down) * std::sin(around),
                         radius * std::cos(down) + height);
    };
    text += place(0, 0);
    for (int ring = 1; ring < kRings; ++ring) {
      for (int i = 0; i < kAround; ++i) {
        text += place(M_PI * ring / kRings, 2 * M_PI * i / kAround);
      }
    }
    const auto number = [](int ring, int i) { return 2 + (ring - 1) * kAround + i % kAround; };
    for (int i = 0; i < kAround; ++i) {
      text += fmt::format("f 1 {} {}\n", number(1, i), number(1, i + 1));
      for (int ring = 1; ring + 1 < kRings; ++ring) {
        text += fmt::format("f {} {} {} {}\n", number(ring, i), number(ring + 1, i),
                            number(ring + 1, i + 1), number(ring, i + 1));
      }
    }
    folder_.write(file, text);
  }

  /// An OBJ file in mm of a square that lies level, of two faces.
  void write_plate(const std::string& file, double side, double height) const {
    const double half = side / 2;
    folder_.write(file, fmt::format("v {0} {0} {2}\nv {1} {0} {2}\nv {1} {1} {2}\nv {0} {1} {2}\n"
                                    "f 1 2 3\nf 1 3 4\n",
                                    -half, half, height));
  }

  void write(const std::string& file, const std::string& text) const { folder_.write(file, text); }

  Scene read(const std::string& text) const {
    return read_scene(folder_.write("scene.yaml", "pliant: scene/1\n" + text));
  }
  Simulation simulated(const std::string& text) const {
    return Simulation(read(text), read_material(PLIANT_SOURCE_DIR "/examples/assumed-cloth.json"));
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace pliant::test
