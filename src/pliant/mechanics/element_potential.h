#pragma once

#include <memory>

#include "pliant/material/density/density.h"
#include "pliant/mechanics/element_fields.h"
#include "pliant/mechanics/element_groups.h"
#include "pliant/mechanics/hessian_places.h"
#include "pliant/mechanics/lane_kernel.h"
#include "pliant/mechanics/parametric_potential.h"
#include "pliant/mechanics/stencils.h"

namespace pliant {

/// A density on the strain measure of many stencils: energy = size * density(strain of the
/// points).
///
/// History of a stencil: its strains at the last accepted step and one step before that, then what
/// the density keeps; eight stencils together, lane by lane.
///
/// Where the measure tells of inversion, the energy is infinite at it and searches are kept from
/// it; likewise beyond a limit of the density's energy. Eight stencils that begin at a multiple of
/// eight and share their points, as those of the points of a hexahedron do, are added to forces and
/// stiffness as one.
template <class Measure>
class ElementPotential : public ParametricPotential, public ElementFields {
 public:
  /// @param density           a law of Measure::kStrains strains
  /// @param parameter_places  where each parameter of the density stands among the system's
  /// @param field_names       of the strains, then of the density's history; empty for no output
  ElementPotential(const Stencils<Measure>& stencils,
                   std::shared_ptr<const ParametricDensity> density,
                   std::vector<int> parameter_places = {},
                   std::vector<std::string> field_names = {});

  std::vector<std::pair<int, int>> couplings() const override;
  void bind(const Coordinates& coordinates, const BlockPattern& pattern) override;
  bool obstructs() const override { return kMayInvert || is_limited(); }
  bool is_limited() const override { return density_->is_limited(); }
  double share_left(const Evaluation& at) const override;
  void limit(const Evaluation& from, const Eigen::Matrix3Xd& to, WayLimits& limits) const override;
  void evaluate(const Evaluation& at, Derivatives& derivatives) const override;

  Eigen::Index history_size() const override;
  Eigen::VectorXd initial_history(const Evaluation& at) const override;
  Energy advance(const Evaluation& at, double* next) const override;

  std::shared_ptr<const ParametricDensity> law(const Eigen::VectorXd& all) const override;
  void add_force_sensitivity(const Evaluation& at, const std::vector<int>& by,
                             const Eigen::Ref<const Eigen::MatrixXd>& history_by_parameter,
                             Eigen::MatrixXd& gradient_by_parameter) const override;
  void advance_sensitivity(const Evaluation& at, const std::vector<int>& by,
                           const Eigen::MatrixXd& positions_by_parameter,
                           Eigen::Ref<Eigen::MatrixXd> history_by_parameter) const override;

  std::vector<std::string> field_names() const override { return field_names_; }
  Eigen::MatrixXd field_values(const double* history) const override;
  Eigen::MatrixXi element_points() const override;
  Eigen::VectorXd element_sizes() const override;

 private:
  using Rests = std::array<typename Measure::Rest, kLanes>;
  struct Batch;  // eight stencils, evaluated
  static constexpr bool kMayInvert = requires(const LaneKernel<Measure>& kernel) {
    kernel.volume_ratio();
  };

  const ParametricDensity& law_at(const Evaluation& at) const {
    return at.law ? *at.law : *density_;
  }
  /// Whether ways end at the limit of the law.
  bool obeys_limit(const Evaluation& at) const {
    return law_at(at).is_limited() && at.time.limits.mended == 0;
  }
  void shorten_to_limit(const Evaluation& from, const Eigen::Matrix3Xd& to,
                        WayLimits& limits) const;
  /// For each parameter of the law its column among `by`; -1: none.
  std::vector<int> columns_of_parameters(const std::vector<int>& by) const;
  int batches() const { return static_cast<int>(points_.size()) / kLanes; }
  int columns() const { return 2 * Measure::kStrains + density_->history_size(); }
  /// Vectors of all points, one after the other, in the order of a batch; and back, added.
  LanePositions<Measure> gather(int batch, const double* all) const;
  void scatter(int batch, const LanePositions<Measure>& values, double* all) const;
  Samples samples(int batch, const LaneStrains& strain, const double* history) const;
  Rests rests_near(int batch, const LaneView& last) const;
  Energy evaluate_batch(int batch, const Evaluation& at, const Derivatives& derivatives) const;
  static std::array<LanePositions<Measure>, Measure::kStrains> strain_gradients(
      const Batch& elements);
  void add_hessian(int batch, const Batch& elements, const Evaluation& at, Hessian& hessian) const;

  std::vector<std::array<int, Measure::kNodes>> points_;  // filled up to whole batches
  std::vector<char> share_points_;                        // whether those of a batch do
  std::vector<typename Measure::Rest> rests_;
  std::vector<double> sizes_;  // zero for those that fill up
  Eigen::MatrixXd weights_;    // kLanes rows; of the samples of each batch, one after the other
  int count_ = 0;              // without those that fill up
  std::shared_ptr<const ParametricDensity> density_;
  std::vector<int> parameter_places_;
  std::vector<std::string> field_names_;
  HessianPlaces<Measure> places_;  // once bound
  ElementGroups groups_;           // of batches
};

}  // namespace pliant
