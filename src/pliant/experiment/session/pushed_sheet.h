#pragma once

#include <memory>
#include <vector>

#include "pliant/experiment/session/sheet_predictor.h"
#include "pliant/experiment/session/sheet_states.h"
#include "pliant/experiment/session/sheet_system.h"
#include "pliant/material/material.h"
#include "pliant/measurement/session.h"

namespace pliant {

/// The frames of a session on a table as one quasi-static path of a material with internal
/// friction.
///
/// The sheet lies flat and at rest on the table until it is pushed over the edge. It passes the
/// edge row by row, whatever the frames skip: each piece bends where it leaves the table and
/// unbends a little as it hangs further out, and friction remembers that. Pulled back, it is laid
/// down row by row; it turns round at rows only, the next one that the frames reach into.
class PushedSheet : public SheetPredictor {
 public:
  /// @param session   with a table, on the mesh that is simulated; outlives this
  /// @param material  complete
  PushedSheet(const Session& session, const Material& material);

  std::vector<std::optional<SheetShape>> predict_each(const Eigen::VectorXd& parameters,
                                                      const std::vector<int>& by, int threads,
                                                      const StopToken& stop) override;

 private:
  class Path;

  /// The sheet as the table holds it in a state, made when it is first asked for.
  const SheetSystem& held_at(int row);

  const Session& session_;
  Material material_;
  SheetStates states_;
  std::vector<std::unique_ptr<const SheetSystem>> sheets_;  // one a state
};

}  // namespace pliant
