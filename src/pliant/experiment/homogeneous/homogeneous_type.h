#pragma once

#include <optional>

#include "pliant/experiment/homogeneous/homogeneous_rows.h"
#include "pliant/experiment/test_type.h"

namespace pliant {

/// A specimen of a solid that is deformed alike all over.
const TestType& homogeneous_type();

struct HomogeneousSpec : TestSpec {
  std::optional<HomogeneousMode> mode;  ///< of all rows; else a column says it
  bool incompressible = true;           ///< the volume stays
  double area = 0;                      ///< of the cross-section at rest (m^2); 0: not stated

  const TestType& type() const override { return homogeneous_type(); }
  WrittenFields fields() const override;
  bool volume_may_change() const override { return !incompressible; }
};

/// From rest to a stretch and, where there are several, back and to the next.
struct VirtualHomogeneous : VirtualTest {
  HomogeneousMode mode = HomogeneousMode::uniaxial;
  bool incompressible = true;
  std::vector<double> peaks;    ///< stretches along 1 at which it turns
  std::vector<double> peaks_2;  ///< along 2 at the same time; of biaxial tests
  int samples = 30;             ///< rows of the way from rest to the largest peak
  bool cycles = false;          ///< after each peak back to rest
  double duration = 0;          ///< s, that the whole way takes; 0: no times are written
  double noise = 0;             ///< of the nominal stress (Pa)

  const TestType& type() const override { return homogeneous_type(); }
  void require(const Material& material) const override;
  VirtualData measure(const VirtualSpecimen& specimen, const VirtualWork& work) const override;
  WrittenFields study_fields() const override;
  std::string heading() const override { return std::string(name_of(mode)); }
  WrittenFields description() const override;
  nlohmann::ordered_json facts() const override;

 private:
  std::vector<HomogeneousRow> path() const;
};

}  // namespace pliant
