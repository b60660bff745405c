#include "pliant/measurement/session/balance.h"

#include <cmath>
#include <optional>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/number_text.h"
#include "pliant/mechanics/cloth_potentials.h"

namespace pliant {
namespace {

/// Mass and density of a sample may differ by this part.
constexpr double kMassAgreement = 0.05;
constexpr int kDigits = 3;

void warn_of_mass(const Session& session, std::vector<std::string>& warnings) {
  const SessionSample& sample = session.sample;
  if (!sample.mass || !sample.density) return;
  const double by_density = *sample.density * rest_area(session.rest);
  if (std::abs(by_density - *sample.mass) <= kMassAgreement * *sample.mass) return;
  warnings.push_back(
      fmt::format("the sample weighs {} by its density and {} by its mass: the density is used",
                  format_quantity(by_density, Dimension::mass),
                  format_quantity(*sample.mass, Dimension::mass)));
}

/// The frame that is worst by some size, and how many are out of bounds by it.
struct Worst {
  int frame = 0, count = 0;
  double size = 0, bound = 0, excess = 0;

  void look_at(int at, double found, double allowed) {
    if (found <= allowed) return;
    ++count;
    if (count > 1 && found - allowed <= excess) return;
    frame = at;
    size = found;
    bound = allowed;
    excess = found - allowed;
  }
};

std::string sentence(const char* what, const Worst& worst, const char* unit,
                     const Session& session) {
  return fmt::format(
      "the {} on sheet and clips are out of balance in {} of {} frames, most in frame {}: {} {} "
      "are left of cords and weights (expected: at most {} {}, `balance_bound` of {} N a cord)",
      what, worst.count, session.frame_count(), worst.frame, format_number(worst.size, kDigits),
      unit, format_number(worst.bound, kDigits), unit,
      format_number(session.balance_bound, kDigits));
}

/// What the cords of all frames with cords pull with together, on average (N); none without any.
std::optional<Eigen::Vector3d> mean_pull(const Session& session) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  int frames = 0;
  for (const SessionFrame& frame : session.frames) {
    bool any = false;
    for (const auto& cords : frame.cords) {
      for (const CordForce& cord : cords) sum += cord.force;
      any = any || !cords.empty();
    }
    if (any) ++frames;
  }
  if (frames == 0) return std::nullopt;
  return sum / frames;
}

double mass_of(const Session& session) {
  double mass = area_density(session) * rest_area(session.rest);
  for (const SessionClip& clip : session.clips) mass += clip.mass;
  return mass;
}

/// Cords of light cloth may all miss by more than it weighs. Their mean says nevertheless whether
/// they carry it: nothing of it, or as if gravity pulled another way.
void warn_of_weight(const Session& session, std::vector<std::string>& warnings) {
  constexpr double kFar = 0.5, kNear = 0.2;  // of the weight
  const auto pull = mean_pull(session);
  if (!pull) return;
  const double mass = mass_of(session);
  const double weight = mass * kStandardGravity;
  if ((*pull + mass * session.gravity).norm() <= kFar * weight) return;
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector3d other = sign * kStandardGravity * Eigen::Vector3d::Unit(axis);
      if ((*pull + mass * other).norm() > kNear * weight) continue;
      warnings.push_back(fmt::format(
          "the cords carry sheet and clips as if gravity were {:.4g} m/s^2 along {}{} (expected: "
          "[{:.4g}, {:.4g}, {:.4g}], as session.yaml says, and forces in the axes of the frames)",
          kStandardGravity, sign < 0 ? '-' : '+', "xyz"[axis], session.gravity.x(),
          session.gravity.y(), session.gravity.z()));
      return;
    }
  }
  if (pull->norm() > kNear * weight || session.gravity.isZero()) return;
  warnings.push_back(
      fmt::format("the forces of all cords add up to {} N on average, but sheet and clips weigh {} "
                  "N: cords carry the weights, too",
                  format_number(pull->norm(), kDigits), format_number(weight, kDigits)));
}

}  // namespace

bool states_density(const Session& session) {
  return session.sample.density || session.sample.mass;
}

double area_density(const Session& session) {
  constexpr double kAnyDensity = 0.1;  // kg/m^2; nothing depends on it
  if (session.sample.density) return *session.sample.density;
  if (!session.sample.mass) {
    PLIANT_ASSERT(session.kind == SessionKind::strip, "a sample has a mass or a density");
    return kAnyDensity;
  }
  return *session.sample.mass / rest_area(session.rest);
}

Eigen::VectorXd vertex_masses(const Session& session) {
  return area_density(session) * vertex_areas(session.rest);
}

ClipLoad clip_load(const Session& session, int frame, int clip, const Eigen::Vector3d& centre) {
  const SessionClip& body = session.clips[static_cast<std::size_t>(clip)];
  const SessionFrame& now = session.frames[static_cast<std::size_t>(frame)];
  ClipLoad load;
  load.force = body.mass * session.gravity;
  load.moment = (clip_middle(session, frame, clip) - centre).cross(load.force);
  for (const CordForce& cord : now.cords[static_cast<std::size_t>(clip)]) {
    load.force += cord.force;
    load.moment += (cord.point - centre).cross(cord.force);
  }
  return load;
}

Eigen::Vector3d sheet_centre(const Session& session, int frame) {
  const Eigen::VectorXd masses = vertex_masses(session);
  return session.frames[static_cast<std::size_t>(frame)].positions * masses / masses.sum();
}

Imbalance imbalance(const Session& session, int frame) {
  PLIANT_ASSERT(!session.table, "the support of a table is not known");
  const Eigen::Vector3d centre = sheet_centre(session, frame);
  Imbalance left;
  left.force = area_density(session) * rest_area(session.rest) * session.gravity;
  for (int clip = 0; clip < static_cast<int>(session.clips.size()); ++clip) {
    const ClipLoad load = clip_load(session, frame, clip, centre);
    left.force += load.force;
    left.moment += load.moment;
  }
  for (const auto& cords : session.frames[static_cast<std::size_t>(frame)].cords) {
    for (const CordForce& cord : cords) {
      left.force_bound += session.balance_bound;
      left.moment_bound += session.balance_bound * (cord.point - centre).norm();
    }
  }
  return left;
}

std::optional<double> carried_share(const Session& session) {
  const auto pull = mean_pull(session);
  if (!pull || session.table || session.gravity.isZero()) return std::nullopt;
  std::size_t cords = 0;
  for (const SessionFrame& frame : session.frames) {
    std::size_t here = 0;
    for (const auto& of_clip : frame.cords) here += of_clip.size();
    cords = std::max(cords, here);
  }
  const double carried = -pull->dot(session.gravity.normalized());
  if (carried < session.balance_bound * static_cast<double>(cords)) return std::nullopt;
  return carried / (mass_of(session) * session.gravity.norm());
}

std::vector<std::string> balance_warnings(const Session& session) {
  std::vector<std::string> warnings;
  warn_of_mass(session, warnings);
  if (session.table) return warnings;
  Worst forces, moments;
  for (int frame = 0; frame < session.frame_count(); ++frame) {
    const Imbalance left = imbalance(session, frame);
    if (left.force_bound == 0) continue;  // no cords
    forces.look_at(frame, left.force.norm(), left.force_bound);
    moments.look_at(frame, left.moment.norm(), left.moment_bound);
  }
  if (forces.count > 0) warnings.push_back(sentence("forces", forces, "N", session));
  if (moments.count > 0) warnings.push_back(sentence("moments", moments, "N m", session));
  warn_of_weight(session, warnings);
  return warnings;
}

}  // namespace pliant
