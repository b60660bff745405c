#include "pliant/experiment/moved_body/moved_body_predictor.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "pliant/material/solid/metric_values.h"
#include "pliant/mechanics/element_strains.h"

namespace pliant {

MovedBodyPredictor::MovedBodyPredictor(const BodySetup& setup, Schedule schedule,
                                       const Material& material)
    : schedule_(std::move(schedule)),
      body_(setup, solid_law(material)),
      remembers_(body_.system().initial_state().history.size() > 0) {
  const ParameterList& list = body_.system().parameters();
  parameters_ = list.names;
  values_ = Eigen::Map<const Eigen::VectorXd>(list.values.data(), std::ssize(list.values));
}

template <class Take>
bool MovedBodyPredictor::walk(const Eigen::VectorXd& values, const std::vector<int>& by,
                              const Workers& workers, const Take& take) {
  MovedBodyPath path(body_, {body_.system().with(values), by, workers.stop});
  std::vector<Eigen::Matrix3Xd> found;
  for (std::size_t f = 0; f < schedule_.frames.size(); ++f) {
    workers.stop.throw_if_requested();
    const bool known = !remembers_ && f < found_.size();
    const auto point = path.go_to(schedule_.shifts[f], known ? &found_[f] : nullptr);
    if (!point) return false;
    take(f, *point);
    found.push_back(point->positions);
  }
  found_ = std::move(found);
  return true;
}

PredictedFrame MovedBodyPredictor::rows_of(const Frame& frame, const BodyPoint& point,
                                           std::size_t by) const {
  PredictedFrame rows;
  rows.value.resize(frame.count);
  rows.by.setZero(frame.count, static_cast<Eigen::Index>(by));
  for (int row = 0; row < frame.count; ++row) {
    const BodyReadout readout =
        schedule_.observable.read(frame.first + row, point.positions, point.force);
    rows.value(row) = readout.value;
    if (by == 0) continue;
    rows.by.row(row) = readout.by_force.transpose() * point.force_by;
    for (const auto& [node, change] : readout.by_node) {
      rows.by.row(row) += change.transpose() * point.positions_by.middleRows<3>(3 * node);
    }
  }
  return rows;
}

bool MovedBodyPredictor::predict(const Eigen::VectorXd& values, const std::vector<int>& by,
                                 const Workers& workers, FrameSink& rows) {
  return walk(values, by, workers, [&](std::size_t f, const BodyPoint& point) {
    rows.take(static_cast<int>(f), rows_of(schedule_.frames[f], point, by.size()));
  });
}

std::vector<double> MovedBodyPredictor::strains(const std::string& component,
                                                const Eigen::VectorXd& values,
                                                const Workers& workers) {
  std::vector<double> strains;
  const VolumeMesh& mesh = body_.setup().mesh;
  walk(values, {}, workers, [&](std::size_t, const BodyPoint& point) {
    if (component == "J") {
      std::ranges::copy(volume_strains(mesh, point.positions), std::back_inserter(strains));
      return;
    }
    for (const GreenStrainVector& strain : element_strains(mesh, point.positions)) {
      for (const double value : metric_values(component, strain)) strains.push_back(value);
    }
  });
  return strains;
}

std::vector<int> MovedBodyPredictor::lost_frames(const Eigen::VectorXd& values,
                                                 const Workers& workers) {
  std::size_t reached = 0;
  walk(values, {}, workers, [&](std::size_t, const BodyPoint&) { ++reached; });
  std::vector<int> lost;
  for (std::size_t f = reached; f < schedule_.frames.size(); ++f) {
    lost.push_back(static_cast<int>(f));
  }
  return lost;
}

}  // namespace pliant
