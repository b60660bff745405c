#include "pliant/experiment/profile/strip_shapes.h"

#include "pliant/material/bending_strain.h"
#include "pliant/material/law_path.h"

namespace pliant {

BendingPath bent_and_released(const ComponentLaw& law, double setting, double curvature) {
  constexpr int kPoints = 120;  // each way
  LawPath stress(law, {});
  BendingPath path;
  path.setting = setting;
  const auto add = [&](int share) {
    path.curvature.push_back(curvature * share / kPoints);
    path.moment.push_back(stress.at(kStrainPerCurvature * path.curvature.back()).stress);
  };
  for (int i = 0; i <= kPoints; ++i) add(i);
  stress.turn_at(kStrainPerCurvature * curvature, {});
  for (int i = kPoints - 1; i >= 0; --i) add(i);
  return path;
}

}  // namespace pliant
