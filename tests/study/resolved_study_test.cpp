// The resolved study says the same as the study it was made from.

#include <cmath>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/study/study.h"

#include "io/temporary_folder.h"
#include "study/study_text.h"

namespace pliant {
namespace {

using test::study_with_more;
using test::TemporaryFolder;
using ::testing::HasSubstr;

/// Every field of a study that has text behind it.
constexpr const char* kFull = R"yaml(pliant: study/1
name: "null"
density: 0.3333333333333333 kg/m^2
info: {lot: "007", note: "a: b # c", empty: ""}
conditions: {temperature: 20 degC}
experiments:
  - {name: a, type: hanging-weights, direction: warp, data: "raw/a-*.csv", length: 0.1 m, width: 3.3333333 in,
     clip_mass: 12.3456789 g, rested: true, standard: "yes", exclude: [{rows: 3-5, reason: "jaw: slip"}, {rows: 7, reason: x}]}
  - {name: b, type: tensile-cycles, direction: bias, length: 8 cm, width: 5 cm,
     data: {file: raw/b.csv, columns: {force: "Load (N)", length: "L, mm"}, encoding: latin1, skip_rows: 3},
     pretension: 5.5555555 cN, apparatus_friction: 0.1 N, precondition_cycles: 2, initial_friction: rest,
     rest_length: known, noise: {force: 3 mN, length: 20 um}}
  - {name: c, type: shear-cycles, data: raw/c.csv, transverse_tension: 9.8 N/m, noise: {force: 0.1 N/m}}
  - {name: e, type: cantilever, direction: weft, density: unknown, data: raw/c.csv, noise: {position: 0.15 mm}}
  - {name: f, type: rolled-strip, direction: bias, data: raw/c.csv, length: 12.345 cm, width: 1 in}
  - {name: g, type: pure-bending, direction: warp, data: raw/c.csv, width: 20 cm, initial_friction: rest, noise: {moment: 0.001 gf cm/cm}}
  - {name: h, type: bending-length, direction: warp, data: raw/c.csv, width: 1 in, angle: 43.21 deg, noise: {overhang: 0.5 mm}}
  - {name: d, type: buckling-bend, direction: weft, side: up, rest_length: unknown, data: raw/c.csv, length: 8 cm, width: 5 cm}
  - {name: l, type: tensile-cycles, direction: 22.5 deg, data: raw/b.csv, length: 8 cm, width: 5 cm}
  - {name: j, type: session, data: raw/c.csv, objective: clip-forces, cord_friction: unknown}
  - {name: k, type: session, data: raw/c.csv, cord_friction: 12.3456789 cN}
model:
  membrane: soft-constraint
  strips: sheet
  stiffness: hermite
  friction: none
  limits: [{of: [shear]}, {of: [stretch.weft, coupling]}]
  components: {shear: {stiffness: constant}, coupling: {stiffness: energy}, stretch.warp: {friction: dahl, addends: [dahl, dahl]},
               bend.weft: {stiffness: none, addends: [dahl]}}
fit: {estimator: anchor, control_points: 3, loss: cauchy, monotone_stress: true, bounds: {"*.friction.tau": [1e-3, 0.3333333333333333]},
      fix: {stretch.warp.k1: 4.5}, priors: {"*.k2": {mean: -30, sd: 2}}}
validate: ["b", "c*"]
accept: {rms: 3 %, loop: 12.5 %}
)yaml";

/// Quantities are written with 15 significant digits.
void expect_near(double a, double b) { EXPECT_NEAR(a, b, 1e-14 * std::abs(a)); }

void expect_same(const ExperimentSpec& a, const ExperimentSpec& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.type, b.type);
  EXPECT_EQ(a.direction, b.direction);
  EXPECT_EQ(a.standard, b.standard);
  ASSERT_EQ(a.data.files.size(), b.data.files.size());
  for (size_t i = 0; i < a.data.files.size(); ++i) {
    EXPECT_TRUE(std::filesystem::equivalent(a.data.files[i], b.data.files[i]));
  }
  EXPECT_EQ(a.data.csv.columns, b.data.csv.columns);
  EXPECT_EQ(a.data.csv.encoding, b.data.csv.encoding);
  EXPECT_EQ(a.data.csv.skip_rows, b.data.csv.skip_rows);
  EXPECT_EQ(a.test->fields(), b.test->fields());
  EXPECT_EQ(a.test->is_only_sheet(), b.test->is_only_sheet());
  EXPECT_EQ(a.noise.force.has_value(), b.noise.force.has_value());
  expect_near(a.noise.force.value_or(0), b.noise.force.value_or(0));
  expect_near(a.noise.length.value_or(0), b.noise.length.value_or(0));
  ASSERT_EQ(a.excluded.size(), b.excluded.size());
  for (size_t i = 0; i < a.excluded.size(); ++i) {
    EXPECT_EQ(a.excluded[i].first, b.excluded[i].first);
    EXPECT_EQ(a.excluded[i].last, b.excluded[i].last);
    EXPECT_EQ(a.excluded[i].reason, b.excluded[i].reason);
  }
  EXPECT_EQ(a.role, b.role);
}

void expect_same(const Study& a, const Study& b) {
  EXPECT_EQ(a.name, b.name);
  expect_near(a.density, b.density);
  EXPECT_EQ(a.info, b.info);
  EXPECT_EQ(a.conditions, b.conditions);
  ASSERT_EQ(a.experiments.size(), b.experiments.size());
  for (size_t i = 0; i < a.experiments.size(); ++i) {
    SCOPED_TRACE(a.experiments[i].name);
    expect_same(a.experiments[i], b.experiments[i]);
  }
  EXPECT_EQ(a.model.membrane, b.model.membrane);
  EXPECT_EQ(a.model.strips_as_sheets, b.model.strips_as_sheets);
  EXPECT_EQ(a.model.stiffness, b.model.stiffness);
  EXPECT_EQ(a.model.friction, b.model.friction);
  EXPECT_EQ(a.model.limits, b.model.limits);
  ASSERT_EQ(a.model.components.size(), b.model.components.size());
  for (const auto& [name, component] : a.model.components) {
    EXPECT_EQ(component.stiffness, b.model.components.at(name).stiffness);
    EXPECT_EQ(component.friction, b.model.components.at(name).friction);
    EXPECT_EQ(component.addends, b.model.components.at(name).addends);
  }
  EXPECT_EQ(a.fit.estimator, b.fit.estimator);
  EXPECT_EQ(a.fit.control_points, b.fit.control_points);
  EXPECT_EQ(a.fit.loss, b.fit.loss);
  EXPECT_EQ(a.fit.monotone_stress, b.fit.monotone_stress);
  EXPECT_EQ(a.fit.bounds, b.fit.bounds);
  EXPECT_EQ(a.fit.fix, b.fit.fix);
  ASSERT_EQ(a.fit.priors.size(), b.fit.priors.size());
  for (const auto& [name, prior] : a.fit.priors) {
    EXPECT_EQ(prior.mean, b.fit.priors.at(name).mean);
    EXPECT_EQ(prior.sd, b.fit.priors.at(name).sd);
  }
  EXPECT_EQ(a.validate, b.validate);
  expect_near(a.accept.rms, b.accept.rms);
  expect_near(a.accept.span, b.accept.span);
  expect_near(a.accept.loop, b.accept.loop);
  expect_near(a.accept.unexplained, b.accept.unexplained);
}

TEST(ResolvedStudy, ReadsBackAsTheSameStudyFromAnyFolder) {
  const TemporaryFolder folder;
  for (const char* file :
       {"study/raw/a-1.csv", "study/raw/a-2.csv", "study/raw/b.csv", "study/raw/c.csv"}) {
    folder.write(file, "force_N\n1\n");
  }
  const Study study = read_study(folder.write("study/study.yaml", kFull));
  EXPECT_EQ(study.experiments[0].data.files.size(), 2U);
  for (const char* place : {"study", "results", "study/raw", "a/deep/er/folder"}) {
    SCOPED_TRACE(place);
    const std::string text = resolved_study_text(study, folder.path() / place);
    const Study back = read_study(folder.write(std::string(place) + "/study.resolved.yaml", text));
    expect_same(study, back);
    EXPECT_EQ(resolved_study_text(back, folder.path() / place), text);
  }
}

TEST(ResolvedStudy, OfNoFolderIsThatOfTheWorkingDirectory) {
  const TemporaryFolder folder;
  for (const char* file : {"raw/a-1.csv", "raw/b.csv", "raw/c.csv"})
    folder.write(file, "force_N\n");
  const Study study = read_study(folder.write("study.yaml", kFull));
  EXPECT_EQ(resolved_study_text(study, ""),
            resolved_study_text(study, std::filesystem::current_path()));
}

TEST(ResolvedStudy, SpellsOutTheDefaults) {
  const TemporaryFolder folder;
  const Study study = read_study(folder.write("study.yaml", study_with_more("")));
  const std::string text = resolved_study_text(study, folder.path());
  for (const char* line : {"rested: false", "rested: false", "estimator: path", "control_points: 5",
                           "friction: auto", "membrane: stvk", "data: w.csv"}) {
    EXPECT_THAT(text, HasSubstr(line));
  }
}

}  // namespace
}  // namespace pliant
