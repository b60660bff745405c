#include "pliant/experiment/virtual_table.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "pliant/experiment/registry.h"
#include "pliant/io/csv_writer.h"
#include "pliant/material/material_samples.h"

namespace pliant {
namespace {

constexpr int kDigits = 4;

ComponentLaw specimen_law(const ComponentLaw& law, double variation, RandomStream& random) {
  if (variation == 0) return law;
  Eigen::VectorXd parameters = law.parameters();
  for (double& p : parameters) p *= std::exp(variation * random.normal());
  return law.with_parameters(parameters);
}

std::string instrument_text(const std::vector<Channel>& channels, const Instrument& instrument,
                            double Instrument::*Channel::*number) {
  std::vector<std::string> texts;
  for (const Channel& channel : channels) {
    const double value = instrument.*(channel.*number);
    texts.push_back(fmt::format(
        "{} {}", channel.key,
        value > 0 ? format_quantity(value, channel.dimension, kDigits) : std::string("none")));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

void read_numbers(Fields& fields, std::string_view key, double Instrument::*Channel::*number,
                  VirtualTable& test) {
  const auto node = fields.optional(key);
  if (!node) return;
  Fields inner = node->fields();
  for (const Channel& channel : test.type().channels) {
    if (auto v = inner.optional(channel.key)) {
      test.instrument.*(channel.*number) = v->quantity_from_zero(channel.dimension);
    }
  }
  inner.finish();
}

/// What strips in one dimension do not know.
void refuse_laws_of_sheets(const Material& material, const std::string& component,
                           const Location& where) {
  if (differs_in(material, component)) {
    throw InputError(where,
                     fmt::format("is of a strip that is the same everywhere, and {} of the "
                                 "material {} differs from place to place",
                                 component, quoted_value(material.name)),
                     "a material without samples, or a test of sheets");
  }
  for (const EnergyLimit& limit : material.limits) {
    if (std::ranges::find(limit.of, component) == limit.of.end()) continue;
    throw InputError(where,
                     fmt::format("a strip in one dimension knows no limits of energy, and the "
                                 "material {} has {}",
                                 quoted_value(material.name), limit_name(limit.of)),
                     "a material without it");
  }
}

}  // namespace

void VirtualTable::require(const Material& material) const {
  const TestFacts& facts = type().facts;
  const auto law = law_of(material, component_of_test(facts, direction));
  if (!law) {
    throw InputError(
        where,
        "needs a component that the material " + quoted_value(material.name) + " does not have",
        "a direction that was measured or assumed");
  }
  refuse_laws_of_sheets(material, component_of_test(facts, direction), where);
  if (facts.needs_density && !(material.density > 0)) {
    throw InputError(where,
                     "needs the density of the material " + quoted_value(material.name) +
                         ", which does not say it",
                     "a material with `density`: its own weight bends the strip");
  }
}

VirtualData VirtualTable::measure(const VirtualSpecimen& specimen, const VirtualWork& work) const {
  work.stop.throw_if_requested();
  const Material& material = specimen.material;
  const auto stream_of = [&](const VirtualTest& test) {
    return specimen.random.split(fmt::format("{}/{}", test.name, specimen.number));
  };
  RandomStream random = stream_of(*this), of_strip = stream_of(first());
  const ComponentLaw law = *law_of(material, component_of_test(type().facts, direction));
  const ComponentLaw own = specimen_law(law, specimen.variation, before ? of_strip : random);
  return {{{specimen.name + ".csv", rows(own, {material.density, material.membrane}, random)}}};
}

nlohmann::ordered_json VirtualTable::facts() const {
  return {{"direction", direction},
          {"peaks", peaks},
          {"settings", settings},
          {"repeats", repeats},
          {"force_noise", instrument.force_noise},
          {"length_noise", instrument.length_noise},
          {"force_resolution", instrument.force_resolution},
          {"length_resolution", instrument.length_resolution}};
}

WrittenFields VirtualTable::description() const {
  WrittenFields lines = own_description();
  lines.emplace_back(
      "instrument",
      fmt::format("noise: {}; resolution: {}",
                  instrument_text(type().channels, instrument, &Channel::noise),
                  instrument_text(type().channels, instrument, &Channel::resolution)));
  return lines;
}

WrittenFields VirtualTable::study_fields() const {
  return {{"direction", direction},
          {"width", fmt::format("{} m", width)},
          {"length", fmt::format("{} m", length)}};
}

std::string VirtualTable::size_text() const {
  return fmt::format("{} long, {} wide", format_quantity(length, Dimension::length, kDigits),
                     format_quantity(width, Dimension::length, kDigits));
}

std::string VirtualTable::sequence_text(const std::vector<double>& values, Dimension dimension,
                                        const std::string& more) const {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(format_quantity(value, dimension, kDigits));
  return fmt::format("{}; {} repeat{}{}", fmt::join(texts, ", "), repeats, repeats == 1 ? "" : "s",
                     more);
}

Prediction VirtualTable::predicted(const ComponentExperiment& experiment, const ComponentLaw& law,
                                   const Eigen::VectorXd& nuisance) const {
  auto prediction = experiment.predict(law, nuisance, /*with_jacobian=*/false);
  if (!prediction) fail("the material cannot carry its loads; its prediction");
  return std::move(*prediction);
}

void VirtualTable::fail(const std::string& problem) const {
  throw SolverError(fmt::format("virtual experiment {}: {}", name, problem), 0, 0);
}

SampledPath VirtualCycles::clamp_path(int way) const {
  const auto [least, most] = std::minmax_element(peaks.begin(), peaks.end());
  const double share = way * slack / length;
  require_samples((*least + share) / (*most + share));
  std::vector<double> turns;
  for (const double peak : peaks) turns.push_back(length * (1 + way * peak));
  const double start = length - slack, reach = std::abs(length * (1 + way * *most) - start);
  return sample_path(cycle_turns(start, turns, repeats), reach / (samples - 1));
}

SampledPath VirtualCycles::timed(SampledPath path) const {
  if (duration > 0) set_duration(duration, path);
  return path;
}

void VirtualCycles::require_samples(double share) const {
  constexpr int kFewestRows = 9;
  const double rows = share * (samples - 1);
  if (rows >= kFewestRows) return;
  throw InputError({where.file, where.line, where.field + ".samples"},
                   fmt::format("the shortest half cycle would have {:.0f} rows", rows),
                   fmt::format("at least {}: more `samples`, or no such small peak", kFewestRows));
}

std::vector<ReadColumn> with_times(std::vector<ReadColumn> columns, const SampledPath& path) {
  if (!path.time.empty()) columns.push_back({"time_s", path.time});
  return columns;
}

std::string table_text(const std::vector<ReadColumn>& columns, RandomStream& random) {
  std::vector<std::string> header;
  for (const ReadColumn& column : columns) header.push_back(column.header);
  CsvWriter csv(header);
  for (size_t row = 0; row < columns.front().values.size(); ++row) {
    for (const auto& [name, values, per_si, reading] : columns) {
      csv.cell(per_si * measured(values[row], reading.noise, reading.resolution, random));
    }
    csv.end_row();
  }
  return csv.text();
}

void read_virtual_size(Fields& fields, VirtualTable& test) {
  if (auto v = fields.optional("length")) test.length = v->positive_quantity(Dimension::length);
  if (auto v = fields.optional("width")) test.width = v->positive_quantity(Dimension::length);
}

std::vector<double> read_quantities(const Value& list, Dimension dimension, std::string_view what) {
  std::vector<double> values;
  for (const Value& item : list.items()) values.push_back(item.positive_quantity(dimension));
  if (values.empty()) list.fail("is empty", fmt::format("at least one {}", what));
  return values;
}

void read_cycles(Fields& fields, Dimension dimension, VirtualTable& test) {
  test.peaks = read_quantities(fields.require("peaks"), dimension, "peak");
  read_repeats(fields, test);
  read_instrument(fields, test);
}

void read_repeats(Fields& fields, VirtualTable& test) {
  if (auto v = fields.optional("repeats")) test.repeats = v->integer(1, 1000);
}

void read_samples(Fields& fields, VirtualCycles& test) {
  if (auto v = fields.optional("samples")) test.samples = v->integer(3, 1000000);
}

void read_duration(Fields& fields, VirtualCycles& test) {
  if (auto v = fields.optional("duration")) {
    test.duration = v->positive_quantity(Dimension::time);
  }
}

void read_instrument(Fields& fields, VirtualTable& test) {
  read_numbers(fields, "noise", &Channel::noise, test);
  read_numbers(fields, "resolution", &Channel::resolution, test);
}

}  // namespace pliant
