#include "pliant/capture/dic_import.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/capture/bias_strip.h"
#include "pliant/capture/frame_moments.h"
#include "pliant/experiment/contraction/lateral_contraction_type.h"
#include "pliant/experiment/session/session_type.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"
#include "pliant/io/csv_writer.h"
#include "pliant/io/yaml_text.h"
#include "pliant/measurement/session/balance.h"

namespace pliant {
namespace {

std::string millimetres(double metres) { return format_quantity(metres, Dimension::length, 3); }

std::string study_head(const DicSession& made, const std::string& name) {
  std::string text = fmt::format("pliant: study/1\nname: {}\n", yaml_text(name));
  const double density = area_density(made.session);
  return text + fmt::format("density: {}\n", exact_quantity(density, Dimension::area_density));
}

std::string sheet_study(const DicSession& made, const std::string& name) {
  return study_head(made, name) +
         fmt::format("experiments:\n  - {{name: {}, type: {}, data: {}}}\n", yaml_text(name),
                     session_type().name, kDicSessionFolder);
}

double largest(const std::vector<double>& numbers) {
  double most = 0;
  for (const double number : numbers) {
    if (!std::isnan(number)) most = std::max(most, std::abs(number));
  }
  return most;
}

/// Whether it narrows by more than what is noise, or nothing to a lab.
bool narrows(const MiddleRecord& middle) {
  constexpr double kShare = 0.02, kSmallest = 5e-4;
  return largest(middle.lateral_strain) > std::max(kShare * largest(middle.strain), kSmallest);
}

/// Whether what its middle did is a test of its own.
bool is_strip(const DicSession& made) { return made.middle && !made.force.empty(); }

std::string strip_study(const DicSession& made, const std::string& name) {
  const MiddleRecord& middle = *made.middle;
  const auto entry = [&](const char* suffix, const TestType& type) {
    return fmt::format(
        "  - name: {}\n    type: {}\n    direction: {}\n    data: middle.csv\n"
        "    length: {}\n    width: {}\n",
        yaml_text(name + suffix), type.name, middle.direction,
        exact_quantity(middle.length, Dimension::length),
        exact_quantity(middle.width, Dimension::length));
  };
  return study_head(made, name) +
         "# The middle third of the sample: no clamp hinders it, and none lets go of it.\n"
         "experiments:\n" +
         entry("", tensile_cycles_type()) +
         (narrows(middle) ? entry("-width", lateral_contraction_type()) : std::string());
}

std::string middle_table(const DicSession& dic) {
  const MiddleRecord& middle = *dic.middle;
  std::vector<std::string> header{"force_N", "strain (%)", "lateral_strain (%)"};
  for (const ClipSlip& slip : dic.slips) header.push_back("slip_" + slip.clip + "_mm");
  if (!dic.time.empty()) header.emplace_back("time_s");
  CsvWriter csv(header);
  for (std::size_t f = 0; f < middle.strain.size(); ++f) {
    if (std::isnan(middle.strain[f]) || std::isnan(dic.force[f])) continue;
    csv.cell(dic.force[f]).cell(100 * middle.strain[f]).cell(100 * middle.lateral_strain[f]);
    for (const ClipSlip& slip : dic.slips) csv.cell(1e3 * slip.slip[f]);
    if (!dic.time.empty()) csv.cell(dic.time[f]);
    csv.end_row();
  }
  return csv.text();
}

/// A row a frame: how much of the sample was seen, how well cameras agree and matches hold.
std::string frame_table(const DicSession& dic) {
  std::vector<std::string> header{"frame",   "lost",    "unseen",   "agreeing",
                                  "miss_px", "back_px", "drift_px", "broken"};
  if (!dic.stands.empty()) header.emplace_back("force_spread_mN");
  for (const std::string& camera : dic.cameras) header.push_back("share_" + camera);
  CsvWriter csv(header);
  for (std::size_t f = 0; f < dic.qualities.size(); ++f) {
    const auto& quality = dic.qualities[f];
    if (!quality) continue;
    csv.cell(static_cast<int>(f)).cell(dic.lost[f]).cell(dic.unseen[f]);
    csv.cell(quality->agreeing).cell(quality->miss.value_or(NAN));
    csv.cell(quality->matches.back).cell(quality->matches.drift).cell(quality->matches.broken);
    if (!dic.stands.empty()) csv.cell(dic.stands[f] ? 1e3 * dic.stands[f]->spread : NAN);
    for (const double share : quality->share) csv.cell(share);
    csv.end_row();
  }
  return csv.text();
}

std::string distrusted(const std::vector<FrameDoubt>& doubts) {
  return fmt::format("{} frames are to be distrusted, first frame {}: {}", doubts.size(),
                     doubts.front().frame, doubts.front().why);
}

/// The frame with the largest of some numbers, NaN left out.
template <class Number>
std::size_t worst_frame(const std::vector<Number>& numbers) {
  const auto size = [](Number number) {
    const double value = std::abs(static_cast<double>(number));
    return std::isnan(value) ? -1 : value;
  };
  return static_cast<std::size_t>(std::ranges::max_element(numbers, {}, size) - numbers.begin());
}

using Sentences = std::vector<std::string>;

void note_tilt(const DicSession& made, Sentences& notes) {
  const std::size_t f = worst_frame(made.nearer);
  notes.push_back(fmt::format(
      "against the camera the sample tilts as if a clip came {:.2g} % of its distance {} (frame "
      "{}), which counts as no strain",
      100 * std::abs(made.nearer[f]), made.nearer[f] > 0 ? "nearer" : "further away", f));
}

void note_left_out(const std::vector<LeftOutFrame>& left_out, Sentences& notes) {
  constexpr std::size_t kNamed = 4;
  if (left_out.empty()) return;
  std::vector<std::string> named;
  for (const LeftOutFrame& frame : left_out) {
    named.push_back(fmt::format("frame {} {}", frame.frame, frame.why));
  }
  const bool all = named.size() <= kNamed;
  if (!all) named.resize(kNamed);
  notes.push_back(fmt::format("{} frames are left out: {}{}", left_out.size(),
                              fmt::join(named, "; "), all ? "" : "; ..."));
}

/// How the sample lies in the first frame.
void note_rest(const DicFile& dic, const DicSession& made, Sentences& notes) {
  if (!dic.origin)
    notes.emplace_back("the sample is centred on the points (`origin` says otherwise)");
  if (made.off_plane > 0) {
    notes.push_back(fmt::format("points at rest are off their plane by {} (root mean square)",
                                millimetres(made.off_plane)));
  }
  if (made.unrolled) {
    notes.push_back(
        fmt::format("the sample does not lie flat at first: it was unrolled, by which "
                    "distances on it miss by {:.2g} % (root mean square)",
                    100 * *made.unrolled));
  }
}

void note_noise(const DicSession& made, Sentences& notes) {
  const SheetNoise& noise = made.session.noise;
  if (noise.position) {
    notes.push_back(fmt::format(
        "points miss a smooth motion of those around them by {}, a vertex so by {} (`noise` of "
        "the session): noise, and what bends within {}",
        millimetres(made.point_noise), millimetres(*noise.position),
        millimetres(2 * made.spacing)));
  }
  if (noise.force) {
    notes.push_back(fmt::format(
        "a component of a clip's force is known to {} (`noise` of the session), by the spread of "
        "what cells read while the sample stood still and by how well cords are seen",
        format_quantity(*noise.force, Dimension::force, 2)));
  }
}

void note_slack(const DicFile& dic, const DicSession& made, Sentences& notes) {
  if (made.slack.empty()) return;
  notes.push_back(
      dic.views
          ? "the first pictures are not in the session: nothing pulls there, and the sample lies "
            "on something"
          : fmt::format("{} frames in which the sample hung slack are not in the session: one "
                        "camera does not see how it buckles",
                        made.slack.size()));
}

void note_unseen(const DicSession& made, Sentences& notes) {
  const std::size_t lost = worst_frame(made.lost), unseen = worst_frame(made.unseen);
  if (made.lost[lost] > 0) {
    notes.push_back(fmt::format("up to {} points were lost (frame {})", made.lost[lost], lost));
  }
  if (made.unseen[unseen] > 0) {
    notes.push_back(fmt::format("up to {} of {} vertices were not seen (frame {})",
                                made.unseen[unseen], made.session.rest.vertex_count(), unseen));
  }
}

void note_slips(const DicSession& made, Sentences& notes) {
  for (const ClipSlip& slip : made.slips) {
    const std::size_t f = worst_frame(slip.slip);
    const auto unknown =
        std::ranges::count_if(slip.slip, [](double value) { return std::isnan(value); });
    const bool is_seen = unknown <= std::ssize(made.left_out);
    notes.push_back(is_seen
                        ? fmt::format("cloth has left the clip {} by {} at most (frame {}), what "
                                      "the points beside it say",
                                      slip.clip, millimetres(slip.slip[f]), f)
                        : fmt::format("whether cloth has left the clip {} is not seen in all "
                                      "frames: no points are near it",
                                      slip.clip));
  }
}

Sentences notes_of(const DicFile& dic, const DicSession& made) {
  Sentences notes{fmt::format("{} frames of points {} apart; a mesh of {} vertices on {} x {}",
                              made.frame_count(), millimetres(made.spacing),
                              made.session.rest.vertex_count(), millimetres(dic.sample.width),
                              millimetres(dic.sample.height))};
  notes.insert(notes.end(), made.notes.begin(), made.notes.end());
  if (dic.labels) note_tilt(made, notes);
  note_left_out(made.left_out, notes);
  note_rest(dic, made, notes);
  note_noise(made, notes);
  note_slack(dic, made, notes);
  note_unseen(made, notes);
  note_slips(made, notes);
  if (is_strip(made)) {
    notes.push_back(
        "middle.csv, strip.yaml: what the middle third did, as a tensile test of a "
        "strip along " +
        made.middle->direction +
        (narrows(*made.middle) ? "" : "; across the pull it hardly narrows"));
  }
  return notes;
}

void warn_of_wrinkles(const DicFile& dic, const DicSession& made, Sentences& warnings) {
  constexpr double kWrinkled = 0.01;
  if (!(made.unrolled.value_or(0) > kWrinkled)) return;
  warnings.push_back(fmt::format(
      "{}: the sample is wrinkled in this first frame, or bent both ways: laid flat it is "
      "stretched by {:.2g} %, which counts as strain in all others; a frame in which it lies "
      "smooth comes first",
      dic.file_of(0), 100 * *made.unrolled));
}

void warn_of_clips_in_cloth(const std::vector<ClipSlip>& slips, Sentences& warnings) {
  constexpr double kInto = 0.3e-3;  // m
  for (const ClipSlip& slip : slips) {
    const auto into = std::ranges::find_if(slip.slip, [](double out) { return out < -kInto; });
    if (into == slip.slip.end()) continue;
    warnings.push_back(fmt::format(
        "in frame {} the clip {} has gone {} further than the cloth beside it, as if into the "
        "cloth: are its labels, or its motion, those of another clip?",
        into - slip.slip.begin(), slip.clip, millimetres(-*into)));
  }
}

void warn_of_pretension(const std::vector<double>& force, Sentences& warnings) {
  constexpr double kPretension = 0.02;  // of the largest force
  // Of a frame that was taken when the log was not running it is not known.
  if (force.empty() || !(std::abs(force.front()) > kPretension * largest(force))) return;
  warnings.push_back(
      fmt::format("the sample is pulled by {} in the first frame, where it is taken to be at "
                  "rest: a frame of the slack sample comes first, or the cell's zero is off",
                  format_quantity(force.front(), Dimension::force, 3)));
}

Sentences warnings_of(const DicFile& dic, const DicSession& made,
                      const std::vector<FrameDoubt>& doubts) {
  Sentences warnings = made.warnings;
  if (!doubts.empty()) warnings.push_back(distrusted(doubts));
  if (dic.forces && dic.forces->rate) {
    const std::string gap = gap_doubt(dic.files());
    if (!gap.empty()) warnings.push_back(gap);
  }
  warn_of_wrinkles(dic, made, warnings);
  if (!dic.forces && !dic.table) {
    warnings.emplace_back(
        "no `forces`: the session has shapes alone, and no stiffness comes of shapes without "
        "forces");
  }
  warn_of_clips_in_cloth(made.slips, warnings);
  warn_of_pretension(made.force, warnings);
  return warnings;
}

}  // namespace

DicImport import_dic(const std::filesystem::path& file, const ReadPicture& read_picture,
                     const RunContext& context) {
  const DicFile dic = read_dic(file);
  if ((dic.pictures || dic.views) && !read_picture) {
    throw InputError({dic.file, 0, dic.views ? "views" : "pictures"},
                     "cannot be read: this program was built without them", "tables of `points`");
  }
  DicSession made = make_dic_session(dic, read_picture, context);
  if (dic.test == kBiasExtension && made.middle) made.middle->direction = "bias";
  std::vector<FrameDoubt> doubts = frame_doubts(made);
  const std::string name = file.stem().string();
  ImportedStudy study;
  study.study_yaml = sheet_study(made, name);
  if (is_strip(made)) {
    study.files.emplace_back("middle.csv", middle_table(made));
    study.files.emplace_back("strip.yaml", strip_study(made, name));
  }
  if (!made.cameras.empty()) {
    study.files.emplace_back("frames.csv", frame_table(made));
  }
  study.warnings = warnings_of(dic, made, doubts);
  study.notes = notes_of(dic, made);
  return {std::move(study), std::move(made), std::move(doubts)};
}

void make_session_files(const DicImport& imported,
                        const std::function<void(const std::string&, std::string)>& take) {
  const auto in_folder = [&](const std::string& name, std::string content) {
    take(fmt::format("{}/{}", kDicSessionFolder, name), std::move(content));
  };
  const Session& session = imported.made.session;
  if (session.test == kBiasExtension) {
    make_session_files(in_yarn_axes(session), in_folder);
  } else {
    make_session_files(session, in_folder);
  }
}

}  // namespace pliant
