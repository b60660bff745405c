// How long a fit takes, and what one sample of a friction path costs, against the thesis' own
// method.

#include <benchmark/benchmark.h>

#include "pliant/experiment/hanging/weight_path.h"
#include "pliant/experiment/tensile/strip_pull.h"
#include "pliant/material/density/dahl_published.h"
#include "pliant/material/law_path.h"
#include "pliant/study/study_fit.h"

#include "support/virtual_lab.h"

namespace {

using namespace pliant;

// Table 5.1, warp of cotton/spandex.
ComponentLaw spandex() {
  return {ScalarCurve::affine(4.42, 32.19), FrictionLaw::dahl, {0.40, 4.84, 0.088}};
}

test::LabFolder measured(const test::AnyTest& experiment) {
  const Material fabric = test::made_up_material("stretch.warp", spandex());
  return test::LabFolder(test::measurements_of(test::lab_of(fabric, {experiment})));
}

// Weights of [T] 5.3.2 on spandex, read with a ruler.
test::LabFolder hung_weights() {
  auto experiment = test::hung_weights();
  experiment.instrument.length_noise = 0.2e-3;
  return measured(experiment);
}

// Cycles of a tensile tester.
test::LabFolder tensile_cycles() {
  auto experiment = test::strip_cycles({0.15, 0.3, 0.45, 0.6});
  experiment.width = 0.05;
  experiment.samples = 250;
  experiment.instrument.force_noise = 5e-3;
  return measured(experiment);
}

// 3 repeats x 6 hanging-weight cycles, 144 rows; data read once, as a fit reads it.
void fit_hanging_weights(benchmark::State& state, EstimatorKind estimator) {
  const test::LabFolder folder = hung_weights();
  Study study = folder.study();
  study.fit.estimator = estimator;
  for (auto _ : state) benchmark::DoNotOptimize(fit_study(study, {}, {}));
}
BENCHMARK_CAPTURE(fit_hanging_weights, path, EstimatorKind::path)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fit_hanging_weights, anchor_as_published, EstimatorKind::anchor)
    ->Unit(benchmark::kMillisecond);

// Four nested cycles of a tensile tester, Hermite stiffness grown up to five control points.
void fit_tensile_cycles(benchmark::State& state) {
  const test::LabFolder folder = tensile_cycles();
  const Study study = folder.study();
  for (auto _ : state) benchmark::DoNotOptimize(fit_study(study, {}, {}));
}
BENCHMARK(fit_tensile_cycles)->Unit(benchmark::kMillisecond);

// One sample of a path of a million, exact solution.
void exact_friction_sample(benchmark::State& state) {
  const DahlParameters dahl{0.40, 4.84, 0.088};
  FrictionState point{0.1, 0.2};
  double strain = 0.1, step = 1e-4;
  for (auto _ : state) {
    strain += step;
    if (strain > 0.6 || strain < 0.05) step = -step;
    point = {strain, friction_stress(dahl, strain, point).stress};
    benchmark::DoNotOptimize(point);
  }
}
BENCHMARK(exact_friction_sample);

// The same with the papers' approximation (Eq. 5.3).
void published_friction_sample(benchmark::State& state) {
  const DahlParameters dahl{0.40, 4.84, 0.088};
  FrictionState point{0.1, 0.2};
  double strain = 0.1, step = 1e-4;
  for (auto _ : state) {
    strain += step;
    if (strain > 0.6 || strain < 0.05) step = -step;
    point = {strain, published_friction_stress(dahl, strain, point).stress};
    benchmark::DoNotOptimize(point);
  }
}
BENCHMARK(published_friction_sample);

// Time of one sample of a tensile record: force alone, and with the derivatives that a fit needs.
void strip_sample(benchmark::State& state) {
  const bool derivatives = state.range(0) != 0;
  std::vector<double> lengths;
  for (int i = 0; i < 2000; ++i) lengths.push_back(0.1 + 0.06 * std::abs((i % 500) / 250.0 - 1));
  const auto half_cycles = half_cycles_of(lengths, 1e-4);
  const UniaxialGeometry geometry{0.1, 0.05, MembraneMeasure::stvk};
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        pull_strip(spandex(), geometry, {}, {}, lengths, half_cycles, derivatives ? 5 : 0));
  }
  state.counters["per_sample"] = benchmark::Counter(
      2000, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}
BENCHMARK(strip_sample)->ArgName("derivatives")->Arg(0)->Arg(1);

}  // namespace
