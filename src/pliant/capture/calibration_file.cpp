#include "pliant/capture/calibration_file.h"

#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/base/number_text.h"
#include "pliant/io/fields.h"
#include "pliant/io/vector_fields.h"

namespace pliant {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json json_list(const Vector& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(value);
  return list;
}

Json json_of_camera(const RigCalibration& found, int c) {
  const CameraModel& camera = found.bundle.cameras[c];
  const CameraResiduals& residuals = found.cameras[c];
  Json json{{"name", found.names[c]}, {"columns", camera.columns}, {"rows", camera.rows}};
  for (int k = 0; k < kIntrinsics; ++k) {
    json["intrinsics"][kIntrinsicNames[k]] = camera.intrinsics(k);
    json["errors"][kIntrinsicNames[k]] = found.error(c, k);
  }
  json["rotation"] = json_list(camera.pose.rotation);
  json["translation"] = json_list(camera.pose.translation);
  Json rotation_errors = Json::array(), translation_errors = Json::array();
  for (int k = 0; k < 3; ++k) {
    rotation_errors.push_back(found.error(c, kIntrinsics + k));
    translation_errors.push_back(found.error(c, kIntrinsics + 3 + k));
  }
  json["errors"]["rotation"] = rotation_errors;
  json["errors"]["translation"] = translation_errors;
  json["noise"] = found.bundle.noise[c];
  json["rms"] = residuals.rms;
  json["rms_all"] = residuals.rms_all;
  Json regions = Json::array();
  for (const auto& region : residuals.regions) {
    regions.push_back(region ? Json(*region) : Json(nullptr));
  }
  json["regions"] = regions;
  json["pictures"] = residuals.pictures;
  json["corners"] = residuals.corners;
  json["corners_left_out"] = residuals.left_out;
  json["widest_tilt"] = residuals.widest_tilt;
  return json;
}

Json json_of_pictures(const RigCalibration& found) {
  Json list = Json::array();
  for (const RigPicture& picture : found.pictures) {
    Json json{
        {"file", picture.file}, {"camera", found.names[picture.camera]}, {"shot", picture.shot}};
    if (!picture.left_out.empty()) json["left_out"] = picture.left_out;
    list.push_back(json);
  }
  return list;
}

void add_checks(const RigCalibration& found, Json& json) {
  json["pairs"] = Json::array();
  for (const EpipolarResidual& pair : found.pairs) {
    json["pairs"].push_back({{"first", found.names[pair.first]},
                             {"second", found.names[pair.second]},
                             {"corners", pair.corners},
                             {"epipolar_rms", pair.rms}});
  }
  if (found.held_out) {
    json["held_out_boards"] = {{"boards", found.held_out->boards},
                               {"corners", found.held_out->corners},
                               {"rms", found.held_out->rms},
                               {"scale_error", found.held_out->scale_error}};
  }
  if (found.length) {
    json["second_length"] = {{"stated", found.length->stated},
                             {"measured", found.length->measured},
                             {"error", found.length->error},
                             {"errors_apart", found.length->errors_apart()},
                             {"times", found.length->measured_in}};
  }
  if (found.gravity) {
    json["gravity"] = {{"direction", json_list(found.gravity->direction)},
                       {"error", found.gravity->error}};
  }
}

Intrinsics read_intrinsics(const Value& value) {
  Fields fields = value.fields();
  Intrinsics result;
  for (int k = 0; k < kIntrinsics; ++k) result(k) = fields.require(kIntrinsicNames[k]).number();
  fields.finish();
  if (!(result.head<2>().minCoeff() > 0)) value.fail("have no focal length", "fx and fy above 0");
  return result;
}

void read_camera(const Value& value, CalibratedRig& rig) {
  constexpr int kLargest = 100'000;
  Fields fields = value.fields();
  CameraModel camera;
  rig.names.push_back(fields.require("name").text());
  camera.columns = fields.require("columns").integer(1, kLargest);
  camera.rows = fields.require("rows").integer(1, kLargest);
  camera.intrinsics = read_intrinsics(fields.require("intrinsics"));
  camera.pose.rotation = read_vector(fields.require("rotation"));
  camera.pose.translation = read_vector(fields.require("translation"));
  rig.noise.push_back(fields.require("noise").number());
  rig.rms.push_back(fields.require("rms").number());
  rig.cameras.push_back(camera);
  fields.all();  // what is said of its pictures
}

Eigen::MatrixXd read_covariance(const Value& value, int size) {
  const std::vector<Value> rows = value.items();
  Eigen::MatrixXd result(size, size);
  if (std::ssize(rows) != size) value.fail("has another number of rows", std::to_string(size));
  for (int i = 0; i < size; ++i) {
    const std::vector<double> numbers = rows[i].numbers();
    if (std::ssize(numbers) != size) rows[i].fail("is too long or short", std::to_string(size));
    for (int k = 0; k < size; ++k) result(i, k) = numbers[k];
  }
  return result;
}

}  // namespace

std::string calibration_text(const RigCalibration& found, const RigFile& rig) {
  Json json{{"pliant", "calibration/1"}, {"rig", rig.file}};
  json["cameras"] = Json::array();
  for (int c = 0; c < std::ssize(found.names); ++c) {
    json["cameras"].push_back(json_of_camera(found, c));
  }
  add_checks(found, json);
  json["boards"] = Json::array();
  for (int b = 0; b < std::ssize(rig.boards); ++b) {
    Json board{{"name", rig.boards[b].name}};
    if (rig.warp) board["warp"] = json_list(found.bundle.warps[b]);
    json["boards"].push_back(board);
  }
  json["pictures"] = json_of_pictures(found);
  json["warnings"] = found.warnings;
  json["covariance"] = Json::array();
  for (Eigen::Index i = 0; i < found.covariance.cameras.rows(); ++i) {
    json["covariance"].push_back(json_list(Eigen::VectorXd(found.covariance.cameras.row(i))));
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string corners_table(const RigCalibration& found, const RigFile& rig) {
  std::string table = "camera,picture,board,corner,x_px,y_px,missed_x_px,missed_y_px,used\n";
  for (const CornerView& view : found.bundle.views) {
    const Eigen::Matrix2Xd residuals = found.bundle.residuals(view);
    const int board = found.bundle.placements[view.placement].board;
    for (int i = 0; i < std::ssize(view.corners); ++i) {
      table +=
          fmt::format("{},{},{},{},{:.4f},{:.4f},{:.4f},{:.4f},{}\n", found.names[view.camera],
                      std::filesystem::path(found.pictures[view.picture].file).filename().string(),
                      rig.boards[board].name, view.corners[i], view.pixels(0, i), view.pixels(1, i),
                      residuals(0, i), residuals(1, i), view.is_used[i] ? 1 : 0);
    }
  }
  return table;
}

CalibratedRig read_calibration(const std::filesystem::path& path) {
  return calibration_of(read_json(path));
}

CalibratedRig calibration_of(const Document& document) {
  Fields fields = Value(document).fields();
  require_document(fields, "calibration", 1);
  CalibratedRig rig;
  rig.file = document.file;
  const Value cameras = fields.require("cameras");
  for (const Value& camera : cameras.items()) read_camera(camera, rig);
  if (rig.cameras.empty()) cameras.fail("names no camera", "one camera or more");
  rig.covariance = read_covariance(fields.require("covariance"),
                                   static_cast<int>(rig.cameras.size()) * kCameraNumbers);
  if (const auto v = fields.optional("gravity")) {
    Fields gravity = v->fields();
    rig.gravity = read_vector(gravity.require("direction"));
    gravity.all();
  }
  if (const auto v = fields.optional("warnings")) {
    for (const Value& item : v->items()) rig.warnings.push_back(item.text());
  }
  fields.all();
  return rig;
}

}  // namespace pliant
