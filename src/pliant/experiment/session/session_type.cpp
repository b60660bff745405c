#include "pliant/experiment/session/session_type.h"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/experiment/session/virtual/session_fields.h"
#include "pliant/experiment/session/virtual_session.h"
#include "pliant/experiment/virtual_sheet.h"

namespace pliant {
namespace {

constexpr int kDigits = 4;

std::shared_ptr<const TestSpec> read(Fields& fields, const SpecimenDefaults&, ExperimentSpec&) {
  auto spec = std::make_shared<SessionSpec>();
  if (auto v = fields.optional("objective")) {
    spec->objective = sheet_objective(
        v->choice({"clip-forces", "parallel-clip-forces", "axial-clip-forces", "positions"}));
  }
  if (auto v = fields.optional("cord_friction")) {
    spec->cord_friction.unknown = v->text() == "unknown";
    if (!spec->cord_friction.unknown) {
      spec->cord_friction.width = v->quantity_from_zero(Dimension::force);
    }
  }
  return spec;
}

/// A session is a folder of its name, beside the lab's files.
void require_folder_name(const Value& name) {
  const std::string extension = std::filesystem::path(name.text()).extension().string();
  if (extension != ".csv" && extension != ".yaml" && extension != ".json") return;
  name.fail("is the name of a file", "the name of a folder for the session");
}

std::shared_ptr<VirtualTest> read_virtual(Fields& fields) {
  auto test = std::make_shared<VirtualSessionTest>();
  require_folder_name(fields.require("name"));
  test->session = read_virtual_session(fields);
  return test;
}

std::string text_or_none(double value, Dimension dimension) {
  return value > 0 ? format_quantity(value, dimension, kDigits) : std::string("none");
}

}  // namespace

const TestType& session_type() {
  static const TestType type{.name = "session",
                             .facts = {.measures_sheets = true},
                             .read = read,
                             .read_virtual = read_virtual};
  return type;
}

WrittenFields SessionSpec::fields() const {
  WrittenFields fields;
  if (objective) fields.emplace_back("objective", name_of(*objective));
  if (cord_friction.unknown) {
    fields.emplace_back("cord_friction", "unknown");
  } else if (cord_friction.width > 0) {
    fields.emplace_back("cord_friction", exact_quantity(cord_friction.width, Dimension::force));
  }
  return fields;
}

void VirtualSessionTest::require(const Material& material) const {
  require_sheet_material(material, session, where);
}

VirtualData VirtualSessionTest::measure(const VirtualSpecimen& specimen,
                                        const VirtualWork& work) const {
  const Material material = sheet_of(specimen);
  RandomStream random = specimen.random.split(specimen.name);
  const Session measured =
      make_virtual_session(material, session, random, {specimen.name, work.stop, work.done});
  VirtualData data;
  data.warnings = measured.warnings;
  for (auto& [file, content] : session_files(measured)) {
    data.files.emplace_back(specimen.name + "/" + file, std::move(content));
  }
  return data;
}

WrittenFields VirtualSessionTest::study_fields() const {
  const bool has_cords = session_test_kind(session.test).clip_mass > 0;
  if (has_cords && session.noise.cord_friction > 0) return {{"cord_friction", "unknown"}};
  return {};
}

WrittenFields VirtualSessionTest::description() const {
  const SessionTestKind& kind = session_test_kind(session.test);
  return {
      {"sheet", fmt::format("{} x {}", format_quantity(session.width, Dimension::length, kDigits),
                            format_quantity(session.height, Dimension::length, kDigits))},
      {std::string(kind.amplitude),
       fmt::format("{}; {} frames", format_quantity(session.amplitude, kind.dimension, kDigits),
                   session.frames)},
      {"instrument", fmt::format("noise: position {}, force {}; cord friction {}",
                                 text_or_none(session.noise.position, Dimension::length),
                                 text_or_none(session.noise.force, Dimension::force),
                                 text_or_none(session.noise.cord_friction, Dimension::force))}};
}

nlohmann::ordered_json VirtualSessionTest::facts() const {
  return {{"test", session.test},
          {std::string(session_test_kind(session.test).amplitude), session.amplitude},
          {"size", {session.width, session.height}},
          {"frames", session.frames},
          {"position_noise", session.noise.position},
          {"force_noise", session.noise.force},
          {"cord_friction", session.noise.cord_friction}};
}

}  // namespace pliant
