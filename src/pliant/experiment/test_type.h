#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "pliant/base/quantity.h"
#include "pliant/experiment/component_experiment.h"
#include "pliant/experiment/experiment_spec.h"
#include "pliant/experiment/template_files.h"
#include "pliant/experiment/test_facts.h"
#include "pliant/experiment/virtual_test.h"
#include "pliant/io/fields.h"
#include "pliant/material/material.h"

namespace pliant {

struct StandardFigures;
class WholeSheetTest;

/// A reading of a test's instrument: its key in `noise:` and `resolution:`, and where its numbers
/// are kept.
struct Channel {
  std::string_view key;
  Dimension dimension;
  std::optional<double> StatedNoise::*stated;
  double Instrument::*noise;
  double Instrument::*resolution;
};

constexpr Channel force_channel(std::string_view key = "force",
                                Dimension dimension = Dimension::force) {
  return {key, dimension, &StatedNoise::force, &Instrument::force_noise,
          &Instrument::force_resolution};
}

constexpr Channel length_channel(std::string_view key = "length") {
  return {key, Dimension::length, &StatedNoise::length, &Instrument::length_noise,
          &Instrument::length_resolution};
}

/// What clamps add to a pull: cloth that the largest pull so far has drawn out of them, and what
/// the apparatus gives way (strip_pull.h).
struct Clamps {
  double slip = 0;            ///< m/N
  double compliance = 0;      ///< m/N
  bool slip_is_known = true;  ///< else it is estimated along
  bool compliance_is_known = true;
};

/// `defaults:` of a study; zero where nothing was said.
struct SpecimenDefaults {
  double length = 0;
  double width = 0;
  Clamps clamps = {};
};

/// What of the cloth a test needs beside the law that it is predicted with.
struct ClothFacts {
  double density = 0;  ///< kg/m^2; 0 = not stated
  MembraneMeasure membrane = MembraneMeasure::stvk;
};

/// The columns of a table, by what they hold.
class TableColumns {
 public:
  virtual ~TableColumns() = default;
  virtual bool has(std::string_view quantity, Dimension dimension) const = 0;
};

/// A type of test: all that the rest of the program knows of it (registry.h).
struct TestType {
  std::string_view name;  ///< in studies and labs
  TestFacts facts;
  std::vector<Channel> channels = {};  ///< none: noise is not stated but estimated
  TestFiles template_files = {};       ///< what a laboratory starts the test with; or none
  /// What a study must tell of the test beside its data, in the order in which it is written.
  std::vector<std::string_view> required = {};
  /// Those of them that a column of the same name may tell instead.
  std::vector<std::string_view> told_by_columns = {};

  /// Reads the type's fields of an experiment of a study, its direction included.
  /// @throws InputError
  std::shared_ptr<const TestSpec> (*read)(Fields& fields, const SpecimenDefaults& defaults,
                                          ExperimentSpec& experiment);
  /// Makes the experiment of a specification and its rows; none where sheets are measured
  /// or the test is only predicted.
  /// @throws InputError for unusable data
  std::unique_ptr<ComponentExperiment> (*make)(const ExperimentSpec& spec, const DataRows& data,
                                               const ClothFacts& cloth) = nullptr;
  /// The same of a test of solids.
  /// @throws InputError for unusable data
  std::unique_ptr<Experiment> (*make_solid)(const ExperimentSpec& spec,
                                            const DataRows& data) = nullptr;
  /// The same of a test that is only predicted.
  /// @throws InputError for unusable data
  std::unique_ptr<WholeSheetTest> (*make_whole)(const ExperimentSpec& spec,
                                                const DataRows& data) = nullptr;
  /// Reads the type's fields of an experiment of a lab.
  /// @throws InputError
  std::shared_ptr<VirtualTest> (*read_virtual)(Fields& fields);
  /// Columns of its tables that no other test has.
  std::vector<std::pair<std::string, Dimension>> own_quantities = {};
  /// Whether a table of such columns can be the test's data.
  bool (*is_table)(const TableColumns& columns) = nullptr;
  /// What the test's standard reports of rows; none where there is nothing.
  /// @param test    null where the rows alone are known
  /// @param weight  of the cloth, per area (N/m^2); 0: not known
  StandardFigures (*standard_figures)(const DataRows& data, const TestSpec* test,
                                      double weight) = nullptr;
};

}  // namespace pliant
