#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace pliant::report {

/// Text made safe for HTML content and double-quoted attributes.
std::string escape_html(std::string_view text);

/// `<tag>escaped text</tag>`
std::string element(std::string_view tag, std::string_view text);

/// `<ul>` of escaped texts; empty for none.
std::string bullet_list(const std::vector<std::string>& texts);

/// A section of warnings; empty for none.
std::string warning_section(const std::vector<std::string>& warnings);

/// `<dl>` of names and values that stand side by side where there is room; both are escaped.
std::string fact_list(const std::vector<std::pair<std::string, std::string>>& facts);

/// Builds an HTML table whose cells are escaped unless given as HTML.
class HtmlTable {
 public:
  enum class Align { text, unit, number };  ///< units and numbers are not broken
  struct Column {
    std::string heading;
    Align align = Align::text;
    std::string explanation = {};  ///< small print under the heading
  };

  explicit HtmlTable(std::vector<Column> columns, std::string css_class = {});

  void begin_row(std::string_view css_class = {});
  void cell(std::string_view text);
  void html_cell(std::string_view html);

  bool empty() const { return rows_.empty(); }
  /// The table in a box that scrolls sideways where the page is narrow.
  std::string html() const;

 private:
  std::vector<Column> columns_;
  std::string css_class_;
  std::string rows_;
  std::size_t next_column_ = 0;
};

/// A table of names and values, those without value left out.
std::string fact_table(const std::vector<std::pair<std::string, std::string>>& facts);

}  // namespace pliant::report
