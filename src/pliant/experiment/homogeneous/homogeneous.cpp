#include "pliant/experiment/homogeneous/homogeneous.h"

#include <algorithm>
#include <cmath>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/homogeneous/homogeneous_predictor.h"
#include "pliant/experiment/homogeneous/homogeneous_type.h"

namespace pliant {

HomogeneousTest::HomogeneousTest(const ExperimentSpec& spec, const DataRows& data) {
  const auto& own = spec_of<HomogeneousSpec>(spec);
  incompressible_ = own.incompressible;
  HomogeneousRows rows = read_rows(own, spec.where, data);
  path_ = std::move(rows.rows);
  measured_ = Eigen::Map<const Eigen::VectorXd>(rows.nominal_stress.data(),
                                                std::ssize(rows.nominal_stress));
  const std::vector<SpecimenRows> specimens = data.specimens();
  require_rows(specimens, data, 3);
  info_ = describe_experiment(spec, data, {"nominal_stress_Pa", "stress", "Pa", 1});
  for (std::string& text : rows.handled) info_.handled.push_back(std::move(text));
  info_.handled.emplace_back(incompressible_
                                 ? "the volume is taken to stay: the pressure is what makes the "
                                   "stress on the free sides vanish"
                                 : "the stretches across are those at which the stress on the free "
                                   "sides vanishes");
  cut_into_frames(specimens);
  take_times();
}

// The first row of each beginning is come to from rest, in no time that is told.
void HomogeneousTest::take_times() {
  if (info_.time.empty()) return;
  for (std::size_t row = 1; row < path_.size(); ++row) {
    const bool begins = std::ranges::binary_search(beginnings(), static_cast<int>(row));
    if (!begins) path_[row].seconds = info_.time[row] - info_.time[row - 1];
  }
}

void HomogeneousTest::cut_into_frames(const std::vector<SpecimenRows>& specimens) {
  for (std::size_t s = 0; s < specimens.size(); ++s) {
    const int end = specimens[s].first + specimens[s].count;
    for (int first = specimens[s].first; first < end;) {
      int last = first;
      while (last < end && path_[static_cast<std::size_t>(last)].mode ==
                               path_[static_cast<std::size_t>(first)].mode) {
        ++last;
      }
      std::vector<double> stretches;
      for (int i = first; i < last; ++i) {
        stretches.push_back(path_[static_cast<std::size_t>(i)].stretch);
      }
      append_from_rest(first, stretches, static_cast<int>(s));
      first = last;
    }
  }
}

std::unique_ptr<Predictor> HomogeneousTest::predictor(const Material& material) const {
  return std::make_unique<HomogeneousPredictor>(*this, material);
}

}  // namespace pliant
