// `pliant convert` as a user runs it.

#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/run_program.h"

namespace pliant::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

constexpr char kRubber[] =
    "{\"pliant\": \"material/1\", \"name\": \"rubber\", \"kind\": \"solid\", \"density\": 1100,\n"
    " \"components\": {\"I1-bar\": {\"addends\": [{\"law\": \"linear\", \"c\": 17000}]},\n"
    "  \"J\": {\"stiffness\": {\"curve\": \"constant\", \"value\": 2e5}}},\n"
    " \"damping\": {\"fraction\": 0.01}}\n";

/// A tetrahedron whose edges are 1 of its unit, and a triangle alone.
constexpr char kTetrahedron[] =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n0 0 1 0\n"
    "Tetrahedra\n1\n1 2 3 4 0\nEnd\n";
constexpr char kTriangle[] =
    "MeshVersionFormatted 2\nDimension 3\nVertices\n3\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
    "Triangles\n1\n1 2 3 0\nEnd\n";

class Convert : public ::testing::Test {
 protected:
  Convert() {
    folder_.write("rubber.json", kRubber);
    folder_.write("one.mesh", kTetrahedron);
    folder_.write("flat.mesh", kTriangle);
  }

  ProgramRun run(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "convert");
    return run_program(arguments, {.working_directory = folder_.path()});
  }

  /// A run that is refused: its line.
  std::string refusal(const std::vector<std::string>& arguments) const {
    const std::vector<std::string> before = names_in(folder_.path());
    const ProgramRun wrong = run(arguments);
    EXPECT_EQ(wrong.status, 2) << wrong.err;
    EXPECT_EQ(std::count(wrong.err.begin(), wrong.err.end(), '\n'), 1) << wrong.err;
    EXPECT_EQ(names_in(folder_.path()).size(), before.size());
    return wrong.err;
  }

  std::string written(const std::string& name) const { return content_of(folder_.path() / name); }

  TemporaryFolder folder_;
};

TEST_F(Convert, WritesTheFileAndSaysWhatIsLost) {
  const ProgramRun done = run({"rubber.json", "rubber.feb", "--to", "febio"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_EQ(done.out, "");
  EXPECT_THAT(done.err, HasSubstr("lost: damping\n"));
  EXPECT_THAT(done.err, HasSubstr("rubber.feb: Neo-Hookean for FEBio\n"));
  EXPECT_THAT(written("rubber.feb"), HasSubstr("<c1>17000</c1>"));
}

TEST_F(Convert, SaysWhatIsLostInQuietToo) {
  EXPECT_THAT(run({"rubber.json", "rubber.inp", "--to", "abaqus", "--quiet"}).err,
              ::testing::AllOf(HasSubstr("lost: damping"), ::testing::Not(HasSubstr("Neo"))));
}

TEST_F(Convert, SumsUpInJson) {
  const ProgramRun done =
      run({"rubber.json", "rubber.inp", "--to", "calculix", "--json", "--quiet"});
  const auto json = nlohmann::json::parse(done.out);
  EXPECT_EQ(json["written"], "rubber.inp");
  EXPECT_EQ(json["law"], "Neo-Hookean");
  EXPECT_THAT(json["lost"].get<std::vector<std::string>>(), ElementsAre("damping"));
}

TEST_F(Convert, TakesAMeshInItsUnit) {
  const ProgramRun done = run({"rubber.json", "model.inp", "--to", "abaqus", "--mesh", "one.mesh",
                               "--unit", "mm", "--quiet"});
  EXPECT_EQ(done.status, 0) << done.err;
  EXPECT_THAT(written("model.inp"), HasSubstr("\n2, 0.001, 0, 0\n"));
  EXPECT_THAT(written("model.inp"), HasSubstr("*SOLID SECTION, ELSET=EALL, MATERIAL=RUBBER\n"));
}

TEST_F(Convert, NeverReplacesAFile) {
  folder_.write("mine.inp", "my own");
  EXPECT_EQ(refusal({"rubber.json", "mine.inp", "--to", "abaqus"}),
            "error: mine.inp: is there already; expected a new file\n");
  EXPECT_EQ(written("mine.inp"), "my own");
}

TEST_F(Convert, RefusesWhatItCannotDo) {
  EXPECT_THAT(refusal({"rubber.json", "a.inp", "--to", "abacus"}),
              HasSubstr("--to: \"abacus\" (did you mean \"abaqus\"?)"));
  EXPECT_THAT(refusal({"rubber.json", "a.inp", "--to", "febio"}), HasSubstr("ends in .feb"));
  EXPECT_THAT(refusal({"rubber.json", "none/a.inp", "--to", "abaqus"}),
              StartsWith("error: none/a.inp: cannot be created"));
  EXPECT_THAT(refusal({"none.json", "a.inp", "--to", "abaqus"}), StartsWith("error: none.json: "));
  EXPECT_THAT(refusal({"rubber.json", "a.inp"}), HasSubstr("--to"));
  EXPECT_THAT(refusal({"rubber.json", "a.inp", "--to", "abaqus", "--mesh", "one.mesh"}),
              HasSubstr("--unit: is missing; expected the length unit of one.mesh: m, cm"));
  EXPECT_THAT(
      refusal({"rubber.json", "a.inp", "--to", "abaqus", "--mesh", "flat.mesh", "--unit", "m"}),
      StartsWith("error: flat.mesh: "));
  EXPECT_THAT(refusal({"one.mesh", "a.inp", "--to", "abaqus"}), StartsWith("error: one.mesh:"));
}

TEST_F(Convert, RefusesMaterialsWithoutACounterpartByTheirField) {
  folder_.write("cloth.json",
                "{\"pliant\": \"material/1\", \"name\": \"felt\", \"kind\": \"cloth\",\n"
                " \"components\": {\"bend.warp\": {\"stiffness\": {\"curve\": \"constant\", "
                "\"value\": 1e-5}}}}\n");
  EXPECT_THAT(refusal({"cloth.json", "a.inp", "--to", "abaqus"}),
              StartsWith("error: cloth.json: kind: is a cloth"));
  folder_.write("spline.json",
                "{\"pliant\": \"material/1\", \"name\": \"rubber\", \"kind\": \"solid\",\n"
                " \"components\": {\"stretch-bar\": {\"stiffness\": {\"curve\": \"spline\", "
                "\"strain\": [0, 1], \"value\": [1e5, 2e5]}}}}\n");
  EXPECT_THAT(refusal({"spline.json", "a.feb", "--to", "febio"}),
              StartsWith("error: spline.json: components.stretch-bar.stiffness: "));
}

}  // namespace
}  // namespace pliant::test
