#include "pliant/imaging/centre_line.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "pliant/imaging/strip_end.h"
#include "pliant/math/spline_line.h"

namespace pliant {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr double kStep = 0.25;      // pixels, of the walks across and along the strip
constexpr double kHalfPixel = 0.5;  // the border of a picture lies so far before its first column
constexpr int kFewestMiddles = 12;

// Mean places of the pixels whose ways are alike, in the order of their ways.
Points rough_line(const StripMask& strip) {
  constexpr double kShare = 0.5, kLeast = 2;  // of the thickness; pixels
  const double bin = std::max(kShare * strip.thickness, kLeast);
  const Photo way = ways_from_clamp(strip.inside);
  std::vector<Eigen::Vector3d> sums;  // x, y, number
  for (Eigen::Index row = 0; row < way.rows(); ++row) {
    for (Eigen::Index column = 0; column < way.cols(); ++column) {
      if (!std::isfinite(way(row, column))) continue;
      const auto i = static_cast<size_t>(way(row, column) / bin);
      if (sums.size() <= i) sums.resize(i + 1, Eigen::Vector3d::Zero());
      sums[i] += Eigen::Vector3d(static_cast<double>(column), static_cast<double>(row), 1);
    }
  }
  Points line;
  for (const Eigen::Vector3d& sum : sums) {
    if (sum.z() > 0) line.emplace_back(sum.head<2>() / sum.z());
  }
  return line;
}

SplineLine smooth(const Points& points) {
  constexpr int kPointsPerSpan = 4, kMostSpans = 14;
  const int spans = std::clamp(static_cast<int>(points.size()) / kPointsPerSpan, 1, kMostSpans);
  return {points, length_shares(points), spans};
}

bool within(const Photo& photo, const Eigen::Vector2d& place) {
  return place.x() >= 0 && place.y() >= 0 && place.x() < static_cast<double>(photo.cols() - 1) &&
         place.y() < static_cast<double>(photo.rows() - 1);
}

// Contrast between the pixels; zero outside the picture.
double contrast_at(const Photo& contrast, const Eigen::Vector2d& place) {
  if (!within(contrast, place)) return 0;
  const double x = std::floor(place.x()), y = std::floor(place.y());
  const auto column = static_cast<Eigen::Index>(x), row = static_cast<Eigen::Index>(y);
  const double right = place.x() - x, down = place.y() - y;
  const auto at = [&](Eigen::Index r, Eigen::Index c) {
    return static_cast<double>(contrast(row + r, column + c));
  };
  return (1 - down) * ((1 - right) * at(0, 0) + right * at(0, 1)) +
         down * ((1 - right) * at(1, 0) + right * at(1, 1));
}

// A place in the middle of the strip, and how thick the strip is there.
struct Middle {
  Eigen::Vector2d place;
  double thickness = 0;
};

// Walks from a place inside the strip both ways across it, to where the contrast falls below the
// threshold; nothing where it does not within reach and the picture, or the place lies outside.
std::optional<Middle> middle_across(const StripMask& strip, const Eigen::Vector2d& from,
                                    const Eigen::Vector2d& across) {
  constexpr double kReach = 2;  // of the thickness
  const auto inside = [&](double offset) {
    return contrast_at(strip.contrast, from + offset * across) > strip.threshold;
  };
  if (!inside(0)) return std::nullopt;
  const auto edge = [&](int side) -> std::optional<double> {
    for (double way = kStep; way < kReach * strip.thickness + 2; way += kStep) {
      if (inside(side * way)) continue;
      if (!within(strip.contrast, from + side * way * across)) return std::nullopt;
      // Between two samples the contrast is close to a straight line.
      const double last = contrast_at(strip.contrast, from + side * (way - kStep) * across);
      const double next = contrast_at(strip.contrast, from + side * way * across);
      return way - kStep + kStep * (last - strip.threshold) / (last - next);
    }
    return std::nullopt;
  };
  const auto left = edge(-1), right = edge(1);
  if (!left || !right) return std::nullopt;
  return Middle{from + (*right - *left) / 2 * across, *left + *right};
}

Eigen::Vector2d left_of(const Eigen::Vector2d& direction) {
  return Eigen::Vector2d(-direction.y(), direction.x()).normalized();
}

// Middles along a line, about every half thickness. Where the strip is much thicker or thinner than
// around there a fibre stands out or something hides it: no middle is taken.
Points middles_along(const StripMask& strip, const SplineLine& line, double length) {
  constexpr double kShare = 0.5, kThick = 1.4, kThin = 0.5;
  constexpr int kAround = 10;  // middles each way
  const int count =
      std::max(kFewestMiddles, static_cast<int>(length / std::max(1.0, kShare * strip.thickness)));
  std::vector<Middle> middles;
  for (int i = 0; i <= count; ++i) {
    const double share = static_cast<double>(i) / count;
    const auto middle = middle_across(strip, line.position(share), left_of(line.direction(share)));
    if (middle) middles.push_back(*middle);
  }
  Points points;
  for (size_t i = 0; i < middles.size(); ++i) {
    const size_t first = i > kAround ? i - kAround : 0;
    const size_t end = std::min(i + kAround + 1, middles.size());
    std::vector<double> around;
    for (size_t k = first; k < end; ++k) around.push_back(middles[k].thickness);
    const auto half = around.begin() + static_cast<std::ptrdiff_t>(around.size() / 2);
    std::nth_element(around.begin(), half, around.end());
    const double share = middles[i].thickness / *half;
    if (share < kThick && share > kThin) points.push_back(middles[i].place);
  }
  return points;
}

// The line goes straight on, at its beginning to the border of the picture, at its end to where the
// strip ends.
void extend(const StripMask& strip, const SplineLine& line, Points& points) {
  const Eigen::Vector2d out = line.direction(1).normalized();
  Eigen::Vector2d end = line.position(1);
  while (contrast_at(strip.contrast, end) > strip.threshold) end += kStep * out;
  while (contrast_at(strip.contrast, end) <= strip.threshold &&
         (end - line.position(1)).dot(out) > 0) {
    end -= kStep / 8 * out;
  }
  const Eigen::Vector2d in = line.direction(0).normalized();
  Eigen::Vector2d begin = line.position(0);
  if (in.x() > kHalfPixel) begin -= (begin.x() + kHalfPixel) / in.x() * in;
  if ((end - points.back()).dot(out) > 0) points.push_back(end);
  if ((points.front() - begin).dot(in) > 0) points.insert(points.begin(), begin);
}

// Points at equal distances along a smooth line.
Points evenly_along(const SplineLine& line, int count, double& length) {
  constexpr int kPieces = 2000;
  Points dense;
  for (int i = 0; i <= kPieces; ++i) {
    dense.push_back(line.position(static_cast<double>(i) / kPieces));
  }
  std::vector<double> way{0};
  for (size_t i = 1; i < dense.size(); ++i) {
    way.push_back(way.back() + (dense[i] - dense[i - 1]).norm());
  }
  length = way.back();
  Points even;
  for (int i = 0; i < count; ++i) {
    const double wanted = length * i / (count - 1);
    const auto next =
        std::max<std::ptrdiff_t>(std::lower_bound(way.begin(), way.end(), wanted) - way.begin(), 1);
    const auto k = std::min(static_cast<size_t>(next), way.size() - 1);
    const double share = (wanted - way[k - 1]) / (way[k] - way[k - 1]);
    even.push_back(dense[k - 1] + share * (dense[k] - dense[k - 1]));
  }
  return even;
}

double scatter_about(const SplineLine& line, const Points& points) {
  const std::vector<double> shares = length_shares(points);
  double squares = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d across = left_of(line.direction(shares[i]));
    squares += std::pow(across.dot(points[i] - line.position(shares[i])), 2);
  }
  return std::sqrt(squares / static_cast<double>(points.size()));
}

}  // namespace

CentreLine centre_line(const StripMask& strip, int count, const Location& where) {
  const Points rough = rough_line(strip);
  const auto refuse = [&] {
    throw InputError(where, "the middle of the strip cannot be followed",
                     "a strip that stands out clearly and is seen exactly from its side");
  };
  if (rough.size() < kFewestMiddles) refuse();
  const SplineLine guide = smooth(rough);
  double length = 0;
  evenly_along(guide, 2, length);
  Points middles = middles_along(strip, guide, length);
  if (middles.size() < kFewestMiddles) refuse();
  const SplineLine through = smooth(middles);
  CentreLine result;
  result.scatter = scatter_about(through, middles);
  extend(strip, through, middles);
  const SplineLine whole = smooth(middles);
  result.points = evenly_along(whole, count, result.length);
  const Eigen::Vector2d out = whole.direction(0);
  result.clamp_angle = std::atan2(out.y(), out.x());
  return result;
}

}  // namespace pliant
