#include "pliant/experiment/make_experiment.h"

#include "pliant/base/assert.h"
#include "pliant/experiment/bending/pure_bending.h"
#include "pliant/experiment/buckling/buckling_bend.h"
#include "pliant/experiment/cantilever/cantilever.h"
#include "pliant/experiment/hanging/hanging_weights.h"
#include "pliant/experiment/overhang/overhangs.h"
#include "pliant/experiment/rolled/rolled_strip.h"
#include "pliant/experiment/shear/shear_cycles.h"
#include "pliant/experiment/tensile/tensile_cycles.h"

namespace pliant {

std::unique_ptr<ComponentExperiment> make_experiment(const ExperimentSpec& spec,
                                                     const DataRows& data, double density,
                                                     MembraneMeasure measure) {
  if (spec.type == "hanging-weights") {
    return std::make_unique<HangingWeights>(spec, data, density, measure);
  }
  if (spec.type == "tensile-cycles") return std::make_unique<TensileCycles>(spec, data, measure);
  if (spec.type == "cantilever") return std::make_unique<Cantilever>(spec, data, density);
  if (spec.type == "rolled-strip") return std::make_unique<RolledStrip>(spec, data, density);
  if (spec.type == "bending-length") return std::make_unique<Overhangs>(spec, data, density);
  if (spec.type == "buckling-bend") return std::make_unique<BucklingBend>(spec, data, density);
  if (spec.type == "pure-bending") return std::make_unique<PureBending>(spec, data);
  PLIANT_ASSERT(spec.type == "shear-cycles", "the caller asks is_supported_type first");
  return std::make_unique<ShearCycles>(spec, data);
}

}  // namespace pliant
