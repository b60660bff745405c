#include "pliant/capture/region_misses.h"

#include <algorithm>
#include <cmath>

namespace pliant {

double RegionMisses::Region::rms() const { return std::sqrt(squares / (2.0 * count)); }

void RegionMisses::add(const Eigen::Vector2d& pixel, const Eigen::Vector2d& miss) {
  const auto part = [](double along, int pixels, int parts) {
    return std::clamp(static_cast<int>((along + 0.5) / pixels * parts), 0, parts - 1);
  };
  Region& region =
      regions_[place(part(pixel.x(), columns_, kAcross), part(pixel.y(), rows_, kDown))];
  ++region.count;
  region.sum += miss;
  region.squares += miss.squaredNorm();
}

double RegionMisses::largest_rms() const {
  double largest = 0;
  for (const Region& region : regions_) {
    if (region.count > 0) largest = std::max(largest, region.rms());
  }
  return largest;
}

RegionMisses::Region RegionMisses::whole() const {
  Region whole;
  for (const Region& region : regions_) {
    whole.count += region.count;
    whole.sum += region.sum;
    whole.squares += region.squares;
  }
  return whole;
}

}  // namespace pliant
