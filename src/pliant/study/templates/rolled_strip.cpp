#include "pliant/study/templates/templates.h"

namespace pliant {
namespace {

constexpr char kStudy[] =
    R"yaml(# A rolled-strip test: strips that were rolled around cylinders and let go. PROTOCOL.md says how to
# measure, this file what was measured.
# The numbers here and in warp-rolls.csv are an example: replace them with yours.
pliant: study/1
name: example fabric

density: 255 g/m^2    # mass of a piece of the fabric divided by its area; its weight bends the strip

# Free texts, copied to the report: what identifies the fabric and the test.
# info: {lot: A7, operator: KL, date: 2024-05-31}
conditions: {temperature: 20 degC, humidity: 65 %}

experiments:
  - name: warp-rolls
    type: rolled-strip
    direction: warp   # the yarns that are bent, along the strip: warp, weft or bias (45 degrees)
    data: warp-rolls.csv
    # One file a strip: a pattern takes them all.
    # data: warp-rolls-*.csv
    length: 100 mm                     # from the clamp to the free end, along the strip
    width: 25 mm                       # for the record: it changes nothing
    # noise: {position: 0.15 mm}       # how well a point can be read off the photograph, if known
    # exclude: [{rows: 16-30, reason: the strip touched the table}]   # counted from 1

# Overhanging strips of the same fabric, fitted together with these, say more about its stiffness
# (`pliant init cantilever`):
#  - name: warp-overhangs
#    type: cantilever
#    direction: warp
#    data: warp-overhangs.csv
)yaml";

constexpr char kTable[] =
    R"csv(# One row for each point that you read off a photograph, from the clamp (point 0) to the free end.
# radius_mm: of the cylinder; negative where the strip was rolled to the other side (downwards)
# repeat: 1, 2, 3 with the same cylinder
# x_mm: away from the clamp, level, where the strip leaves it; y_mm: upwards
radius_mm,repeat,point,x_mm,y_mm
4,1,0,0.0,0.0
4,1,1,5.7,3.7
4,1,2,3.0,9.8
4,1,3,-3.8,9.3
4,1,4,-8.2,4.0
4,1,5,-10.4,-3.2
4,1,6,-10.8,-10.1
4,1,7,-10.5,-17.2
4,1,8,-10.0,-24.3
4,1,9,-8.4,-31.5
4,1,10,-4.9,-37.8
4,1,11,1.1,-41.6
4,1,12,7.6,-41.2
4,1,13,12.3,-35.8
4,1,14,11.6,-29.1
8,1,0,0.0,0.0
8,1,1,6.2,3.1
8,1,2,8.2,9.9
8,1,3,4.4,15.4
8,1,4,-2.5,15.9
8,1,5,-7.9,11.3
8,1,6,-10.4,5.1
8,1,7,-11.3,-2.3
8,1,8,-10.9,-9.3
8,1,9,-9.8,-16.4
8,1,10,-6.3,-22.7
8,1,11,-0.7,-26.5
8,1,12,6.5,-26.3
8,1,13,11.3,-21.2
8,1,14,11.0,-14.4
16,1,0,0.0,0.0
16,1,1,7.0,1.4
16,1,2,12.7,5.9
16,1,3,15.8,12.2
16,1,4,16.2,19.0
16,1,5,12.6,25.2
16,1,6,7.5,29.8
16,1,7,0.3,31.6
16,1,8,-6.5,30.3
16,1,9,-12.3,26.0
16,1,10,-15.7,19.8
16,1,11,-16.7,13.0
16,1,12,-14.5,6.0
16,1,13,-9.8,0.6
16,1,14,-3.4,-2.6
50,1,0,0.0,0.0
50,1,1,6.5,-2.4
50,1,2,11.4,-7.3
50,1,3,14.9,-13.8
50,1,4,16.7,-20.7
50,1,5,18.0,-27.8
50,1,6,19.1,-35.0
50,1,7,20.0,-41.8
50,1,8,21.7,-48.9
50,1,9,23.5,-55.8
50,1,10,26.6,-62.4
50,1,11,30.1,-68.6
50,1,12,34.2,-74.1
50,1,13,39.2,-79.2
50,1,14,44.9,-83.6
)csv";

constexpr char kProtocol[] = R"md(# Rolled strips: protocol

**Purpose.** The internal friction of bending: why a fabric that was folded or rolled does not come
back flat. A strip is rolled around a cylinder and let go; the coil that stays, at several radii, gives
the friction, its growth with curvature, and the stiffness.

**Standards.** Conditioning: ISO 139 (20 degC, 65 % relative humidity, at least 24 h, flat, without
load). There is no ISO or ASTM test of this kind. The method is that of *Modeling and Estimation of
Internal Friction in Cloth* (2013), section 4.3. Strips: as for ISO 9073-7 or ASTM D1388.

**Samples.** Strips of 25 mm x 100 mm plus what the clamp holds, at least three for each direction (warp,
weft), from different places, none within 150 mm of the selvedge. Mark the warp with an arrow on every
strip, and its face, before you cut it.

**You need.** Cylinders (rods, drills, tubes) with radii of 3, 4, 5, 6, 7, 7.5, 10, 16, 23, 27.5, 31.5 and
50 mm, or as many as you have over that range; a clamp with level jaws that holds the strip's end; a ruler
in the plane of the strip; a camera on a tripod; an iron or a plate and a weight; a balance.

**Procedure**

1. Weigh a piece of known size: mass / area is the density.
2. Put the camera at least 1 m away, level with the clamp, so that the strip is seen exactly from its
   side. Zoom in rather than go near.
3. Flatten the strip before every rolling: press it under a plate, rolled the other way before if it
   keeps a bend, until it lies flat. It must forget the last cylinder.
4. Clamp one end so that the strip leaves the jaws level.
5. Lay the cylinder on the strip and roll it up to the jaws, upwards, without pulling, so that all of the
   strip lies on the cylinder or on itself. Downwards counts as a negative radius: give that side its
   own experiment, since many fabrics differ on their two sides.
6. Unroll slowly, over several seconds, until the strip hangs free. Never let it spring.
7. Wait 30 s and take the photograph, with the ruler in it. Always wait equally long.
8. Three times for each cylinder, each time from step 3.
9. On each photograph, set the scale by the ruler and read 15 to 25 points along the strip, with any
   program that shows coordinates (ImageJ, WebPlotDigitizer): first where it leaves the jaws, last the
   free end, in that order, about equally far apart. x is level, away from the jaws; y points upwards.
10. Measure overhanging strips of the same fabric, too (`pliant init cantilever`).

**Write down.** Radius (half of what a caliper shows), side, repeat; length of the strip; density; date,
lot, operator, temperature, humidity. Keep the photographs.

**Precision.** Points to 0.2 mm, scale to 0.5 %, axes level to 0.3 degrees, radius to 1 %.

**Frequent mistakes**

- The strip was not flattened: it remembers a smaller cylinder.
- It sprang open, or was unrolled too far and came back: friction then holds another shape.
- Diameters were written for radii. A coil that is more curved than its cylinder is refused.
- The coil touches itself, the jaws or the table: leave that photograph out.
- The strip leaves the jaws at an angle, or its first point lies inside them.
- The coil winds sideways, out of the plane of the picture.
- Points are read in any order, or so far apart that the coil between them is lost.
)md";

}  // namespace

TestTemplate rolled_strip_template() {
  return {{{"study.yaml", kStudy}, {"warp-rolls.csv", kTable}, {"PROTOCOL.md", kProtocol}}};
}

}  // namespace pliant
