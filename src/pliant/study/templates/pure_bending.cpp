#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A pure-bending test (KES-FB2). PROTOCOL.md says how to measure, this file what was measured.
# The numbers here and in bending.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

density: 150 g/m^2    # mass of a piece of the fabric divided by its area

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31, instrument: KES-FB2}
conditions: {temperature: 20 degC, humidity: 65 %}

experiments:
  - name: warp-bending
    type: pure-bending
    standard: KES-FB2
    direction: warp            # the yarns that are bent: warp, weft, or bias (cut at 45 degrees)
    data: bending.csv
    # One file a specimen: a pattern takes them all.
    # data: warp-*.csv
    # The machine's own names of the columns:
    # data: {file: warp.txt, columns: {curvature: "K [1/cm]", moment: "M [gf.cm/cm]"}}
    # noise: {moment: 0.001 gf cm/cm}
    # exclude: [{rows: 12-18, reason: clamp slip}]
)yaml";

constexpr char kTable[] =
    R"csv(# One row for each sample, in the order in which it was recorded: out, back, to the other side, back.
# curvature_1_per_cm: of the specimen, positive with the face outside; both signs (or curvature_1_per_m)
# moment_gf_cm_per_cm: bending moment per width of the specimen (or moment_mN, moment_N: N m per m)
# cycle, time_s may be added
curvature_1_per_cm,moment_gf_cm_per_cm
0,0.0040
0.25,0.0502
0.5,0.0756
0.75,0.1021
1,0.1285
1.25,0.1542
1.5,0.1809
1.75,0.2054
2,0.2320
2.25,0.2575
2.5,0.2835
2.25,0.1622
2,0.1423
1.75,0.1226
1.5,0.1027
1.25,0.0839
1,0.0632
0.75,0.0418
0.5,0.0230
0.25,0.0026
0,-0.0172
-0.25,-0.0411
-0.5,-0.0680
-0.75,-0.0951
-1,-0.1197
-1.25,-0.1461
-1.5,-0.1726
-1.75,-0.1985
-2,-0.2243
-2.25,-0.2499
-2.5,-0.2762
-2.25,-0.1542
-2,-0.1331
-1.75,-0.1148
-1.5,-0.0949
-1.25,-0.0747
-1,-0.0540
-0.75,-0.0352
-0.5,-0.0140
-0.25,0.0042
0,0.0243
0.25,0.0499
0.5,0.0754
0.75,0.1015
1,0.1282
1.25,0.1544
1.5,0.1800
1.75,0.2058
2,0.2327
2.25,0.2582
2.5,0.2838
)csv";

constexpr char kProtocol[] = R"md(# Pure bending (KES-FB2): protocol

**Purpose.** The moment that bends the fabric to a curvature, on the way out and on the way back. The
loop between the two is the friction between fibres and yarns; it is what makes folds stay.

**Standards.** The bending test of the Kawabata system (KES-FB2). Conditioning: ISO 139 (20 degC, 65 %
relative humidity, at least 24 h, flat, without load).

**Samples.** 200 mm wide, 10 mm between the clamps, plus what the clamps hold; 100 mm or less of width
for stiff fabrics, so that the sensor is not overloaded. At least three in which the warp is bent (warp
across the gap between the clamps) and three for the weft, from different places, none within 150 mm of
the selvedge, free of folds. Mark the warp and the face on every specimen before you cut it, and cut
along the yarns. Use every specimen once: it remembers what was done to it.

**You need.** A KES-FB2 tester, or another that bends to one curvature everywhere and records while it
returns. The raw record is needed: the printed B and 2HB are not enough.

**Procedure**

1. Zero the moment without a specimen, at curvature zero.
2. Clamp the specimen upright, straight and without tension; it must not sag or bulge.
3. Bend at 0.5 1/cm per second from 0 to +2.5 1/cm, back through 0 to -2.5 1/cm, and again to
   +2.5 1/cm. The last way closes the loop: the first one starts from an unknown state.
4. No pause at the reversals.
5. Record moment and curvature at least every 0.05 1/cm, in one file.
6. For stiff fabrics stop at a smaller curvature, the same on both sides, rather than overload the
   sensor; for fabrics with much friction add cycles to half of the largest curvature.
7. The next specimen gets a file of its own; `data: warp-*.csv` in study.yaml takes all of them.
8. The weft is another experiment, `direction: weft`.

**Write down.** Width, clamp distance, rate, largest curvature, which side is positive; density; date,
lot, operator, temperature, humidity. Keep the file of the machine as it is.

**Precision.** Moment to 1 % of the largest, curvature to 0.02 1/cm. Friction shows as the step of the
moment within the first 0.2 1/cm after each reversal.

**Frequent mistakes**

- Only one way is recorded, or only the printed B and 2HB: friction then cannot be determined.
- The machine thins its samples: the reversals, where the moment changes fastest, are lost.
- Warp and weft are mixed up: `direction` is that of the yarns that are bent, not of the clamps.
- The moment is given in gf cm for the whole width. It must be per width, gf cm/cm or N.
- A curled specimen shifts the loop; that is allowed for (moment offset), but note it down.
- The fabric was folded or wound on a narrow roll before: it then starts from its history.
- The weight of a wide, limp specimen bends it as well: clamp it upright.
)md";

}  // namespace

TestTemplate pure_bending_template() {
  return {{{"study.yaml", kStudy}, {"bending.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
