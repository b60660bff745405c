// Weights and strips that are disturbed in one way each: what the fit finds then, with the loss or
// the nuisance that fits, and that it names the cause.

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pliant/base/random.h"

#include "estimation/virtual_study.h"

namespace pliant {
namespace {

using test::estimate_named;
using test::VirtualStudy;
using ::testing::Contains;
using ::testing::ContainsRegex;
using ::testing::IsEmpty;

using Rows = VirtualStudy::Rows;
using Row = std::vector<double>;

constexpr double kErrors = 3;

/// A test whose data are disturbed: where its columns stand, and its gauge length.
struct EditedTest {
  const char* file;
  std::size_t measured, length, count;  ///< columns: what is measured, length (mm), cycle or repeat
  double stated;                        ///< mm
  std::function<std::unique_ptr<VirtualStudy>()> study;
};

const Material& cotton() {
  static const Material material = test::published_fabric("cotton");
  return material;
}

EditedTest weights() {
  return {"weights.csv", 4, 4, 0, 100, [] {
            auto test = test::hung_weights();
            test.instrument.length_noise = 0.2e-3;
            return std::make_unique<VirtualStudy>(test::lab_of(cotton(), test), 1);
          }};
}

EditedTest strips() {
  return {"cycles.csv", 0, 1, 2, 100, [] {
            auto test = test::strip_cycles({0.05, 0.1, 0.2});
            test.repeats = 3;
            test.instrument.force_noise = 5e-3;
            auto study = std::make_unique<VirtualStudy>(test::lab_of(cotton(), test), 1);
            study->set_model("stiffness: affine");
            return study;
          }};
}

/// One way in which data are disturbed.
struct Disturbance {
  const char* name;
  std::function<void(const EditedTest&, VirtualStudy&)> disturb;
  std::function<void(VirtualStudy&)> remedy;  ///< null: there is none
  const char* warning;                        ///< a pattern; null: nothing needs to be said
};

/// One row in fifty is off by a tenth, to either side.
void throw_off(const EditedTest& test, VirtualStudy& study) {
  study.edit_rows(test.file, [&](Rows& rows) {
    RandomStream random(7);
    for (std::size_t i = 7; i < rows.size(); i += 50) {
      double& value = rows[i][test.measured];
      const bool is_length = test.measured == test.length;
      value += (random.uniform() < 0.5 ? -0.1 : 0.1) * (is_length ? value - test.stated : value);
    }
  });
}

void let_drift(const EditedTest& test, VirtualStudy& study) {
  study.edit_rows(test.file, [&](Rows& rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i][test.length] += static_cast<double>(i) / static_cast<double>(rows.size());
    }
  });
}

void lose_a_tenth(const EditedTest& test, VirtualStudy& study) {
  study.edit_rows(test.file, [&](Rows& rows) {
    RandomStream random(5);
    std::erase_if(rows, [&](const Row&) { return random.uniform() < 0.1; });
  });
}

void read_coarsely(const EditedTest& test, VirtualStudy& study) {
  study.edit_rows(test.file, [&](Rows& rows) {
    for (Row& row : rows) row[test.length] = std::round(row[test.length]);
  });
}

void swap_first_two(const EditedTest& test, VirtualStudy& study) {
  study.edit_rows(test.file, [&](Rows& rows) {
    const auto is = [&](double number) {
      return [&test, number](const Row& row) { return row[test.count] == number; };
    };
    const auto second = std::ranges::find_if(rows, is(2));
    const auto third = std::ranges::find_if(rows, is(3));
    std::rotate(rows.begin(), second, third);
  });
}

void state_too_long(const EditedTest& test, VirtualStudy& study) {
  study.set_in_experiment("length", fmt::format("{} mm", 1.02 * test.stated));
}

void state_too_short(const EditedTest& test, VirtualStudy& study) {
  study.set_in_experiment("length", fmt::format("{} mm", 0.98 * test.stated));
}

void free_length(VirtualStudy& study) { study.add_to_experiment("rest_length: unknown"); }

const std::vector<Disturbance>& disturbances() {
  static const std::vector<Disturbance> all{
      {"rows off by a tenth", throw_off,
       [](VirtualStudy& study) { study.add("fit: {loss: cauchy}"); }, "standard deviations"},
      {"a drift of 1 mm", let_drift, [](VirtualStudy&) {}, "the zero drifts"},
      {"a tenth missing", lose_a_tenth, [](VirtualStudy&) {}, nullptr},
      {"readings of 1 mm", read_coarsely, nullptr, "a grid of 1 mm"},
      {"repeats swapped", swap_first_two, [](VirtualStudy&) {}, "in the order"},
      {"a length 2 % too long", state_too_long, free_length, "contradict the stated gauge length"},
      {"a length 2 % too short", state_too_short, free_length,
       "contradict the stated gauge length"}};
  return all;
}

/// Largest error of the law's numbers, in standard errors.
double largest_error(const StudyResult& result) {
  double largest = 0;
  for (const std::string& name : test::names_of(cotton(), "stretch.warp")) {
    const ParameterEstimate estimate = estimate_named(result, name);
    if (!estimate.std_error) continue;
    const double off = std::abs(estimate.value - test::truth_of(cotton(), name));
    largest = std::max(largest, off / *estimate.std_error);
  }
  return largest;
}

void expect_named_and_cured(const EditedTest& test) {
  for (const Disturbance& disturbance : disturbances()) {
    const auto own = test.study();
    VirtualStudy& study = *own;
    disturbance.disturb(test, study);
    const StudyResult plain = study.fit();
    fmt::print("{:<24} {:>6.1f} standard errors off", disturbance.name, largest_error(plain));
    if (disturbance.warning != nullptr) {
      std::vector<std::string> told = plain.warnings;
      told.insert(told.end(), plain.questions.begin(), plain.questions.end());
      EXPECT_THAT(told, Contains(ContainsRegex(disturbance.warning))) << disturbance.name;
    }
    if (!disturbance.remedy) {
      fmt::print("\n");
      continue;
    }
    disturbance.remedy(study);
    const double cured = largest_error(study.fit());
    fmt::print(", {:.1f} with the loss or nuisance that fits\n", cured);
    EXPECT_LT(cured, kErrors) << disturbance.name;
  }
}

TEST(SlowPerturbedData, OfWeightsAreNamedAndCured) { expect_named_and_cured(weights()); }

TEST(SlowPerturbedData, OfStripsAreNamedAndCured) { expect_named_and_cured(strips()); }

// A robust loss costs clean data less than a tenth of their errors.
TEST(SlowPerturbedData, OfNoDisturbanceKeepTheirErrors) {
  for (const EditedTest& test : {weights(), strips()}) {
    const auto own = test.study();
    VirtualStudy& study = *own;
    const StudyResult squares = study.fit();
    EXPECT_THAT(squares.warnings, IsEmpty());
    EXPECT_LT(largest_error(squares), kErrors);
    const StudyResult robust = study.add("fit: {loss: huber}").fit();
    for (std::size_t i = 0; i < squares.parameters.size(); ++i) {
      const ParameterEstimate &one = squares.parameters[i], &other = robust.parameters[i];
      EXPECT_NEAR(*other.std_error / *one.std_error, 1, 0.1) << test.file << " " << one.name;
    }
  }
}

}  // namespace
}  // namespace pliant
