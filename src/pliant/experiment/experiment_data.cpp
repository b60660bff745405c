#include "pliant/experiment/experiment_data.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "pliant/experiment/registry.h"

namespace pliant {
namespace {

std::vector<char> used_rows(const ExperimentSpec& spec, int rows) {
  std::vector<char> used(static_cast<size_t>(rows), 1);
  for (const ExcludedRows& range : spec.excluded) {
    if (range.last > rows) {
      throw InputError({spec.where.file, spec.where.line, spec.where.field + ".exclude"},
                       fmt::format("rows {}-{} do not exist", range.first, range.last),
                       fmt::format("rows between 1 and {}", rows));
    }
    std::fill(used.begin() + range.first - 1, used.begin() + range.last, 0);
  }
  return used;
}

}  // namespace

ExperimentInfo describe_experiment(const ExperimentSpec& spec, const DataRows& data,
                                   MeasuredQuantity quantity) {
  ExperimentInfo info;
  info.name = spec.name;
  info.type = spec.type;
  info.direction = spec.direction;
  info.test = spec.test->type().facts;
  info.component = component_of_test(info.test, spec.direction);
  info.role = spec.role;
  info.quantity = std::move(quantity);
  for (const SpecimenRows& specimen : data.specimens()) info.specimens.push_back(specimen.name);
  info.used = used_rows(spec, data.rows());
  info.force_noise = spec.noise.force;
  info.length_noise = spec.noise.length;
  info.weight = spec.weight;
  if (data.is_stated("time")) {
    info.time = data.quantity("time", Dimension::time);
  } else if (unit_conversion(data.quantity_unit("time"), Dimension::time)) {
    // Nothing needs the time: another name's that cannot be read is left out.
    try {
      info.time = *data.optional_quantity("time", Dimension::time);
    } catch (const InputError&) {
      info.warnings.push_back("the column of the time cannot be read, and is not used");
    }
  }
  if (const auto cycles = data.optional_integers("cycle")) {
    const auto never = [](std::size_t) { return false; };
    if (auto warning = backward_count("cycle", *cycles, data.specimens(), never)) {
      info.warnings.push_back(std::move(*warning));
    }
  }
  info.handled = spec.told;
  std::ranges::copy(data.columns_by_synonym(), std::back_inserter(info.handled));
  std::ranges::copy(data.lines_left_out(), std::back_inserter(info.handled));
  for (const ExcludedRows& range : spec.excluded) {
    info.handled.push_back(
        fmt::format("rows {}-{} are left out: {}", range.first, range.last, range.reason));
  }
  if (spec.weight != 1) {
    info.handled.push_back(fmt::format(
        "its squared differences count {:.4g} times, as the study states", spec.weight));
  }
  for (const std::string& column : data.unused_columns()) {
    info.handled.push_back(fmt::format("column {} is not used", quoted_value(column)));
  }
  info.columns = data.own_columns();
  return info;
}

void require_density(const ExperimentSpec& spec, double density) {
  if (density > 0) return;
  throw InputError({spec.where.file, spec.where.line, spec.where.field},
                   "the study states no density, and its own weight bends the strip",
                   "`density:` of the study, e.g. 150 g/m^2");
}

void require_rows(const std::vector<SpecimenRows>& specimens, const DataRows& data, int least) {
  for (const SpecimenRows& specimen : specimens) {
    if (specimen.count >= least) continue;
    const Location where = data.location(specimen.first, "");
    throw InputError(where,
                     fmt::format("specimen {} has {} row{}", quoted_value(specimen.name),
                                 specimen.count, specimen.count == 1 ? "" : "s"),
                     fmt::format("at least {} rows", least));
  }
}

void require_positive(const std::vector<double>& values, const DataRows& data,
                      std::string_view column) {
  const auto bad = std::find_if(values.begin(), values.end(), [](double v) { return !(v > 0); });
  if (bad == values.end()) return;
  // Zero is where extensions begin, and lengths never.
  const bool is_length = column == "length";
  throw InputError(data.location(static_cast<int>(bad - values.begin()), column), "is not positive",
                   is_length ? "the distance of the clamps, above 0; is it an extension, counted "
                               "from the gauge length (a column `extension`)?"
                             : "a value above 0");
}

void require_change(const std::vector<double>& values, const DataRows& data,
                    std::string_view column) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  if (*high > *low) return;
  throw InputError(data.location(0, column), "is the same in every row",
                   "values that change: a constant one determines nothing");
}

std::optional<std::string> backward_count(std::string_view column, const std::vector<long>& numbers,
                                          const std::vector<SpecimenRows>& specimens,
                                          const std::function<bool(std::size_t row)>& restarts) {
  for (const SpecimenRows& specimen : specimens) {
    for (int i = specimen.first + 1; i < specimen.first + specimen.count; ++i) {
      const auto row = static_cast<std::size_t>(i);
      if (numbers[row] >= numbers[row - 1] || restarts(row)) continue;
      return fmt::format(
          "{} {} comes after {} {}: are the rows in the order in which they were measured? "
          "Friction "
          "goes on from each to the next",
          column, numbers[row], column, numbers[row - 1]);
    }
  }
  return std::nullopt;
}

std::string nuisance_name(const ExperimentInfo& info, size_t specimen, std::string_view name) {
  if (info.specimens.size() == 1) return fmt::format("{}.{}", info.name, name);
  return fmt::format("{}.{}.{}", info.name, info.specimens[specimen], name);
}

void append_half_cycles(const SpecimenRows& rows, int specimen,
                        std::span<const HalfCycle> half_cycles,
                        const std::function<CarriedLoad(int row, int direction)>& load,
                        MeasuredPath& path) {
  int anchor = rows.first;
  for (const HalfCycle& half : half_cycles) {
    for (int i = half.first; i <= half.last; ++i) {
      const CarriedLoad here = load(rows.first + i, half.direction);
      path.strain.push_back(here.strain);
      path.force.push_back(here.force);
      path.factor.push_back(here.factor);
      path.direction.push_back(half.direction);
      path.anchor.push_back(anchor);
      path.specimen.push_back(specimen);
    }
    anchor = rows.first + half.last;
  }
}

std::string millimetres(double metres) { return fmt::format("{:.4g} mm", metres * 1e3); }

}  // namespace pliant
