#include "pliant/experiment/drape/drape_test.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "pliant/base/add_once.h"
#include "pliant/base/parallel.h"
#include "pliant/experiment/drape/drape_tables.h"
#include "pliant/experiment/drape/drape_type.h"
#include "pliant/experiment/drape/draped_sheet.h"
#include "pliant/experiment/drape/silhouette_picture.h"
#include "pliant/experiment/experiment_data.h"

namespace pliant {
namespace {

constexpr int kRepeats = 3;
constexpr std::uint64_t kSeed = 1;  // of predictions, which are the same each time

/// The specimen draped in one history.
struct DrapedWay {
  DrapeSetup setup;
  std::vector<DrapedSheet> sheets;

  double mean() const { return mean_coefficient(sheets); }
  std::pair<double, double> coefficients() const {
    const auto [least, most] = std::ranges::minmax(
        sheets, {}, [](const DrapedSheet& sheet) { return sheet.figures.coefficient; });
    return {least.figures.coefficient, most.figures.coefficient};
  }
  std::pair<int, int> nodes() const {
    const auto [least, most] = std::ranges::minmax(
        sheets, {}, [](const DrapedSheet& sheet) { return sheet.figures.nodes; });
    return {least.figures.nodes, most.figures.nodes};
  }
};

/// The history of the measurement first.
std::vector<DrapedWay> ways_of(const DrapeSetup& measured) {
  std::vector<DrapedWay> ways{{measured, {}}};
  for (const DrapeHistory history : drape_histories()) {
    if (history == measured.history) continue;
    ways.push_back({measured, {}});
    ways.back().setup.history = history;
  }
  for (DrapedWay& way : ways) way.sheets.resize(kRepeats);
  return ways;
}

void drape_all(const Material& material, const WholeSheetWork& work, std::vector<DrapedWay>& ways) {
  const RandomStream random(kSeed);
  parallel_for(static_cast<int>(ways.size()) * kRepeats, work.threads, [&](int i) {
    DrapedWay& way = ways[static_cast<std::size_t>(i / kRepeats)];
    const int repeat = i % kRepeats;
    way.sheets[static_cast<std::size_t>(repeat)] =
        drape(material, way.setup, random.split(fmt::format("repeat {}", repeat + 1)),
              {.stop = work.stop});
    work.done(1);
  });
}

std::string range_text(std::pair<int, int> range) {
  const auto [least, most] = range;
  return least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most);
}

std::string way_text(const DrapedWay& way) {
  const auto [least, most] = way.coefficients();
  return fmt::format(
      "{}: drape coefficient {:.1f} % ({:.1f} % to {:.1f} % in {} repeats), {} nodes",
      name_of(way.setup.history), 100 * way.mean(), 100 * least, 100 * most, kRepeats,
      range_text(way.nodes()));
}

double spread_of(const std::vector<DrapedWay>& ways) {
  const auto [least, most] = std::ranges::minmax(ways, {}, &DrapedWay::mean);
  return most.mean() - least.mean();
}

std::string spread_text(const std::vector<DrapedWay>& ways) {
  return fmt::format(
      "the drape coefficient hangs on how the specimen came to hang by {:.1f} points: no single "
      "measurement is better known than that",
      100 * spread_of(ways));
}

nlohmann::ordered_json figures_of(const std::vector<DrapedWay>& ways) {
  nlohmann::ordered_json histories = nlohmann::ordered_json::array();
  for (const DrapedWay& way : ways) {
    nlohmann::ordered_json repeats = nlohmann::ordered_json::array();
    for (const DrapedSheet& sheet : way.sheets) {
      repeats.push_back({{"coefficient", sheet.figures.coefficient},
                         {"nodes", sheet.figures.nodes},
                         {"amplitude_mm", 1e3 * sheet.figures.amplitude},
                         {"irregularity", sheet.figures.irregularity},
                         {"crossings", sheet.crossings}});
    }
    histories.push_back({{"history", name_of(way.setup.history)},
                         {"coefficient", way.mean()},
                         {"repeats", std::move(repeats)}});
  }
  return {{"histories", std::move(histories)}, {"spread", spread_of(ways)}};
}

std::vector<double> read_coefficients(const DataRows& data) {
  std::vector<double> coefficients = data.quantity("drape", Dimension::fraction);
  for (std::size_t i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i] >= 0 && coefficients[i] <= 1) continue;
    throw InputError(data.location(static_cast<int>(i), "drape"),
                     fmt::format("{:.4g} % is no drape coefficient", 100 * coefficients[i]),
                     "0 % (nothing hangs beyond the disc) to 100 % (flat)");
  }
  return coefficients;
}

}  // namespace

DrapeTest::DrapeTest(const ExperimentSpec& spec, const DataRows& data)
    : setup_(spec_of<DrapeSpec>(spec).setup) {
  const std::vector<double> coefficients = read_coefficients(data);
  measured_ = Eigen::Map<const Eigen::VectorXd>(coefficients.data(), std::ssize(coefficients));
  data.optional_integers("nodes");
  data.optional_integers("repeat");
  data.optional_texts("face");
  data.optional_texts("irregularity");
  data.optional_quantity("amplitude", Dimension::length);
  info_ = describe_experiment(spec, data, {"drape_percent", "drape coefficient", "%", 100});
}

void DrapeTest::require(const Material& material, const Location& where) const {
  require_drapable(material, where);
}

int DrapeTest::work() const { return kRepeats * static_cast<int>(drape_histories().size()); }

WholeSheetPrediction DrapeTest::predict(const Material& material,
                                        const WholeSheetWork& work) const {
  std::vector<DrapedWay> ways = ways_of(setup_);
  drape_all(material, work, ways);
  const DrapedWay& own = ways.front();
  WholeSheetPrediction prediction;
  prediction.value = Eigen::VectorXd::Constant(measured_.size(), own.mean());
  const auto rows = static_cast<std::size_t>(measured_.size());
  prediction.columns = {
      {"predicted_nodes", std::vector<std::string>(rows, range_text(own.nodes()))}};
  for (const DrapedWay& way : ways) {
    prediction.told.push_back(way_text(way));
    for (const DrapedSheet& sheet : way.sheets) {
      for (const std::string& warning : sheet.warnings) add_once(warning, prediction.warnings);
    }
  }
  prediction.told.push_back(spread_text(ways));
  for (const std::string& advice : size_advice(own.sheets, setup_)) {
    add_once(advice, prediction.warnings);
  }
  prediction.figures = figures_of(ways);
  std::vector<NamedSilhouette> firsts;
  for (const DrapedWay& way : ways) {
    firsts.push_back({std::string(name_of(way.setup.history)), way.sheets.front()});
  }
  prediction.picture = silhouette_picture(info_.name, firsts, setup_);
  return prediction;
}

}  // namespace pliant
