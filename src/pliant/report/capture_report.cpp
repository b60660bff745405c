#include "pliant/report/capture_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/report/capture_figures.h"
#include "pliant/report/html.h"
#include "pliant/report/number_format.h"
#include "pliant/report/page.h"

namespace pliant {
namespace report {
namespace {

std::string verdict(const CaptureRecord& record) {
  const DicSession& made = record.made;
  std::string text =
      fmt::format("{} of {} frames are in the session.", made.used.size(), made.frame_count());
  if (!made.left_out.empty()) {
    text += fmt::format(" {} could not be used.", made.left_out.size());
  }
  if (!record.doubts.empty()) {
    text += fmt::format(" {} of them are to be distrusted.", record.doubts.size());
  } else if (!made.cameras.empty()) {
    text += " None of them is to be distrusted.";
  }
  const bool is_clean = record.doubts.empty() && record.warnings.empty();
  return fmt::format("<p class=\"verdict{}\">{}</p>\n", is_clean ? "" : " reservations",
                     escape_html(text));
}

std::string facts(const DicSession& made) {
  const auto length = [](double metres) { return format_quantity(metres, Dimension::length, 3); };
  std::vector<std::pair<std::string, std::string>> all{
      {"Sample", fmt::format("{} × {}", length(made.session.sample.width),
                             length(made.session.sample.height))},
      {"Mesh", fmt::format("{} vertices", made.session.rest.vertex_count())},
      {"Points", length(made.spacing) + " apart"}};
  if (!made.cameras.empty()) {
    all.emplace_back("Cameras", std::to_string(made.cameras.size()));
  }
  if (!made.time.empty()) {
    all.emplace_back("First frame",
                     fmt::format("{:.4g} s by the clock of the forces", made.time.front()));
  }
  if (made.session.noise.position) {
    all.emplace_back("Noise of a vertex", length(*made.session.noise.position));
  }
  if (made.off_plane > 0) all.emplace_back("Off the plane at rest", length(made.off_plane));
  return fact_list(all);
}

std::string picture_section(const CaptureRecord& record) {
  if (record.views.empty()) return {};
  const bool is_even = record.made.cameras.size() % 2 == 0;
  std::string html =
      fmt::format("<section><h2>The mesh over the pictures</h2>\n<div class=\"loops{}\">\n",
                  is_even ? " loops-2" : "");
  for (const ShownView& view : record.views) {
    html += mesh_picture(view, record.made.session.rest);
  }
  return html + "</div></section>\n";
}

std::string region_section(const DicSession& made) {
  double largest = 0;
  for (const RegionMisses& misses : made.misses) {
    largest = std::max(largest, misses.largest_rms());
  }
  if (largest == 0) return {};
  std::string html = "<section><h2>Cameras against each other</h2>\n<div class=\"loops\">\n";
  for (std::size_t c = 0; c < made.misses.size(); ++c) {
    const RegionMisses::Region whole = made.misses[c].whole();
    if (whole.count == 0) continue;
    html += "<figure>" + region_picture(made.misses[c], largest) +
            fmt::format("<figcaption>{}: {} px, mean ({:.2f}, {:.2f})</figcaption></figure>\n",
                        escape_html(made.cameras[c]), format_significant(whole.rms(), 2),
                        whole.mean().x(), whole.mean().y());
  }
  return html +
         fmt::format(
             "</div><p class=\"small\">By how much a camera misses, in a region of its "
             "picture, the points that it agrees on with others, all frames together. "
             "Colour: root mean square of a coordinate, up to {} px. Line: mean, at the same "
             "scale a square long; long ones that turn from region to region are a lens, "
             "long ones that point the same way a camera that was moved.</p></section>\n",
             format_significant(largest, 2));
}

std::string frame_section(const CaptureRecord& record) {
  HtmlTable table({{"Frame", HtmlTable::Align::number}, {"What became of it"}, {"Why"}});
  const auto row = [&](int frame, const char* fate, const std::string& why) {
    table.begin_row();
    table.cell(std::to_string(frame));
    table.cell(fate);
    table.cell(why);
  };
  for (const FrameDoubt& doubt : record.doubts) row(doubt.frame, "to be distrusted", doubt.why);
  for (const LeftOutFrame& frame : record.made.left_out) row(frame.frame, "left out", frame.why);
  for (const int frame : record.made.slack) {
    row(frame, "left out", frame == 0 ? "the sample lies on something" : "the sample hangs slack");
  }
  if (table.empty()) return {};
  return "<section><h2>Frames</h2>\n" + table.html() + "</section>\n";
}

}  // namespace
}  // namespace report

std::string make_capture_report(const CaptureRecord& record) {
  using namespace report;
  FigureSheet figures = page_figures();
  std::string body = "<header><h1>" + escape_html(record.name) +
                     " <span>how well it was seen</span></h1></header>\n";
  body += verdict(record) + facts(record.made) + warning_section(record.warnings);
  body += picture_section(record) + frame_figures(record.made, figures);
  body += region_section(record.made) + frame_section(record);
  body += "<section><h2>What was understood</h2>\n" + bullet_list(record.notes) + "</section>\n";
  return page(record.name + ": how well it was seen", body, figures);
}

}  // namespace pliant
