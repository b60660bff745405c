#include "pliant/render/drawing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "pliant/geometry/stroke_font.h"

namespace pliant {
namespace {

constexpr float kStrokeOfCapHeight = 0.135F;
constexpr float kRim = 2;  // pixels
constexpr double kRimCoverage = 0.75;
constexpr Pixel kRimInk = {255, 255, 255};

float distance_to(const Segment& segment, const Eigen::Vector2f& point) {
  const Eigen::Vector2f along = segment.to - segment.from;
  const float length2 = along.squaredNorm();
  const float t =
      length2 > 0 ? std::clamp((point - segment.from).dot(along) / length2, 0.0F, 1.0F) : 0.0F;
  return (segment.from + t * along - point).norm();
}

/// How much of each pixel of a rectangle a drawing covers: lines that overlap count once.
class Coverage {
 public:
  Coverage(const Eigen::Vector2f& low, const Eigen::Vector2f& high)
      : left_(static_cast<int>(std::floor(low.x()))),
        top_(static_cast<int>(std::floor(low.y()))),
        width_(static_cast<int>(std::ceil(high.x())) - left_ + 1),
        height_(static_cast<int>(std::ceil(high.y())) - top_ + 1),
        values_(static_cast<size_t>(width_) * static_cast<size_t>(height_)) {}

  void add(const Segment& segment, float half_width) {
    const float reach = half_width + 1;
    const Eigen::Vector2f low = segment.from.cwiseMin(segment.to);
    const Eigen::Vector2f high = segment.from.cwiseMax(segment.to);
    const int first_x = std::max(0, static_cast<int>(low.x() - reach) - left_);
    const int first_y = std::max(0, static_cast<int>(low.y() - reach) - top_);
    const int last_x = std::min(width_ - 1, static_cast<int>(high.x() + reach) - left_);
    const int last_y = std::min(height_ - 1, static_cast<int>(high.y() + reach) - top_);
    for (int y = first_y; y <= last_y; ++y) {
      for (int x = first_x; x <= last_x; ++x) {
        const Eigen::Vector2f centre(static_cast<float>(x + left_) + 0.5F,
                                     static_cast<float>(y + top_) + 0.5F);
        float& value = at(x, y);
        value = std::max(value,
                         std::clamp(half_width + 0.5F - distance_to(segment, centre), 0.0F, 1.0F));
      }
    }
  }

  void lay_over(Image& image, const Pixel& ink, double strength) {
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (at(x, y) > 0) blend(image, x + left_, y + top_, ink, strength * double(at(x, y)));
      }
    }
  }

 private:
  float& at(int x, int y) {
    return values_[static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x)];
  }

  int left_, top_, width_, height_;
  std::vector<float> values_;
};

void draw_segments(Image& image, const std::vector<Segment>& segments, float half_width,
                   const Pixel& ink, double strength) {
  if (segments.empty()) return;
  Eigen::Vector2f low = segments.front().from, high = low;
  for (const Segment& segment : segments) {
    low = low.cwiseMin(segment.from).cwiseMin(segment.to);
    high = high.cwiseMax(segment.from).cwiseMax(segment.to);
  }
  const Eigen::Vector2f reach = Eigen::Vector2f::Constant(half_width + 1);
  Coverage coverage(low - reach, high + reach);
  for (const Segment& segment : segments) coverage.add(segment, half_width);
  coverage.lay_over(image, ink, strength);
}

/// Upright in the picture, whose y points down, beginning at `base`.
std::vector<Segment> placed(std::vector<Segment> segments, const Eigen::Vector2f& base) {
  for (Segment& segment : segments) {
    segment.from = base + Eigen::Vector2f(segment.from.x(), -segment.from.y());
    segment.to = base + Eigen::Vector2f(segment.to.x(), -segment.to.y());
  }
  return segments;
}

}  // namespace

void draw_text(Image& image, std::string_view text, const Eigen::Vector2f& base,
               TextAlignment alignment, const TextStyle& style) {
  const float width = text_width(text, style.cap_height);
  const float shift = alignment == TextAlignment::left     ? 0
                      : alignment == TextAlignment::centre ? width / 2
                                                           : width;
  const std::vector<Segment> segments =
      placed(text_segments(text, style.cap_height), base - Eigen::Vector2f(shift, 0));
  const float half_width = std::max(0.5F, kStrokeOfCapHeight * style.cap_height / 2);
  draw_segments(image, segments, half_width + kRim, kRimInk, kRimCoverage);
  draw_segments(image, segments, half_width, style.ink, 1);
}

void draw_line(Image& image, const Eigen::Vector2f& from, const Eigen::Vector2f& to, float width,
               const Pixel& ink) {
  draw_segments(image, {{from, to}}, width / 2, ink, 1);
}

}  // namespace pliant
