#include "pliant/experiment/u3m_import.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <yaml-cpp/yaml.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/u3m_info.h"
#include "pliant/experiment/u3m_notes.h"
#include "pliant/experiment/u3m_physics.h"
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

std::string csv_text(const U3mTest& test) {
  const std::string header[] = {"force_N", is_stretch(test) ? "length_mm" : "distance_mm", "cycle"};
  CsvWriter csv(header);
  for (std::size_t s = 0; s < test.segments.size(); ++s) {
    const U3mSegment& segment = test.segments[s];
    const int cycle = static_cast<int>(s / 2) + 1;  // there and back
    for (std::size_t i = 0; i < segment.distance.size(); ++i) {
      csv.cell(segment.force[i]).cell(kMillimetresPerMetre * segment.distance[i]).cell(cycle);
      csv.end_row();
    }
  }
  return csv.text();
}

/// The stretches at 2 cm to predict: those whose direction can be fitted to a stretch at 8 cm.
/// One pattern where it says just that.
std::vector<std::string> validation_patterns(const std::vector<ImportedTest>& tests) {
  const auto has = [&](const std::string& name) {
    return std::any_of(tests.begin(), tests.end(),
                       [&](const ImportedTest& test) { return test.name == name; });
  };
  std::vector<std::string> names;
  bool all = true;
  for (const ImportedTest& imported : tests) {
    if (imported.test.name != "stretch-2cm") continue;
    if (has(imported.direction + "-stretch-8cm")) {
      names.push_back(imported.name);
    } else {
      all = false;
    }
  }
  if (all && !names.empty()) return {"*-stretch-2cm"};
  return names;
}

void emit_experiment(YAML::Emitter& yaml, const ImportedTest& imported) {
  const auto field = [&](const char* key, const std::string& value) {
    yaml << YAML::Key << key << YAML::Value << value;
  };
  yaml << YAML::BeginMap;
  field("name", imported.name);
  field("type", is_stretch(imported.test) ? "tensile-cycles" : "buckling-bend");
  field("direction", imported.direction);
  if (!is_stretch(imported.test)) {
    field("side", imported.test.kind == U3mTestKind::bend_up ? "up" : "down");
  }
  field("data", imported.name + ".csv");
  field("length", format_quantity(imported.test.length, Dimension::length, kDigits));
  field("width", format_quantity(imported.width, Dimension::length, kDigits));
  yaml << YAML::EndMap;
}

void emit_validation(YAML::Emitter& yaml, const std::vector<std::string>& patterns) {
  if (patterns.empty()) return;
  yaml << YAML::Newline
       << YAML::Comment("Predicted, not fitted: the strip may be that of 8 cm, stretched before.");
  yaml << YAML::Key << "validate" << YAML::Value << YAML::Flow << YAML::BeginSeq;
  for (const std::string& pattern : patterns) yaml << YAML::DoubleQuoted << pattern;
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
  emit_validation(yaml, validation_patterns(tests));
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
  const std::vector<ImportedTest> tests = imported_tests(physics, file.physics.file, options);
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
    study.files.emplace_back(test.name + ".csv", csv_text(test.test));
  }
  study.notes = import_notes(tests, physics, options);
  study.warnings = physics.warnings;
  for (std::string& text : segment_warnings(tests)) study.warnings.push_back(std::move(text));
  return study;
}

}  // namespace pliant
