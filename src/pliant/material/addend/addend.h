#pragma once

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "pliant/material/addend/addend_kind.h"

namespace pliant {

/// How long a step without end takes (s).
inline constexpr double kEndless = std::numeric_limits<double>::infinity();

/// A law of some kind with its numbers, on a strain of its own: what it answers at one material
/// point. A value; copies share the law.
class Addend {
 public:
  /// @param values  one a parameter of the kind
  Addend(const AddendKind& kind, const Eigen::VectorXd& values);

  const AddendKind& kind() const { return *kind_; }
  const Eigen::VectorXd& values() const { return values_; }
  int size() const { return static_cast<int>(values_.size()); }
  /// Numbers that it remembers.
  int history_size() const { return density_->history_size(); }
  bool is_elastic() const { return history_size() == 0; }
  bool is_friction() const { return kind_->friction; }
  bool flows() const { return kind_->flows; }
  /// Stiffness of the elastic range of a law that remembers and neither is friction nor flows; 0 of
  /// others.
  double range_stiffness() const;
  /// How much its stress may fall per strain while the strain goes on.
  double fall() const { return kind_->fall ? kind_->fall(values_) : 0; }

  /// The same law with its stress multiplied.
  Addend scaled(double factor) const;

  /// Stress, tangent and energies of a point at `strain` that was at `last` with some history.
  struct Answer {
    double stress = 0;
    double tangent = 0;
    double stored = 0;  ///< energy that comes back
    double work = 0;    ///< what the way from `last` took
  };
  /// @param seconds  that the way from `last` takes; only what flows depends on it
  Answer at(double strain, double last, const Eigen::VectorXd& history,
            double seconds = kEndless) const;

  /// Derivatives of the stress and of the history that a step leaves.
  SampleDerivatives derivatives(double strain, double last, const Eigen::VectorXd& history,
                                double seconds = kEndless) const;

  /// The history that a step from `last` to `strain` leaves.
  Eigen::VectorXd advanced(double strain, double last, const Eigen::VectorXd& history,
                           double seconds = kEndless) const;

 private:
  const AddendKind* kind_;
  Eigen::VectorXd values_;
  std::shared_ptr<const ParametricDensity> density_;
};

/// What the parameters of addends are called after their component: "fung.k", "dahl.a", and
/// "dahl2.a" where there is a second of the kind.
std::vector<std::string> parameter_names(const std::vector<Addend>& addends);

}  // namespace pliant
