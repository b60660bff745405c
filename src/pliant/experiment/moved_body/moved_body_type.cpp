#include "pliant/experiment/moved_body/moved_body_type.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/experiment/moved_body/moved_body.h"
#include "pliant/experiment/moved_body/moved_body_path.h"
#include "pliant/experiment/solid_material.h"
#include "pliant/experiment/virtual_table.h"
#include "pliant/geometry/refined_volume.h"
#include "pliant/geometry/spread_points.h"
#include "pliant/geometry/surface_nodes.h"
#include "pliant/geometry/volume_file.h"
#include "pliant/geometry/volume_source.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

/// Noise that counts as none, where a study has to state some: of the largest force or way.
constexpr double kExact = 1e-6;

constexpr TestFacts kFacts{.measures_solids = true,
                           .assumption =
                               "what is fixed does not give way, and what is moved keeps "
                               "its shape",
                           .unfitted = "a body at rest before its first row"};

/// Nodes of the surface that are neither held nor moved.
std::vector<int> free_surface(const BodySetup& setup) {
  std::vector<int> nodes = surface_nodes(setup.mesh);
  std::erase_if(nodes, [&](int node) {
    return std::ranges::binary_search(setup.held, node) ||
           std::ranges::binary_search(setup.moved, node);
  });
  return nodes;
}

void read_setup(Fields& fields, BodySetup& setup, std::string& fixed, std::string& moved) {
  const Value held = fields.require("fixed"), led = fields.require("moved");
  fixed = held.text();
  moved = led.text();
  setup.held = read_body_nodes(held, setup.mesh);
  setup.moved = read_body_nodes(led, setup.mesh);
  std::vector<int> both;
  std::ranges::set_intersection(setup.held, setup.moved, std::back_inserter(both));
  if (!both.empty()) {
    led.fail(fmt::format("has {} node{} that {} fixed", both.size(), both.size() == 1 ? "" : "s",
                         both.size() == 1 ? "is" : "are"),
             "a part of the body that nothing holds");
  }
  if (free_surface(setup).empty()) led.fail("leaves no surface free", "a part of the body");
}

std::shared_ptr<const TestSpec> read_spec(Fields& fields, const SpecimenDefaults&,
                                          ExperimentSpec&) {
  auto spec = std::make_shared<MovedBodySpec>();
  spec->setup.mesh = read_body_mesh(fields, spec->mesh_file);
  read_setup(fields, spec->setup, spec->fixed, spec->moved);
  if (auto points = fields.optional("points")) spec->points = read_data_source(*points);
  return spec;
}

std::unique_ptr<Experiment> make(const ExperimentSpec& spec, const DataRows& data) {
  const auto& own = spec_of<MovedBodySpec>(spec);
  std::optional<DataRows> points;
  if (own.points) points.emplace(*own.points);
  return std::make_unique<MovedBodyTest>(spec, data, points ? &*points : nullptr);
}

void read_lab_noise(const Value& value, VirtualMovedBody& test) {
  Fields noise = value.fields();
  if (auto v = noise.optional("force")) test.force_noise = v->quantity_from_zero(Dimension::force);
  if (auto v = noise.optional("length")) {
    test.length_noise = v->quantity_from_zero(Dimension::length);
  }
  noise.finish();
}

std::shared_ptr<VirtualTest> read_lab(Fields& fields) {
  auto test = std::make_shared<VirtualMovedBody>();
  test->setup.mesh = make_volume_mesh(read_volume_source(fields.require("mesh")));
  read_setup(fields, test->setup, test->fixed, test->moved);
  const Value shifts = fields.require("shifts");
  for (const Value& shift : shifts.items()) test->shifts.push_back(read_vector(shift));
  if (test->shifts.empty()) shifts.fail("is empty", "at least one [x, y, z]");
  if (auto v = fields.optional("study_mesh")) {
    test->study_mesh = make_volume_mesh(read_volume_source(*v));
  }
  if (auto v = fields.optional("marks")) test->marks = v->integer(0, 100000);
  if (auto v = fields.optional("noise")) read_lab_noise(*v, *test);
  return test;
}

/// A table whose columns are as they are, in the units of their headers.
std::string plain_table(const std::vector<ReadColumn>& columns) {
  RandomStream none(0);
  return table_text(columns, none);
}

std::vector<int> marked_nodes(const BodySetup& setup, int marks) {
  const std::vector<int> surface = free_surface(setup);
  const int count = std::min(marks, static_cast<int>(surface.size()));
  std::vector<int> nodes;
  if (count == 0) return nodes;
  for (const int i : spread_points(setup.mesh.positions(Eigen::all, surface), count)) {
    nodes.push_back(surface[static_cast<std::size_t>(i)]);
  }
  return nodes;
}

/// What was set and what it took, frame by frame.
class MovedTable {
 public:
  void add(const Eigen::Vector3d& shift, const Eigen::Vector3d& force, double noise,
           RandomStream& random) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      columns_[axis].values.push_back(shift(i));
      columns_[3 + axis].values.push_back(force(i) + noise * random.normal());
    }
  }

  std::string text() const { return plain_table(columns_); }

 private:
  std::vector<ReadColumn> columns_{{"shift_x_mm", {}, 1e3}, {"shift_y_mm", {}, 1e3},
                                   {"shift_z_mm", {}, 1e3}, {"force_x_N", {}},
                                   {"force_y_N", {}},       {"force_z_N", {}}};
};

/// Where marks are seen, frame by frame.
class MarkTable {
 public:
  explicit MarkTable(std::vector<int> nodes) : nodes_(std::move(nodes)) {}

  void see(int frame, const Eigen::Matrix3Xd& positions, double noise, RandomStream& random) {
    for (std::size_t mark = 0; mark < nodes_.size(); ++mark) {
      columns_[0].values.push_back(frame);
      columns_[1].values.push_back(static_cast<double>(mark + 1));
      for (int axis = 0; axis < 3; ++axis) {
        columns_[static_cast<std::size_t>(2 + axis)].values.push_back(
            positions(axis, nodes_[mark]) + noise * random.normal());
      }
    }
  }

  std::string text() const { return plain_table(columns_); }

 private:
  std::vector<int> nodes_;
  std::vector<ReadColumn> columns_{
      {"frame", {}}, {"point", {}}, {"x_mm", {}, 1e3}, {"y_mm", {}, 1e3}, {"z_mm", {}, 1e3}};
};

}  // namespace

const TestType& moved_body_type() {
  static const TestType type{
      .name = "moved-body",
      .facts = kFacts,
      .channels = {force_channel(), length_channel()},
      .template_files = template_files("moved_body"),
      .required = {"mesh", "unit", "fixed", "moved"},
      .read = read_spec,
      .make_solid = make,
      .read_virtual = read_lab,
      .is_table = [](const TableColumns& columns) {
        const auto any = [&](const char* what, Dimension dimension) {
          return std::ranges::any_of(std::array{"x", "y", "z"}, [&](const char* axis) {
            return columns.has(fmt::format("{}_{}", what, axis), dimension);
          });
        };
        return any("shift", Dimension::length) && any("force", Dimension::force);
      }};
  return type;
}

WrittenFields MovedBodySpec::fields() const {
  WrittenFields fields = written(mesh_file);
  fields.emplace_back("fixed", fixed);
  fields.emplace_back("moved", moved);
  if (points) {
    fields.emplace_back("points",
                        std::filesystem::absolute(points->files.front()).generic_string());
  }
  return fields;
}

std::shared_ptr<const TestSpec> MovedBodySpec::on_finer_body() const {
  auto finer = std::make_shared<MovedBodySpec>(*this);
  const RefinedVolume body = refined(setup.mesh);
  finer->setup = {body.mesh, body.nodes(setup.held), body.nodes(setup.moved)};
  return finer;
}

std::vector<std::filesystem::path> MovedBodySpec::files() const {
  std::vector<std::filesystem::path> files{mesh_file.path};
  if (points) std::ranges::copy(points->files, std::back_inserter(files));
  return files;
}

void VirtualMovedBody::require(const Material& material) const {
  require_solid_of_volume(material, where);
}

VirtualData VirtualMovedBody::measure(const VirtualSpecimen& specimen,
                                      const VirtualWork& work) const {
  if (specimen.number > 1) {
    throw InputError(where, "measures one body, and the lab has several specimens",
                     "`specimens: 1`");
  }
  RandomStream random = specimen.random.split(fmt::format("{}/{}", name, specimen.number));
  const HeldBody body(setup, solid_law(specimen.material));
  const ParameterList& list = body.system().parameters();
  Eigen::VectorXd numbers =
      Eigen::Map<const Eigen::VectorXd>(list.values.data(), std::ssize(list.values));
  for (double& number : numbers) number *= 1 + specimen.variation * random.normal();
  MovedTable moved_table;
  MarkTable mark_table(marked_nodes(setup, marks));
  mark_table.see(0, setup.mesh.positions, /*noise=*/0, random);
  MovedBodyPath path(body, {body.system().with(numbers), {}, work.stop});
  for (std::size_t f = 0; f < shifts.size(); ++f) {
    const auto found = path.go_to(shifts[f]);
    if (!found) {
      throw SolverError(
          fmt::format("virtual experiment {}: the equilibrium of frame {}", name, f + 1), 0, 0);
    }
    moved_table.add(shifts[f], found->force, force_noise, random);
    mark_table.see(static_cast<int>(f) + 1, found->positions, length_noise, random);
    work.done(1);
  }
  VirtualData data{{{specimen.name + ".csv", moved_table.text()}}};
  if (marks > 0) data.files.emplace_back(specimen.name + "-points.csv", mark_table.text());
  data.files.emplace_back(name + ".msh",
                          volume_file_text(study_mesh.value_or(setup.mesh), name + ".msh"));
  return data;
}

WrittenFields VirtualMovedBody::study_fields() const {
  WrittenFields fields{{"mesh", nlohmann::json(name + ".msh").dump()},
                       {"unit", "m"},
                       {"fixed", fixed},
                       {"moved", moved}};
  if (marks > 0) fields.emplace_back("points", nlohmann::json(name + "-points.csv").dump());
  double way = 0;
  for (const Eigen::Vector3d& shift : shifts) way = std::max(way, shift.norm());
  fields.emplace_back(
      "noise", fmt::format("{{force: {}, length: {}}}",
                           exact_quantity(force_noise > 0 ? force_noise : kExact, Dimension::force),
                           exact_quantity(length_noise > 0 ? length_noise : kExact * way,
                                          Dimension::length)));
  return fields;
}

WrittenFields VirtualMovedBody::description() const {
  return {{"body", fmt::format("{} nodes, {} elements, held at {}, moved at {}",
                               setup.mesh.node_count(), setup.mesh.element_count(), fixed, moved)},
          {"frames", fmt::format("{}, {} marks on the surface", shifts.size(), marks)},
          {"noise", fmt::format("{} and {}", format_quantity(force_noise, Dimension::force),
                                format_quantity(length_noise, Dimension::length))}};
}

nlohmann::ordered_json VirtualMovedBody::facts() const {
  return {{"nodes", setup.mesh.node_count()},
          {"elements", setup.mesh.element_count()},
          {"fixed", fixed},
          {"moved", moved},
          {"frames", shifts.size()},
          {"marks", marks},
          {"force_noise", force_noise},
          {"length_noise", length_noise}};
}

}  // namespace pliant
