#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace pliant {

/// Values of the first and the last colour of a field.
struct ShownRange {
  double low = 0;
  double high = 0;
  bool percentiles = false;  ///< these are the 2nd and the 98th percentile, and values lie beyond
};

/// Gathers the values of a field over many frames, of which a few must not make all others look the
/// same: beside a pin or a clip, strain is many times that of the rest.
class FieldRange {
 public:
  /// @param frames  how many frames are to come; of long simulations every frame gives a sample
  explicit FieldRange(std::size_t frames) : frames_(frames) {}

  /// Adds the values of a frame; what is not finite is left out.
  void add(const Eigen::VectorXd& values);

  /// From the 2nd to the 98th percentile, or all values where these are one; none without values.
  std::optional<ShownRange> shown() const;

 private:
  std::size_t frames_;
  std::uint64_t seen_ = 0;
  double part_kept_ = 1;
  std::vector<double> kept_;
  double lowest_ = std::numeric_limits<double>::infinity();
  double highest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace pliant
