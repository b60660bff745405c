#pragma once

#include <string>
#include <string_view>

#include "pliant/report/figure.h"
#include "pliant/report/labels.h"

namespace pliant::report {

/// A unit in which numbers are of a readable size, and what they are multiplied with to be in it.
struct ReadableUnit {
  std::string name;
  double factor = 1;
};

/// A unit of force, or of force and length, with the prefix for numbers of that size: `N m` and
/// 3e-6 -> `µN m`. Numbers from 0.1 to 10000 keep their unit, and so do all of other units.
/// @param size  in that unit; 0 and what is no number: no prefix
ReadableUnit readable_unit(std::string_view unit, double size);

/// Gives a figure's axis its title, in a readable unit, and its traces numbers in that unit.
/// @param axis_letter  'x' or 'y', whose traces are there already
void set_readable_axis(Figure& figure, char axis_letter, const QuantityLabel& label,
                       bool compact = false);

}  // namespace pliant::report
