#include "pliant/exchange/u3m_import.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/exchange/u3m_info.h"
#include "pliant/exchange/u3m_notes.h"
#include "pliant/exchange/u3m_physics.h"
#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

constexpr double kMillimetresPerMetre = 1e3;
constexpr int kDigits = 15;  // as many as a double always keeps

bool is_stretch(const U3mTest& test) { return test.kind == U3mTestKind::stretch; }

double strip_width(const U3mTest& test, const std::string& name, const std::string& file,
                   const ImportOptions& options) {
  if (options.width_m) return *options.width_m;
  if (test.width) return *test.width;
  throw InputError({file}, fmt::format("tells no strip width for {}", name),
                   "\"width\" in cm in the file, or a width given for the import");
}

std::vector<ImportedTest> imported_tests(const U3mPhysics& physics, const std::string& file,
                                         const ImportOptions& options) {
  std::vector<ImportedTest> tests;
  for (const U3mDirection& direction : physics.directions) {
    for (const U3mTest& test : direction.tests) {
      const std::string name = fmt::format("{}-{}", direction.name, test.name);
      tests.push_back({name, direction.name, strip_width(test, name, file, options), test});
    }
  }
  return tests;
}

/// Without mass per area a bend cannot be used: the strip's own weight bends it along.
void leave_out_bends(const std::string& file, std::vector<ImportedTest>& tests,
                     std::vector<std::string>& warnings) {
  for (const ImportedTest& test : tests) {
    if (is_stretch(test.test)) continue;
    warnings.push_back(test.name +
                       " is left out: the file tells no mass per area, and the weight of the strip "
                       "bends it along");
  }
  std::erase_if(tests, [](const ImportedTest& test) { return !is_stretch(test.test); });
  if (!tests.empty()) return;
  throw InputError({file}, "holds bends alone and tells no mass per area", "M, in g/m^2");
}

std::string csv_text(const U3mTest& test, bool without_pauses) {
  const bool timed = without_pauses && is_stretch(test) && test.frequency;
  std::vector<std::string> header{"force_N", is_stretch(test) ? "length_mm" : "distance_mm",
                                  "cycle"};
  if (timed) header.emplace_back("time_s");
  CsvWriter csv(header);
  int row = 0;
  for (std::size_t s = 0; s < test.segments.size(); ++s) {
    const U3mSegment& segment = test.segments[s];
    const int cycle = static_cast<int>(s / 2) + 1;  // there and back
    for (std::size_t i = 0; i < segment.distance.size(); ++i) {
      csv.cell(segment.force[i]).cell(kMillimetresPerMetre * segment.distance[i]).cell(cycle);
      if (timed) csv.cell(row++ / *test.frequency);
      csv.end_row();
    }
  }
  return csv.text();
}

/// The tests called `name` whose direction can be fitted to another, of which `fitted` are the
/// names. One pattern where it says just that.
std::vector<std::string> predicted_tests(const std::vector<ImportedTest>& tests,
                                         const std::string& name,
                                         const std::vector<std::string>& fitted) {
  const auto has_fitted = [&](const std::string& direction) {
    return std::any_of(tests.begin(), tests.end(), [&](const ImportedTest& test) {
      return test.direction == direction &&
             std::find(fitted.begin(), fitted.end(), test.test.name) != fitted.end();
    });
  };
  std::vector<std::string> names;
  bool all = true;
  for (const ImportedTest& imported : tests) {
    if (imported.test.name != name) continue;
    if (has_fitted(imported.direction)) {
      names.push_back(imported.name);
    } else {
      all = false;
    }
  }
  if (all && !names.empty()) return {"*-" + name};
  return names;
}

void emit_experiment(YAML::Emitter& yaml, const ImportedTest& imported) {
  const auto field = [&](const char* key, const std::string& value) {
    yaml << YAML::Key << key << YAML::Value << value;
  };
  yaml << YAML::BeginMap;
  field("name", imported.name);
  field("type", std::string(test_type_of(imported.test).name));
  field("direction", imported.direction);
  if (!is_stretch(imported.test)) {
    field("side", imported.test.kind == U3mTestKind::bend_up ? "up" : "down");
  }
  field("data", imported.name + ".csv");
  field("length", format_quantity(imported.test.length, Dimension::length, kDigits));
  field("width", format_quantity(imported.width, Dimension::length, kDigits));
  yaml << YAML::EndMap;
}

void emit_validation(YAML::Emitter& yaml, const std::vector<ImportedTest>& tests) {
  const auto stretches = predicted_tests(tests, "stretch-2cm", {"stretch-8cm"});
  const auto bends = predicted_tests(tests, "bend-down-8cm", {"bend-down-2cm", "bend-up-2cm"});
  if (stretches.empty() && bends.empty()) return;
  yaml << YAML::Newline << YAML::Comment("Predicted, not fitted.");
  if (!stretches.empty()) {
    yaml << YAML::Newline
         << YAML::Comment("Stretch: the strip may be that of 8 cm, stretched before.");
  }
  if (!bends.empty()) {
    yaml << YAML::Newline << YAML::Comment("Bend: weight hides the stiffness of the longer strip.");
  }
  yaml << YAML::Key << "validate" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const auto* patterns : {&stretches, &bends}) {
    for (const std::string& pattern : *patterns) yaml << YAML::DoubleQuoted << pattern;
  }
  yaml << YAML::EndSeq;
}

std::string study_text(const std::string& name, const U3mPhysics& physics,
                       const std::vector<std::pair<std::string, std::string>>& info,
                       const std::vector<ImportedTest>& tests) {
  YAML::Emitter yaml;
  yaml << YAML::BeginMap;
  yaml << YAML::Key << "pliant" << YAML::Value << "study/1";
  yaml << YAML::Key << "name" << YAML::Value << YAML::DoubleQuoted << name;
  if (physics.density > 0) {
    yaml << YAML::Key << "density" << YAML::Value
         << format_quantity(physics.density, Dimension::area_density, kDigits);
  }
  yaml << YAML::Key << "info" << YAML::Value << YAML::BeginMap;
  for (const auto& [key, text] : info) {
    yaml << YAML::Key << key << YAML::Value << YAML::DoubleQuoted << text;
  }
  yaml << YAML::EndMap;
  yaml << YAML::Key << "experiments" << YAML::Value << YAML::BeginSeq;
  for (const ImportedTest& test : tests) emit_experiment(yaml, test);
  yaml << YAML::EndSeq;
  emit_validation(yaml, tests);
  yaml << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

/// The file as the user knows it.
std::filesystem::path named_file(const U3mFile& file) {
  return file.material ? file.material->file : file.physics.file;
}

}  // namespace

ImportedStudy import_u3m(const std::filesystem::path& file, const ImportOptions& options) {
  return import_u3m(read_u3m_file(file), options);
}

ImportedStudy import_u3m(const U3mFile& file, const ImportOptions& options) {
  const U3mPhysics physics = read_u3m_physics(file);
  std::vector<ImportedTest> tests = imported_tests(physics, file.physics.file, options);
  std::vector<std::string> warnings = physics.warnings;
  if (physics.density == 0) leave_out_bends(file.physics.file, tests, warnings);
  U3mInfo about = read_u3m_info(file);
  if (about.name.empty()) about.name = named_file(file).stem().string();

  std::vector<std::pair<std::string, std::string>> info{
      {"source", named_file(file).filename().string() + " (U3M physics record)"}};
  for (auto& entry : about.entries) info.push_back(std::move(entry));
  for (auto& entry : conduct_entries(tests, physics)) info.push_back(std::move(entry));
  for (auto& entry : about.vendor_parameters) info.push_back(std::move(entry));

  ImportedStudy study;
  study.study_yaml = study_text(about.name, physics, info, tests);
  for (const ImportedTest& test : tests) {
    study.files.emplace_back(test.name + ".csv", csv_text(test.test, options.without_pauses));
  }
  study.notes = import_notes(tests, physics, options);
  study.warnings = std::move(warnings);
  for (std::string& text : segment_warnings(tests)) study.warnings.push_back(std::move(text));
  return study;
}

}  // namespace pliant
