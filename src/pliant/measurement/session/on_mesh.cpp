#include "pliant/measurement/session/on_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/convex_hull.h"
#include "pliant/geometry/mesh_quality.h"
#include "pliant/geometry/rest_search.h"

namespace pliant {
namespace {

std::vector<RestPoint> places_of_nodes(const Session& session, const TriangleMesh& mesh) {
  const double most = kMeshOverhang * std::max(session.sample.width, session.sample.height);
  const RestSearch search(session.rest);
  std::vector<RestPoint> places;
  for (int node = 0; node < mesh.vertex_count(); ++node) {
    const RestPoint place = search.find(mesh.positions.col(node).head<2>());
    if (place.outside > most) {
      throw InputError({},
                       fmt::format("node {} of the mesh lies {} outside of the session's rest mesh",
                                   node, format_quantity(place.outside, Dimension::length)),
                       fmt::format("at most {}", format_quantity(most, Dimension::length)));
    }
    places.push_back(place);
  }
  return places;
}

/// The clip in whose region a node lies, the nearest where there are several; -1 for none.
int clip_at(const Eigen::Vector2d& node, const std::vector<Eigen::Matrix2Xd>& regions,
            double reach) {
  int nearest = -1;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t c = 0; c < regions.size(); ++c) {
    const double distance = distance_from_convex(regions[c], node);
    if (distance > reach || distance >= least) continue;
    nearest = static_cast<int>(c);
    least = distance;
  }
  return nearest;
}

std::vector<SessionClip> clips_on(const Session& session, const TriangleMesh& mesh) {
  // Vertices stand for the cloth half-way to their neighbours, but a line of nodes on a clip's edge
  // must not draw in the next one.
  const double reach =
      std::min(mesh_quality(session.rest).mean_edge, mesh_quality(mesh).mean_edge) / 2;
  const Eigen::Matrix2Xd vertices = session.rest.positions.topRows<2>();
  std::vector<SessionClip> clips = session.clips;
  std::vector<Eigen::Matrix2Xd> regions;
  for (SessionClip& clip : clips) {
    regions.push_back(convex_hull(vertices(Eigen::all, clip.clamped)));
    clip.clamped.clear();
  }
  for (int node = 0; node < mesh.vertex_count(); ++node) {
    const int clip = clip_at(mesh.positions.col(node).head<2>(), regions, reach);
    if (clip >= 0) clips[static_cast<std::size_t>(clip)].clamped.push_back(node);
  }
  for (const SessionClip& clip : clips) {
    if (clip.clamped.empty()) {
      throw InputError({}, fmt::format("no node of the mesh lies in clip {}", clip.name),
                       "a finer mesh, with nodes where vertices are clamped");
    }
  }
  return clips;
}

/// Nodes that lie by a vertex that was not seen.
std::vector<int> unseen_nodes(const TriangleMesh& rest, const std::vector<RestPoint>& places,
                              const std::vector<int>& unseen) {
  constexpr double kOnVertex = 1e-9;  // weights of the others, by rounding
  std::vector<int> nodes;
  for (std::size_t node = 0; node < places.size() && !unseen.empty(); ++node) {
    const RestPoint& place = places[node];
    for (int k = 0; k < 3; ++k) {
      if (std::abs(place.weights[k]) < kOnVertex) continue;
      if (!std::ranges::binary_search(unseen, rest.triangles(k, place.triangle))) continue;
      nodes.push_back(static_cast<int>(node));
      break;
    }
  }
  return nodes;
}

}  // namespace

Session on_mesh(const Session& session, const TriangleMesh& mesh) {
  const std::vector<RestPoint> places = places_of_nodes(session, mesh);
  Session result = session;
  result.rest = mesh;
  result.clips = clips_on(session, mesh);
  for (SessionFrame& frame : result.frames) {
    frame.positions = interpolated(session.rest, places, frame.positions);
    if (frame.deviations.cols() > 0) {
      frame.deviations = interpolated(session.rest, places, frame.deviations);
    }
    frame.unseen = unseen_nodes(session.rest, places, frame.unseen);
  }
  return result;
}

}  // namespace pliant
