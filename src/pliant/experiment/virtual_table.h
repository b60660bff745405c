#pragma once

#include <string>
#include <vector>

#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/sampled_path.h"
#include "pliant/experiment/test_type.h"
#include "pliant/experiment/virtual_test.h"

namespace pliant {

/// How well an instrument reads.
struct Reading {
  double noise = 0;
  double resolution = 0;
};

/// A column of a table, as an instrument shows it.
struct ReadColumn {
  std::string header;
  std::vector<double> values;  ///< SI
  double per_si = 1;
  Reading reading = {};
};

/// A virtual test of one component of the material whose readings are the rows of a CSV table.
struct VirtualTable : VirtualTest {
  std::string direction;
  double length = 0.1, width = 0.1;  ///< of the specimen (m)
  int repeats = 1;                   ///< of the whole sequence
  Instrument instrument;
  std::vector<double> peaks;     ///< turning points, one cycle each
  std::vector<double> settings;  ///< what is set, one after the other

  void require(const Material& material) const override;
  VirtualData measure(const VirtualSpecimen& specimen, const VirtualWork& work) const override;
  std::string heading() const override { return direction; }
  nlohmann::ordered_json facts() const override;
  WrittenFields description() const override;

  /// The rows as a CSV table.
  /// @param law  of the specimen
  virtual std::string rows(const ComponentLaw& law, const ClothFacts& cloth,
                           RandomStream& random) const = 0;

  WrittenFields study_fields() const override;

 protected:
  Reading force() const { return {instrument.force_noise, instrument.force_resolution}; }
  Reading lengths() const { return {instrument.length_noise, instrument.length_resolution}; }
  /// Lines of the description between the heading and the instrument.
  virtual WrittenFields own_description() const = 0;
  /// `SIZE long, SIZE wide`.
  std::string size_text() const;
  /// `A, B, C; N repeats` and more.
  std::string sequence_text(const std::vector<double>& values, Dimension dimension,
                            const std::string& more = "") const;
  /// A prediction that has to be there.
  /// @throws SolverError
  Prediction predicted(const ComponentExperiment& experiment, const ComponentLaw& law,
                       const Eigen::VectorXd& nuisance = {}) const;
  [[noreturn]] void fail(const std::string& problem) const;
};

/// A virtual test that goes to and fro between turning points at even speed.
struct VirtualCycles : VirtualTable {
  int samples = 100;    ///< rows of a half cycle of the largest amplitude
  double slack = 0;     ///< m, by which clamps start nearer than the length
  double duration = 0;  ///< s, that the whole path takes; 0: no times are written

 protected:
  /// Distances of clamps that go apart (1) or together (-1) by shares of the length, and back.
  SampledPath clamp_path(int way) const;
  /// The path, with the times at which its rows are read.
  SampledPath timed(SampledPath path) const;
  /// @param share  of a half cycle of the largest amplitude that the shortest one has
  /// @throws InputError where its reversals could not be found again
  void require_samples(double share) const;
};

/// Adds the column of a path's times, where it has them.
std::vector<ReadColumn> with_times(std::vector<ReadColumn> columns, const SampledPath& path);

/// @param random  is drawn from row by row
std::string table_text(const std::vector<ReadColumn>& columns, RandomStream& random);

/// Reads an optional size of the specimen.
void read_virtual_size(Fields& fields, VirtualTable& test);
/// Reads `peaks`, positive and at least one, `repeats` and the instrument.
void read_cycles(Fields& fields, Dimension dimension, VirtualTable& test);
void read_repeats(Fields& fields, VirtualTable& test);
void read_samples(Fields& fields, VirtualCycles& test);
void read_duration(Fields& fields, VirtualCycles& test);
/// Reads a list of quantities, at least one.
/// @param what  one of them, for messages: "peak"
std::vector<double> read_quantities(const Value& list, Dimension dimension, std::string_view what);
/// Reads `noise` and `resolution`.
void read_instrument(Fields& fields, VirtualTable& test);

}  // namespace pliant
