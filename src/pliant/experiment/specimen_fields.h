#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <utility>

#include "pliant/experiment/test_type.h"
#include "pliant/io/fields.h"

namespace pliant {

enum class InitialFriction {
  rest,     ///< a fresh specimen: no friction stress at the first row
  unknown,  ///< estimated as a nuisance parameter
};

/// Whether the stated gauge length is the strip's length free of force.
enum class RestLength {
  known,
  unknown,  ///< estimated as a nuisance parameter (default where a pretension is stated)
};

/// `TestFacts::unfitted` of strips between clamps.
inline constexpr std::string_view kUnfittedStrip =
    "rest length as stated, friction at rest, force offset from the rows in which the strip is "
    "slack";

// Fields that several tests have. Those that read throw InputError.

/// `TestType::make` of an experiment of that class.
template <class Made>
std::unique_ptr<ComponentExperiment> make_experiment(const ExperimentSpec& spec,
                                                     const DataRows& data,
                                                     const ClothFacts& cloth) {
  return std::make_unique<Made>(spec, data, cloth);
}

/// `direction`: warp, weft or bias.
std::string read_direction(Fields& fields);
/// `length` and `width`, or their defaults.
void read_length(Fields& fields, const SpecimenDefaults& defaults, TestSpec& spec);
void read_strip(Fields& fields, const SpecimenDefaults& defaults, TestSpec& spec);
/// The width of a strip that only its weight bends: it says nothing, and is kept for the record.
void read_recorded_width(Fields& fields, const SpecimenDefaults& defaults, TestSpec& spec);
InitialFriction read_initial_friction(Fields& fields);
RestLength read_rest_length(Fields& fields, double pretension);
/// `slip` and `compliance`; what is not stated is that of the defaults.
Clamps read_clamps(Fields& fields, const Clamps& defaults);
/// A quantity that is not negative; zero where it is not given.
double read_from_zero(Fields& fields, std::string_view key, Dimension dimension);

/// `length` and `width`, where they are stated.
WrittenFields written_size(const TestSpec& spec);
std::pair<std::string, std::string> written(InitialFriction friction);
std::pair<std::string, std::string> written(RestLength rest_length);
WrittenFields written(const Clamps& clamps);

}  // namespace pliant
