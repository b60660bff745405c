#include "report/sample_results.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <random>
#include <unistd.h>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace pliant::testing {
namespace {

using nlohmann::json;

/// sigma = k1 e + k2 e^3 + friction, with a Dahl law of constant bound.
struct SampleLaw {
  double k1, k2, max_friction, tau;

  double elastic(double strain) const { return k1 * strain + k2 * strain * strain * strain; }
  double step(double friction, double from, double to) const {
    const double sign = to >= from ? 1.0 : -1.0;
    const double saturated = sign * max_friction;
    return saturated + (friction - saturated) * std::exp(-std::abs(to - from) / tau);
  }
};

struct SampleExperiment {
  std::string name, type, direction, component, quantity;
  bool validation;
  SampleLaw law;
  double max_strain, width, noise;
  bool unloads = true;
};

std::vector<SampleExperiment> sample_experiments(const SampleOptions& options) {
  const SampleLaw warp = {60.0, 380.0, 2.2, 0.012};
  const SampleLaw weft = {18.0, 45.0, 1.1, 0.02};
  const SampleLaw bias = {25.0, 90.0, 1.4, 0.016};
  std::vector<SampleExperiment> all = {
      {"warp-stretch-8cm", "tensile-cycles", "warp", "stretch.warp", "force_N", false, warp, 0.35,
       0.05, 0.01},
      {"weft-stretch-8cm", "tensile-cycles", "weft", "stretch.weft", "force_N", false, weft, 0.6,
       0.05, 0.01},
      {"bias-stretch-8cm", "tensile-cycles", "bias", "stretch.bias", "force_N", false, bias, 0.45,
       0.05, 0.01, !options.loading_only_bias},
      {"warp-stretch-2cm", "tensile-cycles", "warp", "stretch.warp", "force_N", true, warp, 0.4,
       0.05, 0.02},
      {"weft-stretch-2cm", "tensile-cycles", "weft", "stretch.weft", "force_N", true, weft, 0.5,
       0.05, 0.02}};
  if (options.rich) {
    const SampleLaw shear = {9.0, 120.0, 0.35, 0.01};
    all.push_back({"shear-kes", "shear-cycles", "weft", "shear", "force_N_per_m", false, shear,
                   0.14, 1.0, 0.01});
    all.push_back({"warp-weights", "hanging-weights", "warp", "stretch.warp", "length_mm", false,
                   warp, 0.2, 0.1, 0.1});
  }
  return all;
}

/// Strains of three cycles of growing amplitude, or of one rise.
std::vector<double> strain_path(const SampleExperiment& e, std::size_t rows) {
  std::vector<double> strains;
  for (std::size_t row = 0; row < rows; ++row) {
    const double phase = static_cast<double>(row) / static_cast<double>(rows);
    const double cycle = std::floor(3.0 * phase);
    const double inside = 3.0 * phase - cycle;
    const double amplitude = e.max_strain * (cycle + 1.0) / 3.0;
    strains.push_back(e.unloads ? amplitude * (1.0 - std::abs(2.0 * inside - 1.0))
                                : e.max_strain * phase);
  }
  return strains;
}

/// The strain at which the law without friction bears that force.
double elastic_strain(const SampleExperiment& e, double force) {
  double low = -0.2, high = 2.0;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (low + high);
    (e.width * e.law.elastic(middle) < force ? low : high) = middle;
  }
  return low;
}

/// Independent of the standard library's distributions, which differ between platforms.
double noise(std::mt19937& generator) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) sum += static_cast<double>(generator()) / 4294967296.0;
  return sum;
}

std::string prediction_csv(const SampleExperiment& e, std::size_t rows) {
  const bool lengths = e.quantity == "length_mm";
  std::string text = lengths                    ? "weight_N,length_mm"
                     : e.type == "shear-cycles" ? "angle_deg,force_N_per_m"
                                                : "force_N,length_mm";
  text += fmt::format(
      ",specimen,strain,branch,used,measured_{0},predicted_{0},elastic_{0},time_s\n", e.quantity);
  std::mt19937 generator(7);
  const std::vector<double> strains = strain_path(e, rows);
  double friction = 0.0;
  for (std::size_t row = 0; row < rows; ++row) {
    const double strain = strains[row];
    if (row > 0) friction = e.law.step(friction, strains[row - 1], strain);
    const double elastic = e.width * e.law.elastic(strain);
    const double force = elastic + e.width * friction;
    const double length = 80.0 * (1.0 + strain);
    const bool rising = row == 0 || strain >= strains[row - 1];
    const double predicted = lengths ? length : force;
    const double measured = predicted + e.noise * noise(generator) +
                            (lengths ? 0.0 : 0.01 * e.noise / 0.01 * std::sin(20.0 * strain));
    const double driver = lengths                    ? force
                          : e.type == "shear-cycles" ? std::atan(strain) * 180.0 / std::numbers::pi
                                                     : measured;
    const double second = lengths ? measured : e.type == "shear-cycles" ? measured : length;
    text += fmt::format("{:.6g},{:.6g},{},{:.8g},{},{},{:.8g},{:.8g},{:.8g},{:.6g}\n", driver,
                        second, 1, strain, rising ? "load" : "unload", row < 5 ? 0 : 1, measured,
                        predicted, lengths ? 80.0 * (1.0 + elastic_strain(e, force)) : elastic,
                        0.05 * static_cast<double>(row));
  }
  return text;
}

json loop(double modulus, double ratio, double loss) {
  return {{"secant_modulus_N_per_m", modulus}, {"hysteresis_ratio", ratio}, {"loop_loss", loss}};
}

json experiment_json(const SampleExperiment& e, std::size_t rows) {
  const bool lengths = e.quantity == "length_mm";
  const double peak = e.width * (e.law.elastic(e.max_strain) + e.law.max_friction);
  json j = {{"name", e.name},
            {"type", e.type},
            {"direction", e.direction},
            {"component", e.component},
            {"role", e.validation ? "validate" : "fit"},
            {"quantity", e.quantity},
            {"rms_force_N", lengths ? json() : json(0.012 * peak)},
            {"peak_force_N", lengths ? json() : json(peak)},
            {"rms_percent_of_peak", lengths        ? 0.8
                                    : e.validation ? 5.7
                                                   : 1.24},
            {"rms_position_mm", lengths ? json(0.11) : json()},
            {"rms_elastic_percent_of_peak", lengths ? json() : json(4.9)},
            {"points", rows - 5},
            {"specimens", 1},
            {"excluded", 5},
            {"noise",
             {{"quantity", lengths ? "length" : "force"},
              {"value", e.noise},
              {"unit", lengths ? "mm" : "N"},
              {"source", "estimated from residuals"}}},
            {"strain_range", {0.0, e.max_strain}},
            {"loop", nullptr},
            {"handled",
             {"clamp distance below the gauge length in 12 rows: the strip is slack there",
              "friction stress at the first row unknown: estimated"}},
            {"prediction_file", "predictions/" + e.name + ".csv"}};
  if (e.unloads) {
    j["loop"] = {{"measured", loop(peak / e.width / e.max_strain, 0.214, 0.186)},
                 {"predicted", loop(1.006 * peak / e.width / e.max_strain, 0.207, 0.181)}};
  }
  return j;
}

json parameter(const std::string& component, const std::string& name, double value, double error,
               const std::string& unit) {
  return {{"name", component + "." + name},
          {"component", component},
          {"value", value},
          {"std_error", error},
          {"unit", unit},
          {"identified", true},
          {"at_bound", false},
          {"fixed", false},
          {"lower", value - 1.96 * error},
          {"upper", value + 1.96 * error},
          {"note", ""},
          {"between_specimen_sd", nullptr}};
}

json parameters_json(const SampleOptions& options) {
  json list = json::array();
  const auto add = [&](const std::string& component, const SampleLaw& law) {
    for (int i = 0; i < 3; ++i) {
      list.push_back(parameter(component, fmt::format("k[{}]", i), law.k1 * (1.0 + 0.4 * i),
                               0.004 * law.k1 * (1 + i), "N/m"));
    }
    list.push_back(
        parameter(component, "friction.a", law.max_friction, 0.021 * law.max_friction, "N/m"));
    list.push_back(parameter(component, "friction.b", 0.31, 0.09, "N/m"));
    list.push_back(parameter(component, "friction.tau", law.tau, 0.03 * law.tau, "1"));
  };
  std::string last;
  for (const SampleExperiment& e : sample_experiments(options)) {
    if (e.validation || e.quantity == "length_mm" || e.component == last) continue;
    add(e.component, e.law);
    last = e.component;
  }
  for (json& p : list) {
    const std::string name = p["name"];
    if (name.starts_with("stretch.bias.friction")) p["identified"] = false;
    if (name == "stretch.weft.friction.b") p["at_bound"] = true;
    if (name.starts_with("stretch.warp.k"))
      p["between_specimen_sd"] = 0.03 * p["value"].get<double>();
    if (name == "shear.friction.tau")
      p.update(json{{"fixed", true}, {"note", "fixed by the study"}});
  }
  return list;
}

json nuisance_json() {
  json offset = parameter("stretch.warp", "force_offset", 0.0123, 0.002, "N");
  offset["name"] = "warp-stretch-8cm.force_offset";
  offset["experiment"] = "warp-stretch-8cm";
  offset.erase("component");
  json initial = parameter("stretch.warp", "initial_friction", -1.9, 0.4, "N/m");
  initial["name"] = "warp-stretch-8cm.initial_friction";
  initial["experiment"] = "warp-stretch-8cm";
  initial.erase("component");
  return {offset, initial};
}

/// The nuisance parameters of the sample belong to a test of stretch.warp.
std::string component(const json& parameter) {
  return parameter.value("component", "stretch.warp");
}

/// Neighbouring parameters of one component are correlated, components are not.
json covariance_json(const json& parameters, const json& nuisance) {
  std::vector<json> all(parameters.begin(), parameters.end());
  all.insert(all.end(), nuisance.begin(), nuisance.end());
  json rows = json::array();
  for (std::size_t i = 0; i < all.size(); ++i) {
    json row = json::array();
    for (std::size_t j = 0; j < all.size(); ++j) {
      const double distance = std::abs(static_cast<double>(i) - static_cast<double>(j));
      const double rho = component(all[i]) == component(all[j]) ? std::pow(-0.55, distance) : 0.0;
      row.push_back(rho * all[i]["std_error"].get<double>() * all[j]["std_error"].get<double>());
    }
    rows.push_back(row);
  }
  return rows;
}

json profile_json() {
  json values = json::array(), increase = json::array();
  for (int i = -20; i <= 20; ++i) {
    const double t = 0.2 * i;
    values.push_back(2.2 + 0.046 * t);
    increase.push_back(t * t * (1.0 + 0.08 * t));
  }
  return {{"parameter", "stretch.warp.friction.a"},
          {"unit", "N/m"},
          {"value", values},
          {"delta_chi2", increase},
          {"lower", 2.1034},
          {"upper", 2.2846},
          {"std_error", 0.046}};
}

json models_json() {
  const auto model = [](const char* name, int parameters, double rms, double bic, double delta) {
    return json{{"component", "stretch.warp"}, {"name", name},      {"parameters", parameters},
                {"rms_percent_of_peak", rms},  {"aic", bic - 30.0}, {"bic", bic},
                {"delta_bic", delta}};
  };
  return {model("linear sigma_max, constant tau", 8, 1.24, -2310.4, 0.0),
          model("constant sigma_max, constant tau", 7, 1.41, -2291.0, 19.4),
          model("constant alpha", 7, 1.96, -2102.7, 207.7)};
}

/// Stiffness at rest and the width of the loop, of each component.
json figures_json(const SampleOptions& options) {
  json list = json::array();
  std::string last;
  for (const SampleExperiment& e : sample_experiments(options)) {
    if (e.validation || e.quantity == "length_mm" || e.component == last) continue;
    last = e.component;
    const auto add = [&](const char* name, double value, double error) {
      const auto of_fit = [&](double number) { return options.evaluation ? json() : json(number); };
      list.push_back({{"component", e.component},
                      {"name", name},
                      {"value", value},
                      {"unit", "N/m"},
                      {"at", nullptr},
                      {"std_error", of_fit(error * value)},
                      {"lower", of_fit((1 - 2 * error) * value)},
                      {"upper", of_fit((1 + 2 * error) * value)},
                      {"beyond_range", false}});
    };
    const bool unloads = e.component != "stretch.bias";
    add("stiffness_at_rest", e.law.k1, 0.02);
    add("loop_width", 2 * e.law.max_friction, unloads ? 0.02 : 0.8);
  }
  return list;
}

json results_json(const SampleOptions& options) {
  json j = {{"pliant", options.evaluation ? "evaluation/1" : "fit/1"},
            {"name", options.name},
            {"density", 0.157},
            {"info", {{"lot", "A7"}, {"operator", "KL"}, {"fibre", "95 % cotton, 5 % elastane"}}},
            {"conditions", {{"temperature", "20 degC"}, {"humidity", "65 %"}}},
            {"command", "pliant fit jersey/study.yaml -o jersey/fit"},
            {"created", "2026-01-01T10:00:00Z"},
            {"version", "0.1.0"},
            {"estimator", "path"},
            {"converged", true},
            {"seconds", 0.83}};
  j["experiments"] = json::array();
  for (const SampleExperiment& e : sample_experiments(options)) {
    j["experiments"].push_back(experiment_json(e, options.rows));
  }
  j["membrane"] = "stvk";
  j["figures"] = figures_json(options);
  j["assumptions"] = {"Friction at the first row of each strip is unknown and estimated.",
                      "Noise is in the force; lengths are taken as exact."};
  j["warnings"] = json::array();
  if (!options.question.empty()) {
    j["questions"] = {options.question};
    j["warnings"].push_back(options.question);
  }
  j["warnings"].push_back(options.warning);
  if (!options.skipped.empty()) {
    j["skipped"] = {{{"name", options.skipped}, {"missing", {"shear"}}}};
  }
  if (options.evaluation) {
    j["material"] = "jersey.json";
    return j;
  }
  j["parameters"] = parameters_json(options);
  j["nuisance"] = nuisance_json();
  j["covariance"] = covariance_json(j["parameters"], j["nuisance"]);
  j["singular_values"] = {
      {{"component", "stretch.warp"}, {"values", {41.0, 12.3, 4.1, 0.92, 0.31, 0.08}}},
      {{"component", "stretch.bias"}, {"values", {33.0, 9.8, 2.4, 1.1e-7}}}};
  j["stages"] = {{{"component", "stretch.warp"},
                  {"name", "1 control point"},
                  {"rms", 0.41},
                  {"unit", "N"},
                  {"accepted", true}},
                 {{"component", "stretch.warp"},
                  {"name", "3 control points"},
                  {"rms", 0.0212},
                  {"unit", "N"},
                  {"accepted", true}},
                 {{"component", "stretch.warp"},
                  {"name", "4 control points"},
                  {"rms", 0.0211},
                  {"unit", "N"},
                  {"accepted", false},
                  {"ended", "more is not worth it"}}};
  j["starts"] = {{{"component", "stretch.warp"}, {"tried", 8}, {"reached_best", 7}}};
  j["judgement"] = {{"fitness", "fit"},
                    {"headline", "Fit for use within the range of the data."},
                    {"details", kSampleDetails},
                    {"undetermined", nlohmann::json::array()},
                    {"experiments", nlohmann::json::array()},
                    {"criteria", nlohmann::json::array()}};
  if (options.loading_only_bias) {
    j["judgement"]["undetermined"].push_back("friction of stretch.bias: its data never unload");
  }
  if (options.rich) {
    j["profiles"] = {profile_json()};
    j["models"] = models_json();
  }
  return j;
}

std::string curves_csv(const SampleOptions& options) {
  std::string text = "component,strain,load,unload,low,high,elastic,friction_max\n";
  std::string last;
  for (const SampleExperiment& e : sample_experiments(options)) {
    if (e.validation || e.quantity == "length_mm" || e.component == last) continue;
    last = e.component;
    constexpr int kSamples = 60;
    for (int i = 0; i <= kSamples; ++i) {
      const double strain = e.max_strain * i / kSamples;
      const double peak = e.law.step(0.0, 0.0, e.max_strain);
      const double load = e.law.elastic(strain) + e.law.step(0.0, 0.0, strain);
      const double unload = e.law.elastic(strain) + e.law.step(peak, e.max_strain, strain - 1e-12);
      const double band = 0.02 * load + 0.05;
      text += fmt::format("{},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}\n", e.component,
                          strain, load, unload, load - band, load + band, e.law.elastic(strain),
                          e.law.max_friction * (1.0 + 0.3 * strain));
    }
  }
  return text;
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "pliant-report-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

void write_sample_results(const std::filesystem::path& directory, const SampleOptions& options) {
  write_text(directory / (options.evaluation ? "evaluation.json" : "fit.json"),
             results_json(options).dump(1));
  write_text(directory / "curves.csv", curves_csv(options));
  if (!options.evaluation) {
    write_text(directory / "material.json", R"({"pliant": "material/1", "membrane": "stvk"})");
  }
  for (const SampleExperiment& e : sample_experiments(options)) {
    write_text(directory / "predictions" / (e.name + ".csv"), prediction_csv(e, options.rows));
  }
}

}  // namespace pliant::testing
