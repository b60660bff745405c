#pragma once

#include <limits>
#include <memory>

#include <Eigen/Core>

namespace pliant {

/// How many material points a density evaluates in one call; the compiler makes vector
/// instructions of their arithmetic.
inline constexpr int kLanes = 8;
/// Most strain components of one material point.
inline constexpr int kMaxStrains = 6;

using Lane = Eigen::Array<double, kLanes, 1>;
/// One column a strain component.
using LaneStrains =
    Eigen::Array<double, kLanes, Eigen::Dynamic, Eigen::ColMajor, kLanes, kMaxStrains>;
/// Column i strains + j holds d stress_i / d strain_j.
using LaneTangents = Eigen::Array<double, kLanes, Eigen::Dynamic, Eigen::ColMajor, kLanes,
                                  kMaxStrains * kMaxStrains>;
/// Numbers of eight points that stand elsewhere: one column a strain component or a number of a
/// density's history.
using LaneView = Eigen::Map<const Eigen::Array<double, kLanes, Eigen::Dynamic>>;
using MutableLaneView = Eigen::Map<Eigen::Array<double, kLanes, Eigen::Dynamic>>;

/// How limits of energy are kept (limited_density.h): by a barrier m psi_max b(g) of the share
/// g = 1 - psi / psi_max of a limit that is left, b = -ln g.
struct LimitBarrier {
  double share = 1e-6;  ///< m; the smaller, the nearer a limit is reached before anything is felt
  /// Below this g the barrier goes on as a parabola, so that it is finite beyond the limit too and
  /// leads back; 0: it is infinite there.
  double mended = 0;
};

/// What laws that depend on time know of the present step: the rate of strain is
/// (strain - (now last + earlier before)) per_second.
struct StepTime {
  double per_second = 0;  ///< 1/s; 0 in statics, where there are no rates
  double now = 1;         ///< weight of the strain at the last accepted step
  double earlier = 0;     ///< weight of the strain one accepted step before that
  LimitBarrier limits = {};
  /// How long the step takes (s): what flows with time comes to rest in one without end, as those
  /// of statics are unless they follow a record.
  double seconds = std::numeric_limits<double>::infinity();
};

/// Eight material points: their strain, and what they remember. A view: the numbers outlive it.
struct Samples {
  LaneView strain;
  LaneView last;     ///< strain at the last accepted step
  LaneView before;   ///< strain one accepted step before that
  LaneView history;  ///< what the density itself keeps, set at accepted steps only
  /// What each sample of a heterogeneous material counts at the points ([T] Eq. 4.4); no column
  /// where the material is one.
  LaneView weights = LaneView(nullptr, kLanes, 0);

  /// The same points, with a part of the history as the whole.
  Samples with_history(int first, int size) const {
    return {strain, last, before, LaneView(history.data() + kLanes * first, kLanes, size), weights};
  }
};

/// What eight material points answer, per rest area or volume.
struct Response {
  explicit Response(int strains);

  Lane stored;           ///< energy that comes back: of elasticity (J/m^2)
  Lane work;             ///< work done since the last accepted step against friction and damping
  LaneStrains stress;    ///< d (stored + work) / d strain
  LaneTangents tangent;  ///< d stress / d strain
};

/// Puts the nearest tangents without negative eigenvalues in place of those of a response.
void make_tangent_convex(Response& response, int strains);

/// Derivatives of one material point's stress and history along a quasi-static path ([T] 5.2; a
/// path's sensitivity carries them from step to step).
struct SampleDerivatives {
  SampleDerivatives(int strains, int history, int parameters);

  Eigen::VectorXd stored_by_parameter;  ///< of laws that remember nothing
  Eigen::MatrixXd stress_by_last;       ///< strains x strains: w.r.t. the strain at the last step
  Eigen::MatrixXd stress_by_history;    ///< strains x history
  Eigen::MatrixXd stress_by_parameter;  ///< strains x parameters
  Eigen::MatrixXd next_by_strain;       ///< history x strains: the history that the step leaves
  Eigen::MatrixXd next_by_last;         ///< history x strains
  Eigen::MatrixXd next_by_history;      ///< history x history
  Eigen::MatrixXd next_by_parameter;    ///< history x parameters
};

/// The law of a material: energy per rest area or volume as a function of strain, parameters and
/// history. It knows no nodes. A law of one strain component is told which one it acts on.
///
/// Rate-independent friction and damping are laws too: within a step their stress is the derivative
/// of an incremental potential of the new strain, `Response::work` (docs/architecture.md).
class Density {
 public:
  virtual ~Density() = default;

  /// Numbers that it keeps for each material point from step to step.
  virtual int history_size() const = 0;

  /// Adds its energy, stress and tangent.
  virtual void add(const Samples& samples, const StepTime& time, Response& response) const = 0;

  /// Whether energies of it have a limit, beyond which its own is infinite.
  virtual bool is_limited() const { return false; }

  /// Lowers `left` to what share of their limits limited energies are below them; below 0 beyond.
  virtual void lower_to_share_left(const Samples& samples, Lane& left) const {
    static_cast<void>(samples), static_cast<void>(left);
  }

  /// Adds the energy that is stored at the strain. Those that have none, or a short way to it, say
  /// so; else it is that of `add`.
  virtual void add_stored(const Samples& samples, Lane& stored) const;

  /// Ends a step at `samples.strain`.
  /// @param next  the history from then on
  /// @param work  gets the work done during the step against friction and damping added
  virtual void advance(const Samples& samples, const StepTime& time, MutableLaneView next,
                       Lane& work) const = 0;
};

/// A law described by numbers that fits look for, with what the sensitivity of a quasi-static path
/// needs of it. Like every law it is constant: other numbers make another law.
class ParametricDensity : public Density {
 public:
  /// The numbers that describe the law, e.g. the control values of its stiffness.
  virtual Eigen::VectorXd parameters() const = 0;
  /// Whether energy, stress and tangent are linear in them, so that the law of a sum of numbers is
  /// the sum of the laws.
  virtual bool is_linear() const { return false; }
  /// The law of the same kind with other numbers.
  virtual std::unique_ptr<ParametricDensity> with_parameters(
      const Eigen::VectorXd& values) const = 0;

  /// Adds the derivatives of material point `lane`, where nothing has a rate.
  /// @param first_history, first_parameter  where its own begin in `derivatives`
  virtual void differentiate(const Samples& samples, const StepTime& time, int lane,
                             int first_history, int first_parameter,
                             SampleDerivatives& derivatives) const = 0;
};

}  // namespace pliant
