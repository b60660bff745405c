#include "pliant/experiment/homogeneous/homogeneous_type.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "pliant/base/quantity.h"
#include "pliant/experiment/homogeneous/homogeneous.h"
#include "pliant/experiment/homogeneous/homogeneous_predictor.h"
#include "pliant/experiment/solid_material.h"
#include "pliant/experiment/virtual_table.h"

namespace pliant {
namespace {

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults& defaults,
                                     ExperimentSpec&) {
  auto spec = std::make_shared<HomogeneousSpec>();
  spec->length = defaults.length;
  if (auto v = fields.optional("mode")) spec->mode = read_mode(*v);
  if (auto v = fields.optional("incompressible")) spec->incompressible = v->flag();
  if (auto v = fields.optional("length")) spec->length = v->positive_quantity(Dimension::length);
  if (auto v = fields.optional("area")) spec->area = v->positive_quantity(Dimension::area);
  return spec;
}

std::vector<double> read_stretches(const Value& list) {
  const std::vector<double> values = list.numbers();
  if (values.empty()) list.fail("is empty", "at least one stretch");
  for (const double value : values) {
    if (!(value > 0)) list.fail("has a stretch of 0 or below", "stretches above 0");
  }
  return values;
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualHomogeneous>();
  test->mode = read_mode(fields.require("mode"));
  if (auto v = fields.optional("incompressible")) test->incompressible = v->flag();
  test->peaks = read_stretches(fields.require("peaks"));
  if (test->mode == HomogeneousMode::biaxial) {
    const Value second = fields.require("peaks_2");
    test->peaks_2 = read_stretches(second);
    if (test->peaks_2.size() != test->peaks.size()) {
      second.fail("has another number of stretches than `peaks`", "one for each peak");
    }
  }
  if (auto v = fields.optional("samples")) test->samples = v->integer(3, 100000);
  if (auto v = fields.optional("cycles")) test->cycles = v->flag();
  if (auto v = fields.optional("duration")) test->duration = v->positive_quantity(Dimension::time);
  if (auto v = fields.optional("noise")) test->noise = v->quantity_from_zero(Dimension::stress);
  return test;
}

std::unique_ptr<Experiment> make(const ExperimentSpec& spec, const DataRows& data) {
  return std::make_unique<HomogeneousTest>(spec, data);
}

}  // namespace

const TestType& homogeneous_type() {
  static const TestType type{
      .name = "homogeneous",
      .facts = {.measures_solids = true,
                .follows_time = true,
                .assumption = "the specimen deforms alike all over, along its axes",
                .unfitted = "a specimen at rest at its first row"},
      .channels = {force_channel("stress", Dimension::stress)},
      .template_files = template_files("homogeneous"),
      .required = {"mode"},
      .told_by_columns = {"mode"},
      .read = read,
      .make_solid = make,
      .read_virtual = read_virtual,
      .own_quantities = {{"stretch", Dimension::number},
                         {"stretch_2", Dimension::number},
                         {"nominal_stress", Dimension::stress}},
      .is_table = [](const TableColumns& columns) {
        return columns.has("nominal_stress", Dimension::stress) &&
               (columns.has("stretch", Dimension::number) ||
                columns.has("strain", Dimension::fraction));
      }};
  return type;
}

WrittenFields HomogeneousSpec::fields() const {
  WrittenFields fields;
  if (mode) fields.emplace_back("mode", name_of(*mode));
  fields.emplace_back("incompressible", incompressible ? "true" : "false");
  if (length > 0) fields.emplace_back("length", exact_quantity(length, Dimension::length));
  if (area > 0) fields.emplace_back("area", exact_quantity(area, Dimension::area));
  return fields;
}

void VirtualHomogeneous::require(const Material& material) const {
  require_solid_law(material, where);
  require_same_everywhere(material, where);
  if (!incompressible) require_solid_of_volume(material, where);
}

std::vector<HomogeneousRow> VirtualHomogeneous::path() const {
  double reach = 0;
  for (const double peak : peaks) reach = std::max(reach, std::abs(peak - 1));
  std::vector<HomogeneousRow> rows;
  double from = 1, from_2 = 1;
  const auto go = [&](double to, double to_2) {
    const int steps = std::max(1, static_cast<int>(std::lround((samples - 1) * std::abs(to - from) /
                                                               std::max(reach, 1e-12))));
    for (int i = rows.empty() ? 0 : 1; i <= steps; ++i) {
      const double share = static_cast<double>(i) / steps;
      rows.push_back({mode, from + share * (to - from), from_2 + share * (to_2 - from_2)});
    }
    from = to;
    from_2 = to_2;
  };
  for (std::size_t i = 0; i < peaks.size(); ++i) {
    go(peaks[i], peaks_2.empty() ? 1 : peaks_2[i]);
    if (cycles) go(1, 1);
  }
  if (duration > 0) {
    const double seconds = duration / static_cast<double>(rows.size() - 1);
    for (HomogeneousRow& row : rows) row.seconds = seconds;
  }
  return rows;
}

VirtualData VirtualHomogeneous::measure(const VirtualSpecimen& specimen,
                                        const VirtualWork& work) const {
  work.stop.throw_if_requested();
  RandomStream random = specimen.random.split(fmt::format("{}/{}", name, specimen.number));
  const NamedLaw density = solid_density(specimen.material);
  Eigen::VectorXd numbers = density.law->parameters();
  for (double& number : numbers) number *= 1 + specimen.variation * random.normal();
  const auto law = density.law->with_parameters(numbers);
  const std::vector<HomogeneousRow> rows = path();
  const auto stresses = homogeneous_stresses(*law, rows, {0}, incompressible, false);
  if (!stresses) {
    throw SolverError("virtual experiment " + name + ": the equilibrium of the free sides", 0, 0);
  }
  ReadColumn first{"stretch", {}}, second{"stretch_2", {}},
      stress{"nominal_stress_Pa", {}, 1, {noise, 0}}, time{"time_s", {}};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    first.values.push_back(rows[i].stretch);
    second.values.push_back(rows[i].stretch_2);
    stress.values.push_back((*stresses)[i].value);
    time.values.push_back(static_cast<double>(i) * rows[i].seconds);
  }
  std::vector<ReadColumn> columns{first};
  if (mode == HomogeneousMode::biaxial) columns.push_back(second);
  columns.push_back(stress);
  if (duration > 0) columns.push_back(time);
  return {{{specimen.name + ".csv", table_text(columns, random)}}};
}

WrittenFields VirtualHomogeneous::study_fields() const {
  return {{"mode", std::string(name_of(mode))},
          {"incompressible", incompressible ? "true" : "false"}};
}

WrittenFields VirtualHomogeneous::description() const {
  return {
      {"mode", std::string(name_of(mode))},
      {"volume", incompressible ? "stays" : "may change"},
      {"stretches", fmt::format("{}{}", fmt::join(peaks, ", "), cycles ? ", each and back" : "")},
      {"noise", fmt::format("{:.4g} Pa", noise)}};
}

nlohmann::ordered_json VirtualHomogeneous::facts() const {
  return {{"mode", name_of(mode)}, {"incompressible", incompressible},
          {"peaks", peaks},        {"peaks_2", peaks_2},
          {"samples", samples},    {"cycles", cycles},
          {"stress_noise", noise}};
}

}  // namespace pliant
