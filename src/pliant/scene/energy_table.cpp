#include "pliant/scene/energy_table.h"

#include <utility>

#include <fmt/format.h>

#include "pliant/io/csv.h"

namespace pliant {

std::string energy_table(const std::vector<EnergyRow>& rows) {
  std::string table =
      "time_s,kinetic_J,stored_J,work_J,total_J,drag_J,contact_J,rubbing_J,outside_J\n";
  for (const EnergyRow& row : rows) {
    table += fmt::format("{},{},{},{},{},{},{},{},{}\n", row.time, row.kinetic, row.stored,
                         row.work, row.total(), row.drag, row.contact, row.rubbing, row.outside);
  }
  return table;
}

std::vector<EnergyRow> read_energy_table(const std::filesystem::path& file) {
  const CsvTable table = read_csv(file);
  std::vector<EnergyRow> rows(table.numbers("time_s").size());
  const auto read = [&](const char* column, double EnergyRow::*member) {
    const std::vector<double> numbers = table.numbers(column);
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i].*member = numbers[i];
  };
  read("time_s", &EnergyRow::time);
  read("kinetic_J", &EnergyRow::kinetic);
  read("stored_J", &EnergyRow::stored);
  read("work_J", &EnergyRow::work);
  for (const auto& [column, member] :
       {std::pair("drag_J", &EnergyRow::drag), std::pair("contact_J", &EnergyRow::contact),
        std::pair("rubbing_J", &EnergyRow::rubbing), std::pair("outside_J", &EnergyRow::outside)}) {
    if (table.has(column)) read(column, member);
  }
  return rows;
}

}  // namespace pliant
