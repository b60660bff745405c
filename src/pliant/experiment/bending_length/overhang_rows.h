#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/bending_length/bending_length.h"
#include "pliant/experiment/bending_length/dipping_strip.h"
#include "pliant/measurement/data_source.h"

namespace pliant {

/// The readings of an overhang test, row by row.
struct OverhangRows {
  std::vector<double> overhang;  ///< m
  std::vector<StripFace> face;   ///< up where the table does not say
};

/// @throws InputError for an overhang that is not positive, or an unknown face
OverhangRows read_overhangs(const DataRows& data);

/// The readings with one face up.
std::vector<double> overhangs_of(const OverhangRows& rows, StripFace face);

/// The spread of the readings of a face, or of both.
struct FaceSpread {
  std::string face;  ///< 1, 2, both
  BendingLengthSpread spread;
};

/// One for each face that was measured, and one for both where both were.
/// @param weight  per area (N/m^2); 0: not known
std::vector<FaceSpread> spread_by_face(const OverhangRows& rows, double angle, double weight);

/// The spread of the readings in a sentence for each face that was measured, and for both.
/// @param weight  per area (N/m^2); 0: not known, and no rigidity told
std::vector<std::string> bending_length_texts(const OverhangRows& rows, double angle,
                                              double weight);

}  // namespace pliant
