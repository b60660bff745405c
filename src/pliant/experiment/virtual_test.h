#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "pliant/base/errors.h"
#include "pliant/base/progress.h"
#include "pliant/experiment/template_files.h"
#include "pliant/experiment/test_spec.h"
#include "pliant/experiment/virtual_instrument.h"
#include "pliant/material/material.h"

namespace pliant {

/// A specimen that is measured virtually.
struct VirtualSpecimen {
  std::string name;  ///< of its data: that of the experiment, or NAME-02 where there are several
  int number = 1;
  const Material& material;
  double variation = 0;  ///< of every parameter between specimens: relative standard deviation
  RandomStream random;   ///< of the whole lab; to be split by name
};

/// How the work on a specimen is followed.
struct VirtualWork {
  StopToken stop = {};
  std::function<void(int steps)> done = [](int) {};  ///< of `work()`
};

/// What was measured on a specimen.
struct VirtualData {
  TestFiles files;
  std::vector<std::string> warnings = {};
};

/// An experiment of a lab/1 file: the prediction of a test, seen by an instrument.
struct VirtualTest {
  std::string name;
  Location where;
  std::string after;  ///< name of the test that is on the same specimens before; empty: none is
  std::shared_ptr<const VirtualTest> before = nullptr;  ///< that test

  virtual ~VirtualTest() = default;
  virtual const TestType& type() const = 0;
  /// The test that is the first on its specimens.
  const VirtualTest& first() const { return before ? before->first() : *this; }
  /// @throws InputError where a material lacks what the test needs
  virtual void require(const Material& material) const = 0;
  /// Steps that measuring a specimen takes and that are worth telling of.
  virtual int work() const { return 0; }
  /// Measures a specimen: the same for the same seed.
  /// @throws InputError where the measurement could not be used; SolverError without a prediction
  virtual VirtualData measure(const VirtualSpecimen& specimen, const VirtualWork& work) const = 0;
  /// The test's fields in the study of the measurements.
  virtual WrittenFields study_fields() const = 0;

  /// What is done, in a word or two after the type's name; empty: nothing more.
  virtual std::string heading() const = 0;
  /// The same in labelled lines, and as the fields of a JSON object.
  virtual WrittenFields description() const = 0;
  virtual nlohmann::ordered_json facts() const = 0;
};

}  // namespace pliant
