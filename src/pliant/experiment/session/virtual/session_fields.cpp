#include "pliant/experiment/session/virtual/session_fields.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "pliant/base/number_text.h"
#include "pliant/experiment/virtual_sheet.h"
#include "pliant/io/vector_fields.h"
#include "pliant/measurement/session/clip_poses.h"
#include "pliant/mechanics/cloth_potentials.h"

namespace pliant {
namespace {

constexpr int kMostFrames = 1000;
// With so many nodes along a side, and clips of a part of the sides, each clip holds some.
constexpr int kFewestNodes = 6, kMostNodes = 301;
constexpr double kLargestGrip = 0.2;      // of the shorter side
constexpr double kLargestOverhang = 0.9;  // of the side that is pushed
constexpr double kLargestStrain = 1, kLargestAngle = 1;
constexpr double kLargestSlide = 0.5;  // of the shorter side
constexpr double kClampedNoise = 6;    // deviations that a clamped vertex stays within

bool has_clips(const VirtualSession& session) {
  return session_test_kind(session.test).clip_mass > 0;
}

double shorter_side(const VirtualSession& session) {
  return std::min(session.width, session.height);
}

void require_at_most(const Value& value, double given, double most, const std::string& expected) {
  if (given <= most) return;
  value.fail("is too much for the sheet", expected);
}

std::string up_to(double most, Dimension dimension) {
  return "at most " + format_quantity(most, dimension);
}

double largest_amplitude(const VirtualSession& session) {
  switch (session_test_kind(session.test).dimension) {
    case Dimension::angle:
      return kLargestAngle;
    case Dimension::fraction:
      return kLargestStrain;
    default:
      if (has_clips(session)) return kLargestSlide * shorter_side(session);
      return kLargestOverhang * (session.test == "bend-weft" ? session.width : session.height);
  }
}

void read_amplitude(Fields& fields, VirtualSession& session) {
  const SessionTestKind& kind = session_test_kind(session.test);
  const double most = largest_amplitude(session);
  session.amplitude = std::min(session.amplitude, most);
  const auto value = fields.optional(kind.amplitude);
  if (!value) return;
  session.amplitude = value->positive_quantity(kind.dimension);
  require_at_most(*value, session.amplitude, most, up_to(most, kind.dimension));
}

void read_clips(Fields& fields, VirtualSession& session) {
  const double deepest = kLargestGrip * shorter_side(session);
  session.grip = std::min(session.grip, deepest);
  if (auto v = fields.optional("grip")) {
    session.grip = v->positive_quantity(Dimension::length);
    require_at_most(*v, session.grip, deepest, up_to(deepest, Dimension::length));
  }
  if (auto v = fields.optional("clip_mass")) {
    session.clip_mass = v->quantity_from_zero(Dimension::mass);
  }
  if (auto v = fields.optional("initial_strain")) {
    const bool strains = session_test_kind(session.test).dimension == Dimension::fraction;
    const double largest = strains ? session.amplitude : kLargestStrain;
    session.initial_strain = v->quantity_from_zero(Dimension::fraction);
    require_at_most(*v, session.initial_strain, largest, up_to(largest, Dimension::fraction));
  }
  if (auto v = fields.optional("cord_friction")) {
    session.noise.cord_friction = v->quantity_from_zero(Dimension::force);
  }
}

void read_frames(Fields& fields, VirtualSession& session) {
  const int legs = session_test_kind(session.test).legs;
  if (has_clips(session)) {
    if (auto v = fields.optional("cycles")) session.cycles = v->integer(1, 100);
  }
  const auto frames = fields.optional("frames");
  const int fewest = std::max(2, legs * session.cycles + 1);
  if (frames) session.frames = frames->integer(2, kMostFrames);
  if (session.frames >= fewest) return;
  const std::string expected = fmt::format("at least {}: each turning point in a frame", fewest);
  if (frames) frames->fail("are fewer than the turning points", expected);
  throw InputError(
      {fields.location().file, fields.location().line, fields.location().field + ".frames"},
      fmt::format("are {} by default, fewer than the turning points", session.frames), expected);
}

void read_mesh(Fields& fields, VirtualSession& session) {
  const auto value = fields.optional("mesh");
  const double coarsest = shorter_side(session) / (kFewestNodes - 1);
  session.edge = std::min(session.edge, coarsest);
  if (!value) return;
  Fields mesh = value->fields();
  const auto edge = mesh.optional("edge"), nodes = mesh.optional("nodes");
  if (edge.has_value() == nodes.has_value()) {
    value->fail("is not one mesh", "either `edge` of an irregular mesh or `nodes` of a grid");
  }
  if (nodes) session.nodes = read_counts(*nodes, kFewestNodes, kMostNodes);
  if (edge) {
    session.edge = edge->positive_quantity(Dimension::length);
    const double finest = std::max(session.width, session.height) / (kMostNodes - 1);
    if (session.edge > coarsest || session.edge < finest) {
      edge->fail("makes a mesh that is too coarse or too fine",
                 fmt::format("{} to {}", format_quantity(finest, Dimension::length),
                             format_quantity(coarsest, Dimension::length)));
    }
  }
  mesh.finish();
}

void read_noise(Fields& fields, VirtualSession& session) {
  const auto value = fields.optional("noise");
  if (!value) return;
  Fields noise = value->fields();
  if (auto v = noise.optional("position")) {
    session.noise.position = v->quantity_from_zero(Dimension::length);
    const double most = kClampDrift * std::max(session.width, session.height) / kClampedNoise;
    require_at_most(*v, session.noise.position, most,
                    up_to(most, Dimension::length) + ", or clips would lose their cloth");
  }
  if (has_clips(session)) {
    if (auto v = noise.optional("force")) {
      session.noise.force = v->quantity_from_zero(Dimension::force);
    }
  }
  noise.finish();
}

}  // namespace

VirtualSession read_virtual_session(Fields& fields) {
  std::vector<std::string_view> tests;
  for (const SessionTestKind& kind : session_test_kinds()) tests.push_back(kind.test);
  VirtualSession session = usual_session(fields.require("test").choice(tests));
  if (auto v = fields.optional("size")) std::tie(session.width, session.height) = read_extents(*v);
  read_amplitude(fields, session);
  if (has_clips(session)) read_clips(fields, session);
  read_frames(fields, session);
  read_mesh(fields, session);
  read_noise(fields, session);
  return session;
}

void require_sheet_material(const Material& material, const VirtualSession& options,
                            const Location& where) {
  require_whole_sheet(material, where);
  if (needs_grid(material) && (!options.nodes || options.test == "bias-extension")) {
    throw InputError(
        where, "the springs of " + quoted_value(material.name) + " need a grid along weft and warp",
        "`mesh: {nodes: ...}` and a sheet cut along its yarns");
  }
}

}  // namespace pliant
