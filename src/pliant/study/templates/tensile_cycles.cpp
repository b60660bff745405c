#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A tensile load-unload test. PROTOCOL.md says how to measure, this file what was measured.
# The numbers here and in warp-cycles.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

density: 150 g/m^2    # mass of a piece of the fabric divided by its area

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31, instrument: 50 N tester}
conditions: {temperature: 20 degC, humidity: 65 %}

defaults:
  length: 100 mm      # gauge length: between the clamps when the strip is straight but not pulled
  width: 50 mm

experiments:
  - name: warp-cycles
    type: tensile-cycles
    direction: warp   # the direction that is pulled: warp, weft or bias (45 degrees)
    data: warp-cycles.csv
    # One file a strip: a pattern takes them all.
    # data: warp-*.csv
    # A file as the testing machine wrote it: say which column is which.
    # data: {file: raw.csv, columns: {force: "Load (N)", extension: "Extension (mm)"}, skip_rows: 3}
    # pretension: 50 mN                # under which the gauge length was set
    # precondition_cycles: 1           # first cycles that only prepare the strip
    # apparatus_friction: 10 mN        # of guides and bearings, found by cycling without a strip
    # noise: {force: 5 mN, length: 0.02 mm}
    # exclude: [{rows: 12-18, reason: jaw slip}]

# Experiments that are predicted, not fitted, to see how far the result can be trusted:
# validate: [warp-second-strip]
)yaml";

constexpr char kTable[] =
    R"csv(# One row for each sample, in the order in which it was recorded: loading, unloading, and so on.
# length_mm: distance of the clamps (or a column extension_mm: length minus gauge length)
# cycle: number of the load-unload cycle; may be left out
# time_s may be added; force may also be force_cN or force_gf
force_N,length_mm,cycle
-0.005,100.0,1
0.088,101.0,1
0.170,102.0,1
0.222,103.0,1
0.290,104.0,1
0.339,105.0,1
0.410,106.0,1
0.466,107.0,1
0.532,108.0,1
0.588,109.0,1
0.659,110.0,1
0.409,109.0,1
0.248,108.0,1
0.145,107.0,1
0.063,106.0,1
0.009,105.0,1
0.207,106.0,2
0.346,107.0,2
0.454,108.0,2
0.558,109.0,2
0.634,110.0,2
0.793,112.0,2
0.962,114.0,2
1.139,116.0,2
1.335,118.0,2
1.550,120.0,2
1.165,119.0,2
0.908,118.0,2
0.739,117.0,2
0.617,116.0,2
0.525,115.0,2
0.435,114.0,2
0.363,113.0,2
0.312,112.0,2
0.239,111.0,2
0.190,110.0,2
0.146,109.0,2
0.107,108.0,2
0.051,107.0,2
0.006,106.0,2
)csv";

constexpr char kProtocol[] = R"md(# Tensile load-unload cycles: protocol

**Purpose.** The force that stretches the fabric, on the way out and on the way back. The loop between
the two is the fabric's internal friction; cycles of growing amplitude show how it depends on strain.

**Standards.** Conditioning: ISO 139 (20 degC, 65 % relative humidity, at least 24 h, flat, without
load). Strips: ISO 20932-1 or ASTM D5035 (ravelled strips for wovens, cut strips for knits).

**Samples.** Strips of 50 mm x 100 mm between the clamps, plus what the clamps hold. At least three for
each direction (warp, weft, and bias at 45 degrees), from different places, none within 150 mm of
the selvedge and no two with the same yarns. Mark the warp with an arrow on every strip before you
cut it. Use every strip once: it remembers what was done to it.

**You need.** A tensile tester that records while it returns, with a load cell whose range is not much
above the forces in use (often 10 to 100 N), and clamps that hold without cutting.

**Procedure**

1. Zero the load cell with the empty upper clamp.
2. Set the clamps to the gauge length (100 mm) and check it with a gauge block.
3. Clamp the strip straight and without pull. If it needs a pretension to lie straight, use the same
   small one every time (about 1 % of the peak force) and write it as `pretension`.
4. Choose the largest strain that the fabric meets in use. Run four cycles, to 1/4, 1/2, 3/4 and
   all of it. Each goes out at 20 mm/min and back at the same speed until the force is zero.
5. No pause, or always the same one, at each reversal.
6. Record force and clamp distance at least 50 times for each half cycle, in one file for all cycles.
7. Do not re-zero, re-clamp or smooth the strip between the cycles.
8. Once a day: run the cycle without a strip. What the load cell shows is friction of the apparatus.
9. The next strip gets a file of its own; `data: warp-*.csv` in study.yaml takes all of them.

**Write down.** Gauge length, width, pretension, speed, pause; which strips were stretched before, and
how far; density; date, lot, operator, temperature, humidity. Keep the file of the machine as it is.

**Precision.** Force to 0.5 % of the peak force, clamp distance to 0.02 mm. A strip of 100 mm gives
these strains; a shorter one makes every slip of the clamps a larger strain.

**Frequent mistakes**

- Only loading is recorded, or the file stops at the peak. Without the way back, friction cannot be
  determined.
- The machine thins its samples: the reversals, where the force changes fastest, are lost.
- The force is not zero when the strip is slack. A constant offset is found and reported, a drift is
  not: let the load cell warm up.
- The strip starts slack. Those rows may stay in the file, they show the offset; but the gauge length
  must be the length at which the strip is straight.
- The speed or the pause differs between the cycles: the cloth creeps, and creep is taken for
  friction.
- The strip slips in the clamps (a sudden drop, or a loop that moves on with every cycle): mark the
  jaw line on the strip and look at it afterwards.
- The recorded distance is that of a motor, with backlash: record the position of the clamp itself.
)md";

}  // namespace

TestTemplate tensile_cycles_template() {
  return {{{"study.yaml", kStudy}, {"warp-cycles.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
