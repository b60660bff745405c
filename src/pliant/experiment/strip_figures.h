#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/plausibility.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/test_spec.h"

namespace pliant {

/// The rows of a strip that is pulled between clamps.
struct PulledRows {
  std::string column, unit;    ///< that its stretch was read from: length, extension or strain
  std::vector<double> length;  ///< between the clamps (m)
  std::vector<double> force;   ///< N
  bool is_turned = false;      ///< the file counts a pull negative
  bool is_driven = false;      ///< by a machine, not by what weights there are
  bool comes_back = false;     ///< unbroken
};

/// The figures of a strip, by which its units and sizes are judged: what it measures and weighs, as
/// far as that is stated, and what is added of its test.
class StripFigures : public Plausibility {
 public:
  /// @param density  kg/m^2; 0 = not stated, and one that no cloth has says as little
  StripFigures(const TestSpec& size, double density);

  /// How far the strip is stretched, by which load, and how stiff that makes it.
  /// @return a slip of another kind than a unit or a size; what follows from it is not added
  std::optional<std::string> add_pull(const PulledRows& rows, Reading force);
  /// How fast: one time (s) a row; nothing where none was measured.
  void add_rate(const PulledRows& rows, const std::vector<double>& time, Reading clock);
  /// A shear stiffness (N/m) that goes with some powers.
  void add_shear_stiffness(double stiffness, std::vector<Power> powers);
  /// A bending stiffness (N m) that goes with some powers.
  void add_bending_stiffness(double stiffness, std::vector<Power> powers);

  /// Of the sizes that are stated.
  Reading length() const { return length_; }
  Reading width() const { return width_; }

 private:
  /// Figures that only together are those of no fabric, of a strip whose weight is known.
  /// @param load, stiffness  N/m
  void add_of_weighed(const PulledRows& rows, Figure load, const Figure& strain, Figure stiffness);
  void add_by_weight(const FabricFigure& by_weight, const FabricFigure& alone, double per_width,
                     std::vector<Power> powers);

  double gauge_length_, strip_width_, density_;
  Reading length_ = 0, width_ = 0, weight_ = 0;
};

/// Whether a loop gives back more work than it took, as where its two columns are swapped.
std::optional<std::string> swap_question(const ComponentExperiment& experiment,
                                         std::string_view abscissa, std::string_view ordinate);

/// The first of several judgements that asks anything: the others follow from the same slip.
std::vector<std::string> first_asked(std::initializer_list<std::optional<std::string>> questions);

}  // namespace pliant
