#include "pliant/imaging/drape_mask.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <Eigen/QR>
#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

namespace pliant {
namespace {

// Longest side of what is looked at: a specimen is hundreds of pixels wide then.
constexpr double kLongest = 1500;

// How far a pixel's colour is from another: light counts less than hue, and hardly where it is no
// darker than a shadow is, or brighter than a lamp's spot.
float difference_at(const cv::Mat& colours, int x, int y, const Eigen::RowVector3d& other) {
  constexpr double kShadow = 15, kOfShadow = 0.2, kBeyond = 0.5;
  const cv::Vec3f& own = colours.at<cv::Vec3f>(y, x);
  const Eigen::RowVector3d apart = Eigen::RowVector3d(own[0], own[1], own[2]) - other;
  const double light = std::abs(apart(0));
  const double counted =
      kOfShadow * std::min(light, kShadow) + kBeyond * std::max(light - kShadow, 0.0);
  return static_cast<float>(std::hypot(counted, apart(1), apart(2)));
}

// L, a and b of CIELAB.
cv::Mat colours_of(const ColourPhoto& photo, double& pixel) {
  const cv::Mat whole(photo.rows, photo.columns, CV_8UC3,
                      const_cast<unsigned char*>(photo.levels.data()));  // is read alone
  pixel = std::max(1.0, std::max(photo.rows, photo.columns) / kLongest);
  cv::Mat small, colours;
  cv::resize(whole, small, {}, 1 / pixel, 1 / pixel, cv::INTER_AREA);
  small.convertTo(colours, CV_32F, 1.0 / 255);
  cv::cvtColor(colours, colours, cv::COLOR_BGR2Lab);
  cv::GaussianBlur(colours, colours, {}, 1, 1, cv::BORDER_REPLICATE);
  return colours;
}

double median(const cv::Mat& values, const cv::Mat& of) {
  std::vector<float> list;
  for (int y = 0; y < values.rows; ++y) {
    for (int x = 0; x < values.cols; ++x) {
      if (of.at<unsigned char>(y, x) > 0) list.push_back(values.at<float>(y, x));
    }
  }
  if (list.empty()) return 0;
  const auto middle = list.begin() + static_cast<std::ptrdiff_t>(list.size() / 2);
  std::nth_element(list.begin(), middle, list.end());
  return static_cast<double>(*middle);
}

// 1, x, y, x^2, x y, y^2 of a pixel, from -1 to 1 across the picture.
using Powers = Eigen::Matrix<double, 6, 1>;

Powers powers_at(const cv::Mat& picture, int x, int y) {
  const double u = 2.0 * x / picture.cols - 1, v = 2.0 * y / picture.rows - 1;
  Powers powers;
  powers << 1, u, v, u * u, u * v, v * v;
  return powers;
}

// A colour that changes slowly: a quadratic of the place.
class Background {
 public:
  // The median of a part of the pixels, everywhere.
  static Background uniform(const cv::Mat& colours, const cv::Mat& part) {
    std::vector<cv::Mat> channels;
    cv::split(colours, channels);
    Background background;
    for (int k = 0; k < 3; ++k) {
      background.by_power_(0, k) = median(channels[static_cast<std::size_t>(k)], part);
    }
    return background;
  }

  // What a part of the pixels shows.
  static Background of(const cv::Mat& colours, const cv::Mat& shown) {
    Eigen::Matrix<double, 6, 6> products = Eigen::Matrix<double, 6, 6>::Zero();
    Eigen::Matrix<double, 6, 3> sums = Eigen::Matrix<double, 6, 3>::Zero();
    for (int y = 0; y < colours.rows; y += kApart) {
      for (int x = 0; x < colours.cols; x += kApart) {
        if (shown.at<unsigned char>(y, x) == 0) continue;
        const Powers powers = powers_at(colours, x, y);
        const cv::Vec3f& colour = colours.at<cv::Vec3f>(y, x);
        products += powers * powers.transpose();
        sums += powers * Eigen::RowVector3d(colour[0], colour[1], colour[2]);
      }
    }
    Background background;
    background.by_power_ = products.completeOrthogonalDecomposition().solve(sums);
    return background;
  }

  // By how much each pixel differs from it.
  cv::Mat differences(const cv::Mat& colours) const {
    cv::Mat differences(colours.rows, colours.cols, CV_32F);
    for (int y = 0; y < colours.rows; ++y) {
      for (int x = 0; x < colours.cols; ++x) {
        differences.at<float>(y, x) =
            difference_at(colours, x, y, powers_at(colours, x, y).transpose() * by_power_);
      }
    }
    return differences;
  }

 private:
  static constexpr int kApart = 4;  // pixels: what changes slowly need not be asked everywhere
  Eigen::Matrix<double, 6, 3> by_power_ = Eigen::Matrix<double, 6, 3>::Zero();
};

// A frame of the picture: there is background in most of it.
cv::Mat frame_of(const cv::Size& size) {
  constexpr double kShare = 0.1;
  cv::Mat frame = cv::Mat::ones(size, CV_8U);
  const int across = static_cast<int>(kShare * size.width);
  const int down = static_cast<int>(kShare * size.height);
  frame(cv::Rect(across, down, size.width - 2 * across, size.height - 2 * down)).setTo(0);
  return frame;
}

// The difference from a background that is, to begin with, what is alike in the frame, and then all
// that is like it.
cv::Mat contrast_of(const cv::Mat& colours) {
  constexpr int kRounds = 6;
  constexpr double kAlike = 3, kLeast = 2;  // medians, and units of CIELAB
  const auto alike = [&](const cv::Mat& differences, const cv::Mat& of) {
    return cv::Mat(differences < std::max(kLeast, kAlike * median(differences, of)));
  };
  const cv::Mat frame = frame_of(colours.size());
  cv::Mat differences = Background::uniform(colours, frame).differences(colours);
  cv::Mat shown = frame & alike(differences, frame);
  for (int round = 0; round < kRounds; ++round) {
    differences = Background::of(colours, shown).differences(colours);
    shown = alike(differences, shown);
  }
  return differences;
}

// Otsu's threshold between specimen and background.
double threshold_of(const cv::Mat& contrast) {
  constexpr double kLeast = 5, kLevels = 255;  // units of CIELAB
  double largest = 0;
  cv::minMaxLoc(contrast, nullptr, &largest);
  if (largest <= kLeast) return kLeast;
  cv::Mat levels, unused;
  contrast.convertTo(levels, CV_8U, kLevels / largest);
  const double otsu =
      cv::threshold(levels, unused, 0, 1, cv::THRESH_BINARY | cv::THRESH_OTSU) * largest / kLevels;
  return std::max(otsu, kLeast);
}

// What stands out, in connected pieces.
struct Pieces {
  cv::Mat labels;
  int largest = 0;         // of those within the picture; 0: none
  double area = 0;         // of that one
  double largest_cut = 0;  // area of the largest that the picture's border cuts
};

Pieces pieces_of(const cv::Mat& contrast) {
  Pieces pieces;
  cv::Mat stats, centres;
  const cv::Mat above = contrast > threshold_of(contrast);
  const int count = cv::connectedComponentsWithStats(above, pieces.labels, stats, centres);
  const int rim = 1 + std::max(above.cols, above.rows) / 200;
  const cv::Rect within(rim, rim, above.cols - 2 * rim, above.rows - 2 * rim);
  for (int label = 1; label < count; ++label) {
    const auto stat = [&](int which) { return stats.at<int>(label, which); };
    const cv::Rect box(stat(cv::CC_STAT_LEFT), stat(cv::CC_STAT_TOP), stat(cv::CC_STAT_WIDTH),
                       stat(cv::CC_STAT_HEIGHT));
    const double area = stat(cv::CC_STAT_AREA);
    if ((box & within) != box) {
      pieces.largest_cut = std::max(pieces.largest_cut, area);
    } else if (area > pieces.area) {
      pieces.area = area;
      pieces.largest = label;
    }
  }
  return pieces;
}

// Without holes (folds may look like the background) and without fibres.
cv::Mat whole(const cv::Mat& piece, double area) {
  constexpr double kFibre = 0.02;  // of the specimen's width
  std::vector<std::vector<cv::Point>> outlines;
  cv::findContours(piece, outlines, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
  cv::Mat filled = cv::Mat::zeros(piece.size(), CV_8U);
  cv::drawContours(filled, outlines, -1, cv::Scalar(255), cv::FILLED);
  const int size = static_cast<int>(std::lround(kFibre * std::sqrt(area)));
  if (size < 2) return filled;
  cv::Mat opened, labels, stats, centres;
  cv::morphologyEx(filled, opened, cv::MORPH_OPEN,
                   cv::getStructuringElement(cv::MORPH_ELLIPSE, {size, size}));
  const int count = cv::connectedComponentsWithStats(opened, labels, stats, centres);
  int largest = 0;
  for (int label = 1; label < count; ++label) {
    const auto area_of = [&](int of) { return stats.at<int>(of, cv::CC_STAT_AREA); };
    if (largest == 0 || area_of(label) > area_of(largest)) largest = label;
  }
  return largest > 0 ? cv::Mat(labels == largest) : filled;
}

}  // namespace

DrapeMask find_drape(const ColourPhoto& photo, const Location& where) {
  constexpr double kLeastShare = 0.01;  // of the picture
  constexpr int kSmallest = 32;         // pixels of a side
  if (std::min(photo.rows, photo.columns) < kSmallest) {
    throw InputError(where, "is too small to find a specimen in",
                     fmt::format("at least {0} x {0} pixels", kSmallest));
  }
  DrapeMask mask;
  const cv::Mat colours = colours_of(photo, mask.pixel);
  const Pieces pieces = pieces_of(contrast_of(colours));
  const double least = kLeastShare * static_cast<double>(colours.total());
  if (pieces.largest_cut > std::max(pieces.area, least)) {
    throw InputError(
        where, "what stands out most is cut by the border of the picture",
        "a photograph, or a crop, with the whole specimen in it and background around");
  }
  if (pieces.area < least) {
    throw InputError(where, "shows nothing large that stands out from its background",
                     "a specimen seen from above, of another colour than what is below it");
  }
  const cv::Mat inside = whole(pieces.labels == pieces.largest, pieces.area);
  mask.inside.setZero(inside.rows, inside.cols);
  cv::Mat(inside.rows, inside.cols, CV_8U, mask.inside.data()).setTo(1, inside);
  return mask;
}

SeenPixels drape_seen(const ColourPhoto& photo) {
  double pixel = 1;
  const Pieces pieces = pieces_of(contrast_of(colours_of(photo, pixel)));
  SeenPixels seen(photo.rows, photo.columns);
  for (int y = 0; y < photo.rows; ++y) {
    for (int x = 0; x < photo.columns; ++x) {
      const int row = std::min(static_cast<int>(y / pixel), pieces.labels.rows - 1);
      const int column = std::min(static_cast<int>(x / pixel), pieces.labels.cols - 1);
      const int label = pieces.labels.at<int>(row, column);
      const Seen thing = label == pieces.largest ? Seen::candidate : Seen::standing_out;
      seen(y, x) = label > 0 ? thing : Seen::background;
    }
  }
  return seen;
}

}  // namespace pliant
