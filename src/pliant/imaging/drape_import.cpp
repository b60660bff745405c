#include "pliant/imaging/drape_import.h"

#include <numbers>
#include <set>

#include <fmt/format.h>

#include "pliant/base/assert.h"
#include "pliant/base/quantity.h"
#include "pliant/experiment/drape/drape_tables.h"
#include "pliant/experiment/drape/drape_type.h"
#include "pliant/experiment/drape/silhouette_picture.h"
#include "pliant/imaging/photo_study.h"

namespace pliant {
namespace {

// Of the experiment and of its table.
std::string name() { return std::string(drape_type().name); }

double area_of(double diameter) { return std::numbers::pi / 4 * diameter * diameter; }

DrapedSheet draped_in(const std::filesystem::path& photo, const DrapeTrace& trace,
                      const DrapeStudyOptions& options) {
  const double disc = options.photo.disc;
  DrapedSheet sheet;
  sheet.silhouette = trace.silhouette;
  sheet.figures = fold_figures(trace.silhouette.radii, (options.specimen - disc) / 2);
  sheet.figures.coefficient =
      drape_coefficient(trace.silhouette.area, area_of(disc), area_of(options.specimen));
  if (sheet.figures.coefficient > 1) {
    throw InputError({photo.string()},
                     fmt::format("the silhouette covers {:.0f} cm^2, the flat specimen {:.0f} cm^2",
                                 1e4 * trace.silhouette.area, 1e4 * area_of(options.specimen)),
                     "the scale at the specimen's height, and the specimen's diameter");
  }
  return sheet;
}

std::string study_text(const std::vector<std::filesystem::path>& photos,
                       const DrapeStudyOptions& options) {
  constexpr int kDigits = 15;  // as many as a double always keeps
  YAML::Emitter yaml;
  begin_study(photos, {options.name, options.density, options.photo.scale}, yaml);
  yaml << YAML::BeginSeq << YAML::BeginMap;
  const auto field = [&](const char* key, const std::string& value) {
    yaml << YAML::Key << key << YAML::Value << value;
  };
  field("name", name());
  field("type", name());
  field("data", name() + ".csv");
  field("specimen", format_quantity(options.specimen, Dimension::length, kDigits));
  field("disc", format_quantity(options.photo.disc, Dimension::length, kDigits));
  yaml << YAML::EndMap << YAML::EndSeq << YAML::EndMap;
  return std::string(yaml.c_str()) + "\n";
}

}  // namespace

ImportedStudy import_drape_photos(const std::vector<std::filesystem::path>& photos,
                                  const DrapeStudyOptions& options) {
  PLIANT_ASSERT(!photos.empty() && options.specimen >= least_specimen(options.photo.disc),
                "draped specimens");
  ImportedStudy study;
  std::vector<DrapedSheet> draped;
  std::set<std::string> taken;
  for (const std::filesystem::path& photo : photos) {
    const DrapeTrace trace = trace_drape(photo, options.photo);
    draped.push_back(draped_in(photo, trace, options));
    const DrapeFigures& figures = draped.back().figures;
    study.files.emplace_back(drawing_name(photo, "outline", taken),
                             photo_with_outline(photo, trace.outline, trace.middle));
    study.notes.push_back(
        fmt::format("{}: drape coefficient {:.1f} %, {} nodes; look at {} whether the line follows "
                    "the specimen",
                    photo.filename().string(), 1e2 * figures.coefficient, figures.nodes,
                    study.files.back().first));
  }
  const DrapeSetup setup{.specimen = options.specimen, .disc = options.photo.disc};
  std::vector<NamedSilhouette> silhouettes;
  for (std::size_t i = 0; i < draped.size(); ++i) {
    silhouettes.push_back({photos[i].filename().string(), draped[i]});
  }
  study.files.emplace_back(name() + ".csv", drape_table(draped));
  study.files.emplace_back("silhouettes.csv", outline_table(draped));
  study.files.emplace_back("silhouettes.svg", silhouette_picture(options.name, silhouettes, setup));
  study.warnings = size_advice(draped, setup);
  study.study_yaml = study_text(photos, options);
  return study;
}

}  // namespace pliant
