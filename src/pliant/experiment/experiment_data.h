#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/measurement/data_source.h"
#include "pliant/measurement/turning_points.h"

namespace pliant {

/// Fills what every experiment type has in common: names, role, specimens, used rows, own columns,
/// warnings. Call it after all known columns were read, so that the others can be reported.
/// @throws InputError for exclusions beyond the data
ExperimentInfo describe_experiment(const ExperimentSpec& spec, const DataRows& data,
                                   MeasuredQuantity quantity);

/// @throws InputError when the study states no density, which the experiment needs
void require_density(const ExperimentSpec& spec, double density);

/// @throws InputError when a specimen has fewer than `least` rows
void require_rows(const std::vector<SpecimenRows>& specimens, const DataRows& data, int least);

/// @throws InputError at the first value that is not above zero
void require_positive(const std::vector<double>& values, const DataRows& data,
                      std::string_view column);

/// @throws InputError when all values are equal: such a column determines nothing
void require_change(const std::vector<double>& values, const DataRows& data,
                    std::string_view column);

/// Name of a specimen's nuisance parameter: EXPERIMENT.NAME, or EXPERIMENT.SPECIMEN.NAME where
/// there are several.
std::string nuisance_name(const ExperimentInfo& info, size_t specimen, std::string_view name);

/// What the material carries at a row: strain, force, and force per stress.
struct CarriedLoad {
  double strain = 0;
  double force = 0;
  double factor = 1;
};

/// Appends the rows of a specimen to a measured path; each half cycle is anchored at the last row
/// of the one before.
/// @param load  of a row of the experiment, and the direction in which the path moves there
void append_half_cycles(const SpecimenRows& rows, int specimen,
                        std::span<const HalfCycle> half_cycles,
                        const std::function<CarriedLoad(int row, int direction)>& load,
                        MeasuredPath& path);

/// Says where numbers that count repeats or cycles go back within a specimen: rows in another order
/// than they were measured in carry the wrong state.
/// @param restarts  where counting may begin anew
std::optional<std::string> backward_count(std::string_view column, const std::vector<long>& numbers,
                                          const std::vector<SpecimenRows>& specimens,
                                          const std::function<bool(std::size_t row)>& restarts);

/// A length as it reads in a sentence, e.g. 0.0123 -> "12.3 mm".
std::string millimetres(double metres);

}  // namespace pliant
