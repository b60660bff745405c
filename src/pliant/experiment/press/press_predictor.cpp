#include "pliant/experiment/press/press_predictor.h"

#include <algorithm>

#include "pliant/base/parallel.h"
#include "pliant/material/solid/metric_values.h"
#include "pliant/mechanics/element_strains.h"

namespace pliant {

PressPredictor::PressPredictor(const PressTest& experiment, const Material& material)
    : experiment_(experiment),
      body_(experiment.setup(), solid_law(material), experiment.stress()),
      workspace_(body_.system()) {
  const ParameterList& list = body_.system().parameters();
  parameters_ = list.names;
  values_ = Eigen::Map<const Eigen::VectorXd>(list.values.data(), std::ssize(list.values));
}

bool PressPredictor::go_to(int row, PressPath& path) const {
  const double set = experiment_.set()[static_cast<std::size_t>(row)];
  return (experiment_.is_at_areas() ? path.go_to_area(set) : path.go_to_travel(set)).has_value();
}

void PressPredictor::add_cost(const PressPath& path) const {
  const std::scoped_lock lock(adding_);
  work_.counts += path.counts();
}

PressPredictor::Rows PressPredictor::walked(const Asked& asked) const {
  Rows rows;
  std::optional<PressPath> path;
  for (int row = 0; row < experiment_.rows(); ++row) {
    asked.workers.stop.throw_if_requested();
    if (std::ranges::binary_search(experiment_.beginnings(), row)) {
      if (path) add_cost(*path);
      path.emplace(body_, options(asked), workspace_.another());
    }
    if (!go_to(row, *path)) break;
    rows.push_back(path->stand());
  }
  if (path) add_cost(*path);
  return rows;
}

// Searches for numbers go back, and to the same bounds again.
const PressPredictor::Solved& PressPredictor::nearest(const Asked& asked) const {
  const auto distance = [&](const Solved& solved) {
    const Eigen::ArrayXd a = solved.values, b = asked.values;
    return ((a - b).abs() / (a.abs() + b.abs()).max(1e-300)).matrix().squaredNorm();
  };
  return *std::ranges::min_element(solved_, {}, distance);
}

std::optional<PressStand> PressPredictor::settled(int row, const Solved& from,
                                                  const Asked& asked) const {
  PressPath path(body_, options(asked), workspace_.another(),
                 from.rows[static_cast<std::size_t>(row)]);
  const auto settle = [&](const Eigen::VectorXd& change) {
    return (experiment_.is_at_areas() ? path.settle_at_area(change) : path.settle_at_travel(change))
        .has_value();
  };
  const Eigen::VectorXd change = asked.values(from.by) - from.values(from.by);
  const bool found = (change.size() > 0 && settle(change)) || settle({});
  add_cost(path);
  return found ? std::optional(path.stand()) : std::nullopt;
}

std::optional<PressStand> PressPredictor::from_row_before(int row, const Rows& rows,
                                                          const Asked& asked) const {
  if (std::ranges::binary_search(experiment_.beginnings(), row)) return std::nullopt;
  PressPath path(body_, options(asked), workspace_.another(),
                 rows[static_cast<std::size_t>(row) - 1]);
  const bool found = go_to(row, path);
  add_cost(path);
  return found ? std::optional(path.stand()) : std::nullopt;
}

// Where the row that is pressed most is not found there is little hope for the others. Rows that
// others begin at are looked for in order, so that nothing depends on that of threads.
std::optional<PressPredictor::Rows> PressPredictor::settled(const Asked& asked) const {
  if (solved_.empty()) return std::nullopt;
  const Solved& from = nearest(asked);
  if (from.values == asked.values && (asked.by.empty() || asked.by == from.by)) return from.rows;
  std::vector<std::optional<PressStand>> found(from.rows.size());
  const auto most = std::ranges::max_element(experiment_.set()) - experiment_.set().begin();
  found[static_cast<std::size_t>(most)] = settled(static_cast<int>(most), from, asked);
  if (!found[static_cast<std::size_t>(most)]) return std::nullopt;
  parallel_for(static_cast<int>(found.size()), asked.workers.threads, [&](int row) {
    asked.workers.stop.throw_if_requested();
    if (row != most) found[static_cast<std::size_t>(row)] = settled(row, from, asked);
  });
  Rows rows;
  for (std::optional<PressStand>& row : found) {
    if (!row) row = from_row_before(static_cast<int>(rows.size()), rows, asked);
    if (!row) return std::nullopt;
    rows.push_back(std::move(*row));
  }
  return rows;
}

const PressPredictor::Rows& PressPredictor::rows(const Asked& asked) {
  constexpr std::size_t kMost = 4;
  auto beside = settled(asked);
  // A walk along limits is long, and what is not found beside numbers that are is mostly beyond.
  const bool walks = solved_.empty() || !body_.system().is_limited();
  found_ = Rows{};
  if (beside) {
    found_ = std::move(*beside);
  } else if (walks) {
    found_ = walked(asked);
  }
  if (!are_all(found_) || body_.remembers()) return found_;
  solved_.push_front({asked.values, asked.by, std::move(found_)});
  if (solved_.size() > kMost) solved_.pop_back();
  return solved_.front().rows;
}

bool PressPredictor::predict(const Eigen::VectorXd& values, const std::vector<int>& by,
                             const Workers& workers, FrameSink& frames) {
  const Rows& found = rows({values, by, workers});
  if (!are_all(found)) return false;
  PredictedFrame all;
  all.value.resize(experiment_.rows());
  all.by.resize(experiment_.rows(), std::ssize(by));
  for (Eigen::Index row = 0; row < all.value.size(); ++row) {
    const PressPoint& point = found[static_cast<std::size_t>(row)].point;
    all.value(row) = point.force;
    if (!by.empty()) all.by.row(row) = point.force_by;
  }
  give_by_frames(experiment_, all, frames);
  return true;
}

std::vector<double> PressPredictor::strains(const std::string& component,
                                            const Eigen::VectorXd& values, const Workers& workers) {
  std::vector<double> strains;
  const VolumeMesh& mesh = experiment_.setup().mesh;
  for (const PressStand& row : rows({values, {}, workers})) {
    const Eigen::Matrix3Xd& positions = row.state.configuration.positions;
    if (component == "J") {
      std::ranges::copy(volume_strains(mesh, positions), std::back_inserter(strains));
      continue;
    }
    for (const GreenStrainVector& strain : point_strains(mesh, positions)) {
      for (const double value : metric_values(component, strain)) strains.push_back(value);
    }
  }
  return strains;
}

std::vector<int> PressPredictor::lost_frames(const Eigen::VectorXd& values,
                                             const Workers& workers) {
  const int found = static_cast<int>(rows({values, {}, workers}).size());
  std::vector<int> lost;
  const std::vector<Frame> frames = experiment_.frames();
  for (std::size_t f = 0; f < frames.size(); ++f) {
    if (frames[f].first + frames[f].count > found) lost.push_back(static_cast<int>(f));
  }
  return lost;
}

}  // namespace pliant
