#pragma once

#include "pliant/experiment/drape/drape_setup.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// A round specimen that hangs over a disc (Cusick 1965, ISO 9073-9).
const TestType& drape_type();

struct DrapeSpec : TestSpec {
  DrapeSetup setup;

  const TestType& type() const override { return drape_type(); }
  WrittenFields fields() const override;
};

/// The setup's fields of a study or a lab.
/// @throws InputError
DrapeSetup read_drape_setup(Fields& fields);
/// The same, every default filled in.
WrittenFields written(const DrapeSetup& setup);

}  // namespace pliant
