#include "pliant/mechanics/element_potential.h"

#include <algorithm>
#include <cmath>

#include "pliant/base/assert.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/material/strain/hexahedron_dilatation.h"
#include "pliant/material/strain/linear_tetrahedron.h"
#include "pliant/material/strain/soft_constraint_membrane.h"
#include "pliant/material/strain/spring.h"
#include "pliant/material/strain/stvk_membrane.h"
#include "pliant/material/strain/trilinear_hexahedron.h"
#include "pliant/mechanics/lane_derivatives.h"
#include "pliant/mechanics/lane_kernel.h"
#include "pliant/mechanics/limited_ways.h"
#include "pliant/mechanics/sample_weights.h"
#include "pliant/mechanics/shells_lanes.h"
#include "pliant/mechanics/solid_lanes.h"
#include "pliant/mechanics/stvk_lanes.h"

namespace pliant {

template <class Measure>
struct ElementPotential<Measure>::Batch {
  LanePositions<Measure> positions;
  LaneStrains strain;
  Samples samples;
  Rests rests;
  LaneKernel<Measure> kernel;
  Response response;
  Lane size;

  /// @param differentiated  whether forces or stiffness will be asked for
  Batch(const ElementPotential& potential, int batch, const Configuration& configuration,
        const double* history, bool differentiated = true)
      : positions(potential.gather(batch, configuration.positions.data())),
        strain(kLanes, Measure::kStrains),
        samples(potential.samples(batch, strain, history)),
        rests(potential.rests_near(batch, samples.last)),
        kernel(rests.data(), positions, differentiated),
        response(Measure::kStrains),
        size(Eigen::Map<const Lane>(potential.sizes_.data() + kLanes * batch)) {
    strain = kernel.strain();
  }
  Batch(const Batch&) = delete;  // the samples and the kernel refer to its own numbers
  Batch& operator=(const Batch&) = delete;
};

template <class Measure>
ElementPotential<Measure>::ElementPotential(const Stencils<Measure>& stencils,
                                            std::shared_ptr<const ParametricDensity> density,
                                            std::vector<int> parameter_places,
                                            std::vector<std::string> field_names)
    : points_(stencils.points),
      rests_(stencils.rests),
      sizes_(stencils.sizes),
      count_(static_cast<int>(stencils.points.size())),
      density_(std::move(density)),
      parameter_places_(std::move(parameter_places)),
      field_names_(std::move(field_names)) {
  PLIANT_ASSERT(count_ > 0, "a potential of elements has at least one");
  PLIANT_ASSERT(
      parameter_places_.empty() ||
          density_->parameters().size() == static_cast<Eigen::Index>(parameter_places_.size()),
      "one place for each parameter of the density");
  while (points_.size() % kLanes != 0) {
    points_.push_back(points_.back());
    rests_.push_back(rests_.back());
    sizes_.push_back(0);
  }
  weights_ = lane_weights(stencils.weights, batches());
  for (auto first = points_.begin(); first != points_.end(); first += kLanes) {
    share_points_.push_back(std::equal(first + 1, first + kLanes, first));
  }
}

template <class Measure>
std::vector<std::pair<int, int>> ElementPotential<Measure>::couplings() const {
  std::vector<std::pair<int, int>> pairs;
  pairs.reserve(points_.size() * kPairs<Measure>);
  for (const auto& nodes : points_) {
    for (const auto& [i, j] : node_pairs<Measure>()) {
      if (i != j) pairs.emplace_back(nodes[static_cast<size_t>(i)], nodes[static_cast<size_t>(j)]);
    }
  }
  return pairs;
}

template <class Measure>
void ElementPotential<Measure>::bind(const Coordinates& coordinates, const BlockPattern& pattern) {
  places_ = HessianPlaces<Measure>(points_, coordinates, pattern);
  groups_ = ElementGroups(batches(), [&](int batch, std::vector<int>& touched) {
    for (int l = 0; l < kLanes; ++l) {
      for (const int node : points_[static_cast<size_t>(kLanes * batch + l)]) {
        touched.push_back(node);
        const int clip = coordinates.clip_of(node);
        if (clip >= 0) touched.push_back(coordinates.points() + clip);
      }
    }
  });
}

template <class Measure>
LanePositions<Measure> ElementPotential<Measure>::gather(int batch, const double* all) const {
  LanePositions<Measure> positions;
  for (int l = 0; l < kLanes; ++l) {
    const auto& nodes = points_[static_cast<size_t>(kLanes * batch + l)];
    for (int i = 0; i < Measure::kNodes; ++i) {
      const double* x = all + Eigen::Index(3) * nodes[static_cast<size_t>(i)];
      for (int a = 0; a < 3; ++a) positions(l, 3 * i + a) = x[a];
    }
  }
  return positions;
}

template <class Measure>
Samples ElementPotential<Measure>::samples(int batch, const LaneStrains& strain,
                                           const double* history) const {
  constexpr int m = Measure::kStrains;
  const double* own = history + Eigen::Index(kLanes) * columns() * batch;
  return {LaneView(strain.data(), kLanes, m), LaneView(own, kLanes, m),
          LaneView(own + kLanes * m, kLanes, m),
          LaneView(own + 2 * kLanes * m, kLanes, columns() - 2 * m),
          of_batch(weights_, batch, batches())};
}

template <class Measure>
typename ElementPotential<Measure>::Rests ElementPotential<Measure>::rests_near(
    int batch, const LaneView& last) const {
  Rests rests;
  for (int l = 0; l < kLanes; ++l) {
    typename Measure::Rest& rest = rests[static_cast<size_t>(l)];
    rest = rests_[static_cast<size_t>(kLanes * batch + l)];
    if constexpr (requires(typename Measure::Strain strain) { Measure::continued(rest, strain); }) {
      rest = Measure::continued(rest, last.row(l).transpose().matrix());
    }
  }
  return rests;
}

template <class Measure>
void ElementPotential<Measure>::limit(const Evaluation& from, const Eigen::Matrix3Xd& to,
                                      WayLimits& limits) const {
  if (obeys_limit(from)) shorten_to_limit(from, to, limits);
  if constexpr (kMayInvert) {
    for (size_t e = 0; e < static_cast<size_t>(count_); ++e) {
      const double share = Measure::share_before_inversion(
          rests_[e], from.configuration.positions(Eigen::all, points_[e]),
          to(Eigen::all, points_[e]), limits.kept);
      if (share == 1) continue;
      limits.obstructed = true;
      for (const int node : points_[e]) {
        limits.shares(node) = std::min(limits.shares(node), share);
      }
    }
  }
}

template <class Measure>
void ElementPotential<Measure>::shorten_to_limit(const Evaluation& from, const Eigen::Matrix3Xd& to,
                                                 WayLimits& limits) const {
  Configuration at = from.configuration;
  for (int batch = 0; batch < batches(); ++batch) {
    const auto left_at = [&](const Configuration& configuration) {
      const Batch elements(*this, batch, configuration, from.history, false);
      Lane left = Lane::Constant(INFINITY);
      law_at(from).lower_to_share_left(elements.samples, left);
      return left;
    };
    const Eigen::ArrayXd shares =
        shares_within_limits(left_at(from.configuration), limits.kept, [&](double share) {
          for (int l = 0; l < kLanes; ++l) {
            for (const int node : points_[static_cast<size_t>(kLanes * batch + l)]) {
              const auto start = from.configuration.positions.col(node);
              at.positions.col(node) = start + share * (to.col(node) - start);
            }
          }
          return left_at(at);
        });
    if ((shares == 1).all()) continue;
    limits.obstructed = true;
    for (int l = 0; l < kLanes; ++l) {
      for (const int node : points_[static_cast<size_t>(kLanes * batch + l)]) {
        limits.shares(node) = std::min(limits.shares(node), shares(l));
      }
    }
  }
}

template <class Measure>
double ElementPotential<Measure>::share_left(const Evaluation& at) const {
  Lane left = Lane::Constant(INFINITY);
  for (int batch = 0; batch < batches() && law_at(at).is_limited(); ++batch) {
    const Batch elements(*this, batch, at.configuration, at.history, false);
    law_at(at).lower_to_share_left(elements.samples, left);
  }
  return left.minCoeff();
}

template <class Measure>
void ElementPotential<Measure>::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  derivatives.energy +=
      groups_.sum<Energy>([&](int batch) { return evaluate_batch(batch, at, derivatives); });
}

template <class Measure>
Energy ElementPotential<Measure>::evaluate_batch(int batch, const Evaluation& at,
                                                 const Derivatives& derivatives) const {
  const bool differentiated = derivatives.gradient || derivatives.hessian;
  Batch elements(*this, batch, at.configuration, at.history, differentiated);
  if constexpr (kMayInvert) {
    if (!(elements.kernel.volume_ratio().minCoeff() > 0)) return {.stored = INFINITY};
  }
  law_at(at).add(elements.samples, at.time, elements.response);
  if (!elements.response.stored.isFinite().all()) return {.stored = INFINITY};
  if (derivatives.gradient) {
    LanePositions<Measure> forces;
    elements.kernel.gradient(elements.response, elements.size, forces);
    scatter(batch, forces, derivatives.gradient->data());
  }
  if (derivatives.hessian) {
    if (at.curvature == Curvature::convex) {
      make_tangent_convex(elements.response, Measure::kStrains);
    }
    add_hessian(batch, elements, at, *derivatives.hessian);
  }
  return {(elements.size * elements.response.stored).sum(),
          (elements.size * elements.response.work).sum()};
}

template <class Measure>
void ElementPotential<Measure>::scatter(int batch, const LanePositions<Measure>& values,
                                        double* all) const {
  if (share_points_[static_cast<size_t>(batch)]) {
    for (int i = 0; i < Measure::kNodes; ++i) {
      double* x = all + Eigen::Index(3) *
                            points_[static_cast<size_t>(kLanes * batch)][static_cast<size_t>(i)];
      for (int a = 0; a < 3; ++a) x[a] += values.col(3 * i + a).sum();
    }
    return;
  }
  for (int l = 0; l < kLanes; ++l) {
    const auto& nodes = points_[static_cast<size_t>(kLanes * batch + l)];
    for (int i = 0; i < Measure::kNodes; ++i) {
      double* x = all + Eigen::Index(3) * nodes[static_cast<size_t>(i)];
      for (int a = 0; a < 3; ++a) x[a] += values(l, 3 * i + a);
    }
  }
}

template <class Measure>
void ElementPotential<Measure>::add_hessian(int batch, const Batch& elements, const Evaluation& at,
                                            Hessian& hessian) const {
  const LaneKernel<Measure>& kernel = elements.kernel;
  const bool convex = at.curvature == Curvature::convex;
  if constexpr (requires(Lane factor, LanePositions<Measure> gradient) {
                  kernel.outer_product(elements.response, elements.size, factor, gradient);
                }) {
    if (convex) {
      Lane factor;
      LanePositions<Measure> gradient;
      kernel.outer_product(elements.response, elements.size, factor, gradient);
      places_.add_outer_products(batch, factor, gradient, points_, at.configuration, hessian);
      return;
    }
  }
  LaneHessian<Measure> values;
  kernel.hessian(elements.response, elements.size, convex, values);
  if (share_points_[static_cast<size_t>(batch)]) {
    places_.add_sum(batch, values, points_, at.configuration, hessian);
  } else {
    places_.add(batch, values, points_, at.configuration, hessian);
  }
}

template <class Measure>
Eigen::Index ElementPotential<Measure>::history_size() const {
  return Eigen::Index(kLanes) * columns() * batches();
}

template <class Measure>
Eigen::VectorXd ElementPotential<Measure>::initial_history(const Evaluation& at) const {
  constexpr int m = Measure::kStrains;
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(history_size());
  Eigen::VectorXd history(history_size());
  advance({at.configuration, at_rest.data(), at.law}, history.data());
  for (int batch = 0; batch < batches(); ++batch) {
    double* own = history.data() + Eigen::Index(kLanes) * columns() * batch;
    MutableLaneView(own + kLanes * m, kLanes, m) = MutableLaneView(own, kLanes, m);
  }
  return history;
}

template <class Measure>
Energy ElementPotential<Measure>::advance(const Evaluation& at, double* next) const {
  constexpr int m = Measure::kStrains;
  const ParametricDensity& law = law_at(at);
  return groups_.sum<Energy>([&](int batch) -> Energy {
    const Batch elements(*this, batch, at.configuration, at.history, false);
    double* own = next + Eigen::Index(kLanes) * columns() * batch;
    MutableLaneView(own, kLanes, m) = elements.strain;
    MutableLaneView(own + kLanes * m, kLanes, m) = elements.samples.last;
    Lane stored = Lane::Zero(), work = Lane::Zero();
    law.add_stored(elements.samples, stored);
    law.advance(elements.samples, at.time,
                MutableLaneView(own + 2 * kLanes * m, kLanes, columns() - 2 * m), work);
    return {(elements.size * stored).sum(), (elements.size * work).sum()};
  });
}

template <class Measure>
std::shared_ptr<const ParametricDensity> ElementPotential<Measure>::law(
    const Eigen::VectorXd& all) const {
  if (parameter_places_.empty()) return density_;
  return density_->with_parameters(all(parameter_places_));
}

template <class Measure>
std::vector<int> ElementPotential<Measure>::columns_of_parameters(
    const std::vector<int>& by) const {
  std::vector<int> columns;
  for (const int place : parameter_places_) {
    const auto found = std::ranges::find(by, place);
    columns.push_back(found == by.end() ? -1 : static_cast<int>(found - by.begin()));
  }
  return columns;
}

// The stencils' own numbers in the potential's history are a matrix of eight rows, a batch after
// the other: strains, the strains before, what the density keeps.
template <class Measure>
void ElementPotential<Measure>::add_force_sensitivity(
    const Evaluation& at, const std::vector<int>& by,
    const Eigen::Ref<const Eigen::MatrixXd>& history_by_parameter,
    Eigen::MatrixXd& gradient_by_parameter) const {
  constexpr int m = Measure::kStrains;
  const int own = density_->history_size();
  const std::vector<int> own_columns = columns_of_parameters(by);
  const bool has_own = std::ranges::any_of(own_columns, [](int column) { return column >= 0; });
  // Without own parameters and without memory, stress changes with the strain alone.
  if (own == 0 && !has_own) return;
  const auto parameters = static_cast<int>(density_->parameters().size());
  for (int batch = 0; batch < batches(); ++batch) {
    const Batch elements(*this, batch, at.configuration, at.history);
    const LaneDerivatives d(law_at(at), elements.samples, at.time, parameters);
    for (Eigen::Index k = 0; k < history_by_parameter.cols(); ++k) {
      const LaneView history(
          history_by_parameter.col(k).data() + Eigen::Index(kLanes) * columns() * batch, kLanes,
          columns());
      Response response(m);
      add_own_parameters(d.stress_by_parameter, own_columns, k, response.stress);
      add_product(d.stress_by_last, history.leftCols(m), response.stress);
      add_product(d.stress_by_history, history.rightCols(own), response.stress);
      LanePositions<Measure> forces;
      elements.kernel.gradient(response, elements.size, forces);
      scatter(batch, forces, gradient_by_parameter.col(k).data());
    }
  }
}

template <class Measure>
void ElementPotential<Measure>::advance_sensitivity(
    const Evaluation& at, const std::vector<int>& by, const Eigen::MatrixXd& positions_by_parameter,
    Eigen::Ref<Eigen::MatrixXd> history_by_parameter) const {
  constexpr int m = Measure::kStrains;
  const int own = density_->history_size();
  if (own == 0) return;  // nothing depends on the strains of an elastic material's steps
  const std::vector<int> own_columns = columns_of_parameters(by);
  const auto parameters = static_cast<int>(density_->parameters().size());
  for (int batch = 0; batch < batches(); ++batch) {
    const Batch elements(*this, batch, at.configuration, at.history);
    const LaneDerivatives d(law_at(at), elements.samples, at.time, parameters);
    const auto gradients = strain_gradients(elements);
    for (Eigen::Index k = 0; k < history_by_parameter.cols(); ++k) {
      const LanePositions<Measure> motion = gather(batch, positions_by_parameter.col(k).data());
      Eigen::Array<double, kLanes, m> strain;
      for (int i = 0; i < m; ++i) {
        strain.col(i) = (gradients[static_cast<size_t>(i)] * motion).rowwise().sum();
      }
      MutableLaneView history(
          history_by_parameter.col(k).data() + Eigen::Index(kLanes) * columns() * batch, kLanes,
          columns());
      const Eigen::Array<double, kLanes, m> last = history.leftCols(m);
      Eigen::ArrayXXd next = Eigen::ArrayXXd::Zero(kLanes, own);
      add_own_parameters(d.next_by_parameter, own_columns, k, next);
      add_product(d.next_by_strain, strain, next);
      add_product(d.next_by_last, last, next);
      add_product(d.next_by_history, history.rightCols(own), next);
      history << strain, last, next;
    }
  }
}

// Gradients of the strains of eight stencils, one after the other.
template <class Measure>
auto ElementPotential<Measure>::strain_gradients(const Batch& elements)
    -> std::array<LanePositions<Measure>, Measure::kStrains> {
  std::array<LanePositions<Measure>, Measure::kStrains> gradients;
  for (int i = 0; i < Measure::kStrains; ++i) {
    Response unit(Measure::kStrains);
    unit.stress.col(i) = 1;
    elements.kernel.gradient(unit, Lane::Ones(), gradients[static_cast<size_t>(i)]);
  }
  return gradients;
}

template <class Measure>
Eigen::MatrixXd ElementPotential<Measure>::field_values(const double* history) const {
  constexpr int m = Measure::kStrains;
  Eigen::MatrixXd values(static_cast<Eigen::Index>(field_names_.size()), count_);
  for (int e = 0; e < count_; ++e) {
    const double* own = history + Eigen::Index(kLanes) * columns() * (e / kLanes) + e % kLanes;
    for (Eigen::Index field = 0; field < values.rows(); ++field) {
      values(field, e) = own[kLanes * (field < m ? field : field + m)];
    }
  }
  return values;
}

template <class Measure>
Eigen::MatrixXi ElementPotential<Measure>::element_points() const {
  return Eigen::Map<const Eigen::MatrixXi>(points_.front().data(), Measure::kNodes, count_);
}

template <class Measure>
Eigen::VectorXd ElementPotential<Measure>::element_sizes() const {
  return Eigen::Map<const Eigen::VectorXd>(sizes_.data(), count_);
}

template class ElementPotential<StvkMembrane>;
template class ElementPotential<SoftConstraintMembrane>;
template class ElementPotential<Spring>;
template class ElementPotential<DiscreteShells>;
template class ElementPotential<LinearTetrahedron>;
template class ElementPotential<TrilinearHexahedron>;
template class ElementPotential<HexahedronDilatation>;

}  // namespace pliant
