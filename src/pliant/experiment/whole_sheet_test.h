#pragma once

#include <functional>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include "pliant/base/errors.h"
#include "pliant/base/progress.h"
#include "pliant/experiment/experiment_info.h"
#include "pliant/experiment/template_files.h"
#include "pliant/material/material.h"

namespace pliant {

/// What a whole material shows in a test.
struct WholeSheetPrediction {
  Eigen::VectorXd value;                ///< of each row, SI
  std::vector<OwnColumn> columns = {};  ///< more that is predicted of each row
  std::vector<std::string> told = {};   ///< what the numbers are, in sentences
  nlohmann::ordered_json figures;       ///< the same as an object
  std::string picture = {};             ///< an SVG document, or nothing
  std::vector<std::string> warnings = {};
};

/// How the work on a prediction is followed.
struct WholeSheetWork {
  int threads = 1;  ///< on which nothing depends
  StopToken stop = {};
  std::function<void(int steps)> done = [](int) {};  ///< of `work()`; from any thread
};

/// A measurement in which all components of a material show together: it is predicted with a whole
/// material, and no fit learns from it.
class WholeSheetTest {
 public:
  virtual ~WholeSheetTest() = default;

  const ExperimentInfo& info() const { return info_; }
  const Eigen::VectorXd& measured() const { return measured_; }

  /// @param where  of the test, for the message
  /// @throws InputError for a material that cannot be predicted with
  virtual void require(const Material& material, const Location& where) const = 0;
  /// Steps that a prediction takes and that are worth telling of.
  virtual int work() const = 0;
  /// @param material  as it is required
  /// @throws SolverError where there is no prediction
  virtual WholeSheetPrediction predict(const Material& material,
                                       const WholeSheetWork& work) const = 0;

 protected:
  ExperimentInfo info_;
  Eigen::VectorXd measured_;
};

}  // namespace pliant
