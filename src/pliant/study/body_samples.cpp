#include "pliant/study/body_samples.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/geometry/inside_volume.h"
#include "pliant/geometry/spread_points.h"

namespace pliant {
namespace {

void require_bodies(const Study& study) {
  for (const ExperimentSpec& spec : study.experiments) {
    if (spec.test->body()) continue;
    throw InputError(spec.where,
                     quoted_value(spec.name) +
                         " is of a piece that is the same everywhere, and the model has samples",
                     "tests of whole bodies, of which a study names the mesh");
  }
}

std::vector<Eigen::Vector3d> places_on_grid(const Eigen::Vector3i& cells, const VolumeMesh& body) {
  const Eigen::Vector3d low = body.positions.rowwise().minCoeff();
  const Eigen::Vector3d size = body.positions.rowwise().maxCoeff() - low;
  std::vector<Eigen::Vector3d> places = middles_of_cells(low, size, cells);
  std::erase_if(places, [&](const Eigen::Vector3d& place) { return !is_inside(body, place); });
  return places;
}

std::vector<Eigen::Vector3d> spread_places(int count, const VolumeMesh& body) {
  std::vector<Eigen::Vector3d> places;
  for (const int node : spread_points(body.positions, count)) {
    places.emplace_back(body.positions.col(node));
  }
  return places;
}

/// Where samples may grow: at several times as many places, enough to tell one side of a body
/// from another.
int choices_of(const SampleOptions& options, const VolumeMesh& body) {
  constexpr int kLeast = 40;
  return std::min(std::max(3 * options.grown, kLeast), body.node_count());
}

std::vector<Eigen::Vector3d> places_of(const SampleOptions& options, const VolumeMesh& body) {
  if (!options.places.empty()) return options.places;
  const int count = std::max(options.spread, options.grown);
  if (count == 0) return places_on_grid(options.grid, body);
  if (count > body.node_count()) {
    throw InputError(options.where, fmt::format("asks for {} places", count),
                     fmt::format("at most the {} nodes of the body", body.node_count()));
  }
  return spread_places(options.grown > 0 ? choices_of(options, body) : count, body);
}

void require_places(const std::vector<Eigen::Vector3d>& places, const SampleOptions& options,
                    const VolumeMesh& body) {
  if (places.empty()) {
    throw InputError(options.where, "has no place within the body", "a finer grid");
  }
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (!is_inside(body, places[k])) {
      throw InputError(options.where, fmt::format("sample {} lies outside the body", k),
                       "places within the mesh, in its coordinates after `unit` and `up`");
    }
    if (std::find(places.begin(), places.begin() + static_cast<std::ptrdiff_t>(k), places[k]) !=
        places.begin() + static_cast<std::ptrdiff_t>(k)) {
      throw InputError(options.where, fmt::format("sample {} is a second one at its place", k),
                       "each place once");
    }
  }
}

}  // namespace

const VolumeMesh* body_of_samples(const Study& study) {
  for (const ExperimentSpec& spec : study.experiments) {
    if (spec.role == ExperimentRole::fit) return spec.test->body();
  }
  return nullptr;
}

MaterialSamples body_samples(const Study& study) {
  MaterialSamples samples;
  if (!study.model.samples) return samples;
  const SampleOptions& options = *study.model.samples;
  require_bodies(study);
  const VolumeMesh* first = body_of_samples(study);
  if (!first) {
    throw InputError(options.where, "has no experiment to be fitted", "at least one of a body");
  }
  const VolumeMesh& body = *first;
  const std::vector<Eigen::Vector3d> places = places_of(options, body);
  require_places(places, options, body);
  for (const Eigen::Vector3d& place : places) samples.at.push_back({place, {}});
  samples.width =
      options.width.value_or(places.size() > 1 ? spacing_of_neighbours(places) : extent_of(body));
  return samples;
}

}  // namespace pliant
