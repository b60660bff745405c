// Measurements that cannot be used are refused with file, line and column.

#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"

#include "io/input_error_of.h"
#include "support/study_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::StudyFolder;
using ::testing::HasSubstr;

struct RefusedData {
  const char* what;
  const char* type;
  const char* csv;
  int line;
  const char* column;
  const char* message;
};

void PrintTo(const RefusedData& refused, std::ostream* out) { *out << refused.what; }

class RefusedDataTest : public ::testing::TestWithParam<RefusedData> {};

TEST_P(RefusedDataTest, NamesFileLineAndColumn) {
  const StudyFolder folder;
  const auto file = folder.write("data.csv", GetParam().csv);
  std::string entry = std::string("{name: test, data: data.csv, type: ") + GetParam().type;
  const std::string type = GetParam().type;
  if (type != "shear-cycles") entry += ", direction: warp, width: 50 mm";
  if (type != "shear-cycles" && type != "cantilever" && type != "bending-length")
    entry += ", length: 80 mm";
  entry += "}";
  const InputError error = input_error_of([&] { folder.experiment(entry); });
  EXPECT_EQ(error.where().file, file.string());
  EXPECT_EQ(error.where().line, GetParam().line);
  EXPECT_EQ(error.where().field, GetParam().column);
  EXPECT_THAT(std::string(error.what()), HasSubstr(GetParam().message));
}

constexpr const char* kWeights = "hanging-weights";
constexpr const char* kTensile = "tensile-cycles";
constexpr const char* kShear = "shear-cycles";
constexpr const char* kBending = "pure-bending";
constexpr const char* kCantilever = "cantilever";
constexpr const char* kRolled = "rolled-strip";
constexpr const char* kLengths = "bending-length";

// A strip of 80 mm on a circle of 25 mm.
constexpr const char* kCoil =
    "radius_mm,point,x_mm,y_mm\n"
    "50,0,0,0\n50,1,12.7,3.5\n50,2,21.8,13.1\n50,3,24.6,25.9\n50,4,20.4,38.4\n50,5,10.3,47\n"
    "50,6,-2.6,49.1\n";

const RefusedData kRefused[] = {
    {"OneRowOfWeights", kWeights, "weight_N,length_mm\n1,80\n", 2, "", "has 1 row;"},
    {"TwoRows", kTensile, "force_N,length_mm\n1,80\n2,81\n", 2, "", "has 2 rows;"},
    {"ASpecimenOfOneRow", kTensile, "specimen,force_N,length_mm\nA,1,80\nA,2,81\nA,3,82\nB,1,80\n",
     5, "", "specimen \"B\" has 1 row;"},
    {"EmptyFile", kTensile, "", 0, "", "empty"},
    {"HeaderWithoutRows", kShear, "angle_deg,force_N_per_m\n", 1, "", "no rows of data"},
    {"DecreasingStep", kWeights,
     "repeat,peak_N,step,weight_N,length_mm\n1,2,0,0,80\n1,2,1,1,81\n1,2,0,2,82\n", 4, "step",
     "step 0 comes after step 1"},
    {"RepeatedStep", kWeights, "step,weight_N,length_mm\n0,0,80\n1,1,81\n1,2,82\n", 4, "step",
     "step 1 comes after step 1"},
    {"NegativeLength", kWeights, "weight_N,length_mm\n0,80\n1,-81\n2,82\n", 3, "length",
     "not positive"},
    {"ZeroLength", kTensile, "force_N,length_mm\n0,80\n1,81\n2,0\n", 4, "length", "not positive"},
    {"ExtensionBeyondTheGaugeLength", kTensile, "force_N,extension_mm\n0,0\n1,-80\n2,1\n", 3,
     "extension", "not positive"},
    {"ConstantForce", kTensile, "force_N,length_mm\n3,80\n3,81\n3,82\n", 2, "force",
     "the same in every row"},
    {"ConstantLength", kTensile, "force_N,length_mm\n1,80\n2,80\n3,80\n", 2, "length",
     "the same in every row"},
    {"ConstantWeight", kWeights, "weight_N,length_mm\n3,80\n3,81\n3,82\n", 2, "weight",
     "the same in every row"},
    {"ConstantShearForce", kShear, "angle_deg,force_N_per_m\n0,1\n2,1\n4,1\n", 2, "force",
     "the same in every row"},
    {"ConstantAngle", kShear, "angle_deg,force_N_per_m\n2,1\n2,2\n2,3\n", 2, "angle",
     "the same in every row"},
    {"NoForce", kTensile, "length_mm\n80\n81\n82\n", 1, "force", "no such column"},
    {"NeitherLengthNorExtension", kTensile, "force_N\n1\n2\n3\n", 1, "length", "no such column"},
    {"NoWeight", kWeights, "length_mm\n80\n81\n82\n", 1, "weight", "no such column"},
    {"NoAngle", kShear, "force_N_per_m\n1\n2\n3\n", 1, "angle", "no such column"},
    {"ColumnWithoutUnit", kTensile, "force,length_mm\n1,80\n2,81\n3,82\n", 1, "force",
     "has no unit"},
    {"UnitOfAnotherKind", kTensile, "force_mm,length_mm\n1,80\n2,81\n3,82\n", 1, "force_mm",
     "no unit of force"},
    {"WeightInMillimetres", kWeights, "weight_mm,length_mm\n1,80\n2,81\n3,82\n", 1, "weight_mm",
     "no unit of force"},
    {"TwoForces", kTensile, "force_N,force_cN,length_mm\n1,1,80\n2,2,81\n3,3,82\n", 1, "force_cN",
     "second column for force"},
    {"TheSameColumnTwice", kTensile, "force_N,force_N,length_mm\n1,1,80\n2,2,81\n3,3,82\n", 1,
     "force_N", "given twice"},
    {"Text", kTensile, "force_N,length_mm\n1,80\nslip,81\n3,82\n", 3, "force_N",
     "\"slip\" is not a finite number"},
    {"NotANumber", kTensile, "force_N,length_mm\n1,80\nnan,81\n3,82\n", 3, "force_N", "nan"},
    {"Infinite", kShear, "angle_deg,force_N_per_m\n0,1\n2,inf\n4,3\n", 3, "force_N_per_m", "inf"},
    {"EmptyCell", kWeights, "weight_N,length_mm\n0,80\n1,\n2,82\n", 3, "length_mm",
     "the cell is empty"},
    {"RowOfThreeCells", kTensile, "force_N,length_mm\n1,80\n2,81,7\n3,82\n", 3, "", "has 3 cells"},
    {"RightAngle", kShear, "angle_deg,force_N_per_m\n0,1\n90,2\n4,3\n", 3, "angle", "90 degrees"},
    {"ConstantMoment", kBending, "curvature_1_per_m,moment_N\n0,1\n50,1\n90,1\n", 2, "moment",
     "the same in every row"},
    {"ConstantCurvature", kBending, "curvature_1_per_m,moment_N\n50,1\n50,2\n50,3\n", 2,
     "curvature", "the same in every row"},
    {"TwoRowsOfBending", kBending, "curvature_1_per_m,moment_N\n0,1\n50,2\n", 2, "", "has 2 rows;"},
    {"NoCurvature", kBending, "moment_N\n1\n2\n3\n", 1, "curvature", "no such column"},
    {"NoMoment", kBending, "curvature_1_per_m\n1\n2\n3\n", 1, "moment", "no such column"},
    {"RadiusInPlaceOfCurvature", kBending, "curvature_mm,moment_N\n1,1\n2,2\n3,3\n", 1,
     "curvature_mm", "no unit of curvature"},
    {"MomentOfTheWholeWidth", kBending, "curvature_1_per_m,moment_gf_cm\n0,1\n50,2\n90,3\n", 1,
     "moment_gf_cm", "no unit of force"},
    {"PointsOutOfOrder", kCantilever,
     "overhang_mm,point,x_mm,y_mm\n40,0,0,0\n40,1,10,0\n40,3,20,-1\n40,2,15,-1\n40,4,40,-4\n", 5,
     "point", "point 2 comes after point 3"},
    {"PointsThatCoincide", kCantilever,
     "overhang_mm,x_mm,y_mm\n40,0,0\n40,10,0\n40,10,0\n40,20,-1\n40,40,-4\n", 4, "x",
     "stands where the point before it does"},
    {"AProfileThatFoldsBack", kCantilever,
     "overhang_mm,x_mm,y_mm\n40,0,0\n40,10,0\n40,20,-1\n40,15,-1\n40,40,-4\n", 5, "x",
     "turns back here by more than 120 degrees"},
    {"FourPoints", kRolled, "radius_mm,x_mm,y_mm\n9,0,0\n9,5,0\n9,10,0\n9,15,0\n", 2, "point",
     "begins a profile of 4 points"},
    {"ASecondProfileOfTwoPoints", kRolled,
     "radius_mm,point,x_mm,y_mm\n9,0,0,0\n9,1,5,0\n9,2,10,0\n9,3,15,0\n9,4,20,0\n"
     "9,0,0,0\n9,1,5,0\n",
     7, "point", "begins a profile of 2 points"},
    {"ZeroRadius", kRolled, "radius_mm,x_mm,y_mm\n0,0,0\n0,5,0\n0,10,0\n0,15,0\n0,20,0\n", 2,
     "radius", "is zero"},
    {"ACoilTighterThanItsCylinder", kRolled, kCoil, 2, "radius", "the free end kept a radius of"},
    {"PointsOfAShorterStrip", kRolled,
     "radius_mm,x_mm,y_mm\n60,0,0\n60,5,0\n60,10,0\n60,15,0\n60,20,0\n", 2, "x",
     "begins a profile that is 20 mm long, but the strip is 80 mm"},
    {"ZeroOverhang", kCantilever, "overhang_mm,x_mm,y_mm\n0,0,0\n0,5,0\n0,10,0\n0,15,0\n0,20,0\n",
     2, "overhang", "is not positive"},
    {"NegativeOverhang", kCantilever,
     "overhang_mm,x_mm,y_mm\n-40,0,0\n-40,5,0\n-40,10,0\n-40,15,0\n-40,20,0\n", 2, "overhang",
     "is not positive"},
    {"NoRadius", kRolled, "x_mm,y_mm\n0,0\n5,0\n10,0\n15,0\n20,0\n", 1, "radius", "no such column"},
    {"NoHeights", kCantilever, "overhang_mm,x_mm\n40,0\n40,5\n40,10\n40,15\n40,20\n", 1, "y",
     "no such column"},
    {"PointsWithoutUnit", kCantilever, "overhang_mm,x,y_mm\n40,0,0\n40,5,0\n40,9,0\n", 1, "x",
     "has no unit"},
    {"AnOverhangOfZero", kLengths, "overhang_mm,face\n46,1\n0,2\n", 3, "overhang",
     "is not positive"},
    {"ANegativeOverhangAtTheAngle", kLengths, "overhang_mm\n46\n-46\n", 3, "overhang",
     "is not positive"},
    {"NoOverhang", kLengths, "face,repeat\n1,1\n", 1, "overhang", "no such column"},
    {"AThirdFace", kLengths, "overhang_mm,face\n46,1\n46,3\n", 3, "face", "is no face"},
    {"CycleThatIsNoNumber", kTensile, "force_N,length_mm,cycle\n1,80,one\n2,81,1\n3,82,1\n", 2,
     "cycle", "\"one\""},
    {"TimeInMillimetres", kTensile, "force_N,length_mm,time_mm\n1,80,1\n2,81,2\n3,82,3\n", 1,
     "time_mm", "no unit of time"},
};

INSTANTIATE_TEST_SUITE_P(Of, RefusedDataTest, ::testing::ValuesIn(kRefused),
                         [](const auto& instance) { return instance.param.what; });

TEST(RefusedData, ExclusionsBeyondTheDataNameTheStudy) {
  const StudyFolder folder;
  folder.write("data.csv", "weight_N,length_mm\n0,80\n1,81\n0,80.5\n");
  const InputError error = input_error_of([&] {
    folder.experiment(
        "{name: test, data: data.csv, type: hanging-weights, direction: warp, length: 80 mm, "
        "width: 50 mm, exclude: [{rows: 3-4, reason: slip}]}");
  });
  EXPECT_EQ(error.where().file, (folder.path() / "study.yaml").string());
  EXPECT_EQ(error.where().line, 5);
  EXPECT_THAT(error.where().field, HasSubstr("experiments[0].exclude"));
  EXPECT_THAT(std::string(error.what()), HasSubstr("rows 3-4 do not exist"));
}

TEST(RefusedData, AStripThatItsWeightBendsNeedsTheDensity) {
  const StudyFolder folder;
  folder.write("data.csv",
               "overhang_mm,x_mm,y_mm\n40,0,0\n40,10,0\n40,20,-1\n40,30,-2\n40,40,-4\n");
  Study study = folder.study("{name: test, data: data.csv, type: cantilever, direction: warp}");
  study.density = 0;
  const InputError error =
      input_error_of([&] { read_experiment(study.experiments.front(), study); });
  EXPECT_EQ(error.where().file, (folder.path() / "study.yaml").string());
  EXPECT_EQ(error.where().line, 5);
  EXPECT_EQ(error.where().field, "experiments[0]");
  EXPECT_THAT(std::string(error.what()), HasSubstr("states no density"));
}

TEST(RefusedData, ADirectoryIsNoFile) {
  const StudyFolder folder;
  folder.write("data.csv/inner.txt", "");
  const InputError error = input_error_of([&] {
    folder.experiment(
        "{name: test, data: data.csv, type: hanging-weights, direction: warp, length: 80 mm, "
        "width: 50 mm}");
  });
  EXPECT_THAT(error.where().file, HasSubstr("data.csv"));
  EXPECT_THAT(std::string(error.what()), HasSubstr("directory"));
}

}  // namespace
}  // namespace pliant
