#include "pliant/report/figure.h"

#include <fmt/format.h>

#include "pliant/report/html.h"

namespace pliant::report {
namespace {

std::string dump(const nlohmann::json& value) {
  return value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// `<` never stands in the block: neither `</script>` nor `<!--` can end or change it.
std::string escape_for_script(std::string_view json) {
  std::string escaped;
  escaped.reserve(json.size());
  for (const char c : json) {
    if (c == '<') {
      escaped += "\\u003c";
    } else {
      escaped += c;
    }
  }
  return escaped;
}

std::string block(std::string_view id, const std::vector<std::string>& entries) {
  return fmt::format("<script type=\"application/json\" id=\"{}\">{{{}}}</script>\n", id,
                     escape_for_script(fmt::format("{}", fmt::join(entries, ",\n"))));
}

}  // namespace

std::string FigureSheet::add(const Figure& figure, std::string_view css_class) {
  const std::string id = fmt::format("figure-{}", entries_.size() + 1);
  entries_.push_back(fmt::format("\"{}\":{{\"data\":{},\"layout\":{}}}", id, dump(figure.traces),
                                 dump(figure.layout)));
  const std::string_view reason = can_draw_
                                      ? "This figure is drawn by a script, which has not run here."
                                      : "This build of Pliant has no drawing script.";
  return fmt::format(
      "<div class=\"figure {}\" id=\"{}\" role=\"img\" aria-label=\"{}\" data-print-width=\"{}\" "
      "data-print-height=\"{}\"><p class=\"note\">{} The numbers are in {}.</p></div>\n",
      css_class, id, escape_html(figure.description), figure.print_size.width,
      figure.print_size.height, reason, escape_html(figure.data_file));
}

std::string FigureSheet::add_view(const nlohmann::json& data, const std::string& description,
                                  const std::string& picture) {
  const std::string id = fmt::format("view-{}", views_.size() + 1);
  views_.push_back(fmt::format("\"{}\":{}", id, dump(data)));
  return fmt::format(
      "<div class=\"sheet-view\" id=\"{}\" role=\"group\" aria-label=\"{}\">{}</div>\n", id,
      escape_html(description), picture);
}

std::string FigureSheet::data_block() const {
  std::string html = block("figures", entries_);
  if (has_views()) html += block("sheet-views", views_);
  return html;
}

}  // namespace pliant::report
