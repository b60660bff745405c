#pragma once

#include <string>
#include <string_view>

namespace pliant {

/// A figure that a standard or a system of instruments reads off a cloth.
struct TextileFigure {
  std::string_view name;      ///< in files: "kes_B"
  std::string_view standard;  ///< "KES-FB2"
  std::string_view symbol;    ///< "B"
  std::string_view meaning;   ///< for readers of a report
  std::string_view unit;      ///< SI; "1" of shares
  std::string_view lab_unit;  ///< as laboratories write it
  double per_si;              ///< value in the lab's unit = per_si * SI value
  /// Within which figures of apparel fabrics usually lie, from chiffon to coating (lab's unit);
  /// both 0: nothing usual is known.
  double usual_least = 0, usual_most = 0;
};

/// A value as laboratories write it: "3.2 %", "0.19 gf cm^2/cm".
/// @param si  in the SI unit of the figure
std::string in_lab_unit(const TextileFigure& figure, double si);

/// @return null where no standard has a figure of that name
const TextileFigure* find_textile_figure(std::string_view name);

}  // namespace pliant
