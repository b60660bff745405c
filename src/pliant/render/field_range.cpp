#include "pliant/render/field_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace pliant {
namespace {

constexpr double kOutside = 0.02;        // of the values, on each side
constexpr double kMostKept = 4'000'000;  // values: 32 MB

/// Multiples of the golden ratio are spread evenly, so that no pattern of a mesh's vertices decides
/// which are kept.
bool is_kept(std::uint64_t number, double part) {
  const double place = static_cast<double>(number) * (std::numbers::phi - 1);
  return place - std::floor(place) < part;
}

double element_at(std::vector<double>& values, double place) {
  const auto nth = values.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace

void FieldRange::add(const Eigen::VectorXd& values) {
  if (seen_ == 0) {
    const double all = static_cast<double>(frames_) * static_cast<double>(values.size());
    part_kept_ = std::min(1.0, kMostKept / std::max(all, 1.0));
  }
  for (const double value : values) {
    if (is_kept(seen_++, part_kept_) && std::isfinite(value)) kept_.push_back(value);
    if (!std::isfinite(value)) continue;
    lowest_ = std::min(lowest_, value);
    highest_ = std::max(highest_, value);
  }
}

std::optional<ShownRange> FieldRange::shown() const {
  if (!(lowest_ <= highest_)) return std::nullopt;
  const ShownRange whole{lowest_, highest_, false};
  if (kept_.empty()) return whole;
  std::vector<double> values = kept_;
  const double last = static_cast<double>(values.size() - 1);
  const double low = element_at(values, std::floor(kOutside * last));
  const double high = element_at(values, std::ceil((1 - kOutside) * last));
  if (!(low < high)) return whole;
  return ShownRange{low, high, low > lowest_ || high < highest_};
}

}  // namespace pliant
