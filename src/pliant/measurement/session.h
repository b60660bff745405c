#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/quantity.h"
#include "pliant/geometry/pose.h"
#include "pliant/geometry/triangle_mesh.h"

namespace pliant {

/// What was measured.
enum class SessionKind {
  sheet,  ///< forces of clips and places of vertices
  strip,  ///< of a tensile tester: how far its two clamps are apart and what pulls the second one;
          ///< vertices are where a uniform stretch would have them
};

/// The piece of cloth of a session.
struct SessionSample {
  std::string id;                 ///< may be empty
  double width = 0, height = 0;   ///< along weft and along warp (m)
  std::optional<double> mass;     ///< kg; this or `density` is given
  std::optional<double> density;  ///< kg/m^2; absent: mass over the area of the rest mesh
};

/// Standard deviation of what was measured, as far as it is stated.
struct SheetNoise {
  std::optional<double> position;  ///< of a coordinate of a vertex (m)
  std::optional<double> force;     ///< of a component of a clip's force (N)
};

/// A rigid body that vertices are clamped to.
struct SessionClip {
  std::string name;
  double mass = 0;           ///< kg, without the cloth
  std::vector<int> clamped;  ///< vertices; each in one clip
};

/// The pull of a cord at its clip.
struct CordForce {
  std::string cord;                                 ///< its name; may be empty
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< of attachment, world (m)
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< on the clip, world (N)
};

/// Force by which a cord may miss: the hysteresis of its pulleys ([T] 3.2.3; N).
inline constexpr double kCordFriction = 0.1;

/// A static state of the sheet.
struct SessionFrame {
  Eigen::Matrix3Xd positions;                 ///< m, one column a vertex of the rest mesh
  std::vector<int> unseen;                    ///< vertices that were not seen, in order: their
                                              ///< positions are filled in
  std::vector<Pose> poses;                    ///< of each clip, relative to the rest mesh
  std::vector<std::vector<CordForce>> cords;  ///< of each clip
  std::optional<double> table_edge;           ///< where the session has a table: m, rest plane
  std::optional<double> time;                 ///< s
  /// Standard deviations of the positions along the axes (m); empty where they are not known.
  Eigen::Matrix3Xd deviations = {};
};

/// Axes of the rest plane.
enum class RestAxis { u, v };

/// One full-field measurement sequence of a sheet ([T] 3.2), the content of a session/1 directory
/// (docs/formats/session.md). SI units, world axes.
struct Session {
  SessionKind kind = SessionKind::sheet;
  std::string test;  ///< stretch-weft, shear, ..., or a name of its own
  std::map<std::string, std::string> info;
  SessionSample sample;
  Eigen::Vector3d gravity{0, 0, -kStandardGravity};  ///< m/s^2
  double balance_bound = kCordFriction;  ///< imbalance for each cord that needs no warning (N)
  SheetNoise noise;
  TriangleMesh rest;  ///< flat: z = 0, u = x, v = y
  std::vector<SessionClip> clips;
  std::optional<RestAxis> table;  ///< across the edge of the table that holds the sheet
  std::vector<SessionFrame> frames;
  std::vector<std::string> warnings;   ///< what the user should know, one line each
  std::vector<std::string> questions;  ///< units and sizes that are hardly right, as warnings

  int frame_count() const { return static_cast<int>(frames.size()); }
};

/// The middle of the vertices that a clip clamps, in a frame (m).
Eigen::Vector3d clip_middle(const Session& session, int frame, int clip);

/// A session with some of its frames alone, in their order.
Session with_frames(const Session& session, const std::vector<int>& frames);

/// Reads and judges a session/1 directory.
/// @throws InputError that names file, line, and the frame, clip or vertex at fault
Session read_session(const std::filesystem::path& directory);

/// The files of a session by their names relative to its directory: session.yaml, rest.ply, frames
/// (binary PLY), cords.csv, clips.csv and, with a table, table.csv. `read_session` gives back the
/// same numbers, to the bit; a table's edge, which is written in mm, to the last bit or its
/// neighbour. Times are in the tables, where rows of a frame can hold them.
std::vector<std::pair<std::string, std::string>> session_files(const Session& session);
/// The same, one after the other: all of them together may be too large for the memory.
/// @param take  is given the name and the content of each
void make_session_files(const Session& session,
                        const std::function<void(const std::string&, std::string)>& take);

/// Writes a session/1 directory, which is complete afterwards or as it was before.
/// @param command  of the program that makes it, whose earlier results are replaced
/// @throws InputError where `directory` holds anything else, OutputError when writing fails
void write_session(const std::filesystem::path& directory, const Session& session,
                   const std::string& command = "capture");

}  // namespace pliant
