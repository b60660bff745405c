#include "pliant/experiment/bending_length/overhangs.h"

#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/bending_length/bending_length_type.h"
#include "pliant/experiment/experiment_data.h"
#include "pliant/experiment/strip_figures.h"
#include "pliant/material/bending_strain.h"

namespace pliant {

Overhangs::Overhangs(OverhangRows rows, double angle, double density, int elements)
    : readings_(std::move(rows)),
      weight_(density * kStandardGravity),
      angle_(angle),
      elements_(elements) {
  measured_ = Eigen::Map<const Eigen::VectorXd>(
      readings_.overhang.data(), static_cast<Eigen::Index>(readings_.overhang.size()));
}

Overhangs::Overhangs(const ExperimentSpec& spec, const DataRows& data, const ClothFacts& cloth)
    : Overhangs(read_overhangs(data), spec_of<BendingLengthSpec>(spec).angle, cloth.density,
                DipOptions().elements) {
  require_density(spec, cloth.density);
  info_ = describe_experiment(spec, data, {"overhang_mm", "length", "mm", 1e3});
  read_path(data, spec);
  info_.handled.push_back(fmt::format(
      "each strip is pushed out flat and bends once, until its tip is seen {:.4g} degrees below "
      "the edge",
      angle_ * 180 / std::numbers::pi));
  for (std::string& text : bending_length_texts(readings_, angle_, weight_)) {
    info_.handled.push_back(std::move(text));
  }
  StripFigures strip(*spec.test, cloth.density);
  strip.add(figures::bending_length_of(cloth.density),
            measured_.mean() / elastic_dip(angle_)->overhang_per_length,
            {{strip.column("overhang", Dimension::length, data.quantity_unit("overhang"))}});
  info_.questions = first_asked({strip.question()});
}

// A reading says what a strip of one rigidity carries where it leaves the edge, bent from flat.
void Overhangs::read_path(const DataRows& data, const ExperimentSpec& spec) {
  const auto elastic = elastic_dip(angle_);
  if (!elastic) {
    throw InputError({spec.where.file, spec.where.line, spec.where.field + ".angle"},
                     "no strip of any use dips so far", "an angle of 41.5 deg, or up to 88 deg");
  }
  const std::vector<SpecimenRows> specimens = data.specimens();
  for (size_t s = 0; s < specimens.size(); ++s) {
    for (int row = specimens[s].first; row < specimens[s].first + specimens[s].count; ++row) {
      const double overhang = measured_(row);
      const double length = overhang / elastic->overhang_per_length;
      const double curvature = elastic->edge_turn / overhang;
      path_.strain.push_back(kStrainPerCurvature * curvature);
      path_.force.push_back(weight_ * length * length * length * curvature);
      path_.factor.push_back(1);
      path_.direction.push_back(1);
      path_.anchor.push_back(row);
      path_.specimen.push_back(static_cast<int>(s));
      path_.starts_flat.push_back(1);
    }
  }
}

std::optional<Prediction> Overhangs::predict(const ComponentLaw& law, const Eigen::VectorXd&,
                                             bool with_jacobian) const {
  Prediction prediction;
  prediction.value.resize(rows());
  prediction.strain.resize(rows());
  prediction.jacobian.resize(rows(), with_jacobian ? law.parameter_count() : 0);
  for (const StripFace face : {StripFace::up, StripFace::down}) {
    if (overhangs_of(readings_, face).empty()) continue;
    const auto strip = dipping_strip(law, weight_, angle_, {face, with_jacobian, elements_});
    if (!strip) return std::nullopt;
    for (Eigen::Index i = 0; i < rows(); ++i) {
      if (readings_.face[static_cast<size_t>(i)] != face) continue;
      prediction.value(i) = strip->overhang;
      prediction.strain(i) = kStrainPerCurvature * strip->edge_curvature;
      if (with_jacobian) prediction.jacobian.row(i) = strip->by_parameter.transpose();
    }
  }
  return prediction;
}

}  // namespace pliant
