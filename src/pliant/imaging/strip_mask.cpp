#include "pliant/imaging/strip_mask.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace pliant {
namespace {

constexpr double kLevels = 255;

cv::Mat as_matrix(Photo& photo) {
  return {static_cast<int>(photo.rows()), static_cast<int>(photo.cols()), CV_32F, photo.data()};
}

// What is behind the strip: medians of windows that are large against its thickness follow the
// light, but not the strip.
cv::Mat background_of(const cv::Mat& photo) {
  constexpr int kSide = 256, kWindow = 51;
  const double share = std::min(1.0, static_cast<double>(kSide) / std::max(photo.cols, photo.rows));
  cv::Mat small, background;
  cv::resize(photo, small, {}, share, share, cv::INTER_AREA);
  small.convertTo(small, CV_8U, kLevels);
  cv::medianBlur(small, small, kWindow);
  small.convertTo(small, CV_32F, 1 / kLevels);
  cv::resize(small, background, photo.size(), 0, 0, cv::INTER_LINEAR);
  return background;
}

// Standard deviation of what is not the strip, which covers the smaller part of the picture.
double noise_of(const cv::Mat& difference) {
  constexpr double kPerMedian = 1.4826;  // of a normal distribution
  std::vector<float> sizes;
  sizes.reserve(difference.total());
  for (auto value = difference.begin<float>(); value != difference.end<float>(); ++value) {
    sizes.push_back(std::abs(*value));
  }
  const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
  std::nth_element(sizes.begin(), middle, sizes.end());
  return kPerMedian * static_cast<double>(*middle);
}

// Otsu's threshold between strip and background, clear of the noise.
double threshold_of(const cv::Mat& contrast, double noise) {
  constexpr double kClear = 5, kLeast = 4 / kLevels;
  double largest = 0;
  cv::minMaxLoc(contrast, nullptr, &largest);
  if (largest <= 0) return kLeast;
  cv::Mat levels, unused;
  contrast.convertTo(levels, CV_8U, kLevels / largest);
  const double otsu =
      cv::threshold(levels, unused, 0, 1, cv::THRESH_BINARY | cv::THRESH_OTSU) * largest / kLevels;
  return std::max({otsu, kClear * noise, kLeast});
}

// A connected set of pixels.
struct Piece {
  int label = 0;
  cv::Rect box;
  double area = 0;
  double extent() const { return std::hypot(box.width, box.height); }
};

// A picture cut into pieces, by one tone.
struct Pieces {
  StripTone tone = StripTone::brighter;
  cv::Mat contrast, labels;
  double threshold = 0;
  std::vector<Piece> long_ones;  // the longest first

  double length() const { return long_ones.empty() ? 0 : long_ones.front().extent(); }
};

// A strip that begins within them begins at the border.
int border_columns(const cv::Size& picture) { return 1 + picture.width / 50; }

// Long and thin, or it is no strip.
bool is_long(const Piece& piece, const cv::Size& picture) {
  constexpr double kLeastShare = 0.1, kLeastSlenderness = 4;
  const double extent = piece.extent();
  return extent > kLeastShare * picture.width && extent * extent > kLeastSlenderness * piece.area;
}

Pieces pieces_of(const cv::Mat& difference, StripTone tone, double noise) {
  Pieces pieces;
  pieces.tone = tone;
  pieces.contrast = cv::max(tone == StripTone::brighter ? difference : cv::Mat(-difference), 0);
  pieces.threshold = threshold_of(pieces.contrast, noise);
  cv::Mat stats, centres;
  const cv::Mat above = pieces.contrast > pieces.threshold;
  const int count = cv::connectedComponentsWithStats(above, pieces.labels, stats, centres);
  for (int label = 1; label < count; ++label) {
    const auto stat = [&](int which) { return stats.at<int>(label, which); };
    const Piece piece{label,
                      {stat(cv::CC_STAT_LEFT), stat(cv::CC_STAT_TOP), stat(cv::CC_STAT_WIDTH),
                       stat(cv::CC_STAT_HEIGHT)},
                      static_cast<double>(stat(cv::CC_STAT_AREA))};
    if (is_long(piece, above.size())) pieces.long_ones.push_back(piece);
  }
  std::sort(pieces.long_ones.begin(), pieces.long_ones.end(),
            [](const Piece& a, const Piece& b) { return a.extent() > b.extent(); });
  return pieces;
}

// Of both tones the one in which a longer thing stands out by more.
Pieces pieces_of(const cv::Mat& photo, StripTone tone) {
  constexpr double kBlur = 1;  // pixels: lets noise not break the strip
  cv::Mat smooth;
  cv::GaussianBlur(photo, smooth, {}, kBlur, kBlur, cv::BORDER_REPLICATE);
  const cv::Mat difference = smooth - background_of(photo);
  const double noise = noise_of(difference);
  if (tone != StripTone::automatic) return pieces_of(difference, tone, noise);
  Pieces bright = pieces_of(difference, StripTone::brighter, noise);
  Pieces dark = pieces_of(difference, StripTone::darker, noise);
  const auto weight = [](const Pieces& pieces) { return pieces.length() * pieces.threshold; };
  return weight(bright) >= weight(dark) ? bright : dark;
}

// How far from a row a piece begins at the border.
double distance_to(const Pieces& pieces, const Piece& piece, double row) {
  double nearest = pieces.labels.rows;
  for (int y = piece.box.y; y < piece.box.br().y; ++y) {
    const int reach = std::min(border_columns(pieces.labels.size()), pieces.labels.cols);
    for (int x = piece.box.x; x < reach; ++x) {
      if (pieces.labels.at<int>(y, x) == piece.label)
        nearest = std::min(nearest, std::abs(y - row));
    }
  }
  return nearest;
}

// The piece that begins at the clamp's row.
const Piece& piece_at(const Pieces& pieces, double row, const Location& where) {
  constexpr double kNear = 0.02;  // of the picture's width
  for (const Piece& piece : pieces.long_ones) {
    if (distance_to(pieces, piece, row) < kNear * pieces.labels.cols) return piece;
  }
  throw InputError(where, "shows no strip at the clamp's pixel",
                   "the pixel X,Y at which the strip leaves its clamp");
}

// The longest piece that begins at the border; nothing where none does.
const Piece* piece_at_border(const Pieces& pieces) {
  const auto found = std::ranges::find_if(pieces.long_ones, [&](const Piece& piece) {
    return piece.box.x < border_columns(pieces.labels.size());
  });
  return found == pieces.long_ones.end() ? nullptr : &*found;
}

// In a band of thickness t the mean distance from the nearest pixel outside is (t + 2) / 4; loose
// fibres hardly count.
double thickness_of(const cv::Mat& inside) {
  constexpr double kPerMean = 4, kOutside = 2;
  cv::Mat distance;
  cv::distanceTransform(inside, distance, cv::DIST_L2, cv::DIST_MASK_5);
  return std::max(kPerMean * cv::mean(distance, inside)[0] - kOutside, 1.0);
}

PixelMask mask_of(const cv::Mat& inside) {
  PixelMask mask = PixelMask::Zero(inside.rows, inside.cols);
  cv::Mat(inside.rows, inside.cols, CV_8U, mask.data()).setTo(1, inside);
  return mask;
}

// A strip of one piece or several.
struct Strip {
  cv::Mat inside;
  std::set<int> labels;
  int gaps = 0;
  bool goes_on = false;  // where the next piece is too far away to be joined

  double extent() const {
    const cv::Rect box = cv::boundingRect(inside);
    return std::hypot(box.width, box.height);
  }
};

// The pixel of a piece that is nearest to the end of a strip and ahead of it.
struct Ahead {
  int label = 0;
  cv::Point pixel;
  double distance = 0;
};

// Pixels of other pieces ahead of an end, the nearest of each piece, the nearest piece first.
std::vector<Ahead> pieces_ahead(const cv::Mat& labels, const std::set<int>& own,
                                const StripEnd& end, double reach) {
  constexpr double kCosine = 0.87;  // 30 degrees
  std::map<int, Ahead> nearest;
  const cv::Rect around(static_cast<int>(end.place.x() - reach),
                        static_cast<int>(end.place.y() - reach), static_cast<int>(2 * reach) + 1,
                        static_cast<int>(2 * reach) + 1);
  const cv::Rect within = around & cv::Rect({}, labels.size());
  for (int y = within.y; y < within.br().y; ++y) {
    for (int x = within.x; x < within.br().x; ++x) {
      const int label = labels.at<int>(y, x);
      if (label == 0 || own.contains(label)) continue;
      const Eigen::Vector2d way = Eigen::Vector2d(x, y) - end.place;
      const double distance = way.norm();
      if (distance > reach || way.dot(end.direction) < kCosine * distance) continue;
      const auto known = nearest.find(label);
      if (known == nearest.end() || distance < known->second.distance) {
        nearest[label] = {label, {x, y}, distance};
      }
    }
  }
  std::vector<Ahead> ahead;
  for (const auto& [label, piece] : nearest) ahead.push_back(piece);
  std::ranges::sort(ahead, {}, &Ahead::distance);
  return ahead;
}

// Whether a piece looks like more of a strip: as thick, and going on in its direction. Of one that
// lies across it the pixels around the nearest lie to both sides.
bool continues(const cv::Mat& labels, const Ahead& ahead, const StripEnd& end, double thickness) {
  constexpr double kShortest = 3, kNear = 6, kOn = 1.2;  // thicknesses
  constexpr double kThin = 0.5, kThick = 2, kCosine = 0.64;
  const cv::Mat piece = labels == ahead.label;
  const cv::Rect box = cv::boundingRect(piece);
  if (std::hypot(box.width, box.height) < kShortest * thickness) return false;
  const double own = thickness_of(piece);
  if (own < kThin * thickness || own > kThick * thickness) return false;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int count = 0;
  for (int y = box.y; y < box.br().y; ++y) {
    for (int x = box.x; x < box.br().x; ++x) {
      if (piece.at<unsigned char>(y, x) == 0) continue;
      const Eigen::Vector2d way(x - ahead.pixel.x, y - ahead.pixel.y);
      if (way.norm() > kNear * thickness) continue;
      sum += way;
      ++count;
    }
  }
  const double on = sum.dot(end.direction);
  return on > kCosine * sum.norm() && on > kOn * thickness * count;
}

// Follows a strip from its first piece over gaps to others that go on.
Strip joined(const Pieces& pieces, const Piece& first) {
  constexpr double kGap = 10, kReach = 40;  // thicknesses
  Strip strip{pieces.labels == first.label, {first.label}};
  const double thickness = thickness_of(strip.inside);
  while (true) {
    const StripEnd end = free_end(mask_of(strip.inside), thickness);
    const std::vector<Ahead> ahead =
        pieces_ahead(pieces.labels, strip.labels, end, kReach * thickness);
    const auto next = std::ranges::find_if(
        ahead, [&](const Ahead& piece) { return continues(pieces.labels, piece, end, thickness); });
    if (next == ahead.end()) return strip;
    if (next->distance > kGap * thickness) {
      strip.goes_on = true;
      return strip;
    }
    strip.inside |= pieces.labels == next->label;
    cv::line(strip.inside, {cvRound(end.place.x()), cvRound(end.place.y())}, next->pixel,
             cv::Scalar(255), std::max(cvRound(thickness), 1));
    strip.labels.insert(next->label);
    ++strip.gaps;
  }
}

// Nothing else of its size that might be the strip, and longer things begin elsewhere.
void require_only(const Pieces& pieces, const Strip* strip, const StripSearch& search,
                  const Location& where) {
  constexpr double kAlike = 0.5;  // share of the longest
  const double own = strip ? strip->extent() : 0;
  const double longest = std::max(own, pieces.length());
  auto alike = std::ranges::count_if(pieces.long_ones, [&](const Piece& piece) {
    const bool other = !strip || !strip->labels.contains(piece.label);
    return other && piece.extent() > kAlike * longest;
  });
  if (own > kAlike * longest) ++alike;
  if (alike > 1) {
    throw InputError(where, fmt::format("shows {} things that could be the strip", alike),
                     "one strip: a crop that leaves the others out, or the pixel of its clamp");
  }
  if (own <= kAlike * longest) {
    throw InputError(
        where,
        fmt::format("the strip does not begin at the {} border, where its clamp should be",
                    search.clamp_border),
        "a crop whose border is the clamp's edge, the pixel of the clamp, or the other side");
  }
}

Strip only_strip(const Pieces& pieces, const StripSearch& search, const Location& where) {
  const Piece* first = piece_at_border(pieces);
  if (!first) require_only(pieces, nullptr, search, where);  // throws
  Strip strip = joined(pieces, *first);
  require_only(pieces, &strip, search, where);
  return strip;
}

void require_free_end(const Strip& strip, const StripSearch& search, const Location& where) {
  const auto refuse = [&](const std::string& border) {
    throw InputError(where, fmt::format("the strip leaves the picture at its {} border", border),
                     "a photograph, or a crop, with the whole strip in it");
  };
  const cv::Rect box = cv::boundingRect(strip.inside);
  if (box.br().x >= strip.inside.cols) refuse(search.far_border);
  if (box.br().y >= strip.inside.rows) refuse("lower");
  if (box.y <= 0) refuse("upper");
}

// A strip that is cut off looks softer than it is, and nothing of the rest would tell.
void require_whole(const StripMask& mask, bool goes_on, const Location& where) {
  const StripEnd end = free_end(mask.inside, mask.thickness);
  if (!goes_on && !goes_on_faintly(mask.contrast, mask.threshold, end, mask.thickness)) return;
  throw InputError(
      where,
      fmt::format("the strip seems to go on beyond where it ends, about pixel {:.0f},{:.0f}",
                  end.place.x(), end.place.y()),
      "a strip in even light with nothing in front of it, or a crop that ends where it does");
}

// Takes off fibres that are thin against the strip, if that leaves it whole.
cv::Mat without_fibres(const cv::Mat& inside, double thickness) {
  constexpr double kShare = 0.4, kWhole = 0.97;
  const int size = static_cast<int>(std::lround(kShare * thickness));
  if (size < 2) return inside;
  cv::Mat opened, labels, stats, centres;
  cv::morphologyEx(inside, opened, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {size, size}));
  const int count = cv::connectedComponentsWithStats(opened, labels, stats, centres);
  for (int label = 1; label < count; ++label) {
    const double width = stats.at<int>(label, cv::CC_STAT_WIDTH);
    const double height = stats.at<int>(label, cv::CC_STAT_HEIGHT);
    const cv::Rect whole = cv::boundingRect(inside);
    if (std::hypot(width, height) > kWhole * std::hypot(whole.width, whole.height)) {
      return labels == label;
    }
  }
  return inside;
}

}  // namespace

StripMask find_strip(const Photo& photo, const StripSearch& search, const Location& where) {
  Photo copy = photo;
  const Pieces pieces = pieces_of(as_matrix(copy), search.tone);
  if (pieces.long_ones.empty()) {
    throw InputError(where, "shows nothing long and thin that stands out from its background",
                     "a strip seen from its side, brighter or darker than all behind it");
  }
  const Strip strip = search.clamp_row ? joined(pieces, piece_at(pieces, *search.clamp_row, where))
                                       : only_strip(pieces, search, where);
  require_free_end(strip, search, where);
  const cv::Mat inside = without_fibres(strip.inside, thickness_of(strip.inside));

  StripMask mask;
  mask.tone = pieces.tone;
  mask.threshold = static_cast<float>(pieces.threshold);
  mask.thickness = thickness_of(inside);
  mask.gaps = strip.gaps;
  mask.contrast.resize(photo.rows(), photo.cols());
  cv::Mat contrast = as_matrix(mask.contrast);
  pieces.contrast.copyTo(contrast);
  mask.inside = mask_of(inside);
  require_whole(mask, strip.goes_on, where);
  return mask;
}

SeenPixels things_seen(const Photo& photo, StripTone tone) {
  Photo copy = photo;
  const Pieces pieces = pieces_of(as_matrix(copy), tone);
  std::set<int> long_ones;
  for (const Piece& piece : pieces.long_ones) long_ones.insert(piece.label);
  SeenPixels seen(photo.rows(), photo.cols());
  for (int y = 0; y < pieces.labels.rows; ++y) {
    for (int x = 0; x < pieces.labels.cols; ++x) {
      const int label = pieces.labels.at<int>(y, x);
      const Seen thing = long_ones.count(label) > 0 ? Seen::candidate : Seen::standing_out;
      seen(y, x) = label > 0 ? thing : Seen::background;
    }
  }
  return seen;
}

}  // namespace pliant
