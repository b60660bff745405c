#include "pliant/report/capture_figures.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "pliant/geometry/topology.h"
#include "pliant/io/base64.h"
#include "pliant/measurement/session/balance.h"
#include "pliant/report/html.h"
#include "pliant/report/plot_style.h"
#include "pliant/report/readable_unit.h"
#include "pliant/report/residual_colours.h"

namespace pliant::report {
namespace {

constexpr PrintSize kPrintSize{700, 240};
constexpr const char* kTable = "frames.csv";

/// Styles for series that have no names of their own elsewhere: told apart by colour and dash.
SeriesStyle series_style(std::size_t number, const char* group, const char* name) {
  static constexpr const char* kColours[] = {"#00538a", "#b34700", "#2e7d4f",
                                             "#7a4a8c", "#555f6b", "#1f2933"};
  static constexpr const char* kDashes[] = {"solid",   "6px,3px", "10px,4px",
                                            "1px,4px", "2px,3px", "8px,3px,2px,3px"};
  const std::size_t kind = number % std::size(kColours);
  return {group, name, kColours[kind], kDashes[kind], nullptr, 1.8};
}

struct Series {
  std::string name;
  std::vector<double> frames, values;
};

std::vector<double> all_frames(std::size_t count) {
  std::vector<double> frames(count);
  std::iota(frames.begin(), frames.end(), 0.0);
  return frames;
}

/// Names of series must live as long as their styles.
std::string frame_figure(const std::string& title, const std::string& explanation,
                         const QuantityLabel& label, const std::vector<Series>& all,
                         const char* data_file, FigureSheet& figures) {
  Figure figure;
  figure.layout = base_layout();
  std::vector<SeriesStyle> legend;
  for (const Series& series : all) {
    legend.push_back(series_style(legend.size(), series.name.c_str(), series.name.c_str()));
    figure.traces.push_back(trace(legend.back(), series.frames, series.values));
  }
  figure.layout["xaxis"] = axis({"Frame", ""});
  set_readable_axis(figure, 'y', label);
  figure.layout["yaxis"]["rangemode"] = "tozero";
  figure.description = title + " by frame";
  figure.data_file = data_file;
  figure.print_size = kPrintSize;
  std::string html = "<section class=\"figure-block\"><h2>" + escape_html(title) + "</h2>\n";
  if (figures.can_draw() && legend.size() > 1) html += legend_html(legend);
  return html + figures.add(figure, "figure-medium") + "<p class=\"small\">" +
         escape_html(explanation) + "</p></section>\n";
}

std::string seen_figure(const DicSession& made, FigureSheet& figures) {
  const std::vector<double> frames = all_frames(made.unseen.size());
  std::vector<Series> all{{"vertices of the mesh", frames, {}}};
  const double vertices = made.session.rest.vertex_count();
  for (const int unseen : made.unseen) all[0].values.push_back(100 * (1 - unseen / vertices));
  for (std::size_t c = 0; c < made.cameras.size(); ++c) {
    Series series{"squares of " + made.cameras[c], frames, {}};
    for (const auto& quality : made.qualities) {
      series.values.push_back(quality ? 100 * quality->share[c] : NAN);
    }
    all.push_back(std::move(series));
  }
  for (const LeftOutFrame& frame : made.left_out) {
    all[0].values[static_cast<std::size_t>(frame.frame)] = NAN;
  }
  return frame_figure("Seen",
                      "Of the mesh: vertices with points around them. Of a camera: squares that it "
                      "found again, in agreement with others.",
                      {"Share", "%"}, all, kTable, figures);
}

std::string match_figure(const DicSession& made, FigureSheet& figures) {
  if (made.cameras.empty()) return {};
  const std::vector<double> frames = all_frames(made.qualities.size());
  Series miss{"cameras miss each other", frames, {}}, back{"there and back", frames, {}},
      drift{"picture to picture would drift", frames, {}};
  if (made.misses.empty()) miss.name = "labels miss the plane";
  for (const auto& quality : made.qualities) {
    miss.values.push_back(quality ? quality->miss.value_or(NAN) : NAN);
    back.values.push_back(quality ? quality->matches.back : NAN);
    drift.values.push_back(quality ? quality->matches.drift : NAN);
  }
  std::vector<Series> all{back, drift};
  if (std::ranges::any_of(miss.values, [](double value) { return std::isfinite(value); })) {
    all.insert(all.begin(), miss);
  }
  return frame_figure(
      "Matches",
      "Medians. There and back: some squares of each frame are matched with the first picture "
      "again. Picture to picture: where following them without the first picture would have led.",
      {"Miss", "pixels"}, all, kTable, figures);
}

std::string force_figure(const DicSession& made, FigureSheet& figures) {
  if (made.force.empty()) return {};
  return frame_figure("Force", "As the log tells it.", {"Force", "N"},
                      {{"force", all_frames(made.force.size()), made.force}}, "middle.csv",
                      figures);
}

std::string balance_figure(const DicSession& made, FigureSheet& figures) {
  const Session& session = made.session;
  Series left{"sum of all forces", {}, {}}, bound{"bound of the cords", {}, {}};
  for (int f = 0; f < session.frame_count(); ++f) {
    const bool has_cords = std::ranges::any_of(session.frames[static_cast<std::size_t>(f)].cords,
                                               [](const auto& cords) { return !cords.empty(); });
    if (!has_cords) continue;
    const Imbalance rest = imbalance(session, f);
    for (Series* series : {&left, &bound}) {
      series->frames.push_back(made.used[static_cast<std::size_t>(f)]);
    }
    left.values.push_back(rest.force.norm());
    bound.values.push_back(rest.force_bound);
  }
  // Forces of a tester's log are made to balance.
  if (left.frames.size() < 2 || !made.force.empty() || session.table) return {};
  return frame_figure("Balance",
                      "What is left of cords and weight together: nothing where all forces were "
                      "measured and the sheet is still.",
                      {"Force", "N"}, {left, bound}, "sheet/cords.csv", figures);
}

std::string strain_figure(const DicSession& made, FigureSheet& figures) {
  if (!made.middle) return {};
  const std::vector<double> frames = all_frames(made.middle->strain.size());
  std::vector<Series> all{{"along the pull", frames, {}}, {"across it", frames, {}}};
  for (const double strain : made.middle->strain) all[0].values.push_back(100 * strain);
  for (const double strain : made.middle->lateral_strain) all[1].values.push_back(100 * strain);
  return frame_figure("Strain of the middle third", "Engineering strain.", {"Strain", "%"}, all,
                      "middle.csv", figures);
}

std::string slip_figure(const DicSession& made, FigureSheet& figures) {
  if (made.slips.empty()) return {};
  std::vector<Series> all;
  for (const ClipSlip& slip : made.slips) {
    Series series{slip.clip, all_frames(slip.slip.size()), {}};
    for (const double way : slip.slip) series.values.push_back(1e3 * way);
    all.push_back(std::move(series));
  }
  return frame_figure("Slip", "How far cloth has come out of a clip, by the points beside it.",
                      {"Slip", "mm"}, all, made.middle ? "middle.csv" : "sheet", figures);
}

/// Edges along weft and warp: diagonals say nothing of a grid.
bool is_mesh_line(const TriangleMesh& rest, const MeshEdge& edge) {
  const Eigen::Vector3d along =
      rest.positions.col(edge.vertices[0]) - rest.positions.col(edge.vertices[1]);
  return std::min(std::abs(along.x()), std::abs(along.y())) < 1e-9;
}

}  // namespace

std::string frame_figures(const DicSession& made, FigureSheet& figures) {
  return seen_figure(made, figures) + match_figure(made, figures) + force_figure(made, figures) +
         balance_figure(made, figures) + strain_figure(made, figures) + slip_figure(made, figures);
}

std::string mesh_picture(const ShownView& view, const TriangleMesh& rest) {
  std::string path;
  for (const MeshEdge& edge : find_edges(rest.triangles)) {
    if (!is_mesh_line(rest, edge)) continue;
    const Eigen::Vector2d from = view.vertices.col(edge.vertices[0]);
    const Eigen::Vector2d to = view.vertices.col(edge.vertices[1]);
    if (!from.allFinite() || !to.allFinite()) continue;
    // The middle of the first pixel is (0, 0).
    path += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", from.x() + 0.5, from.y() + 0.5,
                        to.x() + 0.5, to.y() + 0.5);
  }
  const std::string what = fmt::format("{}, frame {}", view.camera, view.frame);
  return fmt::format(
      "<figure><svg class=\"picture\" role=\"img\" aria-label=\"{0}\" viewBox=\"0 0 {1} {2}\">"
      "<image width=\"{1}\" height=\"{2}\" href=\"data:image/png;base64,{3}\"/>"
      "<path d=\"{4}\" fill=\"none\" stroke=\"#e05a00\" stroke-width=\"0.7\"/></svg>"
      "<figcaption>{0}</figcaption></figure>\n",
      escape_html(what), view.columns, view.rows, base64(view.png), path);
}

std::string region_picture(const RegionMisses& misses, double largest) {
  constexpr int kSide = 60;
  constexpr int kWidth = kSide * RegionMisses::kAcross, kHeight = kSide * RegionMisses::kDown;
  std::string svg = fmt::format(
      "<svg class=\"sheet-picture\" role=\"img\" aria-label=\"misses by region\" "
      "viewBox=\"0 0 {} {}\">",
      kWidth, kHeight);
  for (int down = 0; down < RegionMisses::kDown; ++down) {
    for (int across = 0; across < RegionMisses::kAcross; ++across) {
      const RegionMisses::Region& region = misses.at(across, down);
      const int x = kSide * across, y = kSide * down;
      svg += fmt::format(
          "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\" stroke=\"#fff\"/>", x, y,
          kSide, kSide, region.count > 0 ? residual_colour(region.rms() / largest) : "#f4f6f8");
      if (region.count == 0) continue;
      const Eigen::Vector2d to = region.mean() * (kSide / largest);
      svg += fmt::format(
          "<circle cx=\"{0}\" cy=\"{1}\" r=\"2\"/>"
          "<line x1=\"{0}\" y1=\"{1}\" x2=\"{2:.1f}\" y2=\"{3:.1f}\" stroke=\"#1f2933\" "
          "stroke-width=\"1.6\"/>",
          x + kSide / 2, y + kSide / 2, x + kSide / 2 + to.x(), y + kSide / 2 + to.y());
    }
  }
  return svg + "</svg>\n";
}

}  // namespace pliant::report
