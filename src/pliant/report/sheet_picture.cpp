#include "pliant/report/sheet_picture.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "pliant/experiment/session/sheet_test.h"
#include "pliant/report/residual_colours.h"
#include "pliant/report/sheet_camera.h"

namespace pliant::report {
namespace {

/// Of a panel, in units of the picture.
constexpr int kPanelWidth = 600, kPanelHeight = 460, kMargin = 16;
constexpr double kLongestForce = 0.3;  ///< of the sheet's extent in the picture

using Points = Eigen::Matrix2Xd;

/// World to panel: the same for all panels of a picture.
struct Projection {
  SheetCamera camera;
  Eigen::Vector2d low{0, 0};
  double scale = 1;

  Points operator()(const Eigen::Matrix3Xd& points) const {
    Points flat(2, points.cols());
    flat.row(0) = camera.right.transpose() * points;
    flat.row(1) = -camera.up.transpose() * points;
    return scale * (flat.colwise() - low);
  }
};

/// Forces of the clips as arrows: from the middles of the clips, one column a clip (m).
struct Arrows {
  Eigen::Matrix3Xd from, to;
};

Arrows arrows(const Session& session, int frame, double metres_per_newton) {
  const auto clips = static_cast<Eigen::Index>(session.clips.size());
  Arrows all{Eigen::Matrix3Xd(3, clips), Eigen::Matrix3Xd(3, clips)};
  for (Eigen::Index clip = 0; clip < clips; ++clip) {
    const int c = static_cast<int>(clip);
    all.from.col(clip) = clip_middle(session, frame, c);
    all.to.col(clip) = all.from.col(clip) + metres_per_newton * cord_pull(session, frame, c);
  }
  return all;
}

double largest_force(const Session& session, int frame) {
  double largest = 0;
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    largest = std::max(largest, cord_pull(session, frame, static_cast<int>(c)).norm());
  }
  return largest;
}

/// Fills a panel with all points, the picture's middle in the panel's.
Projection fitted_projection(const SheetCamera& camera, const Eigen::Matrix3Xd& points) {
  Projection projection{camera};
  const Points flat = projection(points);
  const Eigen::Vector2d low = flat.rowwise().minCoeff();
  const Eigen::Vector2d extent = flat.rowwise().maxCoeff() - low;
  const Eigen::Vector2d room(kPanelWidth - 2 * kMargin, kPanelHeight - 2 * kMargin);
  projection.scale = (room.array() / extent.array().max(1e-9)).minCoeff();
  const Eigen::Vector2d panel(kPanelWidth, kPanelHeight);
  projection.low = low + extent / 2 - panel / (2 * projection.scale);
  return projection;
}

/// Triangles from back to front; neighbours in that order that have one colour share a path.
std::string triangles(const TriangleMesh& mesh, const Eigen::Matrix3Xd& positions,
                      const Eigen::VectorXd& part, const Projection& projection) {
  const Eigen::RowVectorXd depth = projection.camera.towards.transpose() * positions;
  std::vector<int> order(static_cast<std::size_t>(mesh.triangle_count()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, {}, [&](int t) { return depth(mesh.triangles.col(t)).sum(); });
  const Eigen::Matrix2Xi at = projection(positions).array().round().cast<int>();
  std::string svg;
  const char* colour = nullptr;
  for (const int t : order) {
    const auto corners = mesh.triangles.col(t);
    const char* own = residual_colour(part(corners).mean());
    if (own != colour) svg += fmt::format("{}<path fill=\"{}\" d=\"", colour ? "\"/>" : "", own);
    colour = own;
    const Eigen::Matrix<int, 2, 3> p = at(Eigen::all, corners);
    svg += fmt::format("M{} {}L{} {} {} {}z", p(0, 0), p(1, 0), p(0, 1), p(1, 1), p(0, 2), p(1, 2));
  }
  return svg + (colour ? "\"/>" : "");
}

std::string lines(const Points& from, const Points& to, std::string_view css_class) {
  std::string svg = fmt::format("<path class=\"{}\" d=\"", css_class);
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    svg += fmt::format("M{:.0f} {:.0f}L{:.0f} {:.0f}", from(0, i), from(1, i), to(0, i), to(1, i));
  }
  return svg + "\"/>";
}

std::string arrow_lines(const Arrows& arrows, const Projection& projection) {
  if (arrows.from.cols() == 0) return {};
  constexpr double kHead = 14, kHeadWidth = 6;
  const Points from = projection(arrows.from), to = projection(arrows.to);
  std::string svg = lines(from, to, "sheet-force");
  std::string heads;
  for (Eigen::Index i = 0; i < from.cols(); ++i) {
    const Eigen::Vector2d along = (to.col(i) - from.col(i)).stableNormalized();
    const Eigen::Vector2d tip = to.col(i) + kHead / 2 * along, back = tip - kHead * along;
    const Eigen::Vector2d across(-along.y() * kHeadWidth, along.x() * kHeadWidth);
    const Eigen::Vector2d left = back + across, right = back - across;
    heads += fmt::format("M{:.0f} {:.0f}L{:.0f} {:.0f} {:.0f} {:.0f}z", tip.x(), tip.y(), left.x(),
                         left.y(), right.x(), right.y());
  }
  return svg + "<path class=\"sheet-force-head\" d=\"" + heads + "\"/>";
}

std::string panel(int place, std::string_view title, const std::string& content) {
  return fmt::format("<g transform=\"translate({} 0)\">{}<text x=\"{}\" y=\"{}\">{}</text></g>",
                     place * kPanelWidth, content, kPanelWidth / 2, kPanelHeight + 24, title);
}

std::string svg(int panels, int height, const std::string& content) {
  return fmt::format(
      "<svg class=\"sheet-picture\" viewBox=\"0 0 {} {}\" aria-hidden=\"true\">{}</svg>\n",
      panels * kPanelWidth, height, content);
}

}  // namespace

std::string sheet_picture(const SheetSession& sheet, int frame, double largest_residual) {
  const auto f = static_cast<std::size_t>(frame);
  const Eigen::Matrix3Xd& measured = sheet.measured.frames[f].positions;
  const Eigen::Matrix3Xd& predicted = sheet.predicted.frames[f].positions;
  const double extent = (measured.rowwise().maxCoeff() - measured.rowwise().minCoeff()).norm();
  const double force =
      std::max(largest_force(sheet.measured, frame), largest_force(sheet.predicted, frame));
  const double per_newton = force > 0 ? kLongestForce * extent / force : 0;
  const Arrows seen = arrows(sheet.measured, frame, per_newton);
  const Arrows found = arrows(sheet.predicted, frame, per_newton);
  Eigen::Matrix3Xd all(3, 2 * measured.cols() + 2 * seen.to.cols());
  all << measured, predicted, seen.to, found.to;
  const Projection projection = fitted_projection(sheet_camera(sheet.measured), all);
  const Eigen::VectorXd part = position_residual(sheet, frame).colwise().norm().transpose() /
                               std::max(largest_residual, 1e-12);
  const TriangleMesh& mesh = sheet.measured.rest;
  return svg(
      2, kPanelHeight + 40,
      panel(0, "measured",
            triangles(mesh, measured, part, projection) + arrow_lines(seen, projection)) +
          panel(1, "predicted",
                triangles(mesh, predicted, part, projection) + arrow_lines(found, projection)));
}

std::string residual_picture(const SheetSession& sheet, int frame) {
  const std::vector<int> free = free_nodes(sheet.measured, frame);
  const auto& positions = sheet.predicted.frames[static_cast<std::size_t>(frame)].positions;
  const Eigen::Matrix3Xd from = positions(Eigen::all, free);
  const Eigen::Matrix3Xd to =
      from + kResidualMagnification * position_residual(sheet, frame)(Eigen::all, free);
  Eigen::Matrix3Xd all(3, positions.cols() + to.cols());
  all << positions, to;
  const Projection projection = fitted_projection(sheet_camera(sheet.measured), all);
  const Eigen::VectorXd none = Eigen::VectorXd::Zero(positions.cols());
  return svg(1, kPanelHeight,
             triangles(sheet.measured.rest, positions, none, projection) +
                 lines(projection(from), projection(to), "sheet-residual"));
}

}  // namespace pliant::report
