#pragma once

#include "pliant/experiment/session.h"
#include "pliant/experiment/sheet/sheet_predictor.h"
#include "pliant/experiment/sheet/sheet_system.h"

namespace pliant {

/// The frames of a session as one quasi-static path of a material with internal friction, from the
/// flat sheet at rest on.
class SheetPath : public SheetPredictor {
 public:
  /// @param session   with clips, without a table, on the mesh that is simulated; outlives this
  /// @param material  complete
  SheetPath(const Session& session, const Material& material);

  std::optional<std::vector<SheetShape>> predict(const Eigen::VectorXd& parameters,
                                                 const std::vector<int>& by, int threads,
                                                 const StopToken& stop) override;

 private:
  const Session& session_;
  SheetSystem sheet_;
};

}  // namespace pliant
