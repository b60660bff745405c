#include "pliant/report/html.h"

#include <fmt/format.h>

namespace pliant::report {

std::string escape_html(std::string_view text) {
  std::string escaped;
  escaped.reserve(text.size());
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        escaped += c;
    }
  }
  return escaped;
}

std::string element(std::string_view tag, std::string_view text) {
  return fmt::format("<{0}>{1}</{0}>\n", tag, escape_html(text));
}

std::string bullet_list(const std::vector<std::string>& texts) {
  if (texts.empty()) return {};
  std::string html = "<ul>\n";
  for (const std::string& text : texts) html += element("li", text);
  return html + "</ul>\n";
}

std::string warning_section(const std::vector<std::string>& warnings) {
  if (warnings.empty()) return {};
  return "<section class=\"warnings\"><h2>Warnings</h2>\n" + bullet_list(warnings) + "</section>\n";
}

std::string fact_list(const std::vector<std::pair<std::string, std::string>>& facts) {
  std::string html = "<dl class=\"facts\">\n";
  for (const auto& [name, value] : facts) {
    html +=
        fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", escape_html(name), escape_html(value));
  }
  return html + "</dl>\n";
}

HtmlTable::HtmlTable(std::vector<Column> columns, std::string css_class)
    : columns_(std::move(columns)), css_class_(std::move(css_class)) {}

void HtmlTable::begin_row(std::string_view css_class) {
  if (!rows_.empty()) rows_ += "</tr>\n";
  rows_ += css_class.empty() ? "<tr>" : fmt::format("<tr class=\"{}\">", css_class);
  next_column_ = 0;
}

void HtmlTable::cell(std::string_view text) { html_cell(escape_html(text)); }

void HtmlTable::html_cell(std::string_view html) {
  const Align align = columns_.at(next_column_++).align;
  const std::string_view css_class = align == Align::number ? " class=\"number\""
                                     : align == Align::unit ? " class=\"unit\""
                                                            : "";
  rows_ += fmt::format("<td{}>{}</td>", css_class, html);
}

std::string HtmlTable::html() const {
  std::string html =
      fmt::format("<div class=\"table-box\"><table class=\"{}\">\n<thead><tr>", css_class_);
  for (const Column& column : columns_) {
    html += fmt::format("<th scope=\"col\"{}>{}",
                        column.align == Align::number ? " class=\"number\"" : "",
                        escape_html(column.heading));
    if (!column.explanation.empty()) {
      html += fmt::format("<small>{}</small>", escape_html(column.explanation));
    }
    html += "</th>";
  }
  html += "</tr></thead>\n<tbody>\n" + rows_;
  if (!rows_.empty()) html += "</tr>\n";
  return html + "</tbody></table></div>\n";
}

std::string fact_table(const std::vector<std::pair<std::string, std::string>>& facts) {
  HtmlTable table({{"Item"}, {"Value"}});
  for (const auto& [name, value] : facts) {
    if (value.empty()) continue;
    table.begin_row();
    table.cell(name);
    table.cell(value);
  }
  return table.html();
}

}  // namespace pliant::report
