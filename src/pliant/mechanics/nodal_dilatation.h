#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "pliant/mechanics/element_fields.h"
#include "pliant/mechanics/parametric_potential.h"

namespace pliant {

/// A density on the volumes around the nodes of tetrahedra, so that a material of nearly constant
/// volume does not lock in them (Bonet and Burton 1998): the strain of a node is V / V0 - 1, V
/// being a quarter of the volumes of its tetrahedra, and energy = V0 density(strain).
///
/// History of a node: as of the stencils of an ElementPotential.
class NodalDilatation : public ParametricPotential, public ElementFields {
 public:
  using Tetrahedra = std::vector<std::array<int, 4>>;  ///< points of each

  /// Weights of the samples of a heterogeneous material at a point.
  using Weights = std::function<Eigen::VectorXd(int point)>;

  /// @param rest_volumes      of the tetrahedra (m^3)
  /// @param density           a law of one strain
  /// @param parameter_places  where each parameter of the density stands among the system's
  /// @param field_names       of the strain, then of the density's history; empty for no output
  NodalDilatation(Tetrahedra tetrahedra, const std::vector<double>& rest_volumes,
                  std::shared_ptr<const ParametricDensity> density,
                  std::vector<int> parameter_places = {}, std::vector<std::string> field_names = {},
                  const Weights& weights = {});

  std::vector<std::pair<int, int>> couplings() const override;
  void bind(const Coordinates& coordinates, const BlockPattern& pattern) override;
  bool obstructs() const override { return is_limited(); }
  void limit(const Evaluation& from, const Eigen::Matrix3Xd& to, WayLimits& limits) const override;
  bool is_limited() const override { return density_->is_limited(); }
  double share_left(const Evaluation& at) const override;
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
  Eigen::VectorXd element_sizes() const override { return rest_volumes_; }

 private:
  /// A node with the tetrahedra around it.
  struct Patch {
    int point = 0;
    std::vector<int> tetrahedra;
    std::vector<int> points;  ///< of the tetrahedra, each once, rising
    std::vector<int> places;  ///< of the pairs of different `points` in the Hessian, row by row
  };
  using Gradient = Eigen::Matrix<double, 3, 4>;  // of a tetrahedron's volume by its nodes

  static constexpr int kThroughCoordinates = -1;  // one of the points is not free

  int batches() const;
  int columns() const { return 2 + density_->history_size(); }
  const ParametricDensity& law_at(const Evaluation& at) const {
    return at.law ? *at.law : *density_;
  }
  std::vector<Gradient> volume_gradients(const Eigen::Matrix3Xd& positions) const;
  /// Of all nodes, and zeros that fill up whole batches.
  Eigen::VectorXd strains(const Eigen::Matrix3Xd& positions) const;
  Samples samples(int batch, const LaneStrains& strain, const double* history) const;
  /// What is left to each node of the limit of its energy.
  Eigen::ArrayXd shares_left(const Evaluation& at, const Eigen::Matrix3Xd& positions) const;
  /// Adds the forces of pressures at the nodes.
  void add_forces(const std::vector<Gradient>& gradients, const Eigen::VectorXd& pressures,
                  double* gradient) const;
  Eigen::Matrix3Xd patch_gradient(const Patch& patch, const std::vector<Gradient>& gradients) const;
  void add_patch(const Patch& patch, double factor, const Eigen::Matrix3Xd& gradient,
                 const Configuration& at, Hessian& hessian) const;
  void add_stress_part(int tetrahedron, double pressure, const Configuration& at,
                       Hessian& hessian) const;
  std::vector<int> columns_of_parameters(const std::vector<int>& by) const;

  Tetrahedra tetrahedra_;
  std::vector<Patch> patches_;
  std::vector<std::array<int, 4>> patches_of_;  // of the nodes of each tetrahedron
  Eigen::VectorXd rest_volumes_;                // of the nodes
  Eigen::MatrixXd weights_;  // kLanes rows; of the samples of each batch, one after the other
  std::shared_ptr<const ParametricDensity> density_;
  std::vector<int> parameter_places_;
  std::vector<std::string> field_names_;
};

}  // namespace pliant
