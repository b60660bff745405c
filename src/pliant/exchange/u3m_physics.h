#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "pliant/exchange/u3m_file.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// A half cycle: the clamps move one way.
struct U3mSegment {
  std::vector<double> distance;  ///< between the clamps, m
  std::vector<double> force;     ///< N; compression is negative
};

enum class U3mTestKind { stretch, bend_down, bend_up };

/// One test of a strip (S1, S2, D1, D2, U1).
struct U3mTest {
  U3mTestKind kind = U3mTestKind::stretch;
  std::string name;                  ///< e.g. stretch-8cm
  double length = 0;                 ///< distance of the clamps at which the strip is straight, m
  std::optional<double> width;       ///< of the strip, m
  std::optional<double> frequency;   ///< of the samples within a segment, Hz
  std::optional<std::int64_t> time;  ///< s since 1970-01-01 UTC
  std::vector<U3mSegment> segments;  ///< loading and unloading in turn, as measured
};

/// The type of test that it is in a study.
const TestType& test_type_of(const U3mTest& test);

/// The tests along one direction of the fabric.
struct U3mDirection {
  std::string name;  ///< warp, weft or bias
  std::vector<U3mTest> tests;
};

/// The first contact of the thickness test; the pressed area is not in the file.
struct U3mThickness {
  double distance = 0;  ///< m
  double force = 0;     ///< N, compression
};

/// A U3M 1.1 physics record (measurements of a Fabric Analyzer) in SI units.
struct U3mPhysics {
  double density = 0;  ///< kg/m^2; 0 = not stated
  std::vector<U3mDirection> directions;
  std::optional<U3mThickness> thickness;
  std::vector<std::string> warnings;  ///< what is missing
};

/// Reads lengths in cm, forces in gram-force and mass in g/m^2, as numbers or as texts that hold
/// numbers. Tests that are missing, or have too few samples to show a curve, are left out with a
/// warning.
/// @throws InputError for values that are no measurement, for another version than 1.x, and when no
///         direction has a test
U3mPhysics read_u3m_physics(const U3mFile& file);

}  // namespace pliant
