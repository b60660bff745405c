#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/capture/calibration_file.h"
#include "pliant/measurement/session.h"

#include "app/run_program.h"

namespace pliant::test {

/// Runs a command on files of a folder.
/// @param out  its results, a folder in that folder
inline ProgramRun run_on(const std::filesystem::path& folder, std::vector<std::string> arguments,
                         const std::string& out) {
  for (std::size_t i = 1; i < arguments.size(); ++i) {
    if (arguments[i].front() != '-') arguments[i] = (folder / arguments[i]).string();
  }
  arguments.insert(arguments.end(), {"-o", (folder / out).string()});
  return run_program(arguments);
}

/// Where places of a sheet's rest plane are, between the vertices around them.
class SheetPlaces {
 public:
  explicit SheetPlaces(const TriangleMesh& rest) : triangles_(rest.triangles) {
    for (const auto& corners : rest.triangles.colwise()) {
      const Eigen::Matrix3d own = rest.positions(Eigen::all, corners);
      Eigen::Matrix2d edges;
      edges << own.col(1).head<2>() - own.col(0).head<2>(),
          own.col(2).head<2>() - own.col(0).head<2>();
      corners_.emplace_back(own.col(0).head<2>());
      weights_.emplace_back(edges.inverse());
    }
  }

  /// NaN of a place that is not on the sheet.
  Eigen::Vector3d at(const Eigen::Matrix3Xd& positions, const Eigen::Vector2d& place) const {
    constexpr double kOutside = 1e-6;
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      const Eigen::Vector2d weights = weights_[t] * (place - corners_[t]);
      if (weights.minCoeff() < -kOutside || weights.sum() > 1 + kOutside) continue;
      const auto corners = triangles_.col(static_cast<Eigen::Index>(t));
      return positions(Eigen::all, corners) *
             Eigen::Vector3d(1 - weights.sum(), weights.x(), weights.y());
    }
    return Eigen::Vector3d::Constant(NAN);
  }

 private:
  Eigen::Matrix3Xi triangles_;
  std::vector<Eigen::Vector2d> corners_;  // the first of each triangle
  std::vector<Eigen::Matrix2d> weights_;  // of the other two, by the way from there
};

/// By how much what was seen misses what was there, without 2 mm beside clips.
struct Misses {
  /// Root mean squares of a frame, the worst of all; the largest of vertices (m).
  double in_plane = 0, off_plane = 0, largest = 0;
  /// The largest of clips' middles (m), of clips (rad), and of clamped vertices, which turns move
  /// where they are far from the middle (m).
  double of_clips = 0, of_turns = 0, of_clamped = 0;
  int vertices = 0, unseen = 0;  ///< of all frames, those unseen among them
  int wrong = 0;                 ///< of those that were seen: off by 0.3 mm
};

/// Whether a place of the rest plane is in a clip, or 2 mm beside it.
inline bool is_beside_clip(const Session& session, const Eigen::Vector2d& rest) {
  constexpr double kBeside = 2e-3;
  return std::ranges::any_of(session.clips, [&](const SessionClip& clip) {
    Eigen::AlignedBox2d box;
    for (const int vertex : clip.clamped) {
      box.extend(session.rest.positions.col(vertex).head<2>());
    }
    return box.exteriorDistance(rest) < kBeside;
  });
}

inline Misses misses_of(const Session& seen, const Session& truth) {
  constexpr double kWrong = 0.3e-3;  // m
  const SheetPlaces places(truth.rest);
  Misses misses;
  for (std::size_t f = 0; f < seen.frames.size(); ++f) {
    const SessionFrame& frame = seen.frames[f];
    double in_plane = 0, off_plane = 0;
    int vertices = 0;
    for (int v = 0; v < seen.rest.vertex_count(); ++v) {
      const Eigen::Vector2d rest = seen.rest.positions.col(v).head<2>();
      const Eigen::Vector3d off =
          frame.positions.col(v) - places.at(truth.frames[f].positions, rest);
      if (is_beside_clip(truth, rest)) continue;
      ++misses.vertices;
      if (std::ranges::binary_search(frame.unseen, v)) {
        ++misses.unseen;
        continue;
      }
      in_plane += off.head<2>().squaredNorm() / 2;
      off_plane += off.z() * off.z();
      misses.largest = std::max(misses.largest, off.norm());
      misses.wrong += off.norm() >= kWrong;
      ++vertices;
    }
    misses.in_plane = std::max(misses.in_plane, std::sqrt(in_plane / vertices));
    misses.off_plane = std::max(misses.off_plane, std::sqrt(off_plane / vertices));
    for (std::size_t c = 0; c < seen.clips.size(); ++c) {
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const int v : seen.clips[c].clamped) {
        const Eigen::Vector3d off =
            frame.positions.col(v) -
            places.at(truth.frames[f].positions, seen.rest.positions.col(v).head<2>());
        middle += off / static_cast<double>(seen.clips[c].clamped.size());
        misses.of_clamped = std::max(misses.of_clamped, off.norm());
      }
      misses.of_clips = std::max(misses.of_clips, middle.norm());
      const double turn =
          frame.poses[c].rotation.angularDistance(truth.frames[f].poses[c].rotation);
      misses.of_turns = std::max(misses.of_turns, turn);
    }
  }
  return misses;
}

inline void print_misses(const std::string& name, const Misses& misses) {
  fmt::print(
      "{}: in plane {:.4f} mm, off it {:.4f} mm (worst frame), {:.3f} mm at most; clips {:.4f} mm "
      "and {:.3f} deg at most, their ends {:.4f} mm; {:.1f} % of the vertices seen, {} of {} off "
      "by 0.3 mm\n",
      name, 1e3 * misses.in_plane, 1e3 * misses.off_plane, 1e3 * misses.largest,
      1e3 * misses.of_clips, misses.of_turns * 180 / M_PI, 1e3 * misses.of_clamped,
      100.0 - 100.0 * misses.unseen / misses.vertices, misses.wrong,
      misses.vertices - misses.unseen);
}

/// The largest angle between cords that were seen and those that pulled (rad).
inline double cord_misses(const Session& seen, const Session& truth) {
  double most = 0;
  for (std::size_t f = 0; f < seen.frames.size(); ++f) {
    for (std::size_t c = 0; c < seen.clips.size(); ++c) {
      EXPECT_EQ(seen.frames[f].cords[c].size(), truth.frames[f].cords[c].size());
      for (const CordForce& cord : truth.frames[f].cords[c]) {
        const auto found = std::ranges::find(seen.frames[f].cords[c], cord.cord, &CordForce::cord);
        if (found == seen.frames[f].cords[c].end()) return M_PI;
        most = std::max(most, std::asin(found->force.cross(cord.force).norm() /
                                        (found->force.norm() * cord.force.norm())));
        EXPECT_NEAR(found->force.norm(), cord.force.norm(), 3e-3) << cord.cord;
      }
    }
  }
  fmt::print("cords within {:.3f} deg\n", most * 180 / M_PI);
  return most;
}

/// By how much a calibration misses the cameras as they are.
struct CalibrationMisses {
  double focal = 0;           ///< the largest of focal lengths (pixels)
  double place = 0;           ///< of where cameras are to the first (m)
  double worst = 0;           ///< of all numbers, in stated errors
  int numbers = 0, held = 0;  ///< that are estimated, by their 95 % intervals

  void add(double miss, double error) {
    if (error == 0) return;  // not estimated
    ++numbers;
    held += std::abs(miss) < 1.96 * error;
    worst = std::max(worst, std::abs(miss) / error);
  }
};

/// @param seen  the folder of a rig that was drawn and calibrated
inline CalibrationMisses calibration_misses(const std::filesystem::path& seen) {
  const CalibratedRig found = read_calibration(seen / "calibration" / "calibration.json");
  const CalibratedRig truth = read_calibration(seen / "truth.json");
  const Eigen::VectorXd errors = found.covariance.diagonal().cwiseSqrt();
  CalibrationMisses misses;
  for (std::size_t c = 0; c < truth.cameras.size(); ++c) {
    const CameraModel &own = found.cameras[c], &known = truth.cameras[c];
    Eigen::Vector<double, kCameraNumbers> off;
    off << own.intrinsics - known.intrinsics, own.pose.rotation - known.pose.rotation,
        own.pose.translation - known.pose.translation;
    for (Eigen::Index i = 0; i < off.size(); ++i) {
      misses.add(off(i), errors(kCameraNumbers * static_cast<Eigen::Index>(c) + i));
    }
    misses.focal = std::max(misses.focal, off.head<2>().cwiseAbs().maxCoeff());
    misses.place = std::max(misses.place, (own.centre() - known.centre()).norm());
  }
  fmt::print(
      "calibration: focal lengths within {:.2f} pixels, cameras within {:.3f} mm; {} of {} "
      "intervals hold the truth, {:.1f} errors off at most\n",
      misses.focal, 1e3 * misses.place, misses.held, misses.numbers, misses.worst);
  return misses;
}

}  // namespace pliant::test
