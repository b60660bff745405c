#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A shear test (KES-FB1). PROTOCOL.md says how to measure, this file what was measured.
# The numbers here and in shear.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

density: 150 g/m^2    # mass of a piece of the fabric divided by its area

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31, instrument: KES-FB1}
conditions: {temperature: 20 degC, humidity: 65 %}

experiments:
  - name: shear
    type: shear-cycles
    standard: KES-FB1
    data: shear.csv
    # One file a specimen: a pattern takes them all.
    # data: shear-*.csv
    # The constant pull across the shear; it resists the angle, and its share is taken off.
    transverse_tension: 10 gf/cm
    # noise: {force: 0.05 N/m}
    # exclude: [{rows: 12-18, reason: clamp slip}]
)yaml";

constexpr char kTable[] =
    R"csv(# One row for each sample, in the order in which it was recorded: out, back, to the other side, back.
# angle_deg: shear angle, 0 when warp and weft are at right angles; both signs
# force_N_per_m: shear force per width of the specimen (or force_gf_per_cm, as KES-FB1 prints it)
# cycle: may be left out; time_s may be added
angle_deg,force_N_per_m,cycle
0,0.01,1
1,1.89,1
2,2.87,1
3,3.65,1
4,4.35,1
5,5.05,1
6,5.73,1
7,6.46,1
8,7.16,1
7,3.64,1
6,2.32,1
5,1.56,1
4,0.90,1
3,0.23,1
2,-0.38,1
1,-0.98,1
0,-1.63,1
-1,-2.29,1
-2,-2.96,1
-3,-3.66,1
-4,-4.35,1
-5,-5.09,1
-6,-5.71,1
-7,-6.43,1
-8,-7.15,1
-7,-3.62,1
-6,-2.33,1
-5,-1.55,1
-4,-0.87,1
-3,-0.21,1
-2,0.38,1
-1,1.03,1
0,1.67,1
1,2.26,1
2,2.96,1
3,3.68,1
4,4.32,1
5,5.04,1
6,5.77,1
7,6.46,1
8,7.14,1
)csv";

constexpr char kProtocol[] = R"md(# Shear cycles (KES-FB1): protocol

**Purpose.** The force that turns warp and weft against each other, on the way out and on the way back.
The loop between the two is the friction where yarns cross; it decides how the fabric drapes and
wrinkles.

**Standards.** The shear test of the Kawabata system (KES-FB1). Conditioning: ISO 139 (20 degC, 65 %
relative humidity, at least 24 h, flat, without load).

**Samples.** 200 mm wide, 50 mm between the clamps, plus what the clamps hold. At least three with the
warp across the clamps and three with the weft, from different places, none within 150 mm of the
selvedge. Mark the warp with an arrow on every specimen before you cut it, and cut along the yarns: a
specimen that is cut askew starts at an angle. Use every specimen once: it remembers what was done to
it.

**You need.** A KES-FB1 tester, or a picture frame or parallel clamps that record while they return. The
raw record is needed: the printed G, 2HG and 2HG5 are not enough.

**Procedure**

1. Zero the force with the empty clamps; check that the clamps are parallel.
2. Clamp the specimen flat, yarns at right angles to the jaws, and apply the transverse tension: 10 gf/cm
   (9.8 N/m), the same for all specimens. For fabrics that wrinkle under the shear, take more and say so.
3. Shear at 0.417 mm/s from 0 to +8 degrees, back through 0 to -8 degrees, and again to +8 degrees. The
   last way closes the loop: the first one starts from an unknown state.
4. No pause at the reversals.
5. Record force and angle at least every 0.2 degrees, in one file.
6. Look at the specimen at the largest angle: stop at a smaller one if it folds.
7. The next specimen gets a file of its own; `data: shear-*.csv` in study.yaml takes all of them.

**Write down.** Width, clamp distance, transverse tension, speed, largest angle; density; date, lot,
operator, temperature, humidity. Keep the file of the machine as it is.

**Precision.** Force to 1 % of the largest, angle to 0.05 degrees. Friction shows as the step of the
force within the first degree after each reversal.

**Frequent mistakes**

- Only one way is recorded, or only the printed G and 2HG: friction then cannot be determined.
- The machine thins its samples: the reversals, where the force changes fastest, are lost.
- The transverse tension is not stated, or drifts. It adds its tangent of the angle to the force and is
  taken for stiffness.
- The force is given in gf for the whole width. It must be per width, N/m or gf/cm.
- The zero of the angle is that of the machine, but the specimen was clamped askew: the loop is shifted.
- The specimen folds at the largest angles: those rows are no shear. Leave them out with `exclude`.
- The specimen was sheared by hand before, to feel it.
)md";

}  // namespace

TestTemplate shear_cycles_template() {
  return {{{"study.yaml", kStudy}, {"shear.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
