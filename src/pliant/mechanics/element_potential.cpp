#include "pliant/mechanics/element_potential.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

#include "pliant/base/assert.h"
#include "pliant/material/strain/discrete_shells.h"
#include "pliant/material/strain/soft_constraint_membrane.h"
#include "pliant/material/strain/spring.h"
#include "pliant/material/strain/stvk_membrane.h"
#include "pliant/mechanics/lane_kernel.h"
#include "pliant/mechanics/shells_lanes.h"
#include "pliant/mechanics/stvk_lanes.h"

namespace pliant {
namespace {

// Where the block of a pair of points goes.
constexpr int kNowhere = -1;      // one of the points is moved from outside
constexpr int kThroughClip = -2;  // one of the points belongs to a free clip
// Otherwise twice the number of the block, plus one when the pair stands in it transposed.

Eigen::Matrix3d block_of(const auto& hessian, int lane, int pair) {
  Eigen::Matrix3d block;
  for (int k = 0; k < 9; ++k) block(k % 3, k / 3) = hessian(lane, 9 * pair + k);
  return block;
}

void make_tangent_convex(Response& response, int strains) {
  bool diagonal = true;
  for (int k = 0; k < strains * strains; ++k) {
    if (k % (strains + 1) == 0) continue;
    diagonal = diagonal && (response.tangent.col(k) == 0).all();
  }
  if (diagonal) {
    response.tangent = response.tangent.max(0);
    return;
  }
  for (int l = 0; l < kLanes; ++l) {
    Eigen::MatrixXd tangent(strains, strains);
    for (int k = 0; k < tangent.size(); ++k) tangent(k) = response.tangent(l, k);
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(tangent);
    tangent = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0).asDiagonal() *
              eigen.eigenvectors().transpose();
    for (int k = 0; k < tangent.size(); ++k) response.tangent(l, k) = tangent(k);
  }
}

}  // namespace

template <class Measure>
struct ElementPotential<Measure>::Batch {
  LanePositions<Measure> positions;
  LaneStrains strain;
  Samples samples;
  Rests rests;
  LaneKernel<Measure> kernel;
  Response response;
  Lane size;

  Batch(const ElementPotential& potential, int batch, const Configuration& configuration,
        const double* history)
      : positions(potential.gather(batch, configuration)),
        strain(kLanes, Measure::kStrains),
        samples(potential.samples(batch, strain, history)),
        rests(potential.rests_near(batch, samples.last)),
        kernel(rests.data(), positions),
        response(Measure::kStrains),
        size(Eigen::Map<const Lane>(potential.sizes_.data() + kLanes * batch)) {
    strain = kernel.strain();
  }
  Batch(const Batch&) = delete;  // the samples and the kernel refer to its own numbers
  Batch& operator=(const Batch&) = delete;
};

template <class Measure>
ElementPotential<Measure>::ElementPotential(const Stencils<Measure>& stencils,
                                            std::shared_ptr<ParametricDensity> density,
                                            std::vector<int> parameter_places,
                                            std::vector<std::string> field_names)
    : points_(stencils.points),
      rests_(stencils.rests),
      sizes_(stencils.sizes),
      count_(static_cast<int>(stencils.points.size())),
      density_(std::move(density)),
      parameter_places_(std::move(parameter_places)),
      parameter_columns_(parameter_places_),
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
  entries_.clear();
  entries_.reserve(points_.size() * kPairs<Measure>);
  groups_ = ElementGroups(batches(), [&](int batch, std::vector<int>& touched) {
    for (int l = 0; l < kLanes; ++l) {
      for (const int node : points_[static_cast<size_t>(kLanes * batch + l)]) {
        touched.push_back(node);
        const int clip = coordinates.clip_of(node);
        if (clip >= 0) touched.push_back(coordinates.points() + clip);
      }
    }
  });
  for (const auto& nodes : points_) {
    for (const auto& [i, j] : node_pairs<Measure>()) {
      const int p = nodes[static_cast<size_t>(i)], q = nodes[static_cast<size_t>(j)];
      const int row = coordinates.row(p), column = coordinates.row(q);
      if (coordinates.is_prescribed(p) || coordinates.is_prescribed(q)) {
        entries_.push_back(kNowhere);
      } else if (row < 0 || column < 0) {
        entries_.push_back(kThroughClip);
      } else if (row <= column) {
        entries_.push_back(2 * pattern.find(row, column));
      } else {
        entries_.push_back(2 * pattern.find(column, row) + 1);
      }
    }
  }
}

template <class Measure>
LanePositions<Measure> ElementPotential<Measure>::gather(int batch,
                                                         const Configuration& configuration) const {
  LanePositions<Measure> positions;
  const double* all = configuration.positions.data();
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
          LaneView(own + 2 * kLanes * m, kLanes, columns() - 2 * m)};
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
void ElementPotential<Measure>::evaluate(const Evaluation& at, Derivatives& derivatives) const {
  derivatives.energy += groups_.sum<Energy>(
      at.threads, [&](int batch) { return evaluate_batch(batch, at, derivatives); });
}

template <class Measure>
Energy ElementPotential<Measure>::evaluate_batch(int batch, const Evaluation& at,
                                                 const Derivatives& derivatives) const {
  Batch elements(*this, batch, at.configuration, at.history);
  density_->add(elements.samples, at.time, elements.response);
  if (derivatives.gradient) add_gradient(batch, elements, *derivatives.gradient);
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
void ElementPotential<Measure>::add_gradient(int batch, const Batch& elements,
                                             Eigen::Matrix3Xd& gradient) const {
  LanePositions<Measure> values;
  elements.kernel.gradient(elements.response, elements.size, values);
  for (int l = 0; l < kLanes; ++l) {
    const auto& nodes = points_[static_cast<size_t>(kLanes * batch + l)];
    for (int i = 0; i < Measure::kNodes; ++i) {
      for (int a = 0; a < 3; ++a) {
        gradient(a, nodes[static_cast<size_t>(i)]) += values(l, 3 * i + a);
      }
    }
  }
}

template <class Measure>
void ElementPotential<Measure>::add_hessian(int batch, const Batch& elements, const Evaluation& at,
                                            Hessian& hessian) const {
  LaneHessian<Measure> values;
  elements.kernel.hessian(elements.response, elements.size, at.curvature == Curvature::convex,
                          values);
  const int* entry = entries_.data() + static_cast<size_t>(kLanes * kPairs<Measure> * batch);
  for (int l = 0; l < kLanes; ++l) {
    const auto& nodes = points_[static_cast<size_t>(kLanes * batch + l)];
    int pair = 0;
    for (const auto& [i, j] : node_pairs<Measure>()) {
      const int place = *entry++;
      const int p = pair++;
      if (place >= 0) {
        const Eigen::Matrix3d block = block_of(values, l, p);
        if (place & 1) {
          hessian.matrix.block(place / 2) += block.transpose();
        } else {
          hessian.matrix.block(place / 2) += block;
        }
      } else if (place == kThroughClip) {
        hessian.coordinates.add_coupling(at.configuration, nodes[static_cast<size_t>(i)],
                                         nodes[static_cast<size_t>(j)], block_of(values, l, p),
                                         hessian.matrix);
      }
    }
  }
}

template <class Measure>
Eigen::Index ElementPotential<Measure>::history_size() const {
  return Eigen::Index(kLanes) * columns() * batches();
}

template <class Measure>
Eigen::VectorXd ElementPotential<Measure>::initial_history(
    const Configuration& configuration) const {
  constexpr int m = Measure::kStrains;
  const Eigen::VectorXd at_rest = Eigen::VectorXd::Zero(history_size());
  Eigen::VectorXd history(history_size());
  advance({configuration, at_rest.data(), {}}, history.data());
  for (int batch = 0; batch < batches(); ++batch) {
    double* own = history.data() + Eigen::Index(kLanes) * columns() * batch;
    MutableLaneView(own + kLanes * m, kLanes, m) = MutableLaneView(own, kLanes, m);
  }
  return history;
}

template <class Measure>
double ElementPotential<Measure>::advance(const Evaluation& at, double* next) const {
  constexpr int m = Measure::kStrains;
  return groups_.sum<double>(at.threads, [&](int batch) {
    const Batch elements(*this, batch, at.configuration, at.history);
    double* own = next + Eigen::Index(kLanes) * columns() * batch;
    MutableLaneView(own, kLanes, m) = elements.strain;
    MutableLaneView(own + kLanes * m, kLanes, m) = elements.samples.last;
    Lane work = Lane::Zero();
    density_->advance(elements.samples, at.time,
                      MutableLaneView(own + 2 * kLanes * m, kLanes, columns() - 2 * m), work);
    return (elements.size * work).sum();
  });
}

template <class Measure>
void ElementPotential<Measure>::set_parameters(const Eigen::VectorXd& all) {
  if (parameter_places_.empty()) return;
  density_->set_parameters(all(parameter_places_));
}

template <class Measure>
void ElementPotential<Measure>::differentiate_by(const std::vector<int>& column_of) {
  for (size_t k = 0; k < parameter_places_.size(); ++k) {
    parameter_columns_[k] = column_of[static_cast<size_t>(parameter_places_[k])];
  }
}

// Without own parameters and without memory, stress changes with the strain alone.
template <class Measure>
bool ElementPotential<Measure>::depends_on_parameters() const {
  return density_->history_size() > 0 ||
         std::any_of(parameter_columns_.begin(), parameter_columns_.end(),
                     [](int column) { return column >= 0; });
}

// Rows of a stencil's numbers in the potential's history: column c of lane l is 8 c + l.
template <class Measure>
void ElementPotential<Measure>::add_force_sensitivity(
    const Evaluation& at, const Eigen::MatrixXd& history_by_parameter,
    Eigen::MatrixXd& gradient_by_parameter) const {
  if (!depends_on_parameters()) return;
  constexpr int m = Measure::kStrains;
  const int own = density_->history_size(), count = static_cast<int>(parameter_columns_.size());
  const auto parameters = static_cast<int>(density_->parameters().size());
  for (int e = 0; e < count_; ++e) {
    const int batch = e / kLanes, lane = e % kLanes;
    const Batch elements(*this, batch, at.configuration, at.history);
    SampleDerivatives d(m, own, parameters);
    density_->differentiate(elements.samples, lane, 0, 0, d);
    const Eigen::Index first = Eigen::Index(kLanes) * columns() * batch + lane;
    Eigen::MatrixXd stress = Eigen::MatrixXd::Zero(m, history_by_parameter.cols());
    for (int k = 0; k < count; ++k) {
      const int column = parameter_columns_[static_cast<size_t>(k)];
      if (column >= 0) stress.col(column) += d.stress_by_parameter.col(k);
    }
    for (int c = 0; c < m; ++c) {
      stress += d.stress_by_last.col(c) * history_by_parameter.row(first + kLanes * c);
    }
    for (int c = 0; c < own; ++c) {
      stress += d.stress_by_history.col(c) * history_by_parameter.row(first + kLanes * (2 * m + c));
    }
    const auto l = static_cast<size_t>(lane);
    const Eigen::MatrixXd force =
        elements.size(lane) *
        Measure::gradient(elements.rests[l], elements.kernel.at(lane)).transpose() * stress;
    for (int i = 0; i < Measure::kNodes; ++i) {
      const int node = points_[static_cast<size_t>(e)][static_cast<size_t>(i)];
      gradient_by_parameter.middleRows<3>(3 * node) += force.middleRows<3>(3 * i);
    }
  }
}

template <class Measure>
void ElementPotential<Measure>::advance_sensitivity(const Evaluation& at,
                                                    const Eigen::MatrixXd& positions_by_parameter,
                                                    Eigen::MatrixXd& history_by_parameter) const {
  constexpr int m = Measure::kStrains;
  const int own = density_->history_size(), count = static_cast<int>(parameter_columns_.size());
  const auto parameters = static_cast<int>(density_->parameters().size());
  const Eigen::Index all = history_by_parameter.cols();
  for (int e = 0; e < count_; ++e) {
    const int batch = e / kLanes, lane = e % kLanes;
    const auto l = static_cast<size_t>(lane);
    const Batch elements(*this, batch, at.configuration, at.history);
    SampleDerivatives d(m, own, parameters);
    density_->differentiate(elements.samples, lane, 0, 0, d);

    Eigen::MatrixXd nodes(Measure::kUnknowns, all);
    for (int i = 0; i < Measure::kNodes; ++i) {
      const int node = points_[static_cast<size_t>(e)][static_cast<size_t>(i)];
      nodes.middleRows<3>(3 * i) = positions_by_parameter.middleRows<3>(3 * node);
    }
    const Eigen::MatrixXd strain =
        Measure::gradient(elements.rests[l], elements.kernel.at(lane)) * nodes;
    const Eigen::Index first = Eigen::Index(kLanes) * columns() * batch + lane;
    const auto rows = [&](int from, int n) {
      return Eigen::seqN(first + kLanes * from, n, kLanes);
    };
    const Eigen::MatrixXd last = history_by_parameter(rows(0, m), Eigen::all);
    const Eigen::MatrixXd kept = history_by_parameter(rows(2 * m, own), Eigen::all);
    Eigen::MatrixXd next =
        d.next_by_strain * strain + d.next_by_last * last + d.next_by_history * kept;
    for (int k = 0; k < count; ++k) {
      const int column = parameter_columns_[static_cast<size_t>(k)];
      if (column >= 0) next.col(column) += d.next_by_parameter.col(k);
    }
    history_by_parameter(rows(0, m), Eigen::all) = strain;
    history_by_parameter(rows(m, m), Eigen::all) = last;
    history_by_parameter(rows(2 * m, own), Eigen::all) = next;
  }
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

}  // namespace pliant
