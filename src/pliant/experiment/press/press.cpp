#include "pliant/experiment/press/press.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/press/press_predictor.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {
namespace {

constexpr int kFewestRows = 3;

void require_areas(const std::vector<double>& areas, const DataRows& data) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] > 0) continue;
    throw InputError(data.location(static_cast<int>(i), "area"), "is not above 0",
                     "rows in which the indenter touches the body");
  }
}

}  // namespace

PressTest::PressTest(const ExperimentSpec& spec, const DataRows& data)
    : spec_(std::dynamic_pointer_cast<const PressSpec>(spec.test)),
      at_areas_(&spec.test->type() == &press_type()) {
  const char* column = at_areas_ ? "area" : "depth";
  set_ = data.quantity(column, at_areas_ ? Dimension::area : Dimension::length);
  require_change(set_, data, column);
  if (at_areas_) require_areas(set_, data);
  const std::vector<double> force = data.quantity("force", Dimension::force);
  require_change(force, data, "force");
  measured_ = Eigen::Map<const Eigen::VectorXd>(force.data(), std::ssize(force));
  const std::vector<SpecimenRows> specimens = data.specimens();
  require_rows(specimens, data, kFewestRows);
  info_ = describe_experiment(spec, data, {"force_N", "force", "N", 1});
  for (std::size_t s = 0; s < specimens.size(); ++s) {
    const std::vector<double> own(set_.begin() + specimens[s].first,
                                  set_.begin() + specimens[s].first + specimens[s].count);
    beginnings_.push_back(specimens[s].first);
    for (const HalfCycle& half : half_cycles_of(own, reversal_threshold(own, 0))) {
      frames_.push_back(
          {specimens[s].first + half.first, half.last - half.first + 1, static_cast<int>(s)});
    }
  }
}

std::vector<std::vector<int>> PressTest::series() const {
  std::vector<std::vector<int>> series;
  for (int row = 0; row < rows(); ++row) {
    if (std::ranges::binary_search(beginnings_, row)) series.emplace_back();
    series.back().push_back(row);
  }
  return series;
}

double PressTest::reference() const { return measured_.cwiseAbs().maxCoeff(); }

// A sphere of radius R touches a body in about pi R d at the depth d ([Hertz1881]); a plane meets
// a body as if that were a sphere.
double PressTest::stress() const {
  const double most = *std::ranges::max_element(set_);
  if (at_areas_) return reference() / most;
  const Eigen::Matrix3Xd& places = setup().mesh.positions;
  const double extent = (places.rowwise().maxCoeff() - places.rowwise().minCoeff()).norm();
  return reference() /
         (std::numbers::pi * setup().radius.value_or(extent / 2) * std::max(most, 1e-3 * extent));
}

std::vector<double> PressTest::imposed() const {
  const Eigen::Matrix3Xd& places = setup().mesh.positions;
  const Eigen::RowVectorXd along = setup().direction.transpose() * places;
  const double extent = along.maxCoeff() - along.minCoeff();
  std::vector<double> shares;
  for (const double value : set_) shares.push_back((at_areas_ ? std::sqrt(value) : value) / extent);
  return shares;
}

Eigen::ArrayXd PressTest::weights() const {
  return Eigen::Map<const Eigen::Array<char, Eigen::Dynamic, 1>>(info_.used.data(),
                                                                 std::ssize(info_.used))
      .cast<double>();
}

std::unique_ptr<Predictor> PressTest::predictor(const Material& material) const {
  return std::make_unique<PressPredictor>(*this, material);
}

}  // namespace pliant
