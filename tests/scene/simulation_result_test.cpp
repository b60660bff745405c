// What tells of a simulation, written and read back.

#include "pliant/scene/simulation_result.h"

#include <gtest/gtest.h>

#include "io/temporary_folder.h"
#include "scene/simulated_scene.h"

namespace pliant {
namespace {

/// A sheet that falls for two steps, with a clip, a field and a frame.
struct FallingSheet {
  Simulation simulation = test::simulated(
      "info: {shot: '12'}\n"
      "cloth: [{name: sheet, mesh: {grid: 1 m x 1 m, nodes: 3x3}, material: jersey.json}]\n"
      "clips: [{name: left, cloth: sheet, edges: [left], mass: 1 g}]\n"
      "time: {step: 1 ms, duration: 3 ms}\noutput: {fields: [strain]}\n");

  FallingSheet() {
    simulation.advance();
    simulation.advance();
    simulation.record_frame();
  }
};

TEST(SimulationResult, IsReadAsItWasWritten) {
  const SimulationFacts facts{"pliant simulate", "2024-01-01T00:00:00Z", "0", "e3b0", 2, 20.5};
  const std::string text = simulation_text(simulation_result(FallingSheet().simulation, facts));
  const test::TemporaryFolder folder;
  folder.write("simulation.json", text);
  const SimulationResult result = read_simulation_result(folder.path());
  EXPECT_EQ(simulation_text(result), text);
  EXPECT_FALSE(result.finished);
  EXPECT_EQ(result.steps, 2);
  EXPECT_EQ(result.vertices, 9);
  EXPECT_EQ(result.last_time(), 0.002);
  EXPECT_EQ(result.info.at("shot"), "12");
  EXPECT_EQ(result.fields.at("strain.stretch.weft"), "1");
  EXPECT_EQ(result.clips, "clips.csv");
  EXPECT_EQ(result.solids, "");
  EXPECT_EQ(result.facts.peak_memory, 20.5);
}

TEST(EnergyTable, IsReadAsItWasWritten) {
  const std::vector<EnergyRow> rows = FallingSheet().simulation.now().energies;
  const test::TemporaryFolder folder;
  const auto read = read_energy_table(folder.write("energy.csv", energy_table(rows)));
  ASSERT_EQ(read.size(), 1u);
  EXPECT_EQ(energy_table(read), energy_table(rows));
  EXPECT_GT(read[0].kinetic, 0) << "it falls";
}

TEST(EnergyTable, OfAnEarlierVersionHasFewerColumns) {
  const test::TemporaryFolder folder;
  const auto rows = read_energy_table(
      folder.write("energy.csv", "time_s,kinetic_J,stored_J,work_J,total_J\n0.5,1,2,3,6\n"));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].work, 3);
  EXPECT_EQ(rows[0].outside, 0);
}

}  // namespace
}  // namespace pliant
