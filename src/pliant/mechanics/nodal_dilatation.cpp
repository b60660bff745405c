#include "pliant/mechanics/nodal_dilatation.h"

#include <algorithm>
#include <cmath>
#include <map>

#include <Eigen/Geometry>

#include "pliant/base/assert.h"
#include "pliant/mechanics/limited_ways.h"
#include "pliant/mechanics/sample_weights.h"

namespace pliant {
namespace {

// (x1 - x0) . (x2 - x0) x (x3 - x0) / 6.
double volume_of(const Eigen::Matrix<double, 3, 4>& x) {
  const Eigen::Vector3d a = x.col(1) - x.col(0), b = x.col(2) - x.col(0), c = x.col(3) - x.col(0);
  return a.dot(b.cross(c)) / 6;
}

Eigen::Matrix<double, 3, 4> volume_gradient(const Eigen::Matrix<double, 3, 4>& x) {
  const Eigen::Vector3d a = x.col(1) - x.col(0), b = x.col(2) - x.col(0), c = x.col(3) - x.col(0);
  Eigen::Matrix<double, 3, 4> gradient;
  gradient.col(1) = b.cross(c) / 6;
  gradient.col(2) = c.cross(a) / 6;
  gradient.col(3) = a.cross(b) / 6;
  gradient.col(0) = -gradient.rightCols<3>().rowwise().sum();
  return gradient;
}

int place_in(const std::vector<int>& rising, int value) {
  return static_cast<int>(std::ranges::lower_bound(rising, value) - rising.begin());
}

}  // namespace

NodalDilatation::NodalDilatation(Tetrahedra tetrahedra, const std::vector<double>& rest_volumes,
                                 std::shared_ptr<const ParametricDensity> density,
                                 std::vector<int> parameter_places,
                                 std::vector<std::string> field_names, const Weights& weights)
    : tetrahedra_(std::move(tetrahedra)),
      density_(std::move(density)),
      parameter_places_(std::move(parameter_places)),
      field_names_(std::move(field_names)) {
  PLIANT_ASSERT(!tetrahedra_.empty() && tetrahedra_.size() == rest_volumes.size(),
                "a volume for each tetrahedron");
  std::map<int, std::vector<int>> around;
  for (size_t t = 0; t < tetrahedra_.size(); ++t) {
    for (const int point : tetrahedra_[t]) around[point].push_back(static_cast<int>(t));
  }
  rest_volumes_ = Eigen::VectorXd::Zero(std::ssize(around));
  patches_of_.resize(tetrahedra_.size());
  for (auto& [point, own] : around) {
    Patch patch{point, std::move(own), {}, {}};
    const auto number = static_cast<int>(patches_.size());
    for (const int t : patch.tetrahedra) {
      const auto& nodes = tetrahedra_[static_cast<size_t>(t)];
      patch.points.insert(patch.points.end(), nodes.begin(), nodes.end());
      const auto corner = std::ranges::find(nodes, point) - nodes.begin();
      patches_of_[static_cast<size_t>(t)][static_cast<size_t>(corner)] = number;
      rest_volumes_(number) += rest_volumes[static_cast<size_t>(t)] / 4;
    }
    std::ranges::sort(patch.points);
    patch.points.erase(std::unique(patch.points.begin(), patch.points.end()), patch.points.end());
    patches_.push_back(std::move(patch));
  }
  Eigen::MatrixXd of_patches;
  for (std::size_t p = 0; weights && p < patches_.size(); ++p) {
    const Eigen::VectorXd own = weights(patches_[p].point);
    of_patches.conservativeResize(own.size(), std::ssize(patches_));
    of_patches.col(static_cast<Eigen::Index>(p)) = own;
  }
  weights_ = lane_weights(of_patches, batches());
}

std::vector<std::pair<int, int>> NodalDilatation::couplings() const {
  std::vector<std::pair<int, int>> pairs;
  for (const Patch& patch : patches_) {
    for (size_t i = 0; i < patch.points.size(); ++i) {
      for (size_t j = i + 1; j < patch.points.size(); ++j) {
        pairs.emplace_back(patch.points[i], patch.points[j]);
      }
    }
  }
  return pairs;
}

void NodalDilatation::bind(const Coordinates& coordinates, const BlockPattern& pattern) {
  const auto place = [&](int p, int q) {
    const int row = coordinates.row(p), column = coordinates.row(q);
    if (row < 0 || column < 0) return kThroughCoordinates;
    return row < column ? 2 * pattern.find(row, column) : 2 * pattern.find(column, row) + 1;
  };
  for (Patch& patch : patches_) {
    patch.places.clear();
    for (size_t i = 0; i < patch.points.size(); ++i) {
      for (size_t j = i + 1; j < patch.points.size(); ++j) {
        patch.places.push_back(place(patch.points[i], patch.points[j]));
      }
    }
  }
}

int NodalDilatation::batches() const {
  return (static_cast<int>(patches_.size()) + kLanes - 1) / kLanes;
}

auto NodalDilatation::volume_gradients(const Eigen::Matrix3Xd& positions) const
    -> std::vector<Gradient> {
  std::vector<Gradient> gradients;
  gradients.reserve(tetrahedra_.size());
  for (const auto& nodes : tetrahedra_) {
    gradients.push_back(volume_gradient(positions(Eigen::all, nodes)));
  }
  return gradients;
}

Eigen::VectorXd NodalDilatation::strains(const Eigen::Matrix3Xd& positions) const {
  Eigen::VectorXd strains = Eigen::VectorXd::Zero(Eigen::Index(kLanes) * batches());
  for (size_t t = 0; t < tetrahedra_.size(); ++t) {
    const double quarter = volume_of(positions(Eigen::all, tetrahedra_[t])) / 4;
    for (const int patch : patches_of_[t]) strains(patch) += quarter;
  }
  const Eigen::Index count = rest_volumes_.size();
  strains.head(count) = strains.head(count).cwiseQuotient(rest_volumes_).array() - 1;
  return strains;
}

Samples NodalDilatation::samples(int batch, const LaneStrains& strain,
                                 const double* history) const {
  const double* own = history + Eigen::Index(kLanes) * columns() * batch;
  return {LaneView(strain.data(), kLanes, 1), LaneView(own, kLanes, 1),
          LaneView(own + kLanes, kLanes, 1), LaneView(own + 2 * kLanes, kLanes, columns() - 2),
          of_batch(weights_, batch, batches())};
}

Eigen::ArrayXd NodalDilatation::shares_left(const Evaluation& at,
                                            const Eigen::Matrix3Xd& positions) const {
  const Eigen::VectorXd strains = this->strains(positions);
  Eigen::ArrayXd left(strains.size());
  for (int batch = 0; batch < batches(); ++batch) {
    const LaneStrains strain = strains.segment<kLanes>(kLanes * batch).array();
    Lane own = Lane::Constant(INFINITY);
    law_at(at).lower_to_share_left(samples(batch, strain, at.history), own);
    left.segment<kLanes>(kLanes * batch) = own;
  }
  return left;
}

double NodalDilatation::share_left(const Evaluation& at) const {
  return is_limited() ? shares_left(at, at.configuration.positions).minCoeff() : 1;
}

void NodalDilatation::limit(const Evaluation& from, const Eigen::Matrix3Xd& to,
                            WayLimits& limits) const {
  if (!is_limited() || from.time.limits.mended > 0) return;
  const Eigen::Matrix3Xd& start = from.configuration.positions;
  const Eigen::ArrayXd shares = shares_within_limits(
      shares_left(from, start), limits.kept,
      [&](double share) { return shares_left(from, start + share * (to - start)); });
  for (size_t p = 0; p < patches_.size(); ++p) {
    const double share = shares(static_cast<Eigen::Index>(p));
    if (share == 1) continue;
    limits.obstructed = true;
    for (const int point : patches_[p].points) {
      limits.shares(point) = std::min(limits.shares(point), share);
    }
  }
}

void NodalDilatation::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  const Eigen::VectorXd strains = this->strains(at.configuration.positions);
  const Eigen::Index count = rest_volumes_.size();
  Eigen::VectorXd pressures(strains.size()), slopes(strains.size());
  for (int batch = 0; batch < batches(); ++batch) {
    const int first = kLanes * batch;
    const LaneStrains strain = strains.segment<kLanes>(first).array();
    Response response(1);
    law_at(at).add(samples(batch, strain, at.history), at.time, response);
    if (!response.stored.isFinite().all()) {
      derivatives.energy.stored = INFINITY;
      return;
    }
    pressures.segment<kLanes>(first) = response.stress.col(0).matrix();
    if (at.curvature == Curvature::convex) make_tangent_convex(response, 1);
    slopes.segment<kLanes>(first) = response.tangent.col(0).matrix();
    const Eigen::Index lanes = std::min<Eigen::Index>(kLanes, count - first);
    const auto sizes = rest_volumes_.segment(first, lanes).array();
    derivatives.energy +=
        {(sizes * response.stored.head(lanes)).sum(), (sizes * response.work.head(lanes)).sum()};
  }
  if (!derivatives.gradient && !derivatives.hessian) return;
  const std::vector<Gradient> gradients = volume_gradients(at.configuration.positions);
  if (derivatives.gradient) add_forces(gradients, pressures, derivatives.gradient->data());
  if (!derivatives.hessian) return;
  for (size_t p = 0; p < patches_.size(); ++p) {
    const auto place = static_cast<Eigen::Index>(p);
    add_patch(patches_[p], slopes(place) / rest_volumes_(place),
              patch_gradient(patches_[p], gradients), at.configuration, *derivatives.hessian);
  }
  if (at.curvature == Curvature::convex) return;
  for (size_t t = 0; t < tetrahedra_.size(); ++t) {
    add_stress_part(static_cast<int>(t), pressures(patches_of_[t]).mean(), at.configuration,
                    *derivatives.hessian);
  }
}

// A tetrahedron feels the mean of the pressures at its nodes.
void NodalDilatation::add_forces(const std::vector<Gradient>& gradients,
                                 const Eigen::VectorXd& pressures, double* gradient) const {
  for (size_t t = 0; t < tetrahedra_.size(); ++t) {
    const Gradient forces = pressures(patches_of_[t]).mean() * gradients[t];
    for (size_t i = 0; i < 4; ++i) {
      Eigen::Map<Eigen::Vector3d>(gradient + Eigen::Index(3) * tetrahedra_[t][i]) +=
          forces.col(static_cast<Eigen::Index>(i));
    }
  }
}

// d V / d positions of the points of a patch.
Eigen::Matrix3Xd NodalDilatation::patch_gradient(const Patch& patch,
                                                 const std::vector<Gradient>& gradients) const {
  Eigen::Matrix3Xd sum = Eigen::Matrix3Xd::Zero(3, std::ssize(patch.points));
  for (const int t : patch.tetrahedra) {
    const auto& nodes = tetrahedra_[static_cast<size_t>(t)];
    for (size_t i = 0; i < 4; ++i) {
      sum.col(place_in(patch.points, nodes[i])) +=
          gradients[static_cast<size_t>(t)].col(static_cast<Eigen::Index>(i)) / 4;
    }
  }
  return sum;
}

// What is on the diagonal follows from the other blocks, as a translation changes no volume.
void NodalDilatation::add_patch(const Patch& patch, double factor, const Eigen::Matrix3Xd& gradient,
                                const Configuration& at, Hessian& hessian) const {
  hessian.matrix.with_entries([&]<class Number>(Number* entries) {
    size_t next = 0;
    for (Eigen::Index i = 0; i < gradient.cols(); ++i) {
      const Eigen::Vector3d left = factor * gradient.col(i);
      for (Eigen::Index j = i + 1; j < gradient.cols(); ++j) {
        const int place = patch.places[next++];
        Eigen::Matrix3d block = left * gradient.col(j).transpose();
        if (place == kThroughCoordinates) {
          hessian.coordinates.add_difference(at, patch.points[static_cast<size_t>(i)],
                                             patch.points[static_cast<size_t>(j)], block,
                                             hessian.matrix);
          continue;
        }
        if (place & 1) block.transposeInPlace();
        Eigen::Map<Eigen::Matrix<Number, 3, 3>>(entries + 9 * (place / 2)) +=
            block.template cast<Number>();
      }
    }
  });
}

// d2 V / (d x_i d x_j) = [u]x / 6 of the edge u across from the edge i j, up to its sign.
void NodalDilatation::add_stress_part(int tetrahedron, double pressure, const Configuration& at,
                                      Hessian& hessian) const {
  constexpr int kAcross[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                 {1, 2, 0, 3}, {2, 3, 0, 1}, {3, 1, 0, 2}};
  const auto& nodes = tetrahedra_[static_cast<size_t>(tetrahedron)];
  for (const auto& [i, j, k, l] : kAcross) {
    const auto node = [&](int corner) { return nodes[static_cast<size_t>(corner)]; };
    const Eigen::Vector3d u =
        pressure / 6 * (at.positions.col(node(k)) - at.positions.col(node(l)));
    Eigen::Matrix3d block;
    block << 0, -u.z(), u.y(), u.z(), 0, -u.x(), -u.y(), u.x(), 0;
    if (hessian.coordinates.is_free(node(i)) && hessian.coordinates.is_free(node(j))) {
      hessian.coordinates.add_coupling(at, node(i), node(j), block, hessian.matrix);
    } else {
      hessian.coordinates.add_difference(at, node(i), node(j), block, hessian.matrix);
    }
  }
}

Eigen::Index NodalDilatation::history_size() const {
  return Eigen::Index(kLanes) * columns() * batches();
}

Eigen::VectorXd NodalDilatation::initial_history(const Evaluation& at) const {
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(history_size());
  Eigen::VectorXd history(history_size());
  advance({at.configuration, at_rest.data(), at.law}, history.data());
  for (int batch = 0; batch < batches(); ++batch) {
    double* own = history.data() + Eigen::Index(kLanes) * columns() * batch;
    MutableLaneView(own + kLanes, kLanes, 1) = MutableLaneView(own, kLanes, 1);
  }
  return history;
}

Energy NodalDilatation::advance(const Evaluation& at, double* next) const {
  const Eigen::VectorXd strains = this->strains(at.configuration.positions);
  const Eigen::Index count = rest_volumes_.size();
  Energy energy;
  for (int batch = 0; batch < batches(); ++batch) {
    const int first = kLanes * batch;
    const LaneStrains strain = strains.segment<kLanes>(first).array();
    const Samples samples = this->samples(batch, strain, at.history);
    double* own = next + Eigen::Index(kLanes) * columns() * batch;
    MutableLaneView(own, kLanes, 1) = strain;
    MutableLaneView(own + kLanes, kLanes, 1) = samples.last;
    Lane stored = Lane::Zero(), work = Lane::Zero();
    law_at(at).add_stored(samples, stored);
    law_at(at).advance(samples, at.time, MutableLaneView(own + 2 * kLanes, kLanes, columns() - 2),
                       work);
    const Eigen::Index lanes = std::min<Eigen::Index>(kLanes, count - first);
    const auto sizes = rest_volumes_.segment(first, lanes).array();
    energy += {(sizes * stored.head(lanes)).sum(), (sizes * work.head(lanes)).sum()};
  }
  return energy;
}

std::shared_ptr<const ParametricDensity> NodalDilatation::law(const Eigen::VectorXd& all) const {
  if (parameter_places_.empty()) return density_;
  return density_->with_parameters(all(parameter_places_));
}

Eigen::MatrixXd NodalDilatation::field_values(const double* history) const {
  Eigen::MatrixXd values(std::ssize(field_names_), rest_volumes_.size());
  for (Eigen::Index p = 0; p < values.cols(); ++p) {
    const double* own = history + kLanes * columns() * (p / kLanes) + p % kLanes;
    for (Eigen::Index field = 0; field < values.rows(); ++field) {
      values(field, p) = own[kLanes * (field < 1 ? field : field + 1)];
    }
  }
  return values;
}

Eigen::MatrixXi NodalDilatation::element_points() const {
  Eigen::MatrixXi points(1, std::ssize(patches_));
  for (size_t p = 0; p < patches_.size(); ++p) {
    points(0, static_cast<Eigen::Index>(p)) = patches_[p].point;
  }
  return points;
}

}  // namespace pliant
