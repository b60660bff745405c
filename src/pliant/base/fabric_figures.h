#pragma once

#include <string_view>

#include "pliant/base/quantity.h"

namespace pliant {

/// A figure of a fabric or of its test, and the range in which it is met: beyond it a number is
/// questioned (plausibility.h), not refused.
struct FabricFigure {
  std::string_view sentence;  ///< with {} for the value
  Dimension dimension;
  double least, most;  ///< SI
};

// The table of all ranges. Cloth is compared by its own weight, which sorts fabrics better than any
// force per width: chiffon and denim differ by 20 in weight, and not by more when it is taken out.
namespace figures {

using enum Dimension;

// Chiffon and tulle from 10 g/m^2, felt, duck and coated cloth to 1.5 kg/m^2.
inline constexpr FabricFigure kAreaDensity{"the cloth weighs {}", area_density, 0.008, 2};
// What is cut to strips and pulled: silk gauze from 17 g/m^2; nets and tissues below that are not.
inline constexpr FabricFigure kPulledDensity{"the strip that is pulled weighs {}", area_density,
                                             0.015, 2};
// Of felt, duck and coated cloth, pressed felt is the softest, with 800 m of stiffness (below).
inline constexpr double kStiffnessOfHeavyCloth = 700;  // m
inline constexpr FabricFigure kSoftDensity{"a strip as soft as this weighs {}", area_density, 0.015,
                                           1};

// 10 mm between the clamps of bending testers to 500 mm between the bench marks of ASTM D3107.
inline constexpr FabricFigure kLength{"the strip is {} long", length, 5e-3, 0.6};
// Single ribbons of 2.25 mm have been pulled; wide jaws take 200 mm, some 300 mm.
inline constexpr FabricFigure kWidth{"the strip is {} wide", length, 2e-3, 0.35};
// Of cloth whose weight is known: it is cut, and frays; ribbons are weighed by their length.
inline constexpr FabricFigure kCutWidth{"the strip is {} wide", length, 8e-3, 0.35};
// Pieces that are seen as a whole by cameras.
inline constexpr FabricFigure kSide{"a side of the sheet measures {}", length, 5e-3, 5};
// Cords that hold a sheet up carry its weight and that of its clips, as well as they are measured.
inline constexpr FabricFigure kCarried{"the cords carry {} of the weight of sheet and clips",
                                       fraction, 0.1, 10};
// A swatch of a simulation to the curtain of a stage.
inline constexpr FabricFigure kArea{"the cloth measures {}", area, 1e-4, 1e3};

// Below, the play of clamps and scales; above, no elastic knit: with elastane they go to 200 %.
inline constexpr FabricFigure kStrain{"the strain reaches {}", fraction, 5e-4, 2.5};
// Between clamps that were set at the gauge length, less slack, and more what a clip pulls.
inline constexpr FabricFigure kStart{"the clamps start at {} of the gauge length", fraction, 0.7,
                                     1.5};
// Creep tests to impacts; standards ask for 0.1 to 1 % of the gauge length a second.
inline constexpr FabricFigure kStrainRate{"the strip changes by {} of its length a second",
                                          fraction, 1e-6, 1};
// Loads as low as the cloth's own weight tell nothing. Yarns break under 15 (cotton) to 80 km
// (nylon) of themselves, and about half of a fabric's yarns lie along the pull.
inline constexpr FabricFigure kLoad{"the largest load is the weight of {} of the cloth", length, 2,
                                    4e4};
// Soft knits from 10 m. Fibres have 500 km (cotton) to 1000 km (polyester); crimp and the yarns
// across leave a fifth of it. Cloth of glass, aramid or carbon is stiffer.
inline constexpr FabricFigure kStiffness{
    "at its stiffness, stretching the strip to twice its length takes the weight of {} of the "
    "cloth",
    length, 3, 2e5};
// A fibre that is stiff along the cloth is met where it is loaded: at less than half a kilometre
// of itself a weave straightens its crimp. Kawabata's suitings and shirtings stretch by 1 to 10 %
// at 50 gf/cm, which is 17 km (of 300 g/m^2) to 33 km at the stiffest.
inline constexpr double kStraightensCrimp = 500;  // m
inline constexpr FabricFigure kCrimpStiffness{
    "under so small a load, stretching the strip to twice its length takes the weight of {} of "
    "the cloth",
    length, 3, 3e4};
// Load times strain, twice the work of a straight line. Knits of 300 g/m^2 take 8 to 20 m at the
// few newtons of a FAB, stiff weaves at 50 gf/cm one or more: less is hardly a test.
inline constexpr FabricFigure kWork{"load times strain of the pull would lift the cloth by {}",
                                    length, 0.4, 2e4};
// What is stretched that far and comes back does not break: knits and elastic weaves, of which
// power nets and stockings carry up to 1 km and break under 3 to 8 km.
inline constexpr double kFarStretch = 0.4;
inline constexpr FabricFigure kReturnedLoad{
    "stretched so far and released, the strip has carried the weight of {} of the cloth", length, 2,
    2e3};
// The same of cloth whose weight is not known: by the lightest and the heaviest.
inline constexpr FabricFigure kTension{"the largest load is {}", force_per_length, 0.2, 8e5};
inline constexpr FabricFigure kModulus{"the strip's stiffness is {}", force_per_length, 0.3, 4e6};
// What is hung by hand.
inline constexpr FabricFigure kHungWeight{"the largest weight is {}", force, 0.02, 200};
inline constexpr FabricFigure kClip{"the clip weighs {}", mass, 1e-4, 1};
// What hangs all the time leaves the strip something to feel of what is added.
inline constexpr FabricFigure kClipShare{"the clip weighs {} of the largest weight", fraction, 1e-6,
                                         3};

// Shear testers go to 8 degrees, frames to the locking angle of some 60.
inline constexpr FabricFigure kShearAngle{"the shear angle reaches {}", angle, 9e-3, 1.4};
// Kawabata's G is 0.2 to 5 gf/cm/deg: 11 to 280 N/m, of chiffon and jersey 15 m and of coated
// taffeta 400 m of cloth.
inline constexpr FabricFigure kShearStiffness{
    "the shear stiffness is the weight of {} of the "
    "cloth",
    length, 2, 2e3};
inline constexpr FabricFigure kShearModulus{"the shear stiffness is {}", force_per_length, 0.5,
                                            1e4};

// Bending testers go to 250 1/m; strips that are folded to a radius of a millimetre.
inline constexpr FabricFigure kCurvature{"the curvature reaches {}", curvature, 5, 2e3};
// The 618 fabrics of Feng et al. 2022, up to 0.87 kg/m^2, have 7 to 39 mm; raw denim and canvas to
// 55 mm.
inline constexpr FabricFigure kBendingLength{"the bending length is {}", length, 5e-3, 0.06};
// Felt, and reinforcements of glass: 140 to 160 mm of Broberg et al. 2022, at 1.4 kg/m^2.
inline constexpr FabricFigure kHeavyBendingLength{"the bending length is {}", length, 5e-3, 0.2};
inline const FabricFigure& bending_length_of(double density) {
  return density < 1 ? kBendingLength : kHeavyBendingLength;
}
// Of these fabrics: 0.2 uN m to 50 mN m.
inline constexpr FabricFigure kBendingStiffness{"the bending stiffness is {}", bending_stiffness,
                                                1e-7, 0.1};
// Cylinders that strips are wound on.
inline constexpr FabricFigure kRadius{"the radius is {}", length, 1e-3, 0.15};

}  // namespace figures

}  // namespace pliant
