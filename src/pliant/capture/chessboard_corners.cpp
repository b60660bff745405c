#include "pliant/capture/chessboard_corners.h"

#ifdef PLIANT_HAS_CALIB3D
#include <vector>

#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>
#endif

namespace pliant {

#ifdef PLIANT_HAS_CALIB3D
namespace {

cv::Mat chessboard_image(const GreyPicture& picture) {
  cv::Mat image(static_cast<int>(picture.rows()), static_cast<int>(picture.cols()), CV_8U);
  for (int row = 0; row < image.rows; ++row) {
    for (int column = 0; column < image.cols; ++column) {
      image.at<std::uint8_t>(row, column) =
          cv::saturate_cast<std::uint8_t>(255 * picture(row, column));
    }
  }
  return image;
}

// The sector detector places corners best but wants all of the outermost squares; the older one
// takes boards that it misses.
std::vector<cv::Point2f> found_corners(const cv::Mat& image, const Chessboard& board) {
  const cv::Size size(board.columns, board.rows);
  std::vector<cv::Point2f> corners;
  // A look at twice the size places corners of small pictures better, not those of large ones, and
  // takes four times as long.
  constexpr double kLarge = 2e6;  // pixels
  const int accuracy = static_cast<double>(image.total()) < kLarge ? cv::CALIB_CB_ACCURACY : 0;
  for (const int thorough : {0, static_cast<int>(cv::CALIB_CB_EXHAUSTIVE)}) {
    if (cv::findChessboardCornersSB(image, size, corners,
                                    thorough | accuracy | cv::CALIB_CB_NORMALIZE_IMAGE)) {
      return corners;
    }
  }
  corners.clear();
  if (!cv::findChessboardCorners(
          image, size, corners,
          cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_FAST_CHECK)) {
    return {};
  }
  // Within less than a square, so that no other corner is seen.
  double least = 1e9;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    if (i % static_cast<std::size_t>(board.columns) != 0) {
      least = std::min(least, cv::norm(corners[i] - corners[i - 1]));
    }
  }
  const int half = std::clamp(static_cast<int>(least / 3), 2, 8);
  cv::cornerSubPix(image, corners, {half, half}, {-1, -1},
                   {cv::TermCriteria::EPS | cv::TermCriteria::COUNT, 50, 1e-3});
  return corners;
}

// Brightness between the corners of the squares that are black in the print, less that of white
// ones.
double contrast_as_printed(const GreyPicture& picture, const Chessboard& board,
                           const Eigen::Matrix2Xd& corners) {
  double sum = 0;
  for (int row = 0; row + 1 < board.rows; ++row) {
    for (int column = 0; column + 1 < board.columns; ++column) {
      const int first = row * board.columns + column, below = first + board.columns;
      const Eigen::Vector2d middle = (corners.col(first) + corners.col(first + 1) +
                                      corners.col(below) + corners.col(below + 1)) /
                                     4;
      const auto pixel = [&](double place, Eigen::Index count) {
        return std::clamp<Eigen::Index>(std::lround(place), 0, count - 1);
      };
      const float value =
          picture(pixel(middle.y(), picture.rows()), pixel(middle.x(), picture.cols()));
      sum += (row + column) % 2 == 0 ? value : -value;
    }
  }
  return sum;
}

// Columns to the right and rows downwards as one looks at the print.
bool is_seen_from_behind(const Chessboard& board, const Eigen::Matrix2Xd& corners) {
  const Eigen::Vector2d along = corners.col(board.columns - 1) - corners.col(0);
  const Eigen::Vector2d down = corners.col(board.corner_count() - board.columns) - corners.col(0);
  return along.x() * down.y() - along.y() * down.x() < 0;
}

Eigen::Matrix2Xd rows_reversed(const Chessboard& board, const Eigen::Matrix2Xd& corners) {
  Eigen::Matrix2Xd result(2, corners.cols());
  for (int row = 0; row < board.rows; ++row) {
    result.middleCols(row * board.columns, board.columns) =
        corners.middleCols((board.rows - 1 - row) * board.columns, board.columns);
  }
  return result;
}

}  // namespace

bool can_find_chessboards() { return true; }

std::optional<Eigen::Matrix2Xd> chessboard_corners(const GreyPicture& picture,
                                                   const Chessboard& board) {
  const std::vector<cv::Point2f> found = found_corners(chessboard_image(picture), board);
  if (static_cast<int>(found.size()) != board.corner_count()) return std::nullopt;
  Eigen::Matrix2Xd corners(2, board.corner_count());
  for (int i = 0; i < board.corner_count(); ++i) corners.col(i) << found[i].x, found[i].y;
  if (is_seen_from_behind(board, corners)) corners = rows_reversed(board, corners);
  if (board.shows_up() && contrast_as_printed(picture, board, corners) > 0) {
    corners = corners.rowwise().reverse().eval();
  }
  return corners;
}

#else

bool can_find_chessboards() { return false; }

std::optional<Eigen::Matrix2Xd> chessboard_corners(const GreyPicture&, const Chessboard&) {
  return std::nullopt;
}

#endif

}  // namespace pliant
