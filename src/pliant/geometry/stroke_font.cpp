#include "pliant/geometry/stroke_font.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "pliant/base/assert.h"

namespace pliant {
namespace {

/// A character: its width, and its strokes as a path. M x y begins a stroke, L x y goes straight
/// on, C cx cy x y goes on along a quarter of an ellipse whose tangents meet at (cx, cy). Capitals
/// are 10 high, small letters 7.
struct Glyph {
  float width;
  const char* path;
};

constexpr float kCapHeight = 10;
constexpr float kSpacing = 2.7F;  // between characters
constexpr Glyph kUnknown = {5, "M0 0L0 10L5 10L5 0L0 0"};

// From ' ' (32) to '~' (126).
constexpr std::array<Glyph, 95> kGlyphs = {{
    {1.6F, ""},
    {0, "M0 10L0 3M0 0L0 0.1"},
    {2, "M0 10L0 7.4M2 10L2 7.4"},
    {7, "M1.6 0L2.8 10M4.4 0L5.6 10M0 3.2L6.6 3.2M0.6 6.8L7 6.8"},
    {6,
     "M3 11.4L3 -1.4M5.7 8C5.3 10 3 10C0.2 10 0.2 7.6C0.2 5.7 3 5.2C6 4.7 6 2.5C6 0 3 0C0.4 0 0 "
     "2.2"},
    {8,
     "M0.8 0L7.2 10M0 7.8C0 10 1.8 10C3.6 10 3.6 7.8C3.6 5.6 1.8 5.6C0 5.6 0 7.8M4.4 2.2C4.4 "
     "4.4 6.2 4.4C8 4.4 8 2.2C8 0 6.2 0C4.4 0 4.4 2.2"},
    {6.8F,
     "M6.8 0L1.4 6.6C0.6 7.6 0.6 8.2C0.6 10 2.5 10C4.4 10 4.4 8.2C4.4 6.6 2 5.4C0 4.4 0 "
     "2.6C0 0 2.8 0C6 0 6.4 4.4"},
    {0, "M0 10L0 7.4"},
    {1.8F, "M1.8 11.4C0 9 0 4.5C0 0 1.8 -2.4"},
    {1.8F, "M0 11.4C1.8 9 1.8 4.5C1.8 0 0 -2.4"},
    {4, "M2 10L2 5.6M0 8.9L4 6.7M0 6.7L4 8.9"},
    {5.6F, "M2.8 7.2L2.8 1.6M0 4.4L5.6 4.4"},
    {0.6F, "M0.6 0.4L0 -1.8"},
    {4, "M0 4.4L4 4.4"},
    {0, "M0 0L0 0.1"},
    {4, "M0 -1.6L4 11.2"},
    {6, "M0 3L0 7C0 10 3 10C6 10 6 7L6 3C6 0 3 0C0 0 0 3"},
    {6, "M1.2 8L3.6 10L3.6 0"},
    {6, "M0.2 7.4C0.4 10 3 10C5.8 10 5.8 7.3C5.8 5.7 4.5 4.4L0.2 0L6 0"},
    {6,
     "M0.3 8C0.6 10 3 10C5.7 10 5.7 7.7C5.7 5.4 3 5.4L2.2 5.4M3 5.4C6 5.4 6 2.7C6 0 3 0C0.4 0 0 "
     "2.2"},
    {6, "M4.6 0L4.6 10L0 3L6.2 3"},
    {6, "M5.4 10L0.9 10L0.5 5.4C1.4 6.4 3 6.4C6 6.4 6 3.2C6 0 3 0C0.7 0 0 2"},
    {6, "M5.4 8.6C4.8 10 3.2 10C0 10 0 5L0 3.2C0 0 3 0C6 0 6 3.1C6 6.2 3 6.2C0 6.2 0 3.2"},
    {6, "M0 10L6 10L2 0"},
    {6,
     "M3 5.3C0.4 5.3 0.4 7.7C0.4 10 3 10C5.6 10 5.6 7.7C5.6 5.3 3 5.3C0 5.3 0 2.6C0 0 3 0C6 0 6 "
     "2.6C6 5.3 3 5.3"},
    {6, "M0.6 1.4C1.2 0 2.8 0C6 0 6 5L6 6.8C6 10 3 10C0 10 0 6.9C0 3.8 3 3.8C6 3.8 6 6.8"},
    {0, "M0 6.4L0 6.5M0 0.2L0 0.3"},
    {0.6F, "M0.6 6.4L0.6 6.5M0.6 0.4L0 -1.8"},
    {5, "M5 8L0 4.4L5 0.8"},
    {5.4F, "M0 5.8L5.4 5.8M0 3L5.4 3"},
    {5, "M0 8L5 4.4L0 0.8"},
    {4.8F, "M0 7.8C0.2 10 2.4 10C4.8 10 4.8 7.8C4.8 6 3.4 5C2.4 4.2 2.4 2.9M2.4 0L2.4 0.1"},
    {8.8F,
     "M6 4.8C6 7 4.2 7C2.4 7 2.4 4.7C2.4 2.4 4.2 2.4C6 2.4 6 4.8M6 7L6 3.8C6 2.4 7.2 2.4C8.8 "
     "2.4 8.8 5C8.8 10 4.4 10C0 10 0 4.6C0 -1 4.6 -1L6.4 -0.6"},
    {7, "M0 0L3.5 10L7 0M1.2 3.4L5.8 3.4"},
    {6, "M0 0L0 10L3 10C5.6 10 5.6 7.7C5.6 5.4 3 5.4L0 5.4M3 5.4C6 5.4 6 2.7C6 0 3 0L0 0"},
    {6.8F, "M6.8 7.6C6.2 10 3.6 10C0 10 0 6L0 4C0 0 3.6 0C6.2 0 6.8 2.4"},
    {6.8F, "M0 0L0 10L2.8 10C6.8 10 6.8 5.8L6.8 4.2C6.8 0 2.8 0L0 0"},
    {5.4F, "M5.4 10L0 10L0 0L5.4 0M0 5.2L4.6 5.2"},
    {5.2F, "M5.2 10L0 10L0 0M0 5L4.4 5"},
    {7, "M6.8 7.6C6.2 10 3.6 10C0 10 0 6L0 4C0 0 3.6 0C7 0 7 3.6L7 4.6L4 4.6"},
    {6.6F, "M0 0L0 10M6.6 0L6.6 10M0 5.2L6.6 5.2"},
    {0, "M0 0L0 10"},
    {4.6F, "M4.6 10L4.6 2.8C4.6 0 2.2 0C0.2 0 0 2"},
    {6.4F, "M0 0L0 10M6.2 10L0 3.8M2.4 6.2L6.4 0"},
    {5.2F, "M0 10L0 0L5.2 0"},
    {8, "M0 0L0 10L4 3L8 10L8 0"},
    {6.8F, "M0 0L0 10L6.8 0L6.8 10"},
    {7.4F, "M0 4L0 6C0 10 3.7 10C7.4 10 7.4 6L7.4 4C7.4 0 3.7 0C0 0 0 4"},
    {6, "M0 0L0 10L3.2 10C6 10 6 7.2C6 4.4 3.2 4.4L0 4.4"},
    {7.4F, "M0 4L0 6C0 10 3.7 10C7.4 10 7.4 6L7.4 4C7.4 0 3.7 0C0 0 0 4M4.8 2.4L7.4 -0.6"},
    {6.2F, "M0 0L0 10L3.2 10C6 10 6 7.2C6 4.4 3.2 4.4L0 4.4M3 4.4L6.2 0"},
    {6, "M5.7 8C5.3 10 3 10C0.2 10 0.2 7.6C0.2 5.7 3 5.2C6 4.7 6 2.5C6 0 3 0C0.4 0 0 2.2"},
    {6.6F, "M0 10L6.6 10M3.3 10L3.3 0"},
    {6.6F, "M0 10L0 3.2C0 0 3.3 0C6.6 0 6.6 3.2L6.6 10"},
    {7, "M0 10L3.5 0L7 10"},
    {9.6F, "M0 10L2.4 0L4.8 9L7.2 0L9.6 10"},
    {6.6F, "M0 0L6.6 10M0 10L6.6 0"},
    {6.8F, "M0 10L3.4 5L6.8 10M3.4 5L3.4 0"},
    {6, "M0 10L6 10L0 0L6 0"},
    {1.8F, "M1.8 11.2L0 11.2L0 -2.2L1.8 -2.2"},
    {4, "M0 11.2L4 -1.6"},
    {1.8F, "M0 11.2L1.8 11.2L1.8 -2.2L0 -2.2"},
    {4.8F, "M0 6.6L2.4 10L4.8 6.6"},
    {5.4F, "M0 -1.2L5.4 -1.2"},
    {1.2F, "M0 10.4L1.2 8.8"},
    {5.2F, "M0.4 5.9C1 7 2.7 7C5.2 7 5.2 4.8L5.2 0M5.2 4L2.4 4C0 4 0 2C0 0 2.2 0C4.2 0 5.2 1.6"},
    {5.4F, "M0 10L0 0M0 3.5C0 7 2.8 7C5.4 7 5.4 3.5C5.4 0 2.8 0C0 0 0 3.5"},
    {5, "M5 5.4C4.4 7 2.7 7C0 7 0 3.5C0 0 2.7 0C4.4 0 5 1.6"},
    {5.4F, "M5.4 10L5.4 0M5.4 3.5C5.4 7 2.6 7C0 7 0 3.5C0 0 2.6 0C5.4 0 5.4 3.5"},
    {5.4F, "M0 3.7L5.4 3.7C5.4 7 2.7 7C0 7 0 3.5C0 0 2.8 0C4.5 0 5.2 1.5"},
    {3.2F, "M3.4 10C1.4 10 1.4 8L1.4 0M0 6.8L3.2 6.8"},
    {5.4F,
     "M5.4 7L5.4 -0.4C5.4 -3 2.7 -3C1 -3 0.4 -1.8M5.4 3.5C5.4 7 2.6 7C0 7 0 3.5C0 0 2.6 "
     "0C5.4 0 5.4 3.5"},
    {5, "M0 10L0 0M0 4.2C0.2 7 2.8 7C5 7 5 4.4L5 0"},
    {0, "M0 7L0 0M0 9.7L0 9.8"},
    {1.4F, "M1.4 7L1.4 -1C1.4 -3 0 -3M1.4 9.7L1.4 9.8"},
    {4.8F, "M0 10L0 0M4.6 7L0 2.6M1.9 4.4L4.8 0"},
    {1.4F, "M0 10L0 1.4C0 0 1.4 0"},
    {8.4F,
     "M0 7L0 0M0 4.4C0.2 7 2.3 7C4.2 7 4.2 4.6L4.2 0M4.2 4.4C4.4 7 6.5 7C8.4 7 8.4 4.6L8.4 "
     "0"},
    {5, "M0 7L0 0M0 4.2C0.2 7 2.8 7C5 7 5 4.4L5 0"},
    {5.6F, "M0 3.5C0 7 2.8 7C5.6 7 5.6 3.5C5.6 0 2.8 0C0 0 0 3.5"},
    {5.4F, "M0 7L0 -3M0 3.5C0 7 2.8 7C5.4 7 5.4 3.5C5.4 0 2.8 0C0 0 0 3.5"},
    {5.4F, "M5.4 7L5.4 -3M5.4 3.5C5.4 7 2.6 7C0 7 0 3.5C0 0 2.6 0C5.4 0 5.4 3.5"},
    {3.2F, "M0 7L0 0M0 4C0.2 7 3.2 6.9"},
    {4.6F,
     "M4.3 5.7C4 7 2.3 7C0.2 7 0.2 5.3C0.2 4 2.3 3.6C4.6 3.2 4.6 1.8C4.6 0 2.3 0C0.3 0 0 "
     "1.5"},
    {3.4F, "M1.3 9.2L1.3 2C1.3 0 3.4 0M0 7L3.2 7"},
    {5, "M0 7L0 2.6C0 0 2.2 0C4.8 0 5 2.8M5 7L5 0"},
    {5.4F, "M0 7L2.7 0L5.4 7"},
    {7.6F, "M0 7L1.9 0L3.8 6.4L5.7 0L7.6 7"},
    {5, "M0 0L5 7M0 7L5 0"},
    {5.4F, "M0 7L2.7 0M5.4 7L2.4 -1C1.7 -3 0 -3"},
    {4.6F, "M0 7L4.6 7L0 0L4.6 0"},
    {2.4F, "M2.4 11.2C1 11.2 1 9.4L1 6.4C1 4.5 0 4.5C1 4.5 1 2.6L1 -0.4C1 -2.2 2.4 -2.2"},
    {0, "M0 11.2L0 -2.2"},
    {2.4F,
     "M0 11.2C1.4 11.2 1.4 9.4L1.4 6.4C1.4 4.5 2.4 4.5C1.4 4.5 1.4 2.6L1.4 -0.4C1.4 -2.2 0 "
     "-2.2"},
    {5.8F, "M0 3.8C0.2 5.2 1.4 5.2C2.4 5.2 2.9 4.4C3.4 3.6 4.4 3.6C5.6 3.6 5.8 5"},
}};

const Glyph& glyph_of(char character) {
  const auto code = static_cast<unsigned char>(character);
  return code >= 32 && code - 32U < kGlyphs.size() ? kGlyphs[code - 32U] : kUnknown;
}

/// Bytes that only continue a character of UTF-8.
bool continues_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U; }

/// Reads a glyph's path.
class PathReader {
 public:
  explicit PathReader(std::string_view path) : rest_(path) {}

  bool at_end() const { return rest_.empty(); }
  char command() {
    const char letter = rest_.front();
    rest_.remove_prefix(1);
    return letter;
  }
  Eigen::Vector2f point() {
    const float x = number();
    return {x, number()};
  }

 private:
  float number() {
    rest_.remove_prefix(rest_.find_first_not_of(' '));
    float value = 0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
    PLIANT_ASSERT(error == std::errc(), "a glyph's path has numbers after its letters");
    rest_.remove_prefix(static_cast<size_t>(end - rest_.data()));
    return value;
  }

  std::string_view rest_;
};

/// A quarter of an ellipse as a cubic Bezier curve, in straight pieces.
void add_curve(const Eigen::Vector2f& from, const Eigen::Vector2f& corner,
               const Eigen::Vector2f& to, std::vector<Segment>& segments) {
  constexpr int kPieces = 6;
  constexpr float kRoundness = 0.5523F;  // 4/3 (sqrt 2 - 1)
  const Eigen::Vector2f a = from + kRoundness * (corner - from);
  const Eigen::Vector2f b = to + kRoundness * (corner - to);
  Eigen::Vector2f last = from;
  for (int i = 1; i <= kPieces; ++i) {
    const float t = static_cast<float>(i) / kPieces, s = 1 - t;
    const Eigen::Vector2f next =
        s * s * s * from + 3 * s * s * t * a + 3 * s * t * t * b + t * t * t * to;
    segments.push_back({last, next});
    last = next;
  }
}

std::vector<Segment> glyph_segments(const Glyph& glyph) {
  std::vector<Segment> segments;
  Eigen::Vector2f pen = Eigen::Vector2f::Zero();
  for (PathReader path(glyph.path); !path.at_end();) {
    const char command = path.command();
    const Eigen::Vector2f point = path.point();
    if (command == 'M') {
      pen = point;
    } else if (command == 'L') {
      segments.push_back({pen, point});
      pen = point;
    } else {
      const Eigen::Vector2f end = path.point();
      add_curve(pen, point, end, segments);
      pen = end;
    }
  }
  return segments;
}

}  // namespace

std::vector<Segment> text_segments(std::string_view text, float cap_height) {
  const float scale = cap_height / kCapHeight;
  std::vector<Segment> segments;
  float x = 0;
  for (const char character : text) {
    if (continues_character(character)) continue;
    const Glyph& glyph = glyph_of(character);
    const Eigen::Vector2f offset(x, 0);
    for (const Segment& segment : glyph_segments(glyph)) {
      segments.push_back({scale * (segment.from + offset), scale * (segment.to + offset)});
    }
    x += glyph.width + kSpacing;
  }
  return segments;
}

float text_width(std::string_view text, float cap_height) {
  float width = 0;
  for (const char character : text) {
    if (!continues_character(character)) width += glyph_of(character).width + kSpacing;
  }
  return std::max(0.0F, width - kSpacing) * cap_height / kCapHeight;
}

}  // namespace pliant
