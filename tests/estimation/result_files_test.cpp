#include "pliant/study/result_files.h"

#include <map>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "pliant/io/csv.h"
#include "pliant/material/material_file.h"
#include "pliant/study/study_evaluation.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using nlohmann::json;
using test::hung_weights;
using test::lab_of;
using test::published_fabric;
using test::strip_cycles;
using test::VirtualStudy;
using ::testing::ElementsAre;
using ::testing::IsSupersetOf;
using ::testing::StartsWith;

const RunFacts kFacts{
    "pliant fit study.yaml -o fit", "2020-01-02T03:04:05Z", "1.2.3", "study.yaml", "abc", ""};

/// The result files of weights that are fitted and cycles that are predicted.
class ResultFiles : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    auto weights = hung_weights();
    weights.instrument.length_noise = 0.2e-3;
    VirtualStudy study(lab_of(published_fabric("cotton"), {weights, strip_cycles({0.1})}));
    study.add("validate: [cycles]");
    study.add("conditions: {temperature: 20 degC}");
    result_ = new StudyResult(study.fit({.compare_friction = true, .profiles = {"*.tau"}}));
    folder_ = new test::TemporaryFolder;
    for (const auto& [name, content] : fit_files(*result_, kFacts)) folder_->write(name, content);
  }
  static void TearDownTestSuite() {
    delete result_;
    delete folder_;
  }

  static std::filesystem::path file(const std::string& name) { return folder_->path() / name; }
  static json fit_json() { return json::parse(test::content_of(file("fit.json"))); }

  static StudyResult* result_;
  static test::TemporaryFolder* folder_;
};

StudyResult* ResultFiles::result_ = nullptr;
test::TemporaryFolder* ResultFiles::folder_ = nullptr;

std::vector<std::string> keys_of(const json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

TEST_F(ResultFiles, FitJsonHasTheFieldsThatItsFormatPromises) {
  const json fit = fit_json();
  EXPECT_EQ(fit["pliant"], "fit/1");
  EXPECT_THAT(keys_of(fit),
              IsSupersetOf({"pliant", "converged", "seconds", "parameters", "nuisance",
                            "covariance", "experiments", "stages", "warnings"}));
  for (const char* list : {"parameters", "nuisance"}) {
    for (const json& p : fit[list]) {
      EXPECT_THAT(keys_of(p), IsSupersetOf({"name", "value", "std_error", "unit", "identified",
                                            "at_bound", "between_specimen_sd"}));
    }
  }
  for (const json& e : fit["experiments"]) {
    EXPECT_THAT(keys_of(e),
                IsSupersetOf({"name", "role", "rms_force_N", "peak_force_N", "rms_percent_of_peak",
                              "rms_position_mm", "points", "specimens"}));
  }
}

TEST_F(ResultFiles, FitJsonTellsWhatTheFitFound) {
  const json fit = fit_json();
  EXPECT_EQ(fit["converged"], true);
  EXPECT_EQ(fit["parameters"][0]["name"], "stretch.warp.k1");
  EXPECT_EQ(fit["parameters"][0]["unit"], "N/m");
  EXPECT_EQ(fit["parameters"][0]["value"], result_->parameters[0].value);
  EXPECT_EQ(fit["parameters"][4]["name"], "stretch.warp.friction.tau");
  EXPECT_TRUE(fit["parameters"][0]["between_specimen_sd"].is_null());
  const json& weights = fit["experiments"][0];
  EXPECT_EQ(weights["role"], "fit");
  EXPECT_TRUE(weights["rms_force_N"].is_null());  // lengths were measured
  EXPECT_NEAR(weights["rms_position_mm"], 0.2, 0.05);
  EXPECT_EQ(weights["points"], 144);
  EXPECT_EQ(weights["specimens"], 1);
  const json& cycles = fit["experiments"][1];
  EXPECT_EQ(cycles["role"], "validate");
  EXPECT_TRUE(cycles["rms_position_mm"].is_null());
  EXPECT_GT(cycles["rms_force_N"], 0);
  EXPECT_EQ(fit["covariance"].size(), 5u);
  EXPECT_EQ(fit["covariance"][0].size(), 5u);
  EXPECT_EQ(fit["models"].size(), 4u);
  EXPECT_EQ(fit["profiles"].size(), 1u);
  EXPECT_EQ(fit["conditions"]["temperature"], "20 degC");
}

TEST_F(ResultFiles, MaterialReadsBackToTheSameBits) {
  const Material material = read_material(file("material.json"));
  const auto law = law_of(material, "stretch.warp");
  ASSERT_TRUE(law.has_value());
  EXPECT_EQ(law->parameters(), law_of(result_->material, "stretch.warp")->parameters());
  EXPECT_EQ(material.density, 0.143);
  EXPECT_EQ(material.components.at("stretch.warp").status, ComponentStatus::measured);
  EXPECT_EQ(material.components.at("bend.weft").status, ComponentStatus::unmeasured);
  EXPECT_EQ(material.provenance.at("command"), kFacts.command);
  EXPECT_EQ(material.provenance.at("study_sha256"), kFacts.study_sha256);
  ASSERT_TRUE(material.components.at("stretch.warp").range.has_value());
  EXPECT_GT(material.components.at("stretch.warp").range->second, 0.2);
}

TEST_F(ResultFiles, FitJsonHasTheDigestsOfTheDataThatWereRead) {
  const json data = fit_json()["data"];
  ASSERT_EQ(data.size(), 2U);
  EXPECT_EQ(data[0]["experiment"], "weights");
  EXPECT_EQ(data[0]["file"], "weights.csv");
  EXPECT_EQ(data[0]["sha256"].get<std::string>().size(), 64U);
  EXPECT_NE(data[0]["sha256"], data[1]["sha256"]);
}

TEST_F(ResultFiles, MaterialSaysHowWellItsNumbersAreKnown) {
  const Material material = read_material(file("material.json"));
  const std::map<std::string, NumberError>& errors = material.components.at("stretch.warp").errors;
  EXPECT_EQ(errors.size(), result_->parameters.size());
  for (const ParameterEstimate& parameter : result_->parameters) {
    const NumberError& error = errors.at(parameter.name.substr(sizeof("stretch.warp")));
    EXPECT_EQ(error.std_error, parameter.std_error) << parameter.name;
    EXPECT_EQ(error.determined, parameter.determination) << parameter.name;
    EXPECT_EQ(error.told_by, "weights 100 %") << parameter.name;
  }
  EXPECT_TRUE(material.components.at("bend.weft").errors.empty());
}

TEST_F(ResultFiles, PredictionsHaveTheOwnColumnsThenMeasuredAndPredicted) {
  const std::string weights = test::content_of(file("predictions/weights.csv"));
  EXPECT_THAT(weights, StartsWith("repeat,peak_N,step,weight_N,length_mm,"));
  const CsvTable table = read_csv(file("predictions/weights.csv"), {});
  const std::vector<double> own = table.numbers("length_mm");
  const std::vector<double> measured = table.numbers("measured_length_mm");
  const std::vector<double> predicted = table.numbers("predicted_length_mm");
  ASSERT_EQ(own.size(), 144u);
  for (size_t i = 0; i < own.size(); ++i) {
    EXPECT_NEAR(measured[i], own[i], 1e-9) << "mm, over SI and back";
    EXPECT_NEAR(predicted[i], own[i], 1) << "mm, five times the noise";
  }
  EXPECT_THAT(test::content_of(file("predictions/cycles.csv")),
              StartsWith("force_N,length_mm,cycle,"));
  EXPECT_EQ(read_csv(file("predictions/cycles.csv"), {}).numbers("predicted_force_N").size(),
            static_cast<size_t>(result_->experiments[1].measured.size()));
}

TEST_F(ResultFiles, ParametersCsvAgreesWithFitJson) {
  const CsvTable table = read_csv(file("parameters.csv"), {});
  EXPECT_THAT(table.texts("name"),
              ElementsAre("stretch.warp.k1", "stretch.warp.k2", "stretch.warp.friction.a",
                          "stretch.warp.friction.b", "stretch.warp.friction.tau"));
  const json fit = fit_json();
  const std::vector<double> values = table.numbers("value");
  const std::vector<double> errors = table.numbers("std_error");
  for (size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(values[i], fit["parameters"][i]["value"]);
    EXPECT_EQ(errors[i], fit["parameters"][i]["std_error"]);
  }
}

TEST_F(ResultFiles, CurvesCsvHoldsTheLoopWithItsBand) {
  const CsvTable table = read_csv(file("curves.csv"), {});
  const auto strain = table.numbers("strain"), load = table.numbers("load"),
             unload = table.numbers("unload"), low = table.numbers("low"),
             high = table.numbers("high");
  EXPECT_EQ(table.texts("component").front(), "stretch.warp");
  EXPECT_EQ(strain.front(), 0);
  EXPECT_EQ(load.front(), 0);
  for (size_t i = 1; i + 1 < strain.size(); ++i) {
    EXPECT_GT(strain[i], strain[i - 1]);
    EXPECT_LT(unload[i], load[i]);
    EXPECT_LE(low[i], load[i]);
    EXPECT_GE(high[i], load[i]);
  }
}

TEST_F(ResultFiles, WhatIsUnknownIsNull) {
  StudyResult result = *result_;
  result.parameters[0].std_error.reset();
  result.parameters[0].value = std::numeric_limits<double>::infinity();
  const json fit = json::parse(summary_text(result, kFacts, true));
  EXPECT_TRUE(fit["parameters"][0]["std_error"].is_null());
  EXPECT_TRUE(fit["parameters"][0]["value"].is_null());
}

TEST(FitFiles, GiveALimitInPlaceOfTheIntervalOfWhatIsAtItsBound) {
  auto cycles = strip_cycles({0.05, 0.1, 0.2});
  cycles.instrument.force_noise = 8e-3;
  const VirtualLab lab = lab_of(published_fabric("polyester"), cycles);
  const auto friction_a = [&](const std::string& options) {
    VirtualStudy study(lab);
    study.set_model("stiffness: affine");
    if (!options.empty()) study.add(options);
    const json fit = json::parse(summary_text(study.fit(), kFacts, true));
    for (const json& p : fit["parameters"]) {
      if (p["name"] == "stretch.warp.friction.a") return p;
    }
    return json();
  };
  const json free = friction_a("");
  EXPECT_TRUE(free["limit"].is_null());
  const double value = free["value"], sd = free["std_error"];
  // A bound next to it: the profile is that of the free fit.
  const json bounded = friction_a(
      fmt::format("fit: {{bounds: {{stretch.warp.friction.a: [{}, 1000]}}}}", value + 0.01 * sd));
  EXPECT_EQ(bounded["at_bound"], true);
  EXPECT_TRUE(bounded["std_error"].is_null());
  // Student's one-sided quantile; the problem is nearly linear.
  EXPECT_NEAR((bounded["limit"].get<double>() - value) / sd, 1.66, 0.1);
}

TEST(EvaluationFiles, SayWhichMaterialPredicted) {
  const VirtualStudy study(lab_of(published_fabric("cotton"), hung_weights()));
  const StudyResult result = evaluate_study(study.study(), published_fabric("cotton"), {});
  RunFacts facts = kFacts;
  facts.material_file = "cotton.json";
  std::map<std::string, std::string> files;
  for (const auto& [name, content] : evaluation_files(result, facts)) files[name] = content;
  EXPECT_EQ(files.count("material.json"), 0u);
  const json evaluation = json::parse(files.at("evaluation.json"));
  EXPECT_EQ(evaluation["pliant"], "evaluation/1");
  EXPECT_EQ(evaluation["material"], "cotton.json");
  EXPECT_THAT(result.warnings, ::testing::IsEmpty());
  // The true material predicts noise-free lengths to rounding.
  EXPECT_LT(evaluation["experiments"][0]["rms_position_mm"], 1e-9);
  EXPECT_EQ(files.count("predictions/weights.csv"), 1u);
}

TEST(EvaluationFiles, WarnOfAMaterialWhoseNumbersNoDataTold) {
  const VirtualStudy study(lab_of(published_fabric("cotton"), hung_weights()));
  Material material = published_fabric("cotton");
  for (const char* number : {"k1", "k2"}) {
    material.components.at("stretch.warp").errors[number] = {40.0, {}, Determination::none, ""};
  }
  EXPECT_THAT(evaluate_study(study.study(), material, {}).warnings,
              ElementsAre(::testing::HasSubstr("the stiffness of stretch.warp")));
}

}  // namespace
}  // namespace pliant
