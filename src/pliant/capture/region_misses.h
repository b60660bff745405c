#pragma once

#include <array>

#include <Eigen/Core>

namespace pliant {

/// By how much a camera misses points on which it agrees with others, by regions of its picture.
/// The means are of the lens or of the camera's place, what scatters around them is noise.
class RegionMisses {
 public:
  static constexpr int kAcross = 8, kDown = 6;

  struct Region {
    int count = 0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    double squares = 0;

    Eigen::Vector2d mean() const { return sum / count; }
    /// Of a coordinate (pixels).
    double rms() const;
  };

  /// @param columns, rows  of the pictures
  RegionMisses(int columns, int rows) : columns_(columns), rows_(rows) {}

  /// @param pixel  where the camera sees a point
  /// @param miss   from where it should see it (pixels)
  void add(const Eigen::Vector2d& pixel, const Eigen::Vector2d& miss);

  const Region& at(int across, int down) const { return regions_[place(across, down)]; }
  Region whole() const;
  /// Of all regions; 0 where nothing was added.
  double largest_rms() const;
  int columns() const { return columns_; }
  int rows() const { return rows_; }

 private:
  static std::size_t place(int across, int down) {
    return static_cast<std::size_t>(down * kAcross + across);
  }

  int columns_, rows_;
  std::array<Region, kAcross * kDown> regions_;
};

}  // namespace pliant
