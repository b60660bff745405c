// Reading lab/1 files.

#include <numbers>
#include <ostream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/errors.h"
#include "pliant/experiment/virtual_lab.h"

#include "io/input_error_of.h"
#include "io/temporary_folder.h"

namespace pliant {
namespace {

using test::input_error_of;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr const char* kMaterial = R"({"pliant": "material/1", "name": "jersey", "kind": "cloth",
 "components": {"stretch.warp": {"stiffness": {"curve": "constant", "value": 30}},
                "stretch.weft": {"stiffness": {"curve": "constant", "value": 30}},
                "shear": {"stiffness": {"curve": "constant", "value": 3}},
                "stretch.bias": {"status": "unmeasured"}}})";

constexpr const char* kLab = R"(pliant: lab/1
material: jersey.json
specimens: 2
specimen_variation: 3 %
experiments:
  - {name: warp-weights, type: hanging-weights, direction: warp, length: 10 cm, width: 9 cm, clip_mass: 20 g,
     peaks: [1 N, 2 N], step: 0.5 N, repeats: 3, noise: {length: 0.2 mm}, resolution: {length: 0.5 mm}}
  - {name: weft, type: tensile-cycles, direction: weft, peaks: [5 %, 10 %], slack: 1 mm, samples: 50,
     noise: {force: 5 mN, length: 10 um}, resolution: {force: 1 mN, length: 10 um}}
  - {name: shear, type: shear-cycles, peaks: [8 deg], transverse_tension: 9.8 N/m, noise: {force: 0.1 N/m}}
validate: ["weft*"]
)";

VirtualLab read_lab_text(const std::string& text) {
  const TemporaryFolder folder;
  folder.write("jersey.json", kMaterial);
  return read_lab(folder.write("lab.yaml", text));
}

TEST(LabFile, ReadsEveryField) {
  const VirtualLab lab = read_lab_text(kLab);
  EXPECT_EQ(lab.name, "jersey");
  EXPECT_EQ(lab.specimens, 2);
  EXPECT_DOUBLE_EQ(lab.specimen_variation, 0.03);
  EXPECT_THAT(lab.validate, ElementsAre("weft*"));
  ASSERT_EQ(lab.experiments.size(), 3U);
  const LabExperiment& hung = lab.experiments[0];
  EXPECT_DOUBLE_EQ(hung.length, 0.1);
  EXPECT_DOUBLE_EQ(hung.width, 0.09);
  EXPECT_DOUBLE_EQ(hung.clip_mass, 0.02);
  EXPECT_THAT(hung.peaks, ElementsAre(1, 2));
  EXPECT_DOUBLE_EQ(hung.step, 0.5);
  EXPECT_EQ(hung.repeats, 3);
  EXPECT_DOUBLE_EQ(hung.instrument.length_noise, 2e-4);
  EXPECT_DOUBLE_EQ(hung.instrument.length_resolution, 5e-4);
  const LabExperiment& pulled = lab.experiments[1];
  EXPECT_THAT(pulled.peaks, ElementsAre(0.05, 0.1));
  EXPECT_DOUBLE_EQ(pulled.slack, 1e-3);
  EXPECT_EQ(pulled.samples, 50);
  EXPECT_DOUBLE_EQ(pulled.instrument.force_noise, 5e-3);
  EXPECT_DOUBLE_EQ(pulled.instrument.force_resolution, 1e-3);
  EXPECT_DOUBLE_EQ(lab.experiments[2].peaks[0], 8 * std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(lab.experiments[2].transverse_tension, 9.8);
}

struct LabRefusal {
  const char* what;
  const char* experiment;  ///< on line 4
  const char* field;
  const char* message;
  int line = 4;
};

void PrintTo(const LabRefusal& refusal, std::ostream* out) { *out << refusal.what; }

class LabFileRefusal : public ::testing::TestWithParam<LabRefusal> {};

TEST_P(LabFileRefusal, NamesLineAndField) {
  const std::string text = std::string("pliant: lab/1\nmaterial: jersey.json\nexperiments:\n  - ") +
                           GetParam().experiment + "\n";
  const InputError error = input_error_of([&] { read_lab_text(text); });
  if (HasFailure()) return;
  EXPECT_EQ(error.where().line, GetParam().line);
  EXPECT_THAT(error.where().field, HasSubstr(GetParam().field));
  EXPECT_THAT(std::string(error.what()), HasSubstr(GetParam().message));
}

const LabRefusal kRefusals[] = {
    {"UnknownKey", "{name: w, type: shear-cycles, peaks: [8 deg], repeat: 2}",
     "experiments[0].repeat", "did you mean \"repeats\"?"},
    {"KeyOfAnotherType", "{name: w, type: shear-cycles, peaks: [8 deg], slack: 1 mm}",
     "experiments[0].slack", "unknown key"},
    {"UnknownType", "{name: w, type: shear-cycle, peaks: [8 deg]}", "experiments[0].type",
     "did you mean \"shear-cycles\"?"},
    {"PeakOfAnotherKind", "{name: w, type: tensile-cycles, direction: warp, peaks: [8 deg]}",
     "experiments[0].peaks[0]", "%"},
    {"NegativePeak", "{name: w, type: tensile-cycles, direction: warp, peaks: [-5 %]}",
     "experiments[0].peaks[0]", "not positive"},
    {"NoPeaks", "{name: w, type: shear-cycles, peaks: []}", "experiments[0].peaks", "is empty"},
    {"NegativeNoise", "{name: w, type: shear-cycles, peaks: [8 deg], noise: {force: -1 N/m}}",
     "experiments[0].noise.force", "is negative"},
    {"ADirectionTheMaterialLacks", "{name: w, type: tensile-cycles, direction: bias, peaks: [5 %]}",
     "experiments[0]", "does not have"},
    {"ANameThatIsNoFileName", "{name: ../w, type: shear-cycles, peaks: [8 deg]}", "experiments[0]",
     "name"},
    {"TheSameNameTwice",
     "{name: w, type: shear-cycles, peaks: [8 deg]}\n"
     "  - {name: w, type: shear-cycles, peaks: [9 deg]}",
     "experiments[1]", "\"w\"", 5},
};

INSTANTIATE_TEST_SUITE_P(Of, LabFileRefusal, ::testing::ValuesIn(kRefusals),
                         [](const auto& instance) { return instance.param.what; });

}  // namespace
}  // namespace pliant
