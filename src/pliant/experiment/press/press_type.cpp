#include "pliant/experiment/press/press_type.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/quantity.h"
#include "pliant/experiment/press/press.h"
#include "pliant/experiment/press/press_path.h"
#include "pliant/experiment/press/press_setup_fields.h"
#include "pliant/experiment/solid_material.h"
#include "pliant/experiment/virtual_table.h"
#include "pliant/geometry/refined_volume.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/geometry/volume_source.h"

namespace pliant {
namespace {

WrittenFields setup_fields(const PressSetup& setup, const std::string& fixed) {
  WrittenFields fields{{"fixed", fixed}, {"direction", vector_text(setup.direction)}};
  if (!setup.radius) return fields;
  fields.emplace_back("radius", exact_quantity(*setup.radius, Dimension::length));
  fields.emplace_back("through", vector_text(setup.through));
  return fields;
}

}  // namespace

std::shared_ptr<const TestSpec> read_press(const TestType& kind, Fields& fields) {
  auto spec = std::make_shared<PressSpec>();
  spec->kind = &kind;
  spec->setup.mesh = read_body_mesh(fields, spec->mesh_file);
  read_press_setup(fields, spec->setup, spec->fixed);
  return spec;
}

std::shared_ptr<VirtualTest> read_virtual_press(const TestType& kind, Fields& fields) {
  auto test = std::make_shared<VirtualPress>();
  test->kind = &kind;
  test->setup.mesh = make_volume_mesh(read_volume_source(fields.require("mesh")));
  read_press_setup(fields, test->setup, test->fixed);
  test->depths = read_quantities(fields.require("depths"), Dimension::length, "depth");
  if (auto v = fields.optional("samples")) test->samples = v->integer(3, 10000);
  if (auto v = fields.optional("cycles")) test->cycles = v->flag();
  if (auto v = fields.optional("noise")) test->noise = v->quantity_from_zero(Dimension::force);
  return test;
}

std::unique_ptr<Experiment> make_press(const ExperimentSpec& spec, const DataRows& data) {
  return std::make_unique<PressTest>(spec, data);
}

const TestType& press_type() {
  static const TestType type{
      .name = "press",
      .facts = kPressFacts,
      .channels = {force_channel()},
      .template_files = template_files("press"),
      .required = {"mesh", "unit", "fixed", "direction"},
      .read = [](Fields& fields, const SpecimenDefaults&,
                 ExperimentSpec&) { return read_press(press_type(), fields); },
      .make_solid = make_press,
      .read_virtual = [](Fields& fields) { return read_virtual_press(press_type(), fields); },
      .own_quantities = {{"area", Dimension::area}},
      .is_table =
          [](const TableColumns& columns) {
            return columns.has("area", Dimension::area) && columns.has("force", Dimension::force) &&
                   !columns.has("extension", Dimension::length);
          }};
  return type;
}

WrittenFields PressSpec::fields() const {
  WrittenFields fields = written(mesh_file);
  std::ranges::move(setup_fields(setup, fixed), std::back_inserter(fields));
  return fields;
}

std::shared_ptr<const TestSpec> PressSpec::on_finer_body() const {
  auto finer = std::make_shared<PressSpec>(*this);
  const RefinedVolume body = refined(setup.mesh);
  finer->setup.mesh = body.mesh;
  finer->setup.held = body.nodes(setup.held);
  return finer;
}

void VirtualPress::require(const Material& material) const {
  require_solid_of_volume(material, where);
  for (const double depth : depths) {
    if (!(depth > 0)) throw InputError(where, "has a depth of 0 or below", "depths above 0");
  }
}

std::vector<double> VirtualPress::path() const {
  const double deepest = *std::ranges::max_element(depths);
  std::vector<double> path;
  double from = 0;
  const auto go = [&](double to) {
    const int steps =
        std::max(1, static_cast<int>(std::lround((samples - 1) * std::abs(to - from) / deepest)));
    for (int i = 1; i <= steps; ++i) path.push_back(from + (to - from) * i / steps);
    from = to;
  };
  for (const double depth : depths) {
    go(depth);
    if (cycles) go(0);
  }
  return path;
}

int VirtualPress::work() const { return static_cast<int>(path().size()); }

VirtualData VirtualPress::measure(const VirtualSpecimen& specimen, const VirtualWork& work) const {
  RandomStream random = specimen.random.split(fmt::format("{}/{}", name, specimen.number));
  const SolidLaw law = solid_law(specimen.material);
  const double pressure = stiffness_at_rest(law).diagonal().tail<3>().maxCoeff();  // to shear
  const PressedBody body(setup, law, pressure);
  const ParameterList& list = body.system().parameters();
  Eigen::VectorXd numbers =
      Eigen::Map<const Eigen::VectorXd>(list.values.data(), std::ssize(list.values));
  for (double& number : numbers) number *= 1 + specimen.variation * random.normal();
  PressPath way(body, {body.system().with(numbers), {}, work.stop});
  ReadColumn area{"area_mm2", {}, 1e6}, depth{"depth_mm", {}, 1e3},
      force{"force_N", {}, 1, {noise, 0}};
  for (const double at : path()) {
    const auto point = way.go_to_travel(at);
    if (!point) {
      throw SolverError(
          fmt::format("virtual experiment {}: the equilibrium at a depth of {:.4g} mm", name,
                      1e3 * at),
          0, 0);
    }
    work.done(1);
    const bool left = kind == &press_type() && !(point->force > 0);
    if (left) continue;
    area.values.push_back(point->area);
    depth.values.push_back(at);
    force.values.push_back(point->force);
  }
  const ReadColumn& set = kind == &press_type() ? area : depth;
  VirtualData data{{{specimen.name + ".csv", table_text({set, force}, random)}}};
  if (specimen.number == 1) {
    data.files.emplace_back(name + ".msh", volume_file_text(setup.mesh, name + ".msh"));
  }
  return data;
}

WrittenFields VirtualPress::study_fields() const {
  WrittenFields fields{{"mesh", nlohmann::json(name + ".msh").dump()}, {"unit", "m"}};
  std::ranges::move(setup_fields(setup, fixed), std::back_inserter(fields));
  return fields;
}

WrittenFields VirtualPress::description() const {
  std::string turns;
  for (const double depth : depths) {
    turns += (turns.empty() ? "" : ", ") + format_quantity(depth, Dimension::length);
  }
  return {
      {"body", fmt::format("{} nodes, {} elements, held at {}", setup.mesh.node_count(),
                           setup.mesh.element_count(), fixed)},
      {"indenter", setup.radius ? "a sphere of " + format_quantity(*setup.radius, Dimension::length)
                                : "a plane"},
      {"depths", turns + (cycles ? ", each and back" : "")},
      {"noise", format_quantity(noise, Dimension::force)}};
}

nlohmann::ordered_json VirtualPress::facts() const {
  nlohmann::ordered_json facts{{"nodes", setup.mesh.node_count()},
                               {"elements", setup.mesh.element_count()},
                               {"fixed", fixed},
                               {"depths", depths},
                               {"samples", samples},
                               {"cycles", cycles},
                               {"force_noise", noise}};
  if (setup.radius) facts["radius"] = *setup.radius;
  return facts;
}

}  // namespace pliant
