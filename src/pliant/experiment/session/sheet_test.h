#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "pliant/experiment/experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/session/cord_drag.h"
#include "pliant/experiment/session/cord_friction.h"
#include "pliant/experiment/session/sheet_objective.h"
#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// What the thesis compares in a test of that name; in others the clips' forces where there are
/// any, else positions.
SheetObjective usual_objective(const Session& session);

/// The strain components that the thesis fits to a test ([T] 3.4.2), e.g. stretch.weft; none for a
/// test of another name.
std::vector<std::string> usual_components(std::string_view test);

/// A session with what a fit compares of it, row by row. Forces (N) or coordinates (m).
///
/// Where the friction of its cords is unknown, the width of the loop of each is a number of its
/// own, EXPERIMENT.CLIP.CORD.cord_friction. It is not negative; without a word of the study its
/// prior is 0
/// +- 0.1 N ([T] 3.2.3), and the cords of a clip are alike.
class SheetTest : public Experiment {
 public:
  /// @param session  on the mesh that is simulated
  /// @throws InputError where the session has nothing of the objective
  SheetTest(std::string name, Session session, SheetObjective objective,
            CordFriction friction = {});

  /// What its squared differences count beside those of other tests; 1 to begin with.
  void set_weight(double weight) { info_.weight = weight; }

  /// The same without some frames, as if they had not been measured.
  /// @param frames  in ascending order
  SheetTest without(const std::vector<int>& frames) const;

  const std::string& name() const { return info_.name; }
  const Session& session() const { return session_; }
  SheetObjective objective() const { return objective_; }
  const CordFriction& cord_friction() const { return friction_; }
  /// The drags of its cords; none where they are known to have none.
  const std::vector<CordDrag>& cords() const { return cords_; }

  int frame_count() const { return session_.frame_count(); }
  using Experiment::measured;
  using Experiment::rows;
  int rows(int frame) const;
  /// Whether one coordinate of each force is compared, instead of vectors.
  bool compares_one_axis() const;
  /// Clips or nodes that are compared in a frame; each has one row or three.
  int compared(int frame) const { return rows(frame) / (compares_one_axis() ? 1 : 3); }

  /// The nodes whose positions are compared in a frame, three rows each; none where forces are.
  const std::vector<int>& compared_nodes(int frame) const {
    return compared_[static_cast<std::size_t>(frame)].nodes;
  }

  Eigen::VectorXd measured(int frame) const;
  Eigen::VectorXd predicted(int frame, const SheetShape& shape) const;
  /// What each row counts in a fit: 0 where nobody knows which way an unknown cord of the clip
  /// moves, and so how it drags; of a position by how much surer it is than others, where the
  /// session tells it; else 1.
  Eigen::ArrayXd weights(int frame) const;
  /// Standard deviation of a row that counts 1 (N or m), where the session states it.
  std::optional<double> stated_noise() const;
  /// rows x parameters
  Eigen::MatrixXd jacobian(int frame, const SheetShape& shape) const;

  std::vector<Frame> frames() const override;
  /// One of each coordinate of a clip's force or of a node, along the frames.
  std::vector<std::vector<int>> series() const override;
  double reference() const override;
  Eigen::ArrayXd weights() const override;
  /// @param material  complete
  std::unique_ptr<Predictor> predictor(const Material& material) const override;

  /// The widths of the loops of its cords (N): those given where they are unknown, else as stated.
  Eigen::VectorXd cord_widths(const Eigen::VectorXd& nuisance) const;

 private:
  struct ForceRow {
    int clip;
    Eigen::Vector3d direction;
  };
  struct Compared {
    std::vector<ForceRow> forces;
    std::vector<int> nodes;  // three rows each
  };
  Compared compared_in(int frame) const;
  std::optional<double> mean_deviation() const;
  void add_cords();

  Session session_;
  SheetObjective objective_;
  CordFriction friction_;
  std::vector<CordDrag> cords_;
  std::vector<Compared> compared_;   // of each frame
  std::optional<double> deviation_;  // of positions: harmonic mean, where all are known (m)
};

/// A session as a study compares it.
/// @param spec     of an experiment of sessions
/// @param session  on the mesh that is simulated, or as it was measured
/// @throws InputError at the experiment's place in the study, for what `SheetTest` refuses, and for
///         unknown friction of cords where no forces are compared
SheetTest sheet_test_of(const ExperimentSpec& spec, Session session);

/// What the cords of a clip pull with in a frame (N).
Eigen::Vector3d cord_pull(const Session& session, int frame, int clip);

/// Of the mesh that is simulated (m).
double shortest_edge(const SheetTest& test);

}  // namespace pliant
