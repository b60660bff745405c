#pragma once

#include "pliant/experiment/drape/drape_type.h"

namespace pliant {

/// Specimens that are draped again and again. Besides the rows of the test, what each of them looks
/// like: outlines as a table and as a picture, and the draped shapes.
struct VirtualDrape : VirtualTest {
  DrapeSetup setup;
  int repeats = 1;

  const TestType& type() const override { return drape_type(); }
  void require(const Material& material) const override;
  int work() const override { return repeats; }
  VirtualData measure(const VirtualSpecimen& specimen, const VirtualWork& work) const override;
  WrittenFields study_fields() const override;
  std::string heading() const override { return std::string(name_of(setup.history)); }
  WrittenFields description() const override;
  nlohmann::ordered_json facts() const override;
};

}  // namespace pliant
