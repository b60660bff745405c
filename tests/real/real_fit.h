#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "app/run_program.h"

// What tests on real measurements share: where those are, and fits of them by the program.

namespace pliant::test {

inline std::filesystem::path measurement(const std::string& name) {
  const char* folder = std::getenv("PLIANT_TEST_DATA");
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder) / name;
}

#define SKIP_WITHOUT(path) \
  if (!std::filesystem::exists(path)) GTEST_SKIP() << "PLIANT_TEST_DATA does not hold " << path

inline std::string cell(const nlohmann::json& value, const char* format = "{:.2f}") {
  return value.is_number() ? fmt::format(fmt::runtime(format), value.get<double>()) : "-";
}

inline std::string pair_of(const nlohmann::json& loop, const char* metric) {
  if (!loop.is_object()) return "-";
  return cell(loop["measured"][metric]) + " / " + cell(loop["predicted"][metric]);
}

/// Errors and loops of all experiments of a fit, one line each.
inline void print_table(const nlohmann::json& fit) {
  fmt::print("{:<20} {:<9} {:>7} {:>8} {:>6} {:>16} {:>16} {:>8}\n", "experiment", "role", "RMS %",
             "elastic", "ratio", "hysteresis m / p", "loop loss m / p", "seconds");
  for (const nlohmann::json& e : fit["experiments"]) {
    const nlohmann::json& rms = e["rms_percent_of_peak"];
    const nlohmann::json& elastic = e["rms_elastic_percent_of_peak"];
    const std::string ratio =
        elastic.is_number() ? cell(elastic.get<double>() / rms.get<double>(), "{:.1f}") : "-";
    fmt::print("{:<20} {:<9} {:>7} {:>8} {:>6} {:>16} {:>16} {:>8}\n", e["name"].get<std::string>(),
               e["role"].get<std::string>(), cell(rms), cell(elastic), ratio,
               pair_of(e["loop"], "hysteresis_ratio"), pair_of(e["loop"], "loop_loss"),
               cell(fit["seconds"]));
  }
}

inline nlohmann::json experiment_named(const nlohmann::json& fit, const std::string& name) {
  for (const nlohmann::json& e : fit["experiments"]) {
    if (e["name"] == name) return e;
  }
  ADD_FAILURE() << "no experiment " << name;
  return {};
}

struct RealFit {
  ProgramRun run;
  nlohmann::json fit;
};

inline RealFit fit_file(const TemporaryFolder& folder, const std::filesystem::path& study) {
  RealFit real;
  real.run = run_program({"fit", study.string(), "-o", (folder.path() / "fit").string(), "--json"});
  EXPECT_EQ(real.run.status, 0) << real.run.err;
  real.fit = nlohmann::json::parse(real.run.out, nullptr, false);
  return real;
}

inline double value_of(const nlohmann::json& fit, const std::string& parameter) {
  for (const nlohmann::json& p : fit["parameters"]) {
    if (p["name"] == parameter) return p["value"];
  }
  ADD_FAILURE() << "no parameter " << parameter;
  return 0;
}

}  // namespace pliant::test
