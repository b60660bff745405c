// One pull of a strip as testing machines write it: whatever the names, units and preamble, it is
// the same experiment.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/study/study.h"

#include "io/temporary_folder.h"

namespace pliant {
namespace {

constexpr const char* kStudy = R"(pliant: study/1
name: strip
experiments:
  - {name: pull, type: tensile-cycles, direction: warp, data: pull.csv, length: 100 mm, width: 50 mm}
)";

std::unique_ptr<ComponentExperiment> experiment_of(const test::TemporaryFolder& folder,
                                                   const std::string& csv) {
  folder.write("pull.csv", csv);
  const Study study = read_study(folder.write("study.yaml", kStudy));
  return read_experiment(study.experiments.front(), study);
}

struct TesterFile {
  std::string name;
  std::string text;
};

const std::vector<TesterFile> kFiles{
    {"CapitalsAndBrackets", "Time (s),Extension (mm),Force (N)\n0,0,0\n1,2,4\n2,5,9\n3,1,2\n"},
    {"Load", "Load (N);Stroke (mm)\n0;0\n4;2\n9;5\n2;1\n"},
    {"LoadInMillinewtons", "Load [mN]\tDisplacement [cm]\n0\t0\n4000\t0.2\n9000\t0.5\n2000\t0.1\n"},
    {"UnitsRow", "Standard force,Standard travel\nN,mm\n0,0\n4,2\n9,5\n2,1\n"},
    {"BracketedUnitsRow", "Load,Tensile extension\n(N),(mm)\n0,0\n4,2\n9,5\n2,1\n"},
    {"German",
     "Prüfzeit;Traversenweg;Standardkraft\ns;mm;N\n0;0,0;0,0\n1;2,0;4,0\n2;5,0;9,0\n3;1,0;2,0\n"},
    {"GermanPerCent", "Kraft in N;Dehnung in %\n0;0\n4;2\n9;5\n2;1\n"},
    {"ElongationPerCent", "Load (N),Elongation (%)\n0,0\n4,2\n9,5\n2,1\n"},
    {"Preamble",
     "Test method;ISO 13934-1\nOperator;KL\nGauge length;100;mm\n\nNo;Extension / mm;Load / N\n"
     "1;0;0\n2;2;4\n3;5;9\n4;1;2\n"},
    {"QuotedPreamble",
     "\"Specimen 1\"\n\"Width\",\"50.0\",\"mm\"\n\n\"Time\",\"Extension\",\"Load\"\n"
     "\"(s)\",\"(mm)\",\"(N)\"\n\"0\",\"0\",\"0\"\n\"1\",\"2\",\"4\"\n\"2\",\"5\",\"9\"\n\"3\","
     "\"1\",\"2\"\n"},
    {"ExtensionPerCent", "Force (N),Extension (%)\n0,0\n4,2\n9,5\n2,1\n"},
    {"LengthOfTheSpecimen",
     "Length (mm),Extension (mm),Force (N)\n100,0,0\n100,2,4\n100,5,9\n100,1,2\n"},
    {"TimeOfDay",
     "Time (s),Load (N),Elongation (mm),Elongation "
     "(%)\n00:00:01,0,0,0\n00:00:02,4,2,2\n00:00:03,9,5,5\n00:00:04,2,1,1\n"},
    {"GripSeparation", "FORCE_N,GRIP SEPARATION (mm)\n0,100\n4,102\n9,105\n2,101\n"}};

class TesterFiles : public ::testing::TestWithParam<TesterFile> {};

TEST_P(TesterFiles, AreTheExperimentThatTheyAre) {
  const test::TemporaryFolder folder;
  const auto expected = experiment_of(folder, "force_N,extension_mm\n0,0\n4,2\n9,5\n2,1\n");
  const auto read = experiment_of(folder, GetParam().text);
  ASSERT_EQ(read->rows(), expected->rows());
  for (int row = 0; row < read->rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    EXPECT_NEAR(read->measured()(row), expected->measured()(row), 1e-12);
    EXPECT_NEAR(read->path().strain[i], expected->path().strain[i], 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, TesterFiles, ::testing::ValuesIn(kFiles),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace pliant
