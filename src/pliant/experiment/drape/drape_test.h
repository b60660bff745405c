#pragma once

#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/experiment/test_type.h"
#include "pliant/experiment/whole_sheet_test.h"

namespace pliant {

/// Drape coefficients that were measured, and nodes where they were counted.
///
/// A prediction drapes the specimen three times in its history, and three times in each of the
/// others: what internal friction keeps of the way is the least error of a single measurement.
class DrapeTest : public WholeSheetTest {
 public:
  /// @throws InputError for unusable data
  DrapeTest(const ExperimentSpec& spec, const DataRows& data);

  void require(const Material& material, const Location& where) const override;
  int work() const override;
  WholeSheetPrediction predict(const Material& material, const WholeSheetWork& work) const override;

 private:
  DrapeSetup setup_;
};

}  // namespace pliant
