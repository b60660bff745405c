#pragma once

#include <optional>

#include "pliant/experiment/session/cord_friction.h"
#include "pliant/experiment/session/sheet_objective.h"
#include "pliant/experiment/session/virtual/options.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// A sheet seen in full while something is done to it ([T] 3.2).
const TestType& session_type();

struct SessionSpec : TestSpec {
  std::optional<SheetObjective> objective;  ///< absent: what is usual for its test
  CordFriction cord_friction;

  const TestType& type() const override { return session_type(); }
  WrittenFields fields() const override;
};

/// Each specimen is a session of its own. Specimens of one number are one sheet, which goes through
/// all tests.
struct VirtualSessionTest : VirtualTest {
  VirtualSession session;

  const TestType& type() const override { return session_type(); }
  void require(const Material& material) const override;
  int work() const override { return session.frames; }
  VirtualData measure(const VirtualSpecimen& specimen, const VirtualWork& work) const override;
  WrittenFields study_fields() const override;
  std::string heading() const override { return session.test; }
  WrittenFields description() const override;
  nlohmann::ordered_json facts() const override;
};

}  // namespace pliant
