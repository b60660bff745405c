#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace pliant {

/// Where the energy of a system is at one time (J). As far as a step's equations are solved, the
/// total never grows by more than the work from outside (but for what backward Euler gains while it
/// buckles).
struct EnergyRow {
  double time = 0;
  double kinetic = 0;
  double stored = 0;   ///< elastic energy, gravity and cords
  double work = 0;     ///< done against friction, damping and air since the start
  double drag = 0;     ///< of it, against the air
  double contact = 0;  ///< of what is stored, in contacts
  double rubbing = 0;  ///< of the work, against the friction of contacts
  double outside = 0;  ///< work done by what is moved from outside since the start

  double total() const { return kinetic + stored + work; }
};

/// energy.csv: a row a frame.
std::string energy_table(const std::vector<EnergyRow>& rows);

/// Columns that files of earlier versions lack are 0.
/// @throws InputError where the file is missing or not what its format says
std::vector<EnergyRow> read_energy_table(const std::filesystem::path& file);

}  // namespace pliant
