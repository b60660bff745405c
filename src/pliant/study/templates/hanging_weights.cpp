#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A hanging-weights test. PROTOCOL.md says how to measure, this file what was measured.
# The numbers here and in warp-weights.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

# Mass of a piece of the fabric divided by its area. Half of the sample's own weight pulls, too.
density: 150 g/m^2

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31}
conditions: {temperature: 20 degC, humidity: 65 %}

defaults:
  length: 100 mm      # between the clamps, flat and without any load
  width: 100 mm

experiments:
  - name: warp-weights
    type: hanging-weights
    direction: warp   # the direction that is pulled: warp, weft or bias (45 degrees)
    data: warp-weights.csv
    clip_mass: 12 g   # everything that hangs below the cloth beside the weights: clip, hook, tray
    # noise: {length: 0.2 mm}                        # how well the length can be read, if known
    # exclude: [{rows: 4-6, reason: clip slipped}]   # rows of the table, counted from 1

# The second direction has a table of its own:
#  - name: weft-weights
#    type: hanging-weights
#    direction: weft
#    data: weft-weights.csv
#    clip_mass: 12 g

# Experiments that are predicted, not fitted, to see how far the result can be trusted:
# validate: [weft-weights]
)yaml";

constexpr char kTable[] = R"csv(# One row for each reading, in the order in which you took them.
# repeat: 1, 2, 3; peak_N: largest weight of the cycle; step: 0, 1, 2, ... within the cycle
# weight_N: weights on the clip, without the clip (1 N is 102 g; a column weight_g is read, too)
# length_mm: length of the cloth between the clamps
repeat,peak_N,step,weight_N,length_mm
1,1,0,0,102.3
1,1,1,1,122.9
1,1,2,0,109.9
1,2,0,0,110.0
1,2,1,1,122.9
1,2,2,2,135.7
1,2,3,1,130.3
1,2,4,0,110.1
1,3,0,0,110.1
1,3,1,1,122.9
1,3,2,2,135.8
1,3,3,3,145.1
1,3,4,2,141.7
1,3,5,1,131.0
1,3,6,0,110.1
)csv";

constexpr char kProtocol[] = R"md(# Hanging weights: protocol

**Purpose.** How much the fabric stretches under a load, and how much of the stretch stays when the
load goes. The difference between loading and unloading is the fabric's internal friction, so both
are measured.

**Standards.** Conditioning: ISO 139 (20 degC, 65 % relative humidity, at least 24 h, flat, without
load). Strips: cut and marked as for ISO 20932-1 or ASTM D5035 (ravelled edges for wovens, cut edges
for knits). The sequence of weights is that of *Measurement-Based Model Estimation for Deformable
Objects* (2014), section 5.3.2.

**Samples.** 100 mm x 100 mm between the clamps, plus what the clamps hold. At least three for each
direction (warp, weft; bias if shear matters), from different places, none within 150 mm of the
selvedge. Mark the warp with an arrow on every sample before you cut it, and draw the two clamp lines
100 mm apart on the flat, relaxed cloth. Use every sample once: it remembers what was done to it.

**You need.** A wall or board, a clamp above and a light clip below, both as wide as the sample; six
weights of 1 N (102 g each); a ruler, or a camera opposite the sample; a balance.

**Procedure**

1. Weigh the clip with its hook. Weigh a piece of known size: mass / area is the density.
2. Clamp the sample along its upper line and fix the clip along the lower one, without stretching it.
3. Read the length under the clip alone. This is step 0 (weight 0).
4. Add 1 N gently: lower the weight by hand, never let it drop or swing.
5. Wait 30 s, then read the length in the middle of the sample. Always wait equally long.
6. Cycle n = 1: weights 0, 1, 0 N. Then n = 2: 0, 1, 2, 1, 0 N. Go on to n = 6, or to the load
   that the fabric meets in use: 0, 1, ..., n, ..., 1, 0 N, one newton at a time, up and down.
7. Do not flatten, pull or unclip the sample between the cycles.
8. Repeat the whole sequence three times on the same sample (column `repeat`).
9. The next sample gets a file of its own; `data: warp-*.csv` in study.yaml takes all of them.

**Write down.** Every reading in the order taken, also the doubtful ones (leave them out with
`exclude` and say why); clip mass, length, width, density; date, lot, operator, temperature, humidity.

**Precision.** Length to 0.2 mm: friction shows as a few millimetres between the way up and the way
down. Weights to 1 %.

**Frequent mistakes**

- Only loading is recorded. Without the way back, friction cannot be determined.
- A weight was dropped, or put on and taken off again: the true peak is higher than the one written.
- The waiting time varies: the cloth creeps, and creep is taken for friction.
- The weight of the clip is forgotten. It is stated once, in study.yaml, and not added to `weight_N`.
- The length is read to the edge of the clip at one end and to the clamp line at the other.
- The sample is slack or wavy at step 0: let it hang straight under the clip before you read.
- The clamp slips: check the clamp lines after each cycle.
)md";

}  // namespace

TestTemplate hanging_weights_template() {
  return {{{"study.yaml", kStudy}, {"warp-weights.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
