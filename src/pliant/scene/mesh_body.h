#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/scene/body_source.h"
#include "pliant/scene/motion.h"

namespace pliant {

/// A body of triangles that stands, is led, or goes through the frames of a sequence.
class MeshBody {
 public:
  /// Reads all its files.
  /// @param motion  of a body that is led, from where it stands
  /// @throws InputError, also where a frame has other faces than the first
  MeshBody(const BodySource& source, const std::optional<Motion>& motion);

  /// Vertices of each triangle, one column a triangle.
  const Eigen::Matrix3Xi& triangles() const { return triangles_; }
  Eigen::Index vertex_count() const { return frames_.front().cols(); }
  bool moves() const { return motion_.has_value() || frames_.size() > 1; }

  /// Of the vertices at a time (s), straight from frame to frame; at rest after the last (m).
  Eigen::Matrix3Xd positions(double time) const;

 private:
  std::vector<Eigen::Matrix3Xd> frames_;
  double rate_;
  std::optional<Motion> motion_;
  Eigen::Matrix3Xi triangles_;
};

/// A body of triangles within the system of a scene.
struct BodyPiece {
  std::string name;
  std::shared_ptr<const MeshBody> body;
  int first_point = 0;  ///< of the system: the body's vertex 0

  Eigen::Matrix3Xi triangles() const { return body->triangles().array() + first_point; }
};

}  // namespace pliant
