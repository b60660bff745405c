#include "pliant/mechanics/coordinates.h"

#include <algorithm>
#include <array>

#include <Eigen/Eigenvalues>

#include "pliant/base/assert.h"
#include "pliant/math/cross_matrix.h"

namespace pliant {
namespace {

Eigen::Quaterniond rotation_by(const Eigen::Vector3d& vector) {
  const double angle = vector.norm();
  if (angle == 0) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(angle, vector / angle));
}

}  // namespace

Coordinates::Coordinates(int points) : owner_(static_cast<size_t>(points), kFree) { number(); }

void Coordinates::prescribe(int point) {
  PLIANT_ASSERT(owner_.at(static_cast<size_t>(point)) < 0, "a point of a clip moves with it");
  owner_[static_cast<size_t>(point)] = kPrescribed;
}

void Coordinates::prescribe_axis(int point, int axis) {
  PLIANT_ASSERT(owner_.at(static_cast<size_t>(point)) == kFree && axis >= 0 && axis < 3,
                "an axis of a free point");
  held_axes_.push_back({point, axis});
}

int Coordinates::add_clip(const std::vector<int>& points, bool prescribed) {
  PLIANT_ASSERT(!points.empty(), "a clip holds points");
  for (const int point : points) {
    int& owner = owner_.at(static_cast<size_t>(point));
    PLIANT_ASSERT(owner == kFree, "a point has one owner");
    owner = clips();
  }
  clips_.push_back({points, {}, prescribed, -1});
  return clips() - 1;
}

bool Coordinates::clip_is_prescribed(int clip) const {
  return clips_.at(static_cast<size_t>(clip)).prescribed;
}

const std::vector<int>& Coordinates::clip_points(int clip) const {
  return clips_.at(static_cast<size_t>(clip)).points;
}

double Coordinates::clip_radius(int clip, const Configuration& at) const {
  const Pose& pose = at.clips[static_cast<size_t>(clip)];
  double radius = 0;
  for (const int point : clip_points(clip)) {
    radius = std::max(radius, (at.positions.col(point) - pose.translation).norm());
  }
  return radius;
}

bool Coordinates::is_prescribed(int point) const {
  const int owner = owner_[static_cast<size_t>(point)];
  return owner == kPrescribed || (owner >= 0 && clip_is_prescribed(owner));
}

bool Coordinates::is_led(int point) const {
  return is_prescribed(point) ||
         std::ranges::any_of(held_axes_, [&](const HeldAxis& held) { return held.point == point; });
}

void Coordinates::number() {
  block_rows_ = 0;
  rows_.assign(owner_.size(), -1);
  for (size_t i = 0; i < owner_.size(); ++i) {
    if (owner_[i] == kFree) rows_[i] = block_rows_++;
  }
  for (Clip& clip : clips_) {
    if (clip.prescribed) continue;
    clip.row = block_rows_;
    block_rows_ += 2;
  }
}

Configuration Coordinates::initial_configuration(const Eigen::Matrix3Xd& positions) {
  Configuration configuration{positions, {}};
  for (Clip& clip : clips_) {
    const Eigen::Matrix3Xd points = positions(Eigen::all, clip.points);
    Pose pose;
    pose.translation = points.rowwise().mean();
    clip.local = points.colwise() - pose.translation;
    configuration.clips.push_back(pose);
  }
  return configuration;
}

Coordinates::Dependences Coordinates::dependences(const Configuration& at, int point) const {
  const int owner = owner_[static_cast<size_t>(point)];
  if (owner == kFree) return {1, {{row(point), Eigen::Matrix3d::Identity()}, {}}};
  if (owner == kPrescribed || clips_[static_cast<size_t>(owner)].prescribed) return {};
  const int first = clips_[static_cast<size_t>(owner)].row;
  const Eigen::Vector3d arm =
      at.positions.col(point) - at.clips[static_cast<size_t>(owner)].translation;
  return {2, {{first, Eigen::Matrix3d::Identity()}, {first + 1, -cross_matrix(arm)}}};
}

std::shared_ptr<const BlockPattern> Coordinates::pattern(
    const std::vector<std::pair<int, int>>& couplings) const {
  const auto rows_of = [this](int point) -> std::pair<int, int> {  // first row and how many
    const int owner = owner_[static_cast<size_t>(point)];
    if (owner == kFree) return {row(point), 1};
    if (owner == kPrescribed || clips_[static_cast<size_t>(owner)].prescribed) return {0, 0};
    return {clips_[static_cast<size_t>(owner)].row, 2};
  };
  std::vector<std::pair<int, int>> blocks;
  blocks.reserve(couplings.size());
  for (const auto& [i, j] : couplings) {
    const auto [first_i, count_i] = rows_of(i);
    const auto [first_j, count_j] = rows_of(j);
    for (int a = first_i; a < first_i + count_i; ++a) {
      for (int b = first_j; b < first_j + count_j; ++b) {
        if (a != b) blocks.emplace_back(a, b);
      }
    }
  }
  for (const Clip& clip : clips_) {
    if (!clip.prescribed) blocks.emplace_back(clip.row, clip.row + 1);
  }
  return std::make_shared<BlockPattern>(block_rows_, std::move(blocks));
}

Eigen::VectorXd Coordinates::reduce(const Configuration& at,
                                    const Eigen::Matrix3Xd& gradient) const {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(unknowns());
  for (int i = 0; i < points(); ++i) {
    if (is_free(i)) {
      result.segment<3>(3 * row(i)) = gradient.col(i);
      continue;
    }
    const Dependences parents = dependences(at, i);
    for (int a = 0; a < parents.count; ++a) {
      result.segment<3>(3 * parents.entry[a].row) +=
          parents.entry[a].matrix.transpose() * gradient.col(i);
    }
  }
  for (const HeldAxis& held : held_axes_) result(3 * row(held.point) + held.axis) = 0;
  return result;
}

Eigen::Matrix3Xd Coordinates::motion(const Configuration& at, const Eigen::VectorXd& change) const {
  Eigen::Matrix3Xd motion = Eigen::Matrix3Xd::Zero(3, points());
  for (int i = 0; i < points(); ++i) {
    const Dependences parents = dependences(at, i);
    for (int a = 0; a < parents.count; ++a) {
      motion.col(i) += parents.entry[a].matrix * change.segment<3>(3 * parents.entry[a].row);
    }
  }
  return motion;
}

void Coordinates::add_coupling(const Configuration& at, int i, int j, const Eigen::Matrix3d& value,
                               BlockMatrix& hessian) const {
  const Dependences rows = dependences(at, i), columns = dependences(at, j);
  for (int a = 0; a < rows.count; ++a) {
    for (int b = i == j ? a : 0; b < columns.count; ++b) {
      const Dependence &r = rows.entry[a], &c = columns.entry[b];
      const Eigen::Matrix3d part = r.matrix.transpose() * value * c.matrix;
      if (i != j && r.row == c.row) {
        hessian.add(r.row, c.row, part + part.transpose());
      } else {
        hessian.add(r.row, c.row, part);
      }
    }
  }
}

void Coordinates::add_difference(const Configuration& at, int i, int j,
                                 const Eigen::Matrix3d& value, BlockMatrix& hessian) const {
  add_coupling(at, i, j, value, hessian);
  add_coupling(at, i, i, -value, hessian);
  add_coupling(at, j, j, -value.transpose(), hessian);
}

void Coordinates::complete_diagonals(BlockMatrix& hessian) const {
  const auto is_free = [](int row) { return row >= 0; };
  hessian.complete_diagonals(static_cast<int>(std::count_if(rows_.begin(), rows_.end(), is_free)));
}

// x(w) = exp(w) arm: the second-order part is w x (w x arm) / 2.
void Coordinates::add_rotation_terms(const Configuration& at, const Eigen::Matrix3Xd& gradient,
                                     BlockMatrix& hessian) const {
  for (size_t k = 0; k < clips_.size(); ++k) {
    const Clip& clip = clips_[k];
    if (clip.prescribed) continue;
    for (const int point : clip.points) {
      const Eigen::Vector3d arm = at.positions.col(point) - at.clips[k].translation;
      const Eigen::Vector3d g = gradient.col(point);
      const Eigen::Matrix3d moment = g * arm.transpose();
      hessian.add(clip.row + 1, clip.row + 1,
                  (moment + moment.transpose()) / 2 - g.dot(arm) * Eigen::Matrix3d::Identity());
    }
  }
}

void Coordinates::hold_neutral_rotations(const Configuration& at, BlockMatrix& hessian) const {
  constexpr double kFlat = 1e-12;  // of the squared radius: rounding of points on a line
  for (size_t k = 0; k < clips_.size(); ++k) {
    const Clip& clip = clips_[k];
    if (clip.prescribed) continue;
    const Eigen::Matrix3Xd arms =
        at.positions(Eigen::all, clip.points).colwise() - at.clips[k].translation;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> spread(arms * arms.transpose());
    const Eigen::Vector3d& squares = spread.eigenvalues();  // increasing
    if (squares(1) > kFlat * squares(2)) continue;
    const bool is_point = squares(2) == 0;
    const Eigen::Vector3d line = spread.eigenvectors().col(2);
    const Eigen::Matrix3d neutral =
        is_point ? Eigen::Matrix3d::Identity().eval() : (line * line.transpose()).eval();
    auto block = hessian.diagonal(clip.row + 1);
    const double size = block.diagonal().cwiseAbs().maxCoeff();
    block += (size > 0 ? size : 1) * neutral;
  }
}

void Coordinates::add_outer_product(const Configuration& at, double factor,
                                    const std::array<int, 4>& points,
                                    const Eigen::Matrix<double, 3, 4>& u,
                                    BlockMatrix& hessian) const {
  std::array<RowVector, 8> rows;
  size_t count = 0;
  for (int k = 0; k < 4; ++k) {
    const Dependences own = dependences(at, points[static_cast<size_t>(k)]);
    for (int d = 0; d < own.count; ++d) {
      const Dependence& on = own.entry[d];
      const Eigen::Vector3d value = on.matrix.transpose() * u.col(k);
      const auto end = rows.begin() + static_cast<std::ptrdiff_t>(count);
      // Points of one clip share their rows.
      const auto same =
          std::find_if(rows.begin(), end, [&](const RowVector& r) { return r.row == on.row; });
      if (same != end) {
        same->value += value;
      } else {
        rows[count++] = {on.row, value};
      }
    }
  }
  hessian.add_outer_product(factor, std::span(rows).first(count));
}

void Coordinates::decouple_prescribed_axes(BlockMatrix& hessian) const {
  if (held_axes_.empty()) return;
  std::vector<std::array<bool, 3>> held(static_cast<size_t>(block_rows_));
  for (const HeldAxis& h : held_axes_) {
    held[static_cast<size_t>(row(h.point))][static_cast<size_t>(h.axis)] = true;
  }
  const auto decouple = [&](int i, int j, auto block) {
    for (size_t a = 0; a < 3; ++a) {
      if (held[static_cast<size_t>(i)][a]) block.row(static_cast<Eigen::Index>(a)).setZero();
      if (held[static_cast<size_t>(j)][a]) block.col(static_cast<Eigen::Index>(a)).setZero();
    }
  };
  const BlockPattern& pattern = hessian.pattern();
  for (int i = 0; i < pattern.size(); ++i) {
    auto block = hessian.diagonal(i);
    const double scale = std::max(block.diagonal().cwiseAbs().maxCoeff(), 1e-300);
    decouple(i, i, block);
    for (int a = 0; a < 3; ++a) {
      if (held[static_cast<size_t>(i)][static_cast<size_t>(a)]) block(a, a) = scale;
    }
    hessian.with_entries([&]<class Number>(Number* entries) {
      for (int k = pattern.row_begin(i) + 1; k < pattern.row_end(i); ++k) {
        decouple(i, pattern.column(k), Eigen::Map<Eigen::Matrix<Number, 3, 3>>(entries + 9 * k));
      }
    });
  }
  for (RowVector& vector : hessian.vectors()) {
    for (size_t a = 0; a < 3; ++a) {
      if (held[static_cast<size_t>(vector.row)][a]) vector.value(static_cast<Eigen::Index>(a)) = 0;
    }
  }
}

Configuration Coordinates::moved(const Configuration& from, const Eigen::VectorXd& change) const {
  Configuration to = from;
  for (int i = 0; i < points(); ++i) {
    if (is_free(i)) to.positions.col(i) += change.segment<3>(3 * row(i));
  }
  for (int k = 0; k < clips(); ++k) {
    const Clip& clip = clips_[static_cast<size_t>(k)];
    if (clip.prescribed) continue;
    Pose pose = from.clips[static_cast<size_t>(k)];
    pose.translation += change.segment<3>(3 * clip.row);
    pose.rotation = (rotation_by(change.segment<3>(3 * clip.row + 3)) * pose.rotation).normalized();
    place_clip(k, pose, to);
  }
  return to;
}

void Coordinates::place_clip(int clip, const Pose& pose, Configuration& configuration) const {
  const Clip& body = clips_[static_cast<size_t>(clip)];
  configuration.clips[static_cast<size_t>(clip)] = pose;
  for (size_t i = 0; i < body.points.size(); ++i) {
    configuration.positions.col(body.points[i]) =
        pose.apply(body.local.col(static_cast<Eigen::Index>(i)));
  }
}

void Coordinates::apply(const Controls& controls, Configuration& configuration) const {
  for (const Controls::Place& place : controls.places) {
    for (int axis = 0; axis < 3; ++axis) {
      if (!place.axes[static_cast<size_t>(axis)]) continue;
      configuration.positions(axis, place.point) = place.position(axis);
    }
  }
  for (const Controls::ClipPose& clip : controls.poses) {
    place_clip(clip.clip, clip.pose, configuration);
  }
}

}  // namespace pliant
