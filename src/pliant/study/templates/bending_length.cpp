#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A bending-length test (ASTM D1388 option A, ISO 9073-7): strips pushed over an edge until their tip
# touches a plane inclined by 41.5 degrees. PROTOCOL.md says how to measure, this file what was measured.
# The numbers here and in warp-overhangs.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

density: 180 g/m^2    # mass of a piece of the fabric divided by its area; its weight is the load here

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31}
conditions: {temperature: 20 degC, humidity: 65 %}

experiments:
  - name: warp-overhangs
    type: bending-length
    standard: ASTM D1388
    direction: warp   # the yarns that are bent, along the strip: warp, weft or bias (45 degrees)
    data: warp-overhangs.csv
    # angle: 41.5 deg                  # inclination of the instrument's plane
    width: 25 mm                       # for the record: it changes nothing
    # noise: {overhang: 0.5 mm}        # how well an overhang repeats, if known
    # exclude: [{rows: 4, reason: the strip twisted}]   # rows of the table, counted from 1

# One angle determines one number, the bending stiffness. How it changes with curvature shows in
# profiles (`pliant init cantilever`), friction in rolled strips (`pliant init rolled-strip`).
)yaml";

constexpr char kTable[] =
    R"csv(# One row for each reading.
# overhang_mm: length of cloth beyond the edge when the tip touches the plane (the slide's way)
# face: which side lies up, 1 or 2 (or top, bottom); repeat: 1, 2 for the two ends of the strip
# specimen: the strip, all its rows together
specimen,overhang_mm,face,repeat
1,46.5,1,1
1,47.0,1,2
1,44.5,2,1
1,45.0,2,2
2,48.0,1,1
2,47.5,1,2
2,45.5,2,1
2,46.0,2,2
3,46.0,1,1
3,46.5,1,2
3,44.0,2,1
3,44.5,2,2
4,47.5,1,1
4,47.0,1,2
4,45.5,2,1
4,45.0,2,2
)csv";

constexpr char kProtocol[] = R"md(# Bending length: protocol

**Purpose.** How stiffly the fabric bends, as one number: the bending length, half of the overhang at
which a strip dips by 41.5 degrees under its own weight, and the flexural rigidity that follows from it.

**Standards.** ASTM D1388 option A (cantilever), ISO 9073-7. Conditioning: ISO 139 (20 degC, 65 %
relative humidity, at least 24 h, flat, without load).

**Samples.** Strips of 25 mm x 200 mm (ISO 9073-7: 25 mm x 250 mm), at least four for each direction
(warp, weft; bias at 45 degrees if wanted), from different places, none within 150 mm of the selvedge,
without creases. Mark the warp with an arrow and the face on every strip before you cut it.

**You need.** A horizontal platform with a straight edge and a plane inclined by 41.5 degrees below it, a
slide with a ruler, a balance. Any inclination will do if study.yaml states it (`angle`).

**Procedure**

1. Weigh a piece of known size: mass / area is the density. All rigidities are in proportion to it.
2. Level the platform. Wipe it: a strip that clings to it is pushed together, not over the edge.
3. Lay the strip on the platform, face 1 up, its end flush with the edge, the slide on it.
4. Push slide and strip out together, about 120 mm a minute, slowly and never back. Keep your breath and
   draughts away.
5. Stop when the tip touches the plane. A strip that twists: take the middle of its tip.
6. Read the overhang off the slide's ruler.
7. Turn the strip round and read its other end (repeat 2), then turn it over for face 2, both ends.
8. The other direction gets an experiment of its own, `direction: weft`.

**Write down.** Overhang, face, end, strip; density; date, lot, operator, temperature, humidity.

**Precision.** Overhang to 0.5 mm: 1 % of the overhang is 3 % of the rigidity. Angle to 0.5 degrees.

**Frequent mistakes**

- The bending length is written down in place of the overhang, which is twice as long.
- The strip was pushed too far and pulled back: friction then holds it up. Flatten it and start again.
- The strip curls or twists by more than 45 degrees: the test says little then; use a wider strip.
- Faces are mixed: fabrics that curl differ on the two, and their mean hides it.
- The strip was creased or wound on a roll: it starts from its history.
- One number is taken for the whole law: it holds for curvatures like those of the strip alone.
)md";

}  // namespace

TestTemplate bending_length_template() {
  return {{{"study.yaml", kStudy}, {"warp-overhangs.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
