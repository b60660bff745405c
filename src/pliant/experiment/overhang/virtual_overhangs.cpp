#include "pliant/experiment/overhang/virtual_overhangs.h"

#include "pliant/base/quantity.h"
#include "pliant/experiment/overhang/dipping_strip.h"
#include "pliant/io/csv_writer.h"

namespace pliant {

std::string measure_overhangs(const LabExperiment& experiment, const ComponentLaw& law,
                              double density, RandomStream& random) {
  constexpr int kElements = 24;  // a fit takes 6
  const std::vector<std::string> header{"overhang_mm", "face", "repeat"};
  CsvWriter csv(header);
  for (const StripFace face : {StripFace::up, StripFace::down}) {
    const auto strip = dipping_strip(law, density * kStandardGravity, experiment.angle,
                                     {face, /*with_derivatives=*/false, kElements});
    if (!strip) {
      throw SolverError("virtual experiment " + experiment.name +
                            ": no overhang below 10 m dips as far as the angle; its prediction",
                        0, 0);
    }
    for (int repeat = 1; repeat <= experiment.repeats; ++repeat) {
      const Instrument& instrument = experiment.instrument;
      csv.cell(1e3 * measured(strip->overhang, instrument.length_noise,
                              instrument.length_resolution, random));
      csv.cell(face == StripFace::up ? 1 : 2).cell(repeat);
      csv.end_row();
    }
  }
  return csv.text();
}

}  // namespace pliant
