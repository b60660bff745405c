#include "pliant/experiment/press/press_predictor.h"

#include <algorithm>

#include "pliant/material/solid/metric_values.h"
#include "pliant/mechanics/element_strains.h"

namespace pliant {

PressPredictor::PressPredictor(const PressTest& experiment, const Material& material)
    : experiment_(experiment), body_(experiment.setup(), solid_law(material), experiment.stress()) {
  const ParameterList& list = body_.system().parameters();
  parameters_ = list.names;
  values_ = Eigen::Map<const Eigen::VectorXd>(list.values.data(), std::ssize(list.values));
}

template <class Take>
bool PressPredictor::walk(const Eigen::VectorXd& values, const std::vector<int>& by,
                          const Workers& workers, const Take& take) const {
  std::optional<PressPath> path;
  for (int row = 0; row < experiment_.rows(); ++row) {
    workers.stop.throw_if_requested();
    if (std::ranges::binary_search(experiment_.beginnings(), row)) {
      path.emplace(body_, PressOptions{body_.system().with(values), by, workers.stop});
    }
    const double set = experiment_.set()[static_cast<std::size_t>(row)];
    const auto point = experiment_.is_at_areas() ? path->go_to_area(set) : path->go_to_travel(set);
    if (!point) return false;
    take(row, *point, path->positions());
  }
  return true;
}

bool PressPredictor::predict(const Eigen::VectorXd& values, const std::vector<int>& by,
                             const Workers& workers, FrameSink& rows) {
  PredictedFrame all;
  all.value.resize(experiment_.rows());
  all.by.resize(experiment_.rows(), std::ssize(by));
  const bool found =
      walk(values, by, workers, [&](int row, const PressPoint& point, const Eigen::Matrix3Xd&) {
        all.value(row) = point.force;
        if (!by.empty()) all.by.row(row) = point.force_by;
      });
  if (!found) return false;
  give_by_frames(experiment_, all, rows);
  return true;
}

std::vector<double> PressPredictor::strains(const std::string& component,
                                            const Eigen::VectorXd& values, const Workers& workers) {
  std::vector<double> strains;
  const VolumeMesh& mesh = experiment_.setup().mesh;
  walk(values, {}, workers, [&](int, const PressPoint&, const Eigen::Matrix3Xd& positions) {
    if (component == "J") {
      std::ranges::copy(volume_strains(mesh, positions), std::back_inserter(strains));
      return;
    }
    for (const GreenStrainVector& strain : element_strains(mesh, positions)) {
      for (const double value : metric_values(component, strain)) strains.push_back(value);
    }
  });
  return strains;
}

std::vector<int> PressPredictor::lost_frames(const Eigen::VectorXd& values,
                                             const Workers& workers) {
  int rows = 0;
  walk(values, {}, workers, [&](int, const PressPoint&, const Eigen::Matrix3Xd&) { ++rows; });
  std::vector<int> lost;
  const std::vector<Frame> frames = experiment_.frames();
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (frames[f].first + frames[f].count > rows) lost.push_back(static_cast<int>(f));
  }
  return lost;
}

}  // namespace pliant
