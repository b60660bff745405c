// What is moved from outside does the work that a simulation gains, and no more is gained.

#include <cmath>
#include <numeric>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/body_scene.h"

namespace pliant {
namespace {

using test::BodyScene;

struct Moved {
  std::string name, what;
  std::string place = "rotate: {axis: [1, 0, 0], angle: 90 deg}";  // it hangs from its top edge
  std::string time = "{step: 2 ms, duration: 400 ms}";
};

const std::string kLevel = "translate: [-0.06, -0.06, 0]";

void PrintTo(const Moved& moved, std::ostream* out) { *out << moved.name; }

/// A sheet of 120 mm and something that moves it.
class OutsideWork : public ::testing::TestWithParam<Moved> {
 protected:
  Simulation simulation() const {
    folder.write_ball("ball.obj", 50, -53);
    return folder.simulated(fmt::format(
        "cloth:\n"
        "  - {{name: sheet, mesh: {{grid: 120 mm x 120 mm, nodes: 9x9}}, material: jersey.json,\n"
        "     place: {{{}}}}}\n"
        "{}time: {}\n",
        GetParam().place, GetParam().what, GetParam().time));
  }
  const BodyScene folder;
};

// Backward Euler loses energy; that it loses little says that the work is not too large.
TEST_P(OutsideWork, IsWhatTheTotalEnergyGainsAtMost) {
  Simulation sheet = simulation();
  sheet.record_frame();
  const EnergyRow start = sheet.now().energies.back();
  double before = start.total(), lost = 0;
  while (!sheet.is_finished()) {
    sheet.advance();
    sheet.record_frame();
    const EnergyRow& row = sheet.now().energies.back();
    const double kept = row.total() - row.outside;
    EXPECT_LE(kept, before + 1e-7) << row.time;
    lost += before - kept;
    before = kept;
  }
  const EnergyRow end = sheet.now().energies.back();
  EXPECT_GT(std::abs(end.outside), 5e-4);
  EXPECT_NEAR(end.total() - start.total(), end.outside, 0.2 * std::abs(end.outside));
  EXPECT_NEAR(lost, start.total() - end.total() + end.outside, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(
    Of, OutsideWork,
    ::testing::Values(
        Moved{"Pins",
              "pins: [{cloth: sheet, edges: [top], motion: {keyframes: [{time: 0 s},\n"
              "        {time: 400 ms, translate: [0, 0, 0.1]}]}}]\n"},
        Moved{"AxesOfPins",
              "pins: [{cloth: sheet, edges: [top], directions: [z], motion: {keyframes: [{time: 0 "
              "s},\n"
              "        {time: 400 ms, translate: [0, 0, 0.1]}]}}]\n"},
        Moved{"PinsInEquilibrium",
              "pins: [{cloth: sheet, edges: [top], motion: {keyframes: [{time: 0 s},\n"
              "        {time: 400 ms, translate: [0, 0, 0.1]}]}}]\n",
              "rotate: {axis: [1, 0, 0], angle: 90 deg}",
              "{kind: quasi-static, steps: 20, duration: 400 ms}"},
        Moved{"Clips",
              "clips: [{name: bar, cloth: sheet, within: {box: {low: [-0.01, 0.11, -0.01],\n"
              "         high: [0.13, 0.13, 0.01]}}, mass: 5 g, motion: {keyframes: [{time: 0 s},\n"
              "         {time: 400 ms, translate: [0, 0, 0.05], rotate: {axis: [0, 0, 1],\n"
              "          angle: 60 deg}}]}}]\n"},
        Moved{"Forces",
              "clips: [{name: bar, cloth: sheet, within: {box: {low: [-0.01, 0.11, -0.01],\n"
              "         high: [0.13, 0.13, 0.01]}}, mass: 5 g, free: true, cords: [{vertex: 76,\n"
              "         force: {keyframes: [{time: 0 s, value: [0, 0, 0]},\n"
              "                             {time: 400 ms, value: [0, 0.02, 0.3]}]}}]}]\n"},
        Moved{"EndsOfCords",
              "clips: [{name: bar, cloth: sheet, within: {box: {low: [-0.01, 0.11, -0.01],\n"
              "         high: [0.13, 0.13, 0.01]}}, mass: 5 g, free: true, cords: [{vertex: 76,\n"
              "         length: 100 mm, stiffness: 20 N/m, end: {keyframes: [\n"
              "          {time: 0 s, value: [0, 0.06, 0.1]},\n"
              "          {time: 400 ms, value: [0, 0.06, 0.3]}]}}]}]\n"},
        Moved{
            "ConvexBodies",
            "obstacles: [{name: ball, sphere: {centre: [0, 0, -0.0525], radius: 50 mm},\n"
            "             friction: 0.4, motion: {interpolation: smooth, keyframes: [{time: 0 s},\n"
            "             {time: 400 ms, translate: [0.02, 0, 0.1], rotate: {axis: [0, 0, 1],\n"
            "              angle: 40 deg}}]}}]\n",
            kLevel},
        Moved{"MeshBodies",
              "obstacles: [{name: ball, mesh: {file: ball.obj, unit: mm}, friction: 0.4,\n"
              "             motion: {interpolation: smooth, keyframes: [{time: 0 s},\n"
              "             {time: 400 ms, translate: [0.02, 0, 0.1], rotate: {axis: [0, 0, 1],\n"
              "              angle: 40 deg}}]}}]\n"
              "contact: {thickness: 2 mm}\n",
              kLevel}),
    [](const auto& moved) { return moved.param.name; });

TEST(NothingMoved, DoesNoWork) {
  const BodyScene folder;
  Simulation sheet = folder.simulated(
      "cloth:\n"
      "  - {name: sheet, mesh: {grid: 120 mm x 120 mm, nodes: 5x5}, material: jersey.json}\n"
      "pins: [{cloth: sheet, edges: [top]}]\n"
      "time: {step: 5 ms, duration: 50 ms}\n");
  while (!sheet.is_finished()) sheet.advance();
  EXPECT_EQ(sheet.now().outside, 0);
}

// What the phases name is never more than a step.
double named_seconds(const StepRecords& records) {
  double named = 0;
  for (size_t i = 0; i < records.costs.size(); ++i) {
    const SearchCosts& step = records.costs[i];
    const double sum =
        step.assembly + step.equations + step.energies + step.pairs + step.ways + step.history;
    EXPECT_LE(sum, records.seconds[i]);
    EXPECT_GT(step.energies, 0);
    EXPECT_GT(step.history, 0);
    named += sum;
  }
  return named;
}

TEST(Phases, AreMostOfTheSecondsOfAStep) {
  const BodyScene folder;
  for (const char* time :
       {"{step: 5 ms, duration: 50 ms}", "{kind: quasi-static, steps: 3, duration: 1 s}"}) {
    Simulation sheet = folder.simulated(
        fmt::format("cloth:\n"
                    "  - {{name: sheet, mesh: {{grid: 120 mm x 120 mm, nodes: 21x21}}, material: "
                    "jersey.json}}\n"
                    "pins: [{{cloth: sheet, edges: [top]}}]\ntime: {}\n",
                    time));
    while (!sheet.is_finished()) sheet.advance();
    const StepRecords& records = sheet.now().records;
    ASSERT_EQ(records.costs.size(), records.seconds.size());
    const double all = std::reduce(records.seconds.begin(), records.seconds.end());
    EXPECT_GT(named_seconds(records), 0.5 * all);
    for (const SearchCosts& step : records.costs) {
      EXPECT_EQ(step.pairs, 0);
      EXPECT_EQ(step.way_tests, 0);
    }
  }
}

TEST(Phases, TellThePairsOfContactFromItsWays) {
  const BodyScene folder;
  folder.write_ball("ball.obj", 50, -53);
  Simulation sheet = folder.simulated(
      "cloth: [{name: sheet, mesh: {grid: 120 mm x 120 mm, nodes: 9x9}, material: jersey.json,\n"
      "         place: {translate: [-0.06, -0.06, 0]}}]\n"
      "obstacles: [{name: ball, mesh: {file: ball.obj, unit: mm}}]\n"
      "contact: {thickness: 2 mm}\ntime: {step: 5 ms, duration: 100 ms}\n");
  while (!sheet.is_finished()) sheet.advance();
  const StepRecords& records = sheet.now().records;
  named_seconds(records);
  EXPECT_GT(records.contacts.back(), 0);
  for (const SearchCosts& step : records.costs) {
    EXPECT_GT(step.pairs, 0);
    EXPECT_GT(step.ways, 0);
  }
  EXPECT_GT(records.costs.back().way_tests, records.contacts.back());
}

}  // namespace
}  // namespace pliant
