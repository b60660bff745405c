// What a fit says of its apparatus without having been asked.

#include "pliant/estimation/nuisance_warnings.h"

#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/study/study.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Cycles of cotton whose force offset and friction at the start are looked for.
class NuisanceWarnings : public ::testing::Test {
 protected:
  NuisanceWarnings() {
    auto cycles = test::strip_cycles({0.05, 0.1, 0.2});
    cycles.instrument.force_noise = 5e-3;
    test::VirtualStudy files(test::lab_of(test::published_fabric("cotton"), cycles));
    files.set_in_experiment("initial_friction", "unknown");
    const Study study = files.study();
    experiment_ = read_experiment(study.experiments.front(), study);
    problem_ = std::make_unique<ComponentProblem>(
        std::vector<const ComponentExperiment*>{experiment_.get()});
    std::vector<std::string> notes;
    fit_ = fit_component(*problem_, plan_component(study, {experiment_.get()}, notes));
  }

  std::unique_ptr<ComponentExperiment> experiment_;
  std::unique_ptr<ComponentProblem> problem_;
  ComponentFit fit_;
};

TEST_F(NuisanceWarnings, LeaveCleanDataInPeace) {
  EXPECT_THAT(nuisance_warnings(*problem_, fit_), IsEmpty());
}

// An offset of a tenth of the peak, and friction that pushes by as much.
TEST_F(NuisanceWarnings, NameNumbersThatUndoEachOther) {
  const Eigen::Index offset = fit_.fit.law.parameter_count(), friction = offset + 1;
  const double tenth = 0.1 * experiment_->reference();
  Eigen::MatrixXd& by = fit_.uncertainty.noise.rows.front().by;
  by.col(offset).setOnes();
  by.col(friction).setConstant(tenth);
  fit_.fit.solution.parameters(offset) = -tenth;
  fit_.fit.solution.parameters(friction) = 1;
  EXPECT_THAT(nuisance_warnings(*problem_, fit_), ElementsAre(HasSubstr("undo each other")));
  by.col(friction) /= 3;
  EXPECT_THAT(nuisance_warnings(*problem_, fit_), IsEmpty());
}

}  // namespace
}  // namespace pliant
