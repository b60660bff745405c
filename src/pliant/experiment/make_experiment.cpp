#include "pliant/experiment/make_experiment.h"

#include "pliant/base/assert.h"
#include "pliant/experiment/buckling_bend.h"
#include "pliant/experiment/cantilever.h"
#include "pliant/experiment/hanging_weights.h"
#include "pliant/experiment/overhangs.h"
#include "pliant/experiment/pure_bending.h"
#include "pliant/experiment/rolled_strip.h"
#include "pliant/experiment/shear_cycles.h"
#include "pliant/experiment/tensile_cycles.h"

namespace pliant {

std::unique_ptr<Experiment> make_experiment(const ExperimentSpec& spec, double density,
                                            MembraneMeasure measure) {
  if (spec.type == "hanging-weights")
    return std::make_unique<HangingWeights>(spec, density, measure);
  if (spec.type == "tensile-cycles") return std::make_unique<TensileCycles>(spec, measure);
  if (spec.type == "cantilever") return std::make_unique<Cantilever>(spec, density);
  if (spec.type == "rolled-strip") return std::make_unique<RolledStrip>(spec, density);
  if (spec.type == "bending-length") return std::make_unique<Overhangs>(spec, density);
  if (spec.type == "buckling-bend") return std::make_unique<BucklingBend>(spec, density);
  if (spec.type == "pure-bending") return std::make_unique<PureBending>(spec);
  PLIANT_ASSERT(spec.type == "shear-cycles", "the caller asks is_supported_type first");
  return std::make_unique<ShearCycles>(spec);
}

}  // namespace pliant
