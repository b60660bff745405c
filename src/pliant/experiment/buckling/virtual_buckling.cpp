#include "pliant/experiment/buckling/virtual_buckling.h"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "pliant/base/quantity.h"
#include "pliant/experiment/buckling/clamped_strip.h"
#include "pliant/experiment/sampled_path.h"
#include "pliant/io/csv_writer.h"

namespace pliant {
namespace {

constexpr int kElements = 6;  // a fit takes 2

SampledPath clamp_path(const LabExperiment& experiment) {
  std::vector<double> peaks;
  for (const double peak : experiment.peaks) peaks.push_back(experiment.length * (1 - peak));
  const double start = experiment.length - experiment.slack;
  const double reach = start - *std::min_element(peaks.begin(), peaks.end());
  return sample_path(cycle_turns(start, peaks, experiment.repeats),
                     reach / (experiment.samples - 1));
}

void move(ClampedStrip& strip, double distance, const LabExperiment& experiment) {
  if (strip.move_to(distance, /*with_derivatives=*/false)) return;
  throw SolverError(fmt::format("virtual experiment {}: with its clamps {:.4g} mm apart the strip "
                                "finds no equilibrium; its force",
                                experiment.name, distance * 1e3),
                    0, 0);
}

}  // namespace

std::string measure_buckling(const LabExperiment& experiment, const ComponentLaw& law,
                             double density, RandomStream& random) {
  const SampledPath path = clamp_path(experiment);
  ClampedStrip strip(law, density * kStandardGravity, experiment.strip_length, experiment.side,
                     kElements);
  const Instrument& instrument = experiment.instrument;
  const double rows = static_cast<double>(path.value.size());
  const std::vector<std::string> header{"force_N", "distance_mm", "cycle"};
  CsvWriter csv(header);
  for (const Stretch& stretch : path.stretches) {
    for (int i = stretch.first; i <= stretch.last; ++i) {
      const double distance = path.value[static_cast<size_t>(i)];
      move(strip, distance, experiment);
      const double force = experiment.width * strip.shape().far_load.x() + experiment.force_offset +
                           experiment.force_drift * i / (rows - 1);
      csv.cell(measured(force, instrument.force_noise, instrument.force_resolution, random));
      csv.cell(1e3 *
               measured(distance, instrument.length_noise, instrument.length_resolution, random));
      csv.cell(path.cycle[static_cast<size_t>(i)]);
      csv.end_row();
    }
    move(strip, stretch.turn, experiment);
  }
  return csv.text();
}

}  // namespace pliant
