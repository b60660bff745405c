#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/base/stopwatch.h"
#include "pliant/experiment/moved_body/moved_body_type.h"
#include "pliant/experiment/stored_rows.h"
#include "pliant/material/material_samples.h"
#include "pliant/material/solid/standard_solids.h"
#include "pliant/study/body_samples.h"

#include "solids/bodies.h"
#include "solids/solid_labs.h"

namespace pliant {
namespace {

/// Of 5,184 tetrahedra.
VirtualMovedBody fine_block() {
  VirtualMovedBody test = test::moved_block();
  test.setup.mesh = block_of_tetrahedra({0.04, 0.02, 0.02}, {16, 6, 9});
  test.setup.held = nodes_at(test.setup.mesh, 0, 0);
  test.setup.moved = nodes_at(test.setup.mesh, 0, 0.04);
  return test;
}

// [T] 4.2.4: a number at each of 300 places.
TEST(SlowManySamples, StayFast) {
  const test::LabFolder folder(
      test::measurements_of(test::lab_of(neo_hookean_solid(5e3, 50e3), {fine_block()}), 1));
  const Study study =
      test::solid_study(folder, "law: neo-hookean, samples: {grid: [10, 6, 5], of: [I1-bar]}");
  const ExperimentSpec& spec = study.experiments.front();
  const auto experiment = spec.test->type().make_solid(spec, DataRows(spec.data));
  Material material = neo_hookean_solid(5e3, 50e3);
  const auto uniform = experiment->predictor(material);
  material.samples = body_samples(study);
  for (SampledComponents& sample : material.samples.at) {
    sample.components["I1-bar"] = material.components.at("I1-bar");
  }
  const auto predictor = experiment->predictor(material);
  const auto seconds_of = [&](Predictor& one, std::size_t by) {
    std::vector<int> numbers(by);
    std::iota(numbers.begin(), numbers.end(), 0);
    StoredRows rows(*experiment, std::ssize(numbers));
    const Stopwatch watch;
    EXPECT_TRUE(one.predict(one.values(), numbers, {}, rows));
    return watch.seconds();
  };
  const double alone = seconds_of(*uniform, 0), sampled = seconds_of(*predictor, 0);
  const double derived = seconds_of(*predictor, 300);
  fmt::print(
      "two frames from rest {:.2f} s, of 300 samples {:.2f} s, with their derivatives {:.2f} s\n",
      alone, sampled, derived);
  EXPECT_LT(sampled, 2 * alone);
  EXPECT_LT(derived, 4 * alone);
}

}  // namespace
}  // namespace pliant
