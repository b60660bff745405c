#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "pliant/base/progress.h"
#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/experiment/session/sheet_states.h"
#include "pliant/material/material.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// The frames of a session as equilibria of an elastic material, each for itself ([T] 3.4.1).
///
/// A search begins where the parameters before have ended, moved along the derivatives there, where
/// that fails at the measured shape, and at last at the equilibrium of a neighbouring frame.
class SheetEquilibria : public SheetPredictor {
 public:
  /// @param session   on the mesh that is simulated; outlives this
  /// @param material  complete; friction is left out
  SheetEquilibria(const Session& session, const Material& material);
  ~SheetEquilibria() override;

  int equilibria_each() const { return static_cast<int>(states_.states.size()); }

  std::vector<std::optional<SheetShape>> predict_each(const Eigen::VectorXd& parameters,
                                                      const std::vector<int>& by, int threads,
                                                      const StopToken& stop) override;
  void begin_at(std::vector<Eigen::Matrix3Xd> guesses) override { guesses_ = std::move(guesses); }
  std::vector<Eigen::Matrix3Xd> guesses() const override;

 private:
  struct Held;     // the sheet, held at some nodes: constant, for searches on any thread
  class Search;    // for an equilibrium
  struct Place;    // for one of these
  struct Reached;  // an equilibrium with its derivatives

  const Held& held(int state);
  Search search(int state, const Eigen::VectorXd& parameters);
  /// Shapes to begin a search at, one after the other, before the measured one.
  std::vector<Eigen::Matrix3Xd> starts(int state, const Eigen::VectorXd& parameters) const;
  bool find(int state, Search& search, Eigen::Matrix3Xd start);
  bool find_from_measured(int state, Search& search);
  bool find_near_measured(int state, Search& search);
  bool differentiate(int state, Search& search, const std::vector<int>& by);
  bool take_differences(int state, const std::vector<int>& by);
  void reach(int state, const Eigen::VectorXd& parameters, const std::vector<int>& by);
  void reach_from_neighbours(const Eigen::VectorXd& parameters, const std::vector<int>& by);
  bool found(int frame) const;
  SheetShape blended(int frame, bool derivatives) const;

  const Session& session_;
  Material material_;
  SheetStates states_;
  StopToken stop_;
  std::vector<Reached> reached_;
  std::vector<Eigen::Matrix3Xd> guesses_;                    // one a state, or none at all
  std::map<std::vector<int>, std::unique_ptr<Place>> held_;  // by the nodes that are
};

}  // namespace pliant
