#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <vector>

#include "pliant/experiment/experiment_spec.h"
#include "pliant/io/fields.h"

namespace pliant {

struct HomogeneousSpec;

/// How a specimen of a solid is deformed, the same all over.
enum class HomogeneousMode {
  uniaxial,     ///< pulled along 1, free on its other sides
  equibiaxial,  ///< pulled alike along 1 and 2
  planar,       ///< pulled along 1, held at its width along 2 (pure shear)
  biaxial,      ///< pulled along 1 and 2, each its own way
};

std::string_view name_of(HomogeneousMode mode);

/// @throws InputError
HomogeneousMode read_mode(const Value& value);

/// What is done to a specimen at a row.
struct HomogeneousRow {
  HomogeneousMode mode = HomogeneousMode::uniaxial;
  double stretch = 1;                                        ///< along 1
  double stretch_2 = 1;                                      ///< along 2; of biaxial rows alone
  double seconds = std::numeric_limits<double>::infinity();  ///< that the way to it takes
};

/// Rows as they were measured.
struct HomogeneousRows {
  std::vector<HomogeneousRow> rows;
  std::vector<double> nominal_stress;  ///< along 1, force over rest area (Pa)
  std::vector<std::string> handled;    ///< how stretch and stress were found
};

/// Stretches from `stretch`, `strain`, `length` or `extension`; stresses from `nominal_stress`,
/// `stress` or `force`.
/// @throws InputError for stretches of 0 and below and for what is missing
HomogeneousRows read_rows(const HomogeneousSpec& spec, const Location& where, const DataRows& data);

}  // namespace pliant
