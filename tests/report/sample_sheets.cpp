#include "report/sample_sheets.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "pliant/material/material_file.h"

#include "report/sample_results.h"
#include "support/virtual_sheets.h"

namespace pliant::testing {
namespace {

using nlohmann::json;

/// One cord a clip, at its middle.
void pull_clips(Session& session, int frame, double force) {
  SessionFrame& now = session.frames[static_cast<std::size_t>(frame)];
  now.cords.resize(2);
  for (int clip = 0; clip < 2; ++clip) {
    const Eigen::Vector3d pull(clip == 0 ? -force : force, 0, 0);
    now.cords[static_cast<std::size_t>(clip)] = {{"", clip_middle(session, frame, clip), pull}};
  }
}

json experiment(const std::string& name, bool forces) {
  return {{"name", name},
          {"type", "session"},
          {"direction", name},
          {"component", forces ? "stretch.weft" : "bend.weft"},
          {"role", "fit"},
          {"quantity", forces ? "force_N" : "height_mm"},
          {"peak_force_N", forces ? json(0.5) : json()},
          {"rms_percent_of_peak", forces ? json(4.0) : json()},
          {"points", 10},
          {"specimens", 1},
          {"prediction_file", "predictions/" + name + ".csv"},
          {"sheets", "sheets/" + name},
          {"fold_height_error_mm", forces ? 0.25 : 0.0125}};
}

json parameter(const std::string& name, double value, double error, const std::string& unit) {
  return {{"name", name},
          {"component", name.substr(0, name.find_first_of(".", name.find('.') + 1))},
          {"value", value},
          {"std_error", error},
          {"unit", unit},
          {"identified", error < value},
          {"lower", value - error},
          {"upper", value + error}};
}

json fixed(const std::string& name, double value, const std::string& unit) {
  json fixed = parameter(name, value, 0, unit);
  fixed["std_error"] = nullptr;
  fixed["identified"] = false;
  fixed["fixed"] = true;
  return fixed;
}

json cord(const std::string& name, double value) {
  json cord = parameter(name, value, 0.01, "N");
  cord.erase("component");
  cord["experiment"] = name.substr(0, name.find('.'));
  return cord;
}

std::string fit_json() {
  return json{
      {"pliant", "fit/1"},
      {"name", "two sheets"},
      {"seconds", 12.0},
      {"parameters",
       {parameter("stretch.weft.k[0]", 80, 1, "N/m"), parameter("stretch.weft.k[1]", 480, 5, "N/m"),
        parameter("stretch.weft.friction.a", 2, 0.1, "N/m"),
        parameter("stretch.weft.friction.b", 5, 0.5, "N/m"),
        parameter("stretch.weft.friction.tau", 0.008, 0.001, "1"),
        parameter("bend.weft.k", 6e-6, 9e-6, "N m"), fixed("bend.warp.k", 3e-6, "N m")}},
      {"nuisance",
       {cord("stretch-weft.clip0.1.cord_friction", 0.1),
        cord("stretch-weft.clip1.1.cord_friction", 0.15)}},
      {"work",
       {{"equilibria", 100},
        {"newton_iterations", 300},
        {"factorizations", 220},
        {"differentiated", 80},
        {"equilibria_by_differences", 340},
        {"seconds", {{"equilibria", 6}, {"derivatives", 3}, {"rest", 3}}}}},
      {"experiments", {experiment("stretch-weft", true), experiment("bend-weft", false)}},
      {"stages",
       {{{"component", "stretch.weft"}, {"name", "1 control point"}, {"accepted", true}},
        {{"component", "stretch.weft"}, {"name", "2 control points"}, {"accepted", true}},
        {{"component", "stretch.weft"}, {"name", "3 control points"}, {"accepted", false}}}},
      {"assumptions", {"search: began twice"}}}
      .dump(1);
}

std::string evaluation_json() {
  return json{{"pliant", "evaluation/1"},
              {"name", "two sheets"},
              {"experiments", {experiment("stretch-weft", true), experiment("bend-weft", false)}}}
      .dump(1);
}

/// Both clips, along x.
std::string force_rows(const report::SheetSession& sheet) {
  std::string csv =
      "frame,clip,axis,specimen,strain,branch,used,measured_force_N,predicted_force_N\n";
  for (int frame = 0; frame < sheet.frame_count(); ++frame) {
    for (std::size_t clip = 0; clip < 2; ++clip) {
      const auto force = [&](const Session& session) {
        return session.frames[static_cast<std::size_t>(frame)].cords[clip].front().force.x();
      };
      csv += fmt::format("{},clip{},x,1,0.1,load,1,{},{}\n", frame, clip, force(sheet.measured),
                         force(sheet.predicted));
    }
  }
  return csv;
}

void write_sheet(const std::filesystem::path& directory, const report::SheetSession& sheet) {
  const std::filesystem::path folder = directory / "sheets" / sheet.measured.test;
  write_session(folder / "measured", sheet.measured);
  write_session(folder / "predicted", sheet.predicted);
}

}  // namespace

Session stretched_sheet(int frames, double extension, double stiffness) {
  Session session =
      test::clamped_sheet("stretch-weft", kSheetNodes,
                          {test::side(kSheetNodes, 0, false), test::side(kSheetNodes, 0, true)});
  const Eigen::RowVectorXd from_middle = session.rest.positions.row(0).array() - kSheetSide / 2;
  const double grip = kSheetSide / (kSheetNodes - 1);
  const double free_half = kSheetSide / 2 - grip;
  for (int f = 0; f < frames; ++f) {
    const double now = extension * f / std::max(frames - 1, 1);
    SessionFrame frame;
    frame.positions = session.rest.positions;
    frame.positions.row(0).array() += (from_middle.array() / free_half).max(-1).min(1) * (now / 2);
    for (const double sign : {-1.0, 1.0}) {
      Pose pose;
      pose.translation.x() = sign * now / 2;
      frame.poses.push_back(pose);
    }
    session.frames.push_back(frame);
    pull_clips(session, f, stiffness * now);
  }
  return session;
}

Session hanging_sheet(int frames) {
  Session session = test::clamped_sheet("bend-weft", kSheetNodes, {});
  session.table = RestAxis::u;
  for (int f = 0; f < frames; ++f) {
    SessionFrame frame;
    frame.table_edge = kSheetSide / 2;
    frame.positions = session.rest.positions;
    const double angle = 0.2 * f;
    for (auto point : frame.positions.colwise()) {
      const double beyond = point.x() - kSheetSide / 2;
      if (beyond <= 0) continue;
      point.x() = kSheetSide / 2 + beyond * std::cos(angle);
      point.z() = -beyond * std::sin(angle);
    }
    session.frames.push_back(frame);
  }
  return session;
}

report::SheetSession with_residuals(const Session& measured, double offset, double force) {
  report::SheetSession sheet{measured, measured};
  for (int f = 0; f < measured.frame_count(); ++f) {
    SessionFrame& frame = sheet.predicted.frames[static_cast<std::size_t>(f)];
    for (const int node : report::free_nodes(measured, f)) frame.positions(2, node) += offset;
    for (std::size_t clip = 0; clip < frame.cords.size(); ++clip) {
      frame.cords[clip].front().force.x() += clip == 0 ? -force : force;
    }
  }
  return sheet;
}

void write_sample_sheets(const std::filesystem::path& directory, bool evaluation) {
  const report::SheetSession stretch = with_residuals(stretched_sheet(5, 5e-3, 100), 1e-3, 0.02);
  const report::SheetSession bend = with_residuals(hanging_sheet(4), 2e-3, 0);
  write_sheet(directory, stretch);
  write_sheet(directory, bend);
  const std::string header = "component,strain,load,unload,low,high,elastic,friction_max\n";
  if (evaluation) {
    write_text(directory / "evaluation.json", evaluation_json());
    write_text(directory / "curves.csv", header);
  } else {
    write_text(directory / "fit.json", fit_json());
    write_text(directory / "material.json", material_text(test::sheet_cloth(true)));
    write_text(directory / "curves.csv",
               header + "stretch.weft,0,0,0,0,0,0,2\nstretch.weft,0.1,10,6,9,11,8,2\n");
  }
  write_text(directory / "predictions/stretch-weft.csv", force_rows(stretch));
  write_text(directory / "predictions/bend-weft.csv",
             "frame,place,axis,specimen,strain,branch,used,measured_height_mm,predicted_height_mm\n"
             "0,60 mm,z,1,0.5,load,1,0,2\n");
}

}  // namespace pliant::testing
