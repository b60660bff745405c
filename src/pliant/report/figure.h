#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace pliant::report {

/// How large a figure is, in CSS pixels, on paper; on the screen it is as wide as its column.
struct PrintSize {
  int width = 0;
  int height = 0;
};

/// One plot: plotly traces and layout, and the place of its numbers for those who want them.
struct Figure {
  nlohmann::json traces = nlohmann::json::array();
  nlohmann::json layout = nlohmann::json::object();
  std::string description;  ///< for screen readers
  std::string data_file;    ///< relative to the results directory
  PrintSize print_size;
};

/// Collects the figures of a report: their data go into one JSON block at its end.
class FigureSheet {
 public:
  /// @param can_draw  whether the report carries a drawing script
  explicit FigureSheet(bool can_draw) : can_draw_(can_draw) {}

  /// Takes a figure and returns the HTML that holds its place.
  /// @param css_class  decides the height on the screen
  std::string add(const Figure& figure, std::string_view css_class);

  /// Takes the data of a three-dimensional view and returns the HTML that holds its place, with a
  /// picture that stands there for readers without script, and on paper.
  /// @param picture  HTML
  std::string add_view(const nlohmann::json& data, const std::string& description,
                       const std::string& picture);

  bool can_draw() const { return can_draw_; }
  bool has_views() const { return !views_.empty(); }

  /// The JSON blocks, safe inside script elements.
  std::string data_block() const;

 private:
  bool can_draw_;
  std::vector<std::string> entries_;
  std::vector<std::string> views_;
};

}  // namespace pliant::report
