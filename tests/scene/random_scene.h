#pragma once

#include <cstdint>
#include <set>
#include <string>

#include "pliant/base/random.h"

#include "scene/body_scene.h"

namespace pliant::test {

/// A scene that asks much of contact, drawn at random: one to three sheets that lie close upon each
/// other, of squares, of long triangles, of needles or in sharp pleats, thrown or held by clips
/// that travel and turn fast, and bodies that hit them.
class RandomScene {
 public:
  explicit RandomScene(std::uint64_t seed);

  Simulation simulation() const { return folder_.simulated(text_); }
  const std::string& text() const { return text_; }
  /// What it asks of contact.
  const std::set<std::string>& ingredients() const { return ingredients_; }
  /// Whether anything is moved from outside.
  bool is_led() const {
    return ingredients_.contains(kLedClips) || ingredients_.contains(kLedBodies);
  }

  static constexpr const char* kThin = "layers less than 0.1 mm apart";
  static constexpr const char* kFast = "cloth or bodies faster than 5 m/s";
  static constexpr const char* kPleats = "pleats of 1 to 30 degrees";
  static constexpr const char* kNeedles = "triangles of 1 to 100 um height";
  static constexpr const char* kFreeClips = "clips that are free";
  static constexpr const char* kLedClips = "clips that are led and turn";
  static constexpr const char* kLedBodies = "bodies that are led and turn";

 private:
  void add_sheets();
  void add_clips();
  void add_bodies();
  std::string mesh();
  std::string needles();
  std::string pleats();
  std::string velocity();
  std::string motion(double way);
  bool chance(double probability) { return random_.uniform(0, 1) < probability; }

  RandomStream random_;
  BodyScene folder_;
  std::string text_;
  std::set<std::string> ingredients_;
  int sheets_ = 0;
  double top_ = 0;  // of the sheets (m)
};

}  // namespace pliant::test
