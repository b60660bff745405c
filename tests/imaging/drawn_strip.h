#pragma once

#include <filesystem>
#include <vector>

#include <Eigen/Core>

namespace pliant::test {

/// How a photograph of a strip is made up; lengths in pixels unless said.
struct DrawnStrip {
  int width = 900, height = 850;
  Eigen::Vector2d clamp{-1, 120};  ///< at which the strip begins
  double pixels_per_metre = 8000;
  double thickness = 9;
  double strip = 0.85, background = 0.15;  ///< brightness
  double gradient = 0.2;  ///< brightness that is added towards the far lower corner
  double noise = 0.02;    ///< standard deviation of the brightness
  bool mirrored = false;  ///< the clamp is on the right
};

/// The profile (m, gravity along -y) of an elastic strip without friction, as densely as a drawing
/// needs it.
std::vector<Eigen::Vector2d> elastic_profile(double rigidity, double weight, double length);

/// Draws strips (profiles in m) one below the other, `apart` pixels from clamp to clamp, and writes
/// the photograph.
void draw_strips(const std::filesystem::path& file,
                 const std::vector<std::vector<Eigen::Vector2d>>& profiles,
                 const DrawnStrip& look = {}, double apart = 0);

/// Makes all columns from one on darker: strip and background keep a share of their brightness.
void draw_shadow(const std::filesystem::path& file, int column, double share);

/// Draws thin bright fibres across the points of a strip, out to both sides of it.
void draw_fibres(const std::filesystem::path& file, const std::vector<Eigen::Vector2d>& pixels);

}  // namespace pliant::test
