#pragma once

#include <cstdint>
#include <string>

#include "pliant/base/random.h"

#include "scene/body_scene.h"

namespace pliant::test {

/// A scene that asks much of contact, drawn at random: one to three sheets that lie close upon each
/// other, of squares, of long triangles or of needles, thrown or held by clips that travel and turn
/// fast, and bodies that hit them.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed);

  Simulation simulation() const { return folder_.simulated(text_); }
  const std::string& text() const { return text_; }
  /// Whether anything is moved from outside.
  bool is_led() const { return led_; }

 private:
  void add_sheets();
  void add_clips();
  void add_bodies();
  std::string mesh();
  std::string needles();
  std::string motion(double way);
  bool chance(double probability) { return random_.uniform(0, 1) < probability; }

  RandomStream random_;
  BodyScene folder_;
  std::string text_;
  int sheets_ = 0;
  bool led_ = false;
};

}  // namespace pliant::test
