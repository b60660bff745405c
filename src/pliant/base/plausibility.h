#pragma once

#include <optional>
#include <string>
#include <vector>

#include "pliant/base/fabric_figures.h"

namespace pliant {

bool is_plausible(const FabricFigure& figure, double value);

/// Whether the figures of a measurement are those of a fabric; where they are not, which unit or
/// size would make them so: the slip that is likely.
class Plausibility {
 public:
  /// What figures were computed from, and may be a slip.
  using Reading = std::size_t;
  struct Power {
    Reading reading;
    double exponent = 1;
  };

  /// A column, in the unit that it was read in; an empty one: SI.
  Reading column(std::string name, Dimension dimension, std::string unit);
  /// A size that a document states (SI).
  Reading field(std::string name, Dimension dimension, double value);

  /// A number that goes with powers of some readings.
  struct Figure {
    double value;
    std::vector<Power> powers;
  };

  /// A figure that goes with powers of some readings.
  void add(const FabricFigure& figure, double value, std::vector<Power> powers);
  /// The same, which is asked for only where another number is above or below a limit.
  void add_above(double limit, const Figure& other, const FabricFigure& figure,
                 const Figure& value);
  void add_below(double limit, const Figure& other, const FabricFigure& figure,
                 const Figure& value);

  /// E.g. "the strain reaches 1500 %: is `extension` in mm, not m? (fabrics: 0.05 % to 400 %)";
  /// nothing where all figures are plausible.
  std::optional<std::string> question() const;

 private:
  /// A name, and what else it may be.
  struct Source {
    std::string name;
    Dimension dimension;
    std::string unit;             // of a column
    std::optional<double> value;  // of a field
  };
  /// What a figure is asked for: `other` within the limits.
  struct Condition {
    Figure other;
    double least, most;
  };
  struct Shown {
    const FabricFigure* range;
    Figure figure;
    std::optional<Condition> condition;
  };
  /// A reading that is too large or small by a factor, in words.
  struct Slip {
    std::string words;
    double distance = 0;  // of the figures from the middles of their ranges, were it mended
  };

  /// A figure with a reading that is mended by a factor.
  static double mended(const Figure& figure, Reading reading, double factor);
  /// The same of what is asked for then; nothing where it is not.
  static std::optional<double> asked(const Shown& shown, Reading reading, double factor);
  std::vector<Slip> slips() const;
  void try_slip(Reading reading, double factor, std::string words, std::vector<Slip>& slips) const;

  std::vector<Source> sources_;
  std::vector<Shown> shown_;
};

}  // namespace pliant
