#include "pliant/capture/dic_file.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "pliant/base/number_text.h"
#include "pliant/base/quantity.h"
#include "pliant/capture/calibration_file.h"
#include "pliant/capture/pattern.h"
#include "pliant/capture/pixel_fields.h"
#include "pliant/capture/tag_detector.h"
#include "pliant/io/document.h"
#include "pliant/io/fields.h"
#include "pliant/io/result_name.h"
#include "pliant/io/vector_fields.h"
#include "pliant/measurement/session/session_document.h"

namespace pliant {
namespace {

PointAxis read_axis(const Value& value) {
  const std::string name = value.choice({"x", "+x", "-x", "y", "+y", "-y"});
  return {name.back() == 'x' ? 0 : 1, name.front() == '-' ? -1.0 : 1.0};
}

SampleSide read_side(const Value& value) {
  const std::string name = value.choice({"left", "right", "bottom", "top"});
  if (name == "left") return SampleSide::left;
  if (name == "right") return SampleSide::right;
  return name == "bottom" ? SampleSide::bottom : SampleSide::top;
}

ClipMotion read_motion(const Value& value) {
  const std::string name = value.choice({"points", "held", "extension"});
  if (name == "held") return ClipMotion::held;
  return name == "extension" ? ClipMotion::extension : ClipMotion::points;
}

/// What clips may not share.
struct TakenByClips {
  std::set<std::string> names;
  std::set<std::pair<SampleSide, double>> places;  // a side and where on it
  std::set<int> codes;
};

std::vector<int> read_codes(const Value& value, std::set<int>& taken) {
  std::vector<int> codes;
  for (const Value& item : value.items()) {
    codes.push_back(item.integer(0, kTagCodes - 1));
    if (!taken.insert(codes.back()).second) {
      item.fail(fmt::format("{} stands here twice", codes.back()), "a code for each label");
    }
  }
  if (codes.empty()) value.fail("names no code", "the codes of the tags, one or more");
  return codes;
}

std::pair<double, double> read_range(const Value& value) {
  const std::vector<Value> items = value.items();
  if (items.size() != 2) value.fail("is no range", "[from, to] along the side");
  const double from = items[0].quantity_from_zero(Dimension::length);
  const double to = items[1].positive_quantity(Dimension::length);
  if (!(to > from)) value.fail("ends before it begins", "[from, to] along the side");
  return {from, to};
}

DicClip read_clip(const Value& value, TakenByClips& taken) {
  Fields fields = value.fields();
  DicClip clip;
  clip.name = read_result_name(fields.require("name"), "a clip", taken.names);
  const Value side = fields.require("side");
  clip.side = read_side(side);
  if (auto v = fields.optional("depth")) clip.depth = v->quantity_from_zero(Dimension::length);
  if (auto v = fields.optional("along")) clip.along = read_range(*v);
  const double from = clip.along ? clip.along->first : 0;
  if (!taken.places.emplace(clip.side, from).second) {
    side.fail("is held by another clip", "a place for each clip");
  }
  if (auto v = fields.optional("labels")) {
    clip.labels = read_codes(*v, taken.codes);
    clip.motion = ClipMotion::labels;
    if (auto motion = fields.optional("motion")) {
      motion->fail("stands beside `labels`", "one of them: labels show how the clip moves");
    }
  } else if (auto motion = fields.optional("motion")) {
    clip.motion = read_motion(*motion);
  }
  if (auto v = fields.optional("mass")) clip.mass = v->quantity_from_zero(Dimension::mass);
  fields.finish();
  return clip;
}

DicPictures read_pictures(const Value& value) {
  DicPictures pictures;
  if (!value.is_mapping()) {
    pictures.files = read_data_source(value).files;
    return pictures;
  }
  Fields fields = value.fields();
  pictures.files = read_data_source(fields.require("files")).files;
  read_patches(fields, pictures.patch, pictures.step);
  fields.finish();
  return pictures;
}

/// A pattern/1 file of labels, or their sizes.
void read_labels(const Value& value, DicFile& dic) {
  DicLabels& labels = dic.labels.emplace();
  if (!value.is_mapping()) {
    const std::filesystem::path file =
        path_beside(value, "a pattern/1 file of labels, or {tag, edge}");
    dic.labels_file = DicReference{file, "", value.location()};
    return;
  }
  Fields fields = value.fields();
  labels.tag = fields.require("tag").positive_quantity(Dimension::length);
  const Value edge = fields.require("edge");
  labels.edge = edge.positive_quantity(Dimension::length);
  if (labels.edge < labels.tag / 2) {
    edge.fail("is within the tag", "at least half of `tag`: from the tag's middle");
  }
  fields.finish();
}

/// A calibration/1 file, of one camera or with the name of one.
DicReference read_camera(const Value& value) {
  if (!value.is_mapping()) return {path_beside(value, kExpectedCalibration), "", value.location()};
  Fields fields = value.fields();
  const std::filesystem::path file =
      path_beside(fields.require("calibration"), kExpectedCalibration);
  const Value name = fields.require("name");
  DicReference camera{file, name.text("the name of a camera"), name.location()};
  fields.finish();
  return camera;
}

constexpr const char* kByMotion = "by motion";  // of the clip that the log is of, or of the cords

void require_rate(const Value& value, const DicForces& forces) {
  if (!forces.rate) value.fail("needs the `rate` of the frames", "both");
}

void read_start(const Value& value, DicForces& forces) {
  require_rate(value, forces);
  forces.start = LogStart{{}, value.location()};
  if (value.text() != kByMotion) forces.start->time = value.quantity(Dimension::time);
}

DicForces read_forces(const Value& value) {
  Fields fields = value.fields();
  DicForces forces;
  if (auto v = fields.optional("cords")) {
    forces.cords = path_beside(*v, "a table like cords.csv of a session");
    for (const char* other : {"data", "on", "cells", "rate", "start", "still"}) {
      if (auto w = fields.optional(other)) w->fail("stands beside `cords`", "one of them");
    }
    fields.finish();
    return forces;
  }
  forces.data = read_data_source(fields.require("data"));
  if (auto cells = fields.optional("cells")) {
    forces.cells = read_cells(*cells);
    if (auto v = fields.optional("on")) v->fail("stands beside `cells`", "one of them");
  } else {
    const Value on = fields.require("on");
    forces.clip = on.text("the name of a clip");
    forces.where_clip = on.location();
  }
  if (auto v = fields.optional("rate")) forces.rate = v->positive_quantity(Dimension::frequency);
  if (auto v = fields.optional("start")) read_start(*v, forces);
  if (auto v = fields.optional("still")) {
    require_rate(*v, forces);
    forces.still = v->positive_quantity(Dimension::time);
  }
  fields.finish();
  return forces;
}

/// A coordinate: a length, or a number of the columns' own unit.
double read_coordinate(const Value& value, const std::optional<double>& scale) {
  const auto number = parse_number(value.text("a coordinate"));
  if (!number) return value.quantity(Dimension::length);
  if (!scale) value.fail("has no unit", "a length, or `scale` for numbers of pixels");
  return *number * *scale;
}

Eigen::Vector2d read_origin(const Value& value, const std::optional<double>& scale) {
  const std::vector<Value> items = value.items();
  if (items.size() != 2) value.fail("is no place", "[x, y] of the sample's corner");
  return {read_coordinate(items[0], scale), read_coordinate(items[1], scale)};
}

/// Where the sample lies in pictures: `scale` and `origin` say it, or the labels.
void read_place(Fields& fields, const std::optional<Value>& pictures, DicFile& dic) {
  const auto origin = fields.optional("origin");
  if (const auto labels = fields.optional("labels")) {
    read_labels(*labels, dic);
    if (auto v = fields.optional("camera")) dic.camera = read_camera(*v);
    if (!pictures) labels->fail("stand in no picture", "`pictures`, or no labels");
    for (const char* other : {"scale", "weft", "warp"}) {
      if (auto v = fields.optional(other)) v->fail("stands beside `labels`, which tell it", "one");
    }
    if (origin) dic.labels->corner = read_pixel(*origin);
    dic.origin = Eigen::Vector2d::Zero();
    return;
  }
  if (auto v = fields.optional("camera")) {
    v->fail("is told, and no `labels` by which it sees where it stands", "`labels`, or no camera");
  }
  if (origin) dic.origin = read_origin(*origin, dic.scale);
  if (!pictures) return;
  if (!dic.scale)
    pictures->fail("has no `scale`", "the length of a pixel at the sample, or `labels`");
  if (!origin) pictures->fail("has no `origin`", "the pixel of the sample's corner, [x, y]");
}

/// Several cameras tell where the sample lies by its corners.
void refuse_place(Fields& fields) {
  for (const char* other : {"scale", "origin", "labels", "camera", "weft", "warp"}) {
    if (auto v = fields.optional(other)) {
      v->fail("stands beside `views`, whose calibration and `corners` tell it", "one");
    }
  }
}

/// Tags that stand still, on no clip.
void read_fixed(const Value& value, DicFile& dic) {
  if (!dic.pictures && !dic.views) value.fail("stand in no picture", "`pictures` or `views`");
  if (dic.labels) {
    value.fail("stand beside `labels`, by which each picture tells where its camera is", "one");
  }
  const std::vector<int> labels = dic.label_codes();
  std::set<int> taken(labels.begin(), labels.end());
  dic.fixed = read_codes(value, taken);
}

constexpr const char* kTwoLabelled =
    "labels on two clips at least, which tell how the plane of the sample is tilted";

/// A tester's clock is found by a clip that is seen to move.
void require_motion_for_clock(const DicFile& dic) {
  if (!dic.forces || !dic.forces->needs_clock() || !dic.forces->cells.empty()) return;
  const auto pulled = dic.pulled_clip();
  const bool is_seen = pulled != dic.clips.end() && pulled->motion != ClipMotion::held;
  if (is_seen && !dic.moves_by_log()) return;
  throw InputError(dic.forces->start->where,
                   "is to be found by how the clip moves, which is not seen",
                   "labels on the clip that `on` names, or points beside it; or a time");
}

/// How many clips carry labels.
std::ptrdiff_t carriers_of(const DicFile& dic) {
  return std::ranges::count_if(dic.clips, [](const DicClip& clip) { return !clip.labels.empty(); });
}

void require_labels(const DicFile& dic, const Value& list) {
  if (dic.views) return;  // which need not know how large they are
  const auto carriers = carriers_of(dic);
  if (!dic.labels && carriers > 0) {
    list.fail("has clips with labels of unknown size", "`labels`, their pattern/1 file");
  }
  if (dic.labels && carriers == 0) list.fail("has no clip with labels", kTwoLabelled);
}

void require_clips_for_motion(const DicFile& dic, const Value& list) {
  if (dic.moves_by_log() && (!dic.forces || !dic.forces->is_tester())) {
    list.fail("has a clip that moves by its extension, and there are no `forces` to tell it",
              "`forces` with a log that has a column of the extension");
  }
}

/// A cord is followed from where it is fastened to its clip, which labels show.
void require_clips_of_cells(const DicFile& dic) {
  if (!dic.forces) return;
  require_single_cords(dic.forces->cells);
  for (const DicCell& cell : dic.forces->cells) {
    if (!dic.views) {
      throw InputError(cell.where, "pulls by a cord that is not seen in space", "`views`");
    }
    const auto clip = dic.clip_named(cell.clip);
    if (clip == dic.clips.end()) {
      throw InputError(cell.where, quoted_value(cell.clip) + " is no clip", "the name of a clip");
    }
    if (clip->labels.empty()) {
      throw InputError(cell.where,
                       "pulls a clip without `labels`, which tell where the cord begins",
                       "labels on each clip that a cord pulls");
    }
  }
}

void read_clips(Fields& fields, DicFile& dic) {
  const Value list = fields.require("clips");
  TakenByClips taken;
  for (const Value& clip : list.items()) dic.clips.push_back(read_clip(clip, taken));
  if (dic.clips.empty()) list.fail("names no clip", "what holds the sample, or a `table`");
  if (auto v = fields.optional("forces")) dic.forces = read_forces(*v);
  require_clips_for_motion(dic, list);
  require_labels(dic, list);
}

/// A table holds the sample, and its weight pulls.
void read_table_in_place(const Value& value, Fields& fields, DicFile& dic) {
  const TableEntry table = read_table(value);
  dic.table = DicTable{table.axis, table.edge};
  for (const char* other : {"clips", "forces"}) {
    if (auto v = fields.optional(other))
      v->fail("stands beside `table`, which holds the sample", "one");
  }
  if (dic.pictures) value.fail("is seen by one camera, which does not see what hangs", "`views`");
  if (!dic.views && !dic.gravity) {
    value.fail("needs `gravity`, by which the sample hangs", "e.g. gravity: [0, 0, -9.81]");
  }
}

void require_edge_under_sample(const DicFile& dic) {
  const auto& [axis, edge] = *dic.table;
  const double length = axis == RestAxis::u ? dic.sample.width : dic.sample.height;
  if (edge > 0 && edge <= length) return;
  throw InputError(
      {dic.file, 0, "table"},
      fmt::format("has its edge at {} of a sample of {}", format_quantity(edge, Dimension::length),
                  format_quantity(length, Dimension::length)),
      "where the edge lies under it in the first frame");
}

/// The labels of the file that the document names, which have to be those on the clips.
void resolve_labels(DicFile& dic) {
  const DicReference& file = *dic.labels_file;
  const Pattern pattern = read_pattern(file.file);
  const auto* printed = std::get_if<ClipCodes>(&pattern.kind);
  if (!printed) {
    throw InputError(file.where, "is no pattern of labels",
                     "what `pliant pattern clips` has written");
  }
  dic.labels->tag = printed->tag;
  dic.labels->edge = printed->edge;
  for (const DicClip& clip : dic.clips) {
    for (const int code : clip.labels) {
      if (printed->has(code)) continue;
      throw InputError(
          file.where, fmt::format("does not have the label {} of the clip {}", code, clip.name),
          fmt::format("one of the labels that were printed: {}", fmt::join(printed->codes, ", ")));
    }
  }
}

/// The camera of the calibration that the document names: the only one, or that of a name.
Lens lens_of(const DicReference& camera) {
  const CalibratedRig rig = read_calibration(camera.file);
  if (camera.name.empty() && rig.cameras.size() == 1) return Lens(rig.cameras.front());
  const auto found = std::ranges::find(rig.names, camera.name);
  if (found != rig.names.end()) {
    return Lens(rig.cameras[static_cast<std::size_t>(found - rig.names.begin())]);
  }
  throw InputError(
      camera.where, camera.name.empty() ? "has several cameras" : "is no camera of the calibration",
      fmt::format("{{calibration: FILE, name: NAME}} of {}", fmt::join(rig.names, ", ")));
}

}  // namespace

const std::vector<std::filesystem::path>& DicFile::files() const {
  if (views) return views->files.front();
  return pictures ? pictures->files : points.files;
}

bool DicFile::moves_by_log() const {
  return std::ranges::any_of(
      clips, [](const DicClip& clip) { return clip.motion == ClipMotion::extension; });
}

std::vector<DicClip>::const_iterator DicFile::clip_named(const std::string& name) const {
  return std::ranges::find(clips, name, &DicClip::name);
}

DicFile read_dic(const std::filesystem::path& path) {
  DicFile dic = dic_of(read_yaml(path));
  if (dic.labels && carriers_of(dic) < 2) {
    throw InputError({dic.file, 0, "clips"}, "has one clip with labels", kTwoLabelled);
  }
  if (dic.table) require_edge_under_sample(dic);
  require_motion_for_clock(dic);
  require_clips_of_cells(dic);
  if (dic.labels_file) resolve_labels(dic);
  if (dic.camera) dic.lens = lens_of(*dic.camera);
  if (dic.views) resolve_views(*dic.views);
  if (dic.forces && dic.views) resolve_cells(dic.forces->cells, *dic.views);
  return dic;
}

DicFile dic_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "dic", 1);
  DicFile dic;
  dic.file = document.file;
  const Value test = fields.require("test");
  dic.test = test.text();
  if (dic.test.empty()) test.fail("is empty", "stretch-warp, shear, ..., or a name of its own");
  dic.info = fields.texts("info");
  dic.sample = read_session_sample(fields.require("sample"), SessionKind::sheet);
  if (auto v = fields.optional("scale")) dic.scale = v->positive_quantity(Dimension::length);
  const auto pictures = fields.optional("pictures");
  const auto views = fields.optional("views");
  if (views) {
    dic.views = read_views(*views);
    if (pictures) pictures->fail("stand beside `views`", "one of them");
  } else if (pictures) {
    dic.pictures = read_pictures(*pictures);
  } else {
    dic.points = read_data_source(fields.require("points"));
  }
  if (views) {
    refuse_place(fields);
    dic.origin = Eigen::Vector2d::Zero();
  } else {
    read_place(fields, pictures, dic);
  }
  if (auto v = fields.optional("weft")) dic.weft = read_axis(*v);
  // Rows of pictures count downwards.
  dic.warp = {1 - dic.weft.axis, pictures && !dic.labels && dic.weft.axis == 0 ? -1.0 : 1.0};
  if (auto v = fields.optional("warp")) {
    dic.warp = read_axis(*v);
    if (dic.warp.axis == dic.weft.axis) v->fail("lies along the weft", "the other axis");
  }
  if (auto v = fields.optional("mesh")) dic.mesh = v->positive_quantity(Dimension::length);
  if (auto v = fields.optional("gravity")) dic.gravity = read_vector(*v);
  if (auto v = fields.optional("points"); v && (pictures || views)) {
    v->fail(views ? "stand beside `views`" : "stand beside `pictures`", "one of them");
  }
  if (const auto table = fields.optional("table")) {
    read_table_in_place(*table, fields, dic);
  } else {
    read_clips(fields, dic);
  }
  if (auto v = fields.optional("fixed")) read_fixed(*v, dic);
  fields.finish();
  return dic;
}

}  // namespace pliant
