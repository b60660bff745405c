#include <algorithm>
#include <cctype>
#include <iterator>

#include <fmt/format.h>

#include "pliant/base/errors.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/dic_import.h"
#include "pliant/exchange/u3m_import.h"
#include "pliant/imaging/refused_photo.h"
#include "pliant/io/result_directory.h"
#include "pliant/measurement/session.h"
#include "pliant/report/capture_report.h"

#include "apps/pliant/command.h"
#include "apps/pliant/import_photos.h"
#include "apps/pliant/import_progress.h"

namespace pliant {
namespace {

struct ImportArguments {
  std::vector<std::string> files;
  std::string output;
  bool without_pauses = false;
  bool dic = false;  ///< a dic/1 file
  bool resume = false;
  PhotoArguments photo;  ///< its width is a U3M file's too
};

ImportOptions import_options(const ImportArguments& arguments) {
  const std::string& width = arguments.photo.width;
  ImportOptions options;
  options.without_pauses = arguments.without_pauses;
  if (width.empty()) return options;
  try {
    options.width_m = parse_quantity(width, Dimension::length);
  } catch (const QuantityError& error) {
    throw InputError({"--width", 0, ""}, error.problem(), error.expected());
  }
  if (*options.width_m <= 0) throw InputError({"--width", 0, ""}, "is not positive", "e.g. 4 cm");
  return options;
}

// Photographs are known by their names' endings; anything else is an instrument's file.
bool is_photo(const std::string& file) {
  std::string ending = std::filesystem::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto endings = {".jpg", ".jpeg", ".png", ".tif", ".tiff", ".bmp"};
  return std::find(endings.begin(), endings.end(), ending) != endings.end();
}

void add_photo_options(CLI::App& command, PhotoArguments& photo) {
  const auto add = [&](const char* name, std::string& text, const char* description) {
    return command.add_option(name, text, description)->group("Photographs");
  };
  add("--scale", photo.scale, "Length of one pixel at the strip or specimen, e.g. \"0.11 mm\"");
  add("--density", photo.density, "Mass per area of the fabric, e.g. \"180 g/m^2\"");
  add("--crop", photo.crop, "Look only in the region X,Y,WIDTHxHEIGHT, in pixels");
  add("--name", photo.name, "Name of the fabric (default: the photograph's)");
}

void add_strip_options(CLI::App& command, PhotoArguments& photo) {
  constexpr const char* kGroup = "Photographs of hanging strips";
  const auto add = [&](const char* name, std::string& text, const char* description) {
    return command.add_option(name, text, description)->group(kGroup);
  };
  add("--areal-load", photo.areal_load, "Weight per area in its place, e.g. \"13.6 N/m^2\"");
  add("--direction", photo.direction, "Yarns that are bent, along the strip")
      ->check(CLI::IsMember({"warp", "weft", "bias"}));
  add("--clamp-side", photo.clamp_side, "Where the clamp is")
      ->check(CLI::IsMember({"left", "right"}))
      ->capture_default_str();
  add("--clamp", photo.clamp, "Pixel X,Y at which the strip leaves it (default: at the border)");
  add("--tone", photo.tone, "Strip against its background")
      ->check(CLI::IsMember({"auto", "brighter", "darker"}))
      ->capture_default_str();
  command.add_option("--points", photo.points, "Points of a profile")
      ->check(CLI::Range(5, 1000))
      ->capture_default_str()
      ->group(kGroup);
}

void add_drape_options(CLI::App& command, PhotoArguments& photo) {
  constexpr const char* kGroup = "Photographs of draped specimens";
  command.add_flag("--drape", photo.drape, "They show round specimens on a disc, from above")
      ->group(kGroup);
  const auto add = [&](const char* name, std::string& text, const char* description) {
    command.add_option(name, text, description)->group(kGroup);
  };
  add("--specimen", photo.specimen, "Diameter of the specimen (default: 300 mm)");
  add("--disc", photo.disc, "Diameter of the disc (default: 180 mm)");
  add("--middle", photo.middle,
      "Pixel X,Y of the disc's middle (default: of the largest circle in the silhouette)");
}

const std::string& only_file(const ImportArguments& arguments, const char* expected) {
  if (arguments.files.size() == 1) return arguments.files.front();
  throw InputError({arguments.files[1]}, "is one file too many", expected);
}

// Leaves a picture of what was seen where the study would stand.
[[noreturn]] void refuse(const RefusedPhoto& photo, ResultDirectory& results, Progress& progress) {
  const std::string name = std::filesystem::path(photo.where().file).stem().string() + "-seen.png";
  results.set_aside(name, photo.as_seen());
  progress.message(Level::info,
                   fmt::format("{} shows what was seen: blue what stands out, orange what could be "
                               "what is looked for",
                               (results.path() / name).string()));
  throw photo;
}

/// @param results  take the files of the session
ImportedStudy import_points(const std::string& file, ResultDirectory& results,
                            const RunContext& context) {
  DicImport imported = import_dic(file, picture_reader(), context);
  make_session_files(imported, [&](const std::string& name, const std::string& content) {
    results.write(name, content);
  });
  ImportedStudy& study = imported.study;
  const CaptureRecord record{std::filesystem::path(file).stem().string(),
                             imported.made,
                             imported.doubts,
                             study.notes,
                             study.warnings,
                             shown_views(imported.made, picture_reader())};
  study.files.emplace_back(kCaptureReport, make_capture_report(record));
  return std::move(study);
}

ImportedStudy import_files(const ImportArguments& arguments, ResultDirectory& results,
                           const CommandContext& context) {
  if (arguments.dic) {
    const std::string& file = only_file(arguments, "one dic/1 file");
    return remembering(results, arguments.resume, context,
                       [&](const RunContext& run) { return import_points(file, results, run); });
  }
  if (arguments.resume) {
    throw InputError({"--resume", 0, ""}, "is of pictures that are followed, with --dic",
                     "the same command without it");
  }
  const auto photos = std::count_if(arguments.files.begin(), arguments.files.end(), is_photo);
  if (photos == std::ssize(arguments.files))
    return import_photo_files(arguments.files, arguments.photo);
  return import_u3m(only_file(arguments, "one instrument's file, or photographs alone"),
                    import_options(arguments));
}

ImportedStudy imported(const ImportArguments& arguments, ResultDirectory& results,
                       const CommandContext& context) {
  try {
    return import_files(arguments, results, context);
  } catch (const RefusedPhoto& photo) {
    refuse(photo, results, context.run.progress);
  }
}

// Reads the session back as a fit would, before it is put into place.
std::vector<std::string> judged_session(const ImportArguments& arguments,
                                        const ResultDirectory& results) {
  try {
    Session session = read_session(results.staging() / kDicSessionFolder);
    std::ranges::move(session.questions, std::back_inserter(session.warnings));
    return session.warnings;
  } catch (const InputError& error) {
    const std::string what = std::filesystem::path(error.where().file).filename().string();
    throw InputError(
        {arguments.files.front()},
        fmt::format("gives a session that cannot be used: {}: {}", what, error.problem()),
        error.expected());
  }
}

}  // namespace

void add_import(CommandRegistry& registry) {
  CLI::App& command = registry.add("import",
                                   "Turn an instrument's file (U3M), points of image correlation "
                                   "(DIC) or photographs of hanging "
                                   "strips or drapes into a study");
  auto arguments = std::make_shared<ImportArguments>();
  command
      .add_option("FILE", arguments->files,
                  "U3M 1.1 physics or .u3m; photographs (JPEG, PNG, TIFF, BMP); or, with --dic, "
                  "a dic/1 file")
      ->required();
  command.add_option("-o,--output", arguments->output, "Directory for the study (DIR)")->required();
  command.add_option("--width", arguments->photo.width,
                     "Strip width, if not the file's, e.g. 5 cm");
  command.add_flag("--dic", arguments->dic,
                   "FILE is a dic/1 file: tables of points from image correlation, and forces");
  command.add_flag("--resume", arguments->resume,
                   "--dic: go on from the progress.bin that a stopped or refused run left in DIR");
  command.add_flag(
      "--no-pauses", arguments->without_pauses,
      "U3M: half cycles follow each other at once; rows get times by its sampling rate");
  add_photo_options(command, arguments->photo);
  add_strip_options(command, arguments->photo);
  add_drape_options(command, arguments->photo);
  registry.on(command, [arguments](CommandContext& context) {
    ResultDirectory results(arguments->output, "import");
    const ImportedStudy study = imported(*arguments, results, context);
    results.write("study.yaml", study.study_yaml);
    for (const auto& [name, content] : study.files) results.write(name, content);
    const std::vector<std::string> doubts =
        arguments->dic ? judged_session(*arguments, results) : std::vector<std::string>{};
    results.commit();
    for (const std::string& note : study.notes) context.say(note);
    for (const auto* warnings : {&study.warnings, &doubts}) {
      for (const std::string& warning : *warnings) {
        context.run.progress.message(Level::warning, warning);
      }
    }
    if (arguments->dic) {
      context.say(fmt::format(
          "report: {}", (std::filesystem::path(arguments->output) / kCaptureReport).string()));
    }
    context.say(fmt::format("study: {}",
                            (std::filesystem::path(arguments->output) / "study.yaml").string()));
    context.print_written_json("import", std::filesystem::path(arguments->output) / "study.yaml");
  });
}

}  // namespace pliant
