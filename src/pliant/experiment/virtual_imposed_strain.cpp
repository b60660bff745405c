#include "pliant/experiment/virtual_imposed_strain.h"

#include <algorithm>

namespace pliant {

std::string VirtualImposedStrain::rows(const ComponentLaw& law, const ClothFacts&,
                                       RandomStream& random) const {
  const auto [least, most] = std::minmax_element(peaks.begin(), peaks.end());
  require_samples(*least / (2 * *most));
  std::vector<double> turns{0};
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (const double peak : peaks) turns.insert(turns.end(), {peak, -peak});
  }
  turns.push_back(0);
  const SampledPath path = timed(sample_path(turns, 2 * *most / (samples - 1)));
  const std::unique_ptr<ComponentExperiment> experiment = on(path);
  const Prediction imposed = predicted(*experiment, law);

  const ImposedTable columns = table();
  return table_text(
      with_times({{columns.driver, path.value, columns.driver_per_si},
                  {columns.measured, {imposed.value.begin(), imposed.value.end()}, 1, force()}},
                 path),
      random);
}

}  // namespace pliant
