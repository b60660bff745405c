#include "pliant/measurement/session/session_document.h"

#include <set>
#include <string_view>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "pliant/base/assert.h"
#include "pliant/base/number_text.h"
#include "pliant/io/fields.h"
#include "pliant/io/named_file.h"
#include "pliant/io/result_name.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

/// Tests of [T] 3.2.2 that pull at clips, away from any table.
const std::set<std::string_view> kTestsWithoutTable{"stretch-weft", "stretch-warp", "shear",
                                                    "corner-pull", "complex-shear"};

std::filesystem::path read_rest(const Value& value) {
  const std::string name = value.text();
  if (!name.ends_with(".ply")) value.fail(quoted_value(name) + " is no PLY file", "rest.ply");
  return read_named_file(value, "a PLY file");
}

ClipEntry read_clip(const Value& value, std::set<std::string>& taken) {
  Fields fields = value.fields();
  ClipEntry clip;
  clip.name = read_result_name(fields.require("name"), "a clip", taken);
  clip.mass = fields.require("mass").quantity_from_zero(Dimension::mass);
  clip.clamped = read_index_list(fields.require("clamped"));
  fields.finish();
  return clip;
}

SheetNoise read_noise(const Value& value) {
  Fields fields = value.fields();
  SheetNoise noise;
  if (auto v = fields.optional("position")) {
    noise.position = v->positive_quantity(Dimension::length);
  }
  if (auto v = fields.optional("force")) noise.force = v->positive_quantity(Dimension::force);
  fields.finish();
  return noise;
}

/// The table belongs to bend tests, with its edge across what is bent.
void check_table(const std::string& test, const std::optional<Value>& value,
                 const std::optional<TableEntry>& table, const Location& document) {
  if (table && kTestsWithoutTable.contains(test)) {
    value->fail(fmt::format("the test {} has no table", test), "a bend test");
  }
  if (test != "bend-weft" && test != "bend-warp") return;
  const RestAxis axis = test == "bend-weft" ? RestAxis::u : RestAxis::v;
  if (table && table->axis == axis) return;
  throw InputError(table ? table->where : Location{document.file, document.line, "table"},
                   table ? "has its edge along what is bent" : "is missing",
                   fmt::format("the edge of the table, `{}` for {}",
                               axis == RestAxis::u ? "edge_x" : "edge_y", test));
}

}  // namespace

SessionSample read_session_sample(const Value& value, SessionKind kind) {
  Fields fields = value.fields();
  SessionSample sample;
  if (auto v = fields.optional("id")) sample.id = v->text();
  sample.width = fields.require("width").positive_quantity(Dimension::length);
  sample.height = fields.require("height").positive_quantity(Dimension::length);
  if (auto v = fields.optional("mass")) sample.mass = v->positive_quantity(Dimension::mass);
  if (auto v = fields.optional("density")) {
    sample.density = v->positive_quantity(Dimension::area_density);
  }
  if (!sample.mass && !sample.density && kind == SessionKind::sheet) {
    value.fail("weighs nothing", "`mass` or `density`");
  }
  fields.finish();
  return sample;
}

SessionDocument session_document_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "session", 1);
  SessionDocument session;
  if (auto v = fields.optional("kind")) {
    const bool strip = v->choice({"sheet", "strip"}) == "strip";
    session.kind = strip ? SessionKind::strip : SessionKind::sheet;
  }
  const Value test = fields.require("test");
  session.test = test.text();
  if (session.test.empty()) test.fail("is empty", "stretch-weft, shear, ..., or a name of its own");
  session.info = fields.texts("info");
  const Value sample = fields.require("sample");
  session.sample_where = sample.location();
  session.sample = read_session_sample(sample, session.kind);
  if (auto v = fields.optional("gravity")) session.gravity = read_vector(*v);
  if (auto v = fields.optional("balance_bound")) {
    session.balance_bound = v->positive_quantity(Dimension::force);
  }
  if (auto v = fields.optional("noise")) session.noise = read_noise(*v);
  session.rest = read_rest(fields.require("rest"));
  session.frames = FrameNames::read(fields.require("frames"));
  std::set<std::string> names;
  if (auto list = fields.optional("clips")) {
    for (const Value& clip : list->items()) session.clips.push_back(read_clip(clip, names));
  }
  const auto table = fields.optional("table");
  if (table) session.table = read_table(*table);
  check_table(session.test, table, session.table, fields.location());
  fields.finish();
  return session;
}

TableEntry read_table(const Value& value) {
  Fields fields = value.fields();
  const auto u = fields.optional("edge_x"), v = fields.optional("edge_y");
  if (u.has_value() == v.has_value()) {
    value.fail("has no single edge", "either `edge_x` (bends weft) or `edge_y` (bends warp)");
  }
  TableEntry table;
  table.where = value.location();
  table.axis = u ? RestAxis::u : RestAxis::v;
  table.edge = (u ? u : v)->quantity(Dimension::length);
  fields.finish();
  return table;
}

SessionDocument read_session_document(const std::filesystem::path& path) {
  return session_document_of(read_yaml(path));
}

namespace {

YAML::Node flow_list() {
  YAML::Node list(YAML::NodeType::Sequence);
  list.SetStyle(YAML::EmitterStyle::Flow);
  return list;
}

YAML::Node sample_node(const SessionSample& sample) {
  YAML::Node node;
  if (!sample.id.empty()) node["id"] = sample.id;
  node["width"] = exact_quantity(sample.width, Dimension::length);
  node["height"] = exact_quantity(sample.height, Dimension::length);
  if (sample.mass) node["mass"] = exact_quantity(*sample.mass, Dimension::mass);
  if (sample.density) node["density"] = exact_quantity(*sample.density, Dimension::area_density);
  return node;
}

YAML::Node noise_node(const SheetNoise& noise) {
  YAML::Node node;
  if (noise.position) node["position"] = exact_quantity(*noise.position, Dimension::length);
  if (noise.force) node["force"] = exact_quantity(*noise.force, Dimension::force);
  return node;
}

YAML::Node clip_node(const SessionClip& clip) {
  YAML::Node node;
  node["name"] = clip.name;
  node["mass"] = exact_quantity(clip.mass, Dimension::mass);
  node["clamped"] = flow_list();
  for (const int vertex : clip.clamped) node["clamped"].push_back(vertex);
  return node;
}

}  // namespace

std::string session_document_text(const Session& session) {
  PLIANT_ASSERT(!session.frames.empty(), "a session has frames");
  YAML::Node node;
  node["pliant"] = "session/1";
  node["kind"] = session.kind == SessionKind::strip ? "strip" : "sheet";
  node["test"] = session.test;
  for (const auto& [key, value] : session.info) node["info"][key] = value;
  node["sample"] = sample_node(session.sample);
  node["gravity"] = flow_list();
  for (const double component : session.gravity) {
    node["gravity"].push_back(format_number(component));
  }
  if (session.balance_bound != kCordFriction) {
    node["balance_bound"] = exact_quantity(session.balance_bound, Dimension::force);
  }
  if (session.noise.position || session.noise.force) node["noise"] = noise_node(session.noise);
  node["rest"] = "rest.ply";
  node["frames"] = "frames/%04d.ply";
  for (const SessionClip& clip : session.clips) node["clips"].push_back(clip_node(clip));
  if (session.table) {
    const char* key = *session.table == RestAxis::u ? "edge_x" : "edge_y";
    node["table"][key] =
        exact_quantity(session.frames.front().table_edge.value(), Dimension::length);
  }
  YAML::Emitter emitter;
  emitter << node;
  return std::string(emitter.c_str()) + "\n";
}

}  // namespace pliant
