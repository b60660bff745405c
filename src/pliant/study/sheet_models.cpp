#include "pliant/study/sheet_models.h"

#include <algorithm>
#include <optional>

namespace pliant {

const std::vector<SheetModel>& sheet_models() {
  static const std::vector<SheetModel> models{
      {"soft-constraint", MembraneMeasure::soft_constraint, "discrete-shells"},
      {"stvk", MembraneMeasure::stvk, "discrete-shells"},
      {"springs", MembraneMeasure::spring, "spring"}};
  return models;
}

const std::vector<SheetVariant>& sheet_variants() {
  static const std::vector<SheetVariant> variants{{"nonlinear-orthotropic", true, true},
                                                  {"linear-orthotropic", false, true},
                                                  {"nonlinear-isotropic", true, false},
                                                  {"linear-isotropic", false, false}};
  return variants;
}

bool is_contained(const SheetVariant& smaller, const SheetVariant& larger) {
  return smaller.nonlinear <= larger.nonlinear && smaller.orthotropic <= larger.orthotropic;
}

std::vector<ModelVariant> model_variants(const std::vector<std::string>& models,
                                         const std::vector<std::string>& variants) {
  std::vector<ModelVariant> combinations;
  for (const SheetModel& model : sheet_models()) {
    if (std::ranges::find(models, model.name) == models.end()) continue;
    const std::vector<SheetVariant>& all = sheet_variants();
    for (auto variant = all.rbegin(); variant != all.rend(); ++variant) {
      if (std::ranges::find(variants, variant->name) == variants.end()) continue;
      combinations.push_back({model, *variant});
    }
  }
  return combinations;
}

Study with_model(Study study, const ModelVariant& combination) {
  study.model.membrane = combination.model.membrane;
  study.model.bending = combination.model.bending;
  study.model.isotropic = !combination.variant.orthotropic;
  study.model.stiffness = combination.variant.nonlinear ? std::optional<CurveKind>()
                                                        : std::optional(CurveKind::constant);
  return study;
}

}  // namespace pliant
