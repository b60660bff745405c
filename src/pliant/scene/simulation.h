#pragma once

#include <array>
#include <memory>
#include <vector>

#include "pliant/mechanics/search_costs.h"
#include "pliant/scene/energy_table.h"
#include "pliant/scene/scene_system.h"

namespace pliant {

/// A clip at one time.
struct ClipRow {
  /// Rigid motion from where it started: x = R x_start + t.
  std::array<double, 3> translation{};  ///< t, m
  std::array<double, 4> rotation{};     ///< R as a quaternion w, x, y, z
  /// What holds or moves it from outside, against cloth, weight and cords (N); nothing where it is
  /// free and in equilibrium.
  std::array<double, 3> force{};
};

/// What the steps of a simulation took, attempts that failed included.
struct StepRecords {
  std::vector<double> seconds;
  std::vector<SearchCosts> costs;  ///< the parts of the seconds
  std::vector<int> substeps;       ///< 1 but where a step was halved
  std::vector<int> newton_iterations;
  std::vector<int> linear_iterations;
  /// Least one of contact at the end, m: from an obstacle, or of cloth from cloth where that is
  /// nearer than the thickness; none without contact.
  std::vector<double> distances;
  /// Points and pairs that touch at the end; none without contact.
  std::vector<int> contacts;
};

/// Everything that a simulation is at the end of a step: what it takes to go on to the same bits.
struct SimulationState {
  int steps = 0;  ///< of the scene's constant size, accepted
  State state;
  double work = 0;  ///< see EnergyRow
  double drag = 0;
  double rubbing = 0;
  double outside = 0;
  StepRecords records;
  std::vector<EnergyRow> energies;  ///< one a frame
  std::vector<ClipRow> clips;       ///< frame by frame, one for each clip of the scene
};

/// A scene on its way through time, or along a path of equilibria. An equilibrium that is not found
/// is approached by half the step, and its halves again; so is a time step where the scene says
/// `adaptive`.
class Simulation {
 public:
  /// @param threads  to compute with, at most; the results do not depend on it
  Simulation(const Scene& scene, const std::optional<Material>& filler, int threads = 1);
  ~Simulation();

  /// The scene, with the tolerance that its steps are solved to.
  const Scene& scene() const { return scene_; }
  const SceneSystem& built() const { return built_; }
  const SimulationState& now() const { return now_; }
  /// Goes on from a state of a simulation of the same scene, which may have ended earlier.
  void resume(SimulationState state);

  bool is_finished() const { return now_.steps >= scene_.time.step_count(); }
  /// Whether a frame stands at the present step.
  bool is_frame() const;
  /// Whether it has been recorded.
  bool is_recorded() const;
  /// Keeps what tables tell of the present step: energies, clips.
  void record_frame();

  /// Takes one step of the scene.
  /// @throws SolverError when it does not converge, however short; the state is then as it was
  void advance();

 private:
  struct StepResult;
  class Stepper;
  class TimeSteps;
  class Equilibria;

  void record_energy(const Energy& energy);
  void record_clips(const Eigen::Matrix3Xd& gradient);
  void record_contacts();

  Scene scene_;
  int threads_;
  SceneSystem built_;
  std::unique_ptr<Stepper> stepper_;
  SimulationState now_;
};

}  // namespace pliant
