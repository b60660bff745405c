#include "pliant/material/density/in_plane.h"

#include <array>
#include <utility>

#include "pliant/material/solid/metric_jet.h"

namespace pliant {
namespace {

/// Where the strains of a sheet stand among those of a solid: E11, E22, 2 E12.
constexpr std::array kPlaces{0, 1, 5};
constexpr int kSheetStrains = static_cast<int>(kPlaces.size());

using SolidLanes = Eigen::Array<double, kLanes, kSolidStrains>;

SolidLanes lifted(const LaneView& strain) {
  SolidLanes all = SolidLanes::Zero();
  for (int i = 0; i < kSheetStrains; ++i) all.col(kPlaces[static_cast<size_t>(i)]) = strain.col(i);
  return all;
}

/// Points of a sheet as those of a solid.
class LiftedPoints {
 public:
  explicit LiftedPoints(const Samples& samples)
      : now_(lifted(samples.strain)),
        last_(lifted(samples.last)),
        before_(lifted(samples.before)),
        own_(samples) {}

  Samples samples() const {
    return {view(now_), view(last_), view(before_), own_.history, own_.weights};
  }

 private:
  static LaneView view(const SolidLanes& lanes) {
    return LaneView(lanes.data(), kLanes, kSolidStrains);
  }

  SolidLanes now_, last_, before_;
  const Samples& own_;
};

}  // namespace

InPlane::InPlane(std::shared_ptr<const ParametricDensity> of_solid)
    : of_solid_(std::move(of_solid)) {}

void InPlane::add(const Samples& samples, const StepTime& time, Response& response) const {
  const LiftedPoints points(samples);
  Response of_solid(kSolidStrains);
  of_solid_->add(points.samples(), time, of_solid);
  response.stored += of_solid.stored;
  response.work += of_solid.work;
  for (int i = 0; i < kSheetStrains; ++i) {
    const int row = kPlaces[static_cast<size_t>(i)];
    response.stress.col(i) += of_solid.stress.col(row);
    for (int j = 0; j < kSheetStrains; ++j) {
      response.tangent.col(kSheetStrains * i + j) +=
          of_solid.tangent.col(kSolidStrains * row + kPlaces[static_cast<size_t>(j)]);
    }
  }
}

void InPlane::add_stored(const Samples& samples, Lane& stored) const {
  of_solid_->add_stored(LiftedPoints(samples).samples(), stored);
}

void InPlane::advance(const Samples& samples, const StepTime& time, MutableLaneView next,
                      Lane& work) const {
  of_solid_->advance(LiftedPoints(samples).samples(), time, next, work);
}

std::unique_ptr<ParametricDensity> InPlane::with_parameters(const Eigen::VectorXd& values) const {
  return std::make_unique<InPlane>(of_solid_->with_parameters(values));
}

void InPlane::differentiate(const Samples& samples, const StepTime& time, int lane,
                            int first_history, int first_parameter,
                            SampleDerivatives& derivatives) const {
  const int history = history_size(), count = static_cast<int>(parameters().size());
  SampleDerivatives of_solid(kSolidStrains, history, count);
  of_solid_->differentiate(LiftedPoints(samples).samples(), time, lane, 0, 0, of_solid);
  derivatives.stored_by_parameter.segment(first_parameter, count) += of_solid.stored_by_parameter;
  derivatives.stress_by_last += of_solid.stress_by_last(kPlaces, kPlaces);
  derivatives.stress_by_history.middleCols(first_history, history) +=
      of_solid.stress_by_history(kPlaces, Eigen::all);
  derivatives.stress_by_parameter.middleCols(first_parameter, count) +=
      of_solid.stress_by_parameter(kPlaces, Eigen::all);
  derivatives.next_by_strain.middleRows(first_history, history) +=
      of_solid.next_by_strain(Eigen::all, kPlaces);
  derivatives.next_by_last.middleRows(first_history, history) +=
      of_solid.next_by_last(Eigen::all, kPlaces);
  derivatives.next_by_history.block(first_history, first_history, history, history) +=
      of_solid.next_by_history;
  derivatives.next_by_parameter.block(first_history, first_parameter, history, count) +=
      of_solid.next_by_parameter;
}

}  // namespace pliant
