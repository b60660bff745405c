#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/study/study.h"
#include "pliant/study/virtual_lab.h"

#include "apps/pliant/file_info.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 4;

Dimension peak_dimension(const std::string& type) {
  if (type == "hanging-weights") return Dimension::force;
  if (type == "pure-bending") return Dimension::curvature;
  const bool share = type == "tensile-cycles" || type == "buckling-bend";
  return share ? Dimension::fraction : Dimension::angle;
}

std::string peaks_text(const LabExperiment& experiment) {
  std::vector<std::string> texts;
  for (const double peak : experiment.peaks) {
    texts.push_back(format_quantity(peak, peak_dimension(experiment.type), kDigits));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string settings_text(const LabExperiment& experiment) {
  std::vector<std::string> texts;
  for (const double setting : experiment.settings) {
    texts.push_back(format_quantity(setting, Dimension::length, kDigits));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string noise_text(const LabExperiment& experiment) {
  const Dimension force =
      experiment.type == "shear-cycles" ? Dimension::force_per_length : Dimension::force;
  const auto text = [](double value, Dimension dimension) {
    return value > 0 ? format_quantity(value, dimension, kDigits) : std::string("none");
  };
  const Instrument& instrument = experiment.instrument;
  if (measures_profiles(experiment.type)) {
    return fmt::format("noise: position {}; resolution: position {}",
                       text(instrument.length_noise, Dimension::length),
                       text(instrument.length_resolution, Dimension::length));
  }
  if (experiment.type == "bending-length") {
    return fmt::format("noise: overhang {}; resolution: overhang {}",
                       text(instrument.length_noise, Dimension::length),
                       text(instrument.length_resolution, Dimension::length));
  }
  if (experiment.type == "pure-bending") {
    return fmt::format("noise: moment {}; resolution: moment {}",
                       text(instrument.force_noise, force),
                       text(instrument.force_resolution, force));
  }
  return fmt::format("noise: force {}, length {}; resolution: force {}, length {}",
                     text(instrument.force_noise, force),
                     text(instrument.length_noise, Dimension::length),
                     text(instrument.force_resolution, force),
                     text(instrument.length_resolution, Dimension::length));
}

std::string specimens_text(const VirtualLab& lab) {
  if (lab.specimen_variation == 0) return fmt::format("{}", lab.specimens);
  return fmt::format("{}, whose parameters vary by {}", lab.specimens,
                     format_quantity(lab.specimen_variation, Dimension::fraction, kDigits));
}

Json session_json(const LabExperiment& experiment) {
  const VirtualSession& session = experiment.session;
  return {{"name", experiment.name},
          {"type", experiment.type},
          {"test", session.test},
          {std::string(session_test_kind(session.test).amplitude), session.amplitude},
          {"size", {session.width, session.height}},
          {"frames", session.frames},
          {"position_noise", session.noise.position},
          {"force_noise", session.noise.force},
          {"cord_friction", session.noise.cord_friction}};
}

Json experiment_json(const LabExperiment& experiment) {
  if (experiment.type == "session") return session_json(experiment);
  const Instrument& instrument = experiment.instrument;
  return {{"name", experiment.name},
          {"type", experiment.type},
          {"direction", experiment.direction},
          {"peaks", experiment.peaks},
          {"settings", experiment.settings},
          {"repeats", experiment.repeats},
          {"force_noise", instrument.force_noise},
          {"length_noise", instrument.length_noise},
          {"force_resolution", instrument.force_resolution},
          {"length_resolution", instrument.length_resolution}};
}

void add_profile_lines(const LabExperiment& experiment, std::vector<std::string>& lines) {
  const bool rolled = experiment.type == "rolled-strip";
  lines.push_back(labelled(experiment.name, experiment.type + ", " + experiment.direction));
  if (rolled) {
    lines.push_back(labelled(
        "strip", format_quantity(experiment.length, Dimension::length, kDigits) + " long", 1));
  }
  lines.push_back(labelled(
      rolled ? "radii" : "overhangs",
      fmt::format("{}; {} repeat{}, {} points a profile", settings_text(experiment),
                  experiment.repeats, experiment.repeats == 1 ? "" : "s", experiment.points),
      1));
  lines.push_back(labelled("instrument", noise_text(experiment), 1));
}

void add_overhang_lines(const LabExperiment& experiment, std::vector<std::string>& lines) {
  lines.push_back(labelled(experiment.name, experiment.type + ", " + experiment.direction));
  lines.push_back(
      labelled("readings",
               fmt::format("{} of each face, at {}", experiment.repeats,
                           format_quantity(experiment.angle, Dimension::angle, kDigits)),
               1));
  lines.push_back(labelled("instrument", noise_text(experiment), 1));
}

std::string buckling_text(const LabExperiment& experiment) {
  return fmt::format("{}; {} long in truth, force offset {}, drift {}", name_of(experiment.side),
                     format_quantity(experiment.strip_length, Dimension::length, kDigits),
                     format_quantity(experiment.force_offset, Dimension::force, kDigits),
                     format_quantity(experiment.force_drift, Dimension::force, kDigits));
}

std::string session_noise_text(const SessionNoise& noise) {
  const auto text = [](double value, Dimension dimension) {
    return value > 0 ? format_quantity(value, dimension, kDigits) : std::string("none");
  };
  return fmt::format("noise: position {}, force {}; cord friction {}",
                     text(noise.position, Dimension::length), text(noise.force, Dimension::force),
                     text(noise.cord_friction, Dimension::force));
}

void add_session_lines(const LabExperiment& experiment, std::vector<std::string>& lines) {
  const VirtualSession& session = experiment.session;
  const SessionTestKind& kind = session_test_kind(session.test);
  lines.push_back(labelled(experiment.name, experiment.type + ", " + session.test));
  lines.push_back(
      labelled("sheet",
               fmt::format("{} x {}", format_quantity(session.width, Dimension::length, kDigits),
                           format_quantity(session.height, Dimension::length, kDigits)),
               1));
  lines.push_back(labelled(
      std::string(kind.amplitude),
      fmt::format("{}; {} frames", format_quantity(session.amplitude, kind.dimension, kDigits),
                  session.frames),
      1));
  lines.push_back(labelled("instrument", session_noise_text(session.noise), 1));
}

void add_lines(const LabExperiment& experiment, std::vector<std::string>& lines) {
  if (experiment.type == "session") return add_session_lines(experiment, lines);
  if (measures_profiles(experiment.type)) return add_profile_lines(experiment, lines);
  if (experiment.type == "bending-length") return add_overhang_lines(experiment, lines);
  const bool shear = experiment.type == "shear-cycles";
  lines.push_back(labelled(
      experiment.name, shear ? experiment.type : experiment.type + ", " + experiment.direction));
  if (!shear && experiment.type != "pure-bending") {
    lines.push_back(
        labelled("strip",
                 fmt::format("{} long, {} wide",
                             format_quantity(experiment.length, Dimension::length, kDigits),
                             format_quantity(experiment.width, Dimension::length, kDigits)),
                 1));
  }
  if (experiment.type == "buckling-bend")
    lines.push_back(labelled("buckles", buckling_text(experiment), 1));
  lines.push_back(labelled("peaks",
                           fmt::format("{}; {} repeat{}", peaks_text(experiment),
                                       experiment.repeats, experiment.repeats == 1 ? "" : "s"),
                           1));
  lines.push_back(labelled("instrument", noise_text(experiment), 1));
}

}  // namespace

FileInfo lab_info(const std::filesystem::path& path) {
  const VirtualLab lab = read_lab(path);
  FileInfo info = begin_info(path, "lab/1");
  info.json["name"] = lab.name;
  info.json["material"] = lab.material.name;
  info.json["specimens"] = lab.specimens;
  info.json["specimen_variation"] = lab.specimen_variation;
  info.json["experiments"] = Json::array();
  info.lines.push_back(labelled("name", lab.name));
  info.lines.push_back(labelled("material", lab.material.name));
  info.lines.push_back(labelled("specimens", specimens_text(lab)));
  for (const LabExperiment& experiment : lab.experiments) {
    info.json["experiments"].push_back(experiment_json(experiment));
    add_lines(experiment, info.lines);
  }
  info.json["warnings"] = info.warnings;
  return info;
}

}  // namespace pliant
