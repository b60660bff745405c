#pragma once

#include <string>
#include <utility>
#include <vector>

#include "pliant/exchange/u3m_import.h"
#include "pliant/exchange/u3m_physics.h"

namespace pliant {

/// A test of a U3M record on its way into a study.
struct ImportedTest {
  std::string name;       ///< of the experiment, e.g. warp-stretch-8cm
  std::string direction;  ///< warp, weft or bias
  double width = 0;       ///< of the strip, m
  U3mTest test;
};

/// When and how the tests were made, as `info:` entries of the study: dates (UTC), the order of the
/// tests of each direction, sampling rates, thickness.
std::vector<std::pair<std::string, std::string>> conduct_entries(
    const std::vector<ImportedTest>& tests, const U3mPhysics& physics);

/// What the import understood: every test's rows, cycles and ranges, strip widths, the order of the
/// tests, and why there is no time column.
std::vector<std::string> import_notes(const std::vector<ImportedTest>& tests,
                                      const U3mPhysics& physics, const ImportOptions& options);

/// Tests whose half cycles do not go to and fro.
std::vector<std::string> segment_warnings(const std::vector<ImportedTest>& tests);

}  // namespace pliant
