// The drape test in labs and studies: what is written, read back, refused and predicted.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/experiment/drape/virtual_drape.h"
#include "pliant/geometry/irregular_mesh.h"
#include "pliant/material/material_file.h"
#include "pliant/study/study_evaluation.h"
#include "pliant/study/study_fit.h"

#include "io/input_error_of.h"
#include "support/cloth_sheet.h"
#include "support/virtual_lab.h"

namespace pliant {
namespace {

using testing::Contains;
using testing::HasSubstr;

Material felt_like() {
  Material material = test::linear_cloth(200, 40, 0);
  material.name = "felt-like";
  material.bending_of = "sheet";
  for (const char* name : {"bend.weft", "bend.warp", "bend.diagonal"}) {
    material.components[name] =
        test::component(ScalarCurve::constant(1.5e-5), DahlParameters{5e-4, 0, 30});
  }
  return material;
}

VirtualDrape draped() {
  VirtualDrape test;
  test.name = "drape";
  test.setup.edge = 0.015;
  test.repeats = 2;
  return test;
}

std::string content_of(const test::MeasuredFiles& files, const std::string& name) {
  for (const auto& [file, content] : files) {
    if (file == name) return content;
  }
  ADD_FAILURE() << "no " << name;
  return {};
}

class DrapeLab : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_irregular_meshes()) GTEST_SKIP() << "built without CGAL";
  }
};
using SlowDrapeLab = DrapeLab;

TEST_F(DrapeLab, WritesRowsOutlinesAndAPicture) {
  const auto files = test::measurements_of(test::lab_of(felt_like(), draped()), 7);
  const std::string rows = content_of(files, "drape.csv");
  EXPECT_THAT(rows, testing::StartsWith("repeat,drape_percent,nodes,amplitude_mm,irregularity\n"));
  EXPECT_EQ(std::ranges::count(rows, '\n'), 3);
  const std::string outlines = content_of(files, "silhouettes/drape.csv");
  EXPECT_THAT(outlines, testing::StartsWith("angle_deg,radius_1_mm,radius_2_mm\n0,"));
  EXPECT_EQ(std::ranges::count(outlines, '\n'), 721);
  EXPECT_THAT(content_of(files, "silhouettes/drape.svg"), HasSubstr("drape coefficient"));
  EXPECT_EQ(files, test::measurements_of(test::lab_of(felt_like(), draped()), 7));
}

TEST_F(SlowDrapeLab, IsEvaluatedWithTheHistoriesThatItMayHaveHad) {
  const test::LabFolder folder(test::measurements_of(test::lab_of(felt_like(), draped()), 7));
  const StudyResult result = evaluate_study(folder.study(), felt_like(), {});
  ASSERT_EQ(result.whole_sheets.size(), 1U);
  const WholeSheetResult& whole = result.whole_sheets.front();
  EXPECT_EQ(whole.measured.size(), 2);
  EXPECT_LT(whole.rms, 0.01);  // other chance than the lab's
  EXPECT_THAT(whole.prediction.told, Contains(HasSubstr("lowered: drape coefficient")));
  EXPECT_THAT(whole.prediction.told, Contains(HasSubstr("pulled: drape coefficient")));
  EXPECT_GT(whole.prediction.figures["spread"].get<double>(), 0.02);  // friction
  EXPECT_THAT(whole.prediction.picture, HasSubstr("<svg"));
}

TEST_F(DrapeLab, IsSkippedByAMaterialThatLacksAComponent) {
  const test::LabFolder folder(test::measurements_of(test::lab_of(felt_like(), draped()), 7));
  Material material = felt_like();
  material.components.erase("shear");
  const InputError error =
      test::input_error_of([&] { evaluate_study(folder.study(), material, {}); });
  EXPECT_THAT(error.what(), HasSubstr("shear"));
}

TEST_F(DrapeLab, TeachesNoFit) {
  const test::LabFolder folder(test::measurements_of(test::lab_of(felt_like(), draped()), 7));
  const InputError error = test::input_error_of([&] { fit_study(folder.study(), {}, {}); });
  EXPECT_THAT(error.what(), HasSubstr("no experiment that this version can fit"));
}

/// Reads a lab of one drape test.
VirtualLab read_drape(const std::string& fields) {
  static const test::TemporaryFolder folder;
  folder.write("cloth.json", material_text(felt_like()));
  return read_lab(folder.write("lab.yaml",
                               "pliant: lab/1\nmaterial: cloth.json\nexperiments:\n"
                               "  - {name: d, type: drape" +
                                   fields + "}\n"));
}

std::string refusal_of(const std::string& fields) {
  return test::input_error_of([&] { read_drape(fields); }).what();
}

TEST(DrapeFields, HaveTheStandardsSizesByDefault) {
  const VirtualLab lab = read_drape("");
  const DrapeSetup& setup = test::experiment_of<VirtualDrape>(lab, 0).setup;
  EXPECT_EQ(setup.specimen, 0.3);
  EXPECT_EQ(setup.disc, 0.18);
  EXPECT_EQ(setup.history, DrapeHistory::lowered);
  EXPECT_DOUBLE_EQ(setup.edge, 0.008);
}

TEST(DrapeFields, AreReadAsTheyAreWritten) {
  const VirtualLab lab =
      read_drape(", specimen: 36 cm, disc: 20 cm, history: shaken, edge: 9 mm, repeats: 4");
  const auto& test = test::experiment_of<VirtualDrape>(lab, 0);
  EXPECT_EQ(test.repeats, 4);
  std::string fields;
  for (const auto& [key, value] : test.study_fields()) fields += ", " + key + ": " + value;
  const VirtualLab again = read_drape(fields);
  const DrapeSetup &one = test.setup, &two = test::experiment_of<VirtualDrape>(again, 0).setup;
  EXPECT_EQ(one.specimen, two.specimen);
  EXPECT_EQ(one.disc, two.disc);
  EXPECT_EQ(one.history, two.history);
  EXPECT_EQ(one.edge, two.edge);
}

TEST(DrapeFields, AreRefusedWhereNothingWouldHang) {
  EXPECT_THAT(refusal_of(", specimen: 18 cm"), HasSubstr("hardly hangs over the disc"));
  EXPECT_THAT(refusal_of(", disc: 29 cm"), HasSubstr("specimen: of 300 mm by default"));
  EXPECT_THAT(refusal_of(", edge: 40 mm"), HasSubstr("too coarse or too fine"));
  EXPECT_THAT(refusal_of(", history: thrown"), HasSubstr("thrown"));
}

TEST(DrapeFields, NeedAWholeSheet) {
  static const test::TemporaryFolder folder;
  Material material = felt_like();
  material.components.erase("bend.diagonal");
  folder.write("cloth.json", material_text(material));
  const auto lab = folder.write("lab.yaml",
                                "pliant: lab/1\nmaterial: cloth.json\nexperiments:\n"
                                "  - {name: d, type: drape}\n");
  EXPECT_THAT(test::input_error_of([&] { read_lab(lab); }).what(), HasSubstr("bend.diagonal"));
}

Study study_of(const std::string& rows) {
  static const test::TemporaryFolder folder;
  folder.write("drape.csv", rows);
  return read_study(folder.write("study.yaml",
                                 "pliant: study/1\nname: s\nexperiments:\n"
                                 "  - {name: d, type: drape, data: drape.csv}\n"));
}

TEST(DrapeRows, AreCoefficientsBetweenTheDiscAndTheFlatSpecimen) {
  const auto refusal = [](const std::string& rows) {
    return std::string(
        test::input_error_of([&] { evaluate_study(study_of(rows), felt_like(), {}); }).what());
  };
  EXPECT_THAT(refusal("drape_percent,nodes\n105,6\n"), HasSubstr("is no drape coefficient"));
  EXPECT_THAT(refusal("drape_percent,nodes\n-3,6\n"), HasSubstr("is no drape coefficient"));
  EXPECT_THAT(refusal("nodes\n6\n"), HasSubstr("drape"));
}

}  // namespace
}  // namespace pliant
