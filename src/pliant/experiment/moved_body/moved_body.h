#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "pliant/experiment/moved_body/body_observable.h"
#include "pliant/experiment/moved_body/moved_body_type.h"
#include "pliant/experiment/solid_experiment.h"
#include "pliant/measurement/data_source.h"

namespace pliant {

/// What one row of a moved body is of.
struct BodyReading {
  int frame = 0;
  int mark = -1;     ///< whose position; -1: the force
  int axis = 0;      ///< x, y, z
  double noise = 1;  ///< standard deviation (N, m)
};

/// A place on a body's surface that is followed through the frames.
struct BodyMark {
  std::string name;
  SurfacePlace place;
  Eigen::Vector3d rest;  ///< as it was measured (m)
};

/// Forces that move a body, and positions of marks on its surface: a mix of readings, each in units
/// of its stated noise. Of marks the way from where they are at rest counts.
class MovedBodyTest : public SolidExperiment, public BodyObservable {
 public:
  /// @param points  rows of the marks' positions; null: none were measured
  /// @throws InputError for unusable data
  MovedBodyTest(const ExperimentSpec& spec, const DataRows& data, const DataRows* points);

  const BodySetup& setup() const { return spec_->setup; }
  /// Of what is moved, frame by frame (m).
  const std::vector<Eigen::Vector3d>& shifts() const { return shifts_; }
  const std::vector<BodyMark>& marks() const { return marks_; }
  /// Of each row, the frames one after the other.
  const std::vector<BodyReading>& readings() const { return readings_; }

  std::vector<Frame> frames() const override { return frames_; }
  /// The forces along each axis; of each frame the marks along each axis.
  std::vector<std::vector<int>> series() const override;
  double stress() const override;
  std::vector<double> imposed() const override;
  std::vector<std::string> differences(const Eigen::VectorXd& predicted) const override;
  std::unique_ptr<Predictor> predictor(const Material& material) const override;
  BodyReadout read(int row, const Eigen::Matrix3Xd& positions,
                   const Eigen::Vector3d& force) const override;

 private:
  struct Row {
    BodyReading reading;
    double value = 0;  // SI
  };
  void read_shifts(const DataRows& data);
  void append_forces(const DataRows& data, const ExperimentSpec& spec, std::vector<Row>& rows);
  void append_positions(const DataRows& points, const ExperimentSpec& spec, std::vector<Row>& rows);
  /// @param places  of each row of `points` (m)
  std::map<std::string, int> read_marks(const DataRows& points, const std::vector<long>& frames,
                                        const std::vector<std::string>& names,
                                        const std::vector<Eigen::Vector3d>& places);
  void take_rows(const std::vector<Row>& rows);
  void describe_rows();

  std::shared_ptr<const MovedBodySpec> spec_;
  std::vector<Eigen::Vector3d> shifts_;
  std::vector<BodyMark> marks_;
  std::vector<BodyReading> readings_;
  std::vector<Frame> frames_;
  double largest_force_ = 0;
};

}  // namespace pliant
