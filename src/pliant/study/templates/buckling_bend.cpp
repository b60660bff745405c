#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A buckling test: a strip between two clamps that come nearer and go back, and the force on a clamp.
# PROTOCOL.md says how to measure, this file what was measured.
# The numbers here and in warp-buckled.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

density: 300 g/m^2    # mass of a piece of the fabric divided by its area; its weight bends the strip along

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31, instrument: 1 N load cell}
conditions: {temperature: 20 degC, humidity: 65 %}

experiments:
  - name: warp-buckled
    type: buckling-bend
    direction: warp   # the yarns that are bent, along the strip: warp, weft or bias (45 degrees)
    data: warp-buckled.csv
    # One file a strip: a pattern takes them all.
    # data: warp-buckled-*.csv
    length: 21 mm                      # distance of the clamps at which the strip is straight
    width: 40 mm
    side: down                         # which way it buckles: along gravity (down) or against it (up)
    # rest_length: unknown             # the length is estimated along; needs strips of both sides
    # noise: {force: 0.2 mN}           # of the load cell, if known
    # exclude: [{rows: 1-4, reason: the strip had not buckled yet}]   # counted from 1

# A strip that buckles upwards, fitted together with this one, says more about its stiffness.
)yaml";

constexpr char kTable[] =
    R"csv(# One row for each sample, in the order in which it was recorded: nearer, back, nearer, and so on.
# force_N: on a clamp, tension positive; its zero need not be right
# distance_mm: between the clamps
# cycle: number of the cycle; may be left out. time_s may be added
force_N,distance_mm,cycle
-0.0094,20.00,1
-0.0101,19.54,1
-0.0104,19.08,1
-0.0111,18.61,1
-0.0109,18.15,1
-0.0120,17.69,1
-0.0121,17.23,1
-0.0121,16.76,1
-0.0125,16.30,1
-0.0130,15.84,1
-0.0102,16.13,1
-0.0076,16.59,1
-0.0062,17.05,1
-0.0050,17.51,1
-0.0041,17.98,1
-0.0037,18.44,1
-0.0029,18.90,1
-0.0024,19.36,1
-0.0013,19.83,1
-0.0061,19.71,2
-0.0090,19.25,2
-0.0104,18.79,2
-0.0107,18.33,2
-0.0108,17.86,2
-0.0114,17.40,2
-0.0120,16.94,2
-0.0122,16.48,2
-0.0127,16.01,2
-0.0130,15.55,2
-0.0139,15.09,2
-0.0137,14.63,2
-0.0144,14.16,2
-0.0152,13.70,2
-0.0154,13.24,2
-0.0158,12.78,2
-0.0136,12.89,2
-0.0109,13.35,2
-0.0095,13.81,2
-0.0082,14.27,2
-0.0076,14.74,2
-0.0062,15.20,2
-0.0062,15.66,2
-0.0055,16.13,2
-0.0051,16.59,2
-0.0046,17.05,2
-0.0043,17.51,2
-0.0037,17.98,2
-0.0032,18.44,2
-0.0023,18.90,2
-0.0015,19.36,2
-0.0003,19.83,2
)csv";

constexpr char kProtocol[] = R"md(# Buckled strips: protocol

**Purpose.** How the fabric bends, and its internal friction, on the tensile tester that stretches it: a
short strip between level clamps buckles when they come nearer, and pushes less on the way back.

**Standards.** Conditioning: ISO 139 (20 degC, 65 % relative humidity, at least 24 h, flat, without
load). There is no ISO or ASTM test of this kind; fabric analyzers of garment software make it.

**Samples.** Strips of 40 mm width, 20 mm between the clamps plus what they hold, at least three for each
direction (warp, weft, and bias at 45 degrees), from different places, none within 150 mm of the
selvedge. Mark the warp with an arrow on every strip, and its face, before you cut it.

**You need.** A tester that lies level, so that the strip is pulled and pushed horizontally, with a load
cell that shows 0.1 mN, and clamps that hold the strip flat and level; a balance.

**Procedure**

1. Weigh a piece of known size: mass / area is the density.
2. Press the strip flat; a strip that was bent before remembers it.
3. Clamp it straight and without pull. Their distance now is the length: measure it to 0.1 mm.
4. Push the strip's middle lightly down (or up) while the clamps come a millimetre nearer, so that it
   buckles to that side.
5. Run three cycles of growing amplitude, slowly: to 15, 25 and 40 % nearer, and each time back to about
   5 % nearer than straight. Never straighten it: it would be pulled.
6. Record force and clamp distance at least 20 times on each way, in one file for all cycles.
7. Take another strip, or press this one flat, and let it buckle to the other side. It gets an experiment
   of its own.
8. No draughts: breath moves the strip.

**Write down.** Length, width, side; speed; density; date, lot, operator, temperature, humidity. Keep the
file of the machine as it is.

**Precision.** Force to 0.1 mN, clamp distance to 0.01 mm, length to 0.1 mm. The zero of the force does
not matter, but it must stay, or drift evenly.

**Frequent mistakes**

- The strip is long: beyond about 40 mm it hangs rather than bends, and its weight is measured.
- Only one way is recorded: friction shows on the way back.
- The length is that of the programme, not of the strip between the clamps: measure it.
- The strip buckles in an S or to one side of its width: it was not clamped straight.
- The load cell warms up: a drift of 1 mN is a tenth of the signal.
- The strip touches the bench or itself.
)md";

}  // namespace

TestTemplate buckling_bend_template() {
  return {{{"study.yaml", kStudy}, {"warp-buckled.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
