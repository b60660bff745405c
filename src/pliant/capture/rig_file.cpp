#include "pliant/capture/rig_file.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "pliant/capture/chessboard_corners.h"
#include "pliant/capture/frame_moments.h"
#include "pliant/capture/pixel_fields.h"
#include "pliant/io/fields.h"
#include "pliant/io/result_name.h"
#include "pliant/measurement/data_source.h"

namespace pliant {
namespace {

constexpr auto kDistortions = {"none", "k1", "k1 k2", "k1 k2 p1 p2", "k1 k2 p1 p2 k3"};

std::string read_distortion(const Value& value) {
  const std::vector<std::string_view> choices(kDistortions.begin(), kDistortions.end());
  return value.choice(choices);
}

std::vector<RigCameraFile> read_cameras(const Value& value) {
  std::vector<RigCameraFile> cameras;
  Fields fields = value.fields();
  std::set<std::string> taken;
  for (const auto& [name, own] : fields.all()) {
    RigCameraFile camera{name, free_intrinsics(kDefaultDistortion), own.location()};
    camera.where.field = "cameras." + name;
    if (!own.is_null()) {
      Fields options = own.fields();
      if (const auto v = options.optional("distortion")) {
        camera.free = free_intrinsics(read_distortion(*v));
      }
      options.finish();
    }
    cameras.push_back(camera);
  }
  if (cameras.empty()) value.fail("names no camera", "a name for each camera");
  return cameras;
}

CalibrationBoard board_of(const Pattern& pattern, const Location& where, std::string name) {
  if (const auto* tags = std::get_if<TagBoard>(&pattern.kind)) return {std::move(name), *tags};
  const auto* chessboard = std::get_if<Chessboard>(&pattern.kind);
  if (!chessboard) {
    throw InputError(where, fmt::format("is a pattern of kind `{}`", kind_name(pattern)),
                     "a `board` of tags or a `chessboard`");
  }
  if (!can_find_chessboards()) {
    throw InputError(where, "is a chessboard; this program was built without OpenCV's calib3d",
                     "a board of tags (pliant pattern board), or a build where "
                     "libopencv-calib3d-dev is installed");
  }
  return {std::move(name), *chessboard};
}

void refuse_shared_codes(const RigFile& rig, const CalibrationBoard& board, const Location& where) {
  const auto* tags = std::get_if<TagBoard>(&board.kind);
  for (const CalibrationBoard& other : rig.boards) {
    const auto* others = std::get_if<TagBoard>(&other.kind);
    if (!tags || !others) continue;
    const int first = std::max(tags->first_code, others->first_code);
    if (tags->has(first) && others->has(first)) {
      throw InputError(where, fmt::format("has code {} as {} has", first, other.name),
                       "boards with codes of their own (`first_code`)");
    }
  }
}

void refuse_code_of_board(const RigFile& rig, int code) {
  for (const CalibrationBoard& board : rig.boards) {
    const auto* tags = std::get_if<TagBoard>(&board.kind);
    if (!tags || !tags->has(code)) continue;
    throw InputError(rig.second_length->where, fmt::format("{} is a code of {}", code, board.name),
                     "tags of another print: a board that came out too large measures itself the "
                     "same");
  }
}

void load_boards(RigFile& rig) {
  const std::filesystem::path folder = std::filesystem::path(rig.file).parent_path();
  for (int b = 0; b < std::ssize(rig.board_files); ++b) {
    const std::filesystem::path& file = rig.board_files[b];
    const Location& where = rig.where_boards[b];
    CalibrationBoard board = board_of(read_pattern(folder / file), where, file.string());
    refuse_shared_codes(rig, board, where);
    rig.boards.push_back(std::move(board));
  }
  if (!rig.second_length) return;
  refuse_code_of_board(rig, rig.second_length->first);
  refuse_code_of_board(rig, rig.second_length->second);
}

void read_boards(const Value& value, RigFile& rig) {
  const std::vector<Value> items = value.is_sequence() ? value.items() : std::vector{value};
  for (const Value& item : items) {
    rig.board_files.emplace_back(item.text("a pattern/1 file of the board"));
    if (rig.board_files.back().empty()) item.fail("is empty", "a pattern/1 file");
    rig.where_boards.push_back(item.location());
  }
  if (rig.board_files.empty()) value.fail("names no board", "a pattern/1 file");
}

RigPictureSet read_picture_set(const Value& value, const RigFile& rig) {
  RigPictureSet set{std::vector<std::vector<std::filesystem::path>>(rig.cameras.size()),
                    value.location()};
  Fields fields = value.fields();
  constexpr const char* kTogether =
      "as many of each camera: those of one number show the boards at the same time; pictures that "
      "a camera took alone are a set of their own";
  std::optional<std::string> first;
  std::size_t first_camera = 0;
  for (const auto& [name, files] : fields.all()) {
    if (files.is_null()) continue;
    const int camera = rig.camera(name);
    if (camera < 0) {
      files.fail("is a camera that `cameras` does not name", "one of the names there");
    }
    auto& own = set.files[camera];
    own = read_data_source(files).files;
    if (!first) {
      first = name;
      first_camera = static_cast<std::size_t>(camera);
    }
    const auto& others = set.files[first_camera];
    if (own.size() != others.size()) {
      files.fail(fmt::format("are {} pictures, and {} has {}", own.size(), *first, others.size()),
                 kTogether);
    }
    require_same_moments(files, own, others, kTogether);
  }
  if (!first) value.fail("names no pictures", "pictures of one or several cameras");
  return set;
}

SecondLength read_second_length(const Value& value) {
  Fields fields = value.fields();
  SecondLength second;
  second.where = value.location();
  if (const auto codes = fields.optional("codes")) {
    const std::vector<Value> items = codes->items();
    if (items.size() != 2) codes->fail("are not two", "the codes of two tags");
    second.first = items[0].integer(0, kTagCodes - 1);
    second.second = items[1].integer(0, kTagCodes - 1);
    if (second.first == second.second)
      codes->fail("are one code", "two tags; or `code` and `side`");
    second.length = fields.require("distance").positive_quantity(Dimension::length);
  } else {
    second.first = second.second = fields.require("code").integer(0, kTagCodes - 1);
    second.length = fields.require("side").positive_quantity(Dimension::length);
  }
  if (const auto v = fields.optional("on_board")) second.on_board = v->flag();
  fields.finish();
  return second;
}

PlumbLine read_plumb(const Value& value, const RigFile& rig) {
  PlumbLine line{{}, value.location()};
  Fields fields = value.fields();
  for (const auto& [name, pixels] : fields.all()) {
    const int camera = rig.camera(name);
    if (camera < 0) pixels.fail("is a camera that `cameras` does not name", "one of the names");
    const std::vector<Value> items = pixels.items();
    if (items.size() != 2) pixels.fail("are not two pixels", "[[column, row], [column, row]]");
    line.seen.push_back({camera, read_pixel(items[0]), read_pixel(items[1])});
  }
  if (line.seen.size() != 2) value.fail("is not seen by two cameras", "pixels in two cameras");
  return line;
}

GravitySource read_gravity(const Value& value, const RigFile& rig) {
  Fields fields = value.fields();
  GravitySource source;
  const auto level = fields.optional("level");
  const auto plumb = fields.optional("plumb");
  if (level && plumb) plumb->fail("stands beside `level`", "one of them");
  if (level) {
    const auto folder = std::filesystem::path(rig.file).parent_path();
    source = LevelBoard{folder / level->text("the name of a picture"), level->location()};
  } else if (plumb) {
    source = read_plumb(*plumb, rig);
  } else {
    value.fail("says nothing", "`level` or `plumb`");
  }
  fields.finish();
  return source;
}

void read_calibration_fields(const Value& value, RigFile& rig) {
  Fields fields = value.fields();
  read_boards(fields.require("boards"), rig);
  const Value pictures = fields.require("pictures");
  const std::vector<Value> sets = pictures.is_sequence() ? pictures.items() : std::vector{pictures};
  for (const Value& set : sets) rig.pictures.push_back(read_picture_set(set, rig));
  if (sets.empty()) pictures.fail("names no pictures", "pictures of one or several cameras");
  if (const auto v = fields.optional("warp")) rig.warp = v->flag();
  if (const auto v = fields.optional("second_length")) {
    rig.second_length = read_second_length(*v);
  }
  if (const auto v = fields.optional("gravity")) rig.gravity = read_gravity(*v, rig);
  fields.finish();
}

}  // namespace

FreeIntrinsics free_intrinsics(const std::string& distortion) {
  FreeIntrinsics free{};
  for (int k = 0; k < 4; ++k) free[k] = true;
  for (int k = 4; k < kIntrinsics; ++k) {
    free[k] = distortion.find(kIntrinsicNames[k]) != std::string::npos;
  }
  return free;
}

int RigFile::camera(const std::string& name) const {
  const auto found = std::ranges::find(cameras, name, &RigCameraFile::name);
  return found == cameras.end() ? -1 : static_cast<int>(found - cameras.begin());
}

RigFile read_rig(const std::filesystem::path& path) {
  RigFile rig = rig_of(read_yaml(path));
  load_boards(rig);
  return rig;
}

RigFile rig_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "rig", 1);
  RigFile rig;
  rig.file = document.file;
  rig.cameras = read_cameras(fields.require("cameras"));
  read_calibration_fields(fields.require("calibration"), rig);
  fields.finish();
  return rig;
}

}  // namespace pliant
