#include "pliant/experiment/moved_body/moved_body_predictor.h"

#include <algorithm>
#include <iterator>

#include "pliant/material/solid/metric_values.h"
#include "pliant/mechanics/element_strains.h"

namespace pliant {

MovedBodyPredictor::MovedBodyPredictor(const MovedBodyTest& experiment, const Material& material)
    : experiment_(experiment),
      body_(experiment.setup(), solid_law(material)),
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
  const std::vector<Frame> frames = experiment_.frames();
  for (std::size_t f = 0; f < frames.size(); ++f) {
    workers.stop.throw_if_requested();
    const int frame = experiment_.readings()[static_cast<std::size_t>(frames[f].first)].frame;
    const bool known = !remembers_ && f < found_.size();
    const auto point = path.go_to(experiment_.shifts()[static_cast<std::size_t>(frame)],
                                  known ? &found_[f] : nullptr);
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
  const Eigen::Matrix3Xd& rest = experiment_.setup().mesh.positions;
  for (Eigen::Index row = 0; row < frame.count; ++row) {
    const BodyReading& reading =
        experiment_.readings()[static_cast<std::size_t>(frame.first + row)];
    if (reading.mark < 0) {
      rows.value(row) = point.force(reading.axis) / reading.noise;
      if (by > 0) rows.by.row(row) = point.force_by.row(reading.axis) / reading.noise;
      continue;
    }
    const SurfacePlace& place = experiment_.marks()[static_cast<std::size_t>(reading.mark)].place;
    rows.value(row) = (place.at(point.positions) - place.at(rest))(reading.axis) / reading.noise;
    for (int i = 0; i < 3 && by > 0; ++i) {
      rows.by.row(row) += place.shares(i) / reading.noise *
                          point.positions_by.row(3 * place.nodes(i) + reading.axis);
    }
  }
  return rows;
}

bool MovedBodyPredictor::predict(const Eigen::VectorXd& values, const std::vector<int>& by,
                                 const Workers& workers, FrameSink& rows) {
  const std::vector<Frame> frames = experiment_.frames();
  return walk(values, by, workers, [&](std::size_t f, const BodyPoint& point) {
    rows.take(static_cast<int>(f), rows_of(frames[f], point, by.size()));
  });
}

std::vector<double> MovedBodyPredictor::strains(const std::string& component,
                                                const Eigen::VectorXd& values,
                                                const Workers& workers) {
  std::vector<double> strains;
  const VolumeMesh& mesh = experiment_.setup().mesh;
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
  for (std::size_t f = reached; f < experiment_.frames().size(); ++f) {
    lost.push_back(static_cast<int>(f));
  }
  return lost;
}

}  // namespace pliant
