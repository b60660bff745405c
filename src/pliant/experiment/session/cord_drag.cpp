#include "pliant/experiment/session/cord_drag.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "pliant/base/assert.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {
namespace {

constexpr double kPoseNoise = 25e-6;  // 75 um in each of about ten vertices ([T] 3.2.3)
constexpr double kTurned = 6;         // standard deviations of its noise that a path turns back by

/// A cord in the frames in which it was measured.
struct Cord {
  int clip = 0;
  std::string name;
  std::vector<int> frames;
  std::vector<const CordForce*> pulls;
};

std::vector<Cord> cords_of(const Session& session) {
  std::vector<Cord> cords;
  for (std::size_t c = 0; c < session.clips.size(); ++c) {
    const std::size_t first = cords.size();
    for (int f = 0; f < session.frame_count(); ++f) {
      const std::vector<CordForce>& pulls = session.frames[static_cast<std::size_t>(f)].cords[c];
      for (std::size_t i = 0; i < pulls.size(); ++i) {
        const std::string name = pulls[i].cord.empty() ? std::to_string(i + 1) : pulls[i].cord;
        auto cord = std::find_if(cords.begin() + static_cast<std::ptrdiff_t>(first), cords.end(),
                                 [&](const Cord& other) { return other.name == name; });
        if (cord == cords.end()) {
          cords.push_back({static_cast<int>(c), name, {}, {}});
          cord = cords.end() - 1;
        }
        cord->frames.push_back(f);
        cord->pulls.push_back(&pulls[i]);
      }
    }
  }
  return cords;
}

const Pose& pose_of(const Session& session, const Cord& cord, int frame) {
  return session.frames[static_cast<std::size_t>(frame)].poses[static_cast<std::size_t>(cord.clip)];
}

/// Where a cord is attached: at one place of its clip, whose pose is known better than any point.
Eigen::Matrix3Xd attachments(const Session& session, const Cord& cord) {
  Eigen::Vector3d place = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < cord.frames.size(); ++i) {
    const Pose& pose = pose_of(session, cord, cord.frames[i]);
    place += pose.rotation.conjugate() * (cord.pulls[i]->point - pose.translation);
  }
  place /= static_cast<double>(cord.frames.size());
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(cord.frames.size()));
  for (Eigen::Index i = 0; i < points.cols(); ++i) {
    points.col(i) = pose_of(session, cord, cord.frames[static_cast<std::size_t>(i)]).apply(place);
  }
  return points;
}

/// The line of a cord, the way it pulls. Noise may turn the reading of a slack cord around, but not
/// the cord.
Eigen::Matrix3Xd lines(const Cord& cord) {
  Eigen::Matrix3Xd lines(3, static_cast<Eigen::Index>(cord.pulls.size()));
  Eigen::Vector3d line = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < lines.cols(); ++i) {
    const Eigen::Vector3d pull = cord.pulls[static_cast<std::size_t>(i)]->force.normalized();
    if (pull.norm() > 0) line = pull.dot(line) < 0 ? Eigen::Vector3d(-pull) : pull;
    lines.col(i) = line;
  }
  return lines;
}

/// Standard deviation of the noise of a path, from its third differences, of which noise makes all
/// and turns make few. A clip of few vertices is known worse than a bar.
double noise_of(const std::vector<double>& path) {
  constexpr double kLowerQuartile = 0.3186;  // of the size of a normal number
  constexpr std::ptrdiff_t kFewest = 12;     // of which turns may make most
  const double spread = std::sqrt(1.0 + 9 + 9 + 1);
  std::vector<double> thirds;
  for (std::size_t i = 3; i < path.size(); ++i) {
    thirds.push_back(std::abs(path[i] - 3 * path[i - 1] + 3 * path[i - 2] - path[i - 3]));
  }
  if (std::ssize(thirds) < kFewest) return kPoseNoise;
  const auto quartile = thirds.begin() + std::ssize(thirds) / 4;
  std::ranges::nth_element(thirds, quartile);
  return std::max(*quartile / (kLowerQuartile * spread), kPoseNoise);
}

/// Which way a path goes in each frame.
struct Ways {
  std::vector<int> direction;  // 1 where it rises, -1 where it falls; 1 at its beginning
  std::vector<char> certain;   // not so near a turn that noise says in which frame it is
};

Ways ways_of(const std::vector<double>& path) {
  const double least = kTurned * noise_of(path);
  Ways ways{std::vector<int>(path.size(), 1), std::vector<char>(path.size(), 1)};
  std::size_t from = 0;
  for (const int turn : turning_samples(path, least)) {
    const auto to = static_cast<std::size_t>(turn);
    const int sign = path[to] < path[from] ? -1 : 1;
    for (std::size_t i = from + 1; i <= to; ++i) {
      const bool at_last = to + 1 < path.size() && std::abs(path[i] - path[to]) < least;
      const bool at_first = from > 0 && std::abs(path[i] - path[from]) < least;
      ways.direction[i] = sign;
      ways.certain[i] = !at_last && !at_first;
    }
    from = to;
  }
  return ways;
}

CordDrag drag_of(const Session& session, const Cord& cord) {
  const Eigen::Matrix3Xd points = attachments(session, cord), along = lines(cord);
  std::vector<double> path(cord.frames.size(), 0);
  for (std::size_t i = 1; i < path.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    path[i] = path[i - 1] + (points.col(at) - points.col(at - 1)).dot(along.col(at));
  }
  const Ways ways = ways_of(path);
  CordDrag drag{cord.clip, cord.name, Eigen::Matrix3Xd::Zero(3, session.frame_count()),
                Eigen::Matrix3Xd::Zero(3, session.frame_count()),
                std::vector<char>(session.frames.size(), 1)};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(i);
    const int frame = cord.frames[i];
    const Eigen::Vector3d force = ways.direction[i] * along.col(at) / 2;
    drag.certain[static_cast<std::size_t>(frame)] = ways.certain[i];
    const Eigen::Vector3d arm = points.col(at) - clip_middle(session, frame, cord.clip);
    drag.forces.col(frame) = force;
    drag.moments.col(frame) = arm.cross(force);
  }
  return drag;
}

void append_derivatives(const std::vector<CordDrag>& cords, Eigen::Index frame, SheetShape& shape) {
  const auto more = static_cast<Eigen::Index>(cords.size());
  Eigen::MatrixXd& forces = shape.clip_forces_by_parameter;
  Eigen::MatrixXd& positions = shape.positions_by_parameter;
  forces.conservativeResize(shape.clip_forces.size(), forces.cols() + more);
  positions.conservativeResize(shape.positions.size(), positions.cols() + more);
  forces.rightCols(more).setZero();
  positions.rightCols(more).setZero();
  for (Eigen::Index i = 0; i < more; ++i) {
    const CordDrag& cord = cords[static_cast<std::size_t>(i)];
    forces.rightCols(more).col(i).segment<3>(static_cast<Eigen::Index>(3 * cord.clip)) =
        cord.forces.col(frame);
  }
}

}  // namespace

std::vector<CordDrag> cord_drags(const Session& session) {
  std::vector<CordDrag> drags;
  for (const Cord& cord : cords_of(session)) drags.push_back(drag_of(session, cord));
  return drags;
}

void add_cord_drags(const std::vector<CordDrag>& cords, const Eigen::VectorXd& widths,
                    bool derivatives, int frame, SheetShape& shape) {
  PLIANT_ASSERT(widths.size() == static_cast<Eigen::Index>(cords.size()), "a width for each cord");
  for (std::size_t i = 0; i < cords.size(); ++i) {
    const double width = widths(static_cast<Eigen::Index>(i));
    shape.clip_forces.col(cords[i].clip) += width * cords[i].forces.col(frame);
    shape.clip_moments.col(cords[i].clip) += width * cords[i].moments.col(frame);
  }
  if (derivatives) append_derivatives(cords, frame, shape);
}

}  // namespace pliant
