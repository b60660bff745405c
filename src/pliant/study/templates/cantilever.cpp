#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A cantilever test: strips that stick out of a clamp and bend under their own weight. PROTOCOL.md
# says how to measure, this file what was measured.
# The numbers here and in warp-overhangs.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

density: 255 g/m^2    # mass of a piece of the fabric divided by its area; its weight is the load here

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31}
conditions: {temperature: 20 degC, humidity: 65 %}

experiments:
  - name: warp-overhangs
    type: cantilever
    direction: warp   # the yarns that are bent, along the strip: warp, weft or bias (45 degrees)
    data: warp-overhangs.csv
    # One file a strip: a pattern takes them all.
    # data: warp-overhangs-*.csv
    width: 25 mm                       # for the record: it changes nothing
    # noise: {position: 0.15 mm}       # how well a point can be read off the photograph, if known
    # exclude: [{rows: 4-6, reason: hidden by the clamp}]   # rows of the table, counted from 1

# Friction does not show here, where the strip is bent once: add rolled strips to this study for it
# (`pliant init rolled-strip`).
)yaml";

constexpr char kTable[] =
    R"csv(# One row for each point that you read off a photograph, from the clamp (point 0) to the free end.
# overhang_mm: length of cloth that sticks out of the clamp; repeat: 1, 2, 3 with the same overhang
# x_mm: away from the clamp, level; y_mm: upwards, so that the strip's are negative
overhang_mm,repeat,point,x_mm,y_mm
40,1,0,0.0,0.0
40,1,1,4.0,-0.2
40,1,2,7.8,-0.3
40,1,3,12.0,-1.2
40,1,4,16.0,-1.4
40,1,5,19.9,-1.7
40,1,6,24.3,-2.2
40,1,7,27.7,-2.5
40,1,8,31.7,-3.1
40,1,9,35.6,-3.9
40,1,10,40.0,-4.4
70,1,0,0.0,0.0
70,1,1,6.7,-1.7
70,1,2,12.4,-5.5
70,1,3,17.0,-10.9
70,1,4,21.6,-16.6
70,1,5,25.3,-22.3
70,1,6,29.2,-28.0
70,1,7,33.3,-34.0
70,1,8,37.1,-39.7
70,1,9,40.8,-45.8
70,1,10,44.4,-51.2
100,1,0,0.0,0.0
100,1,1,9.1,-3.8
100,1,2,14.3,-12.4
100,1,3,17.8,-21.7
100,1,4,20.5,-31.3
100,1,5,23.1,-41.0
100,1,6,25.1,-50.8
100,1,7,26.9,-60.4
100,1,8,29.3,-70.2
100,1,9,31.1,-80.1
100,1,10,33.2,-90.0
)csv";

constexpr char kProtocol[] = R"md(# Cantilever: protocol

**Purpose.** How stiffly the fabric bends. A strip that sticks out of a clamp bends under its own
weight; its whole profile at several lengths gives the stiffness and how it changes with curvature.

**Standards.** Conditioning: ISO 139 (20 degC, 65 % relative humidity, at least 24 h, flat, without
load). Strips: cut and handled as for ISO 9073-7 or ASTM D1388 (cantilever). The evaluation of the
whole profile, in place of one length at 41.5 degrees, follows Clapp, Peng, Ghosh and Eischen,
*Indirect measurement of the moment-curvature relationship for fabrics* (1990).

**Samples.** Strips of 25 mm x 150 mm, at least three for each direction (warp, weft; bias at 45 degrees
if wanted), from different places, none within 150 mm of the selvedge, without creases. Mark the warp
with an arrow on every strip, and its face, before you cut it.

**You need.** A table with a straight, level edge, a plate to clamp the strip on it, a ruler that stands
in the plane of the strip, a camera on a tripod, a balance.

**Procedure**

1. Weigh a piece of known size: mass / area is the density. All results are in proportion to it.
2. Put the camera level with the edge, at least 1 m away, looking along the edge, so that the strip is
   seen exactly from its side. Zoom in rather than go near: a near camera distorts.
3. Iron the strip flat without pulling, or press it under a plate; let it lie for 10 min.
4. Lay it along the table, its end flush with the edge, and put the plate on it.
5. Push strip and plate out together to the first overhang, slowly and never back: about 40 mm, or
   where the end sinks by a tenth of the length. Keep your breath and draughts away.
6. Wait 30 s and take the photograph, with the ruler in it. Always wait equally long.
7. Go on to three or four overhangs, the longest with its end pointing almost straight down.
8. Take the strip off, flatten it, turn it over and repeat: fabrics that curl differ on the two faces.
   Give the second face an experiment of its own.
9. On each photograph, set the scale by the ruler and read 10 to 25 points along the middle line of the
   strip, with any program that shows coordinates (ImageJ, WebPlotDigitizer): first the edge of the
   table where the strip leaves it, last the free end, in that order, about equally far apart. The x axis
   is level and points away from the table, y points upwards.

**Write down.** Overhangs, repeats, face; density; date, lot, operator, temperature, humidity. Keep the
photographs.

**Precision.** Points to 0.2 mm, scale to 0.5 %, axes level to 0.3 degrees. Overhang to 0.5 mm.

**Frequent mistakes**

- The camera looks from above or from the front: the profile is foreshortened.
- The ruler stands nearer to the camera than the strip: everything is scaled.
- The strip was pushed too far and pulled back: friction then holds it up. Flatten it and start again.
- The strip twists or curls across its width: choose a direction or a width without it, or say so.
- Point 0 is the end of the clamp's shadow, not the edge at which the strip is free.
- Points are read in any order, or the free end is left out.
- y is counted downwards, as pixels are.
)md";

}  // namespace

TestTemplate cantilever_template() {
  return {{{"study.yaml", kStudy}, {"warp-overhangs.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
