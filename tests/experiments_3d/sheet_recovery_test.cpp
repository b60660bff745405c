// Materials fitted to full-field sessions that were made with known ones.

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "pliant/estimation/sheet/sheet_fit.h"
#include "pliant/estimation/study_fit.h"
#include "pliant/experiment/study.h"

#include "io/temporary_folder.h"
#include "support/virtual_sheets.h"

namespace pliant {
namespace {

constexpr int kNodes = 13;

// A study of the five tests of a material, on the mesh that they were measured on.
class FiveTests {
 public:
  explicit FiveTests(const Material& material, const std::string& model = "") {
    add(test::virtual_stretch(material, 0, kNodes, 6));
    add(test::virtual_stretch(material, 1, kNodes, 6));
    add(test::virtual_shear(material, kNodes, 6));
    add(test::virtual_bend(material, 0, kNodes, 6));
    add(test::virtual_bend(material, 1, kNodes, 6));
    std::string text = "pliant: study/1\nname: five\nexperiments:\n";
    for (const std::string& name : names_) {
      text += fmt::format("  - {{name: {0}, type: session, data: {0}}}\n", name);
    }
    text += "model: {mesh: measured" + model + "}\n";
    folder_.write("study.yaml", text);
  }

  Study study() const { return read_study(folder_.path() / "study.yaml"); }

 private:
  void add(const Session& session) {
    write_session(folder_.path() / session.test, session);
    names_.push_back(session.test);
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> names_;
};

double value_of(const StudyResult& result, const std::string& component, double strain) {
  return result.material.components.at(component).stiffness->value(strain);
}

TEST(SheetRecovery, FindsAllCurvesOfNoiseFreeSessionsOnTheirOwnMesh) {
  const Material truth = test::nonlinear_cloth();
  const FiveTests tests(truth);
  RunContext context;
  context.threads = 2;
  const StudyResult result = fit_study(tests.study(), {}, context);
  for (const ParameterEstimate& p : result.parameters) {
    std::printf("%s %.6g +- %.2g %s\n", p.name.c_str(), p.value, p.std_error.value_or(NAN),
                p.note.c_str());
  }
  for (const FitStage& s : result.stages) {
    std::printf("%s: %s %.4g %s %d\n", s.component.c_str(), s.name.c_str(), s.rms, s.unit.c_str(),
                s.accepted);
  }
  for (const auto& [name, component] : truth.components) {
    for (const double share : {0.0, 0.3, 0.6, 1.0}) {
      const double strain = share * component.stiffness->knots().back();
      const double expected = component.stiffness->value(strain);
      EXPECT_NEAR(value_of(result, name, strain), expected, 0.05 * expected) << name << strain;
    }
  }
  std::printf("%g s\n", result.seconds);
}

}  // namespace
}  // namespace pliant
