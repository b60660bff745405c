#include "pliant/experiment/press/press.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/press/press_predictor.h"

namespace pliant {
namespace {

constexpr int kFewestRows = 3;

/// No press leads there: what is stated is hardly in the unit that is stated of it.
void refuse_beyond(const std::vector<double>& set, double most, const std::string& what,
                   Dimension dimension, const DataRows& data, const char* column) {
  const auto beyond = std::ranges::find_if(set, [&](double value) { return value > most; });
  if (beyond == set.end()) return;
  throw InputError(data.location(static_cast<int>(beyond - set.begin()), column),
                   fmt::format("{} is more than {}, {}", format_quantity(*beyond, dimension), what,
                               format_quantity(most, dimension)),
                   "less; are the column and the mesh in the units that are stated of them?");
}

}  // namespace

PressTest::PressTest(const ExperimentSpec& spec, const DataRows& data)
    : spec_(std::dynamic_pointer_cast<const PressSpec>(spec.test)),
      at_areas_(&spec.test->type() == &press_type()) {
  const char* column = at_areas_ ? "area" : "depth";
  set_ = data.quantity(column, at_areas_ ? Dimension::area : Dimension::length);
  require_change(set_, data, column);
  if (at_areas_) require_positive(set_, data, column);
  if (at_areas_) {
    refuse_beyond(set_, area_to_touch(setup()), "all of the body that is not held", Dimension::area,
                  data, column);
  } else {
    refuse_beyond(set_, extent_of(setup().mesh), "the body is large", Dimension::length, data,
                  column);
  }
  const std::vector<double> force = data.quantity("force", Dimension::force);
  require_change(force, data, "force");
  measured_ = Eigen::Map<const Eigen::VectorXd>(force.data(), std::ssize(force));
  const std::vector<SpecimenRows> specimens = data.specimens();
  require_rows(specimens, data, kFewestRows);
  info_ = describe_experiment(spec, data, {"force_N", "force", "N", 1});
  for (std::size_t s = 0; s < specimens.size(); ++s) {
    const auto [name, first, count] = specimens[s];
    const std::span own(set_.data() + first, static_cast<std::size_t>(count));
    append_from_rest(first, own, static_cast<int>(s));
  }
}

// A sphere of radius R touches a body in about pi R d at the depth d ([Hertz1881]); a plane meets
// a body as if that were a sphere.
double PressTest::stress() const {
  const double most = *std::ranges::max_element(set_);
  if (at_areas_) return reference() / most;
  const double extent = extent_of(setup().mesh);
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

std::unique_ptr<Predictor> PressTest::predictor(const Material& material) const {
  return std::make_unique<PressPredictor>(*this, material);
}

}  // namespace pliant
