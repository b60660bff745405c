#include "pliant/imaging/photo_import.h"

#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/cantilever/cantilever_type.h"
#include "pliant/imaging/photo_study.h"
#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

constexpr int kDigits = 15;  // as many as a double always keeps
constexpr double kMillimetres = 1e3;

std::string experiment_name(const PhotoStudyOptions& options) {
  return options.direction + "-overhangs";
}

std::string table(const std::vector<StripTrace>& traces) {
  const std::vector<std::string> header{"overhang_mm", "repeat", "point", "x_mm", "y_mm"};
  CsvWriter csv(header);
  for (size_t photo = 0; photo < traces.size(); ++photo) {
    const StripTrace& trace = traces[photo];
    for (size_t i = 0; i < trace.profile.size(); ++i) {
      csv.cell(kMillimetres * trace.length).cell(static_cast<long>(photo + 1));
      csv.cell(static_cast<long>(i));
      csv.cell(kMillimetres * trace.profile[i].x()).cell(kMillimetres * trace.profile[i].y());
      csv.end_row();
    }
  }
  return csv.text();
}

std::string study_text(const std::vector<std::filesystem::path>& photos,
                       const PhotoStudyOptions& options) {
  YAML::Emitter yaml;
  begin_study(photos, {options.name, options.density, options.photo.scale}, yaml);
  yaml << YAML::BeginSeq << YAML::BeginMap;
  const auto field = [&](const char* key, const std::string& value) {
    yaml << YAML::Key << key << YAML::Value << value;
  };
  field("name", experiment_name(options));
  field("type", std::string(cantilever_type().name));
  field("direction", options.direction);
  field("data", experiment_name(options) + ".csv");
  if (options.width > 0) field("width", format_quantity(options.width, Dimension::length, kDigits));
  yaml << YAML::EndMap << YAML::EndSeq << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

std::string note_on(const StripTrace& trace, const std::string& name) {
  return fmt::format(
      "{}: a strip {} than its background, {:.4g} mm long, {:.2g} mm thick; its middle scatters by "
      "{:.2g} mm about {} points",
      name, trace.tone == StripTone::brighter ? "brighter" : "darker", kMillimetres * trace.length,
      kMillimetres * trace.thickness, kMillimetres * trace.scatter, trace.profile.size());
}

void warn_of_gaps(const StripTrace& trace, const std::string& name, ImportedStudy& study) {
  if (trace.gaps == 0) return;
  study.warnings.push_back(fmt::format(
      "{}: the strip is interrupted {} and was joined there: nothing tells its shape in the gap",
      name, trace.gaps == 1 ? "once" : fmt::format("{} times", trace.gaps)));
}

void warn_of_clamp(const StripTrace& trace, const std::string& name, ImportedStudy& study) {
  constexpr double kLevel = 5;  // degrees
  const double angle = trace.clamp_angle * 180 / std::numbers::pi;
  if (std::abs(angle) <= kLevel) return;
  study.warnings.push_back(
      fmt::format("{}: the strip leaves its clamp {:.0f} degrees {} level; a fit takes it as level",
                  name, std::abs(angle), angle > 0 ? "below" : "above"));
}

}  // namespace

ImportedStudy import_photos(const std::vector<std::filesystem::path>& photos,
                            const PhotoStudyOptions& options) {
  PLIANT_ASSERT(!photos.empty() && options.density > 0, "weighed strips in photographs");
  ImportedStudy study;
  std::vector<StripTrace> traces;
  std::set<std::string> taken;
  for (const std::filesystem::path& photo : photos) {
    const std::string name = photo.filename().string();
    traces.push_back(trace_strip(photo, options.photo));
    study.files.emplace_back(drawing_name(photo, "profile", taken),
                             photo_with_line(photo, traces.back().pixels));
    study.notes.push_back(note_on(traces.back(), name));
    study.notes.push_back(
        fmt::format("look at {} whether the line follows the strip", study.files.back().first));
    warn_of_clamp(traces.back(), name, study);
    warn_of_gaps(traces.back(), name, study);
  }
  study.files.emplace_back(experiment_name(options) + ".csv", table(traces));
  study.study_yaml = study_text(photos, options);
  return study;
}

}  // namespace pliant
