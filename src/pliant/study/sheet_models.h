#pragma once

#include <string>
#include <vector>

#include "pliant/study/study.h"

namespace pliant {

/// A cloth model of the thesis ([T] 3.5): what measures its strains.
struct SheetModel {
  std::string name;
  MembraneMeasure membrane;
  std::string bending;
};

/// How free the curves of a model are.
struct SheetVariant {
  std::string name;
  bool nonlinear = false;    ///< stiffness depends on strain
  bool orthotropic = false;  ///< weft and warp have curves of their own
};

/// One model in one variant, as a fit takes it.
struct ModelVariant {
  SheetModel model;
  SheetVariant variant;
  std::string name() const { return model.name + "." + variant.name; }
};

/// `soft-constraint`, `stvk`, `springs`, in the order of [T] Tables A.1-A.4.
const std::vector<SheetModel>& sheet_models();

/// The four variants, in the order of the same tables: the freest first.
const std::vector<SheetVariant>& sheet_variants();

/// Whether every material of a variant is one of another, too.
bool is_contained(const SheetVariant& smaller, const SheetVariant& larger);

/// All pairs of some models and variants in an order in which a variant comes after those that it
/// contains.
std::vector<ModelVariant> model_variants(const std::vector<std::string>& models,
                                         const std::vector<std::string>& variants);

/// A study whose fit uses a model in a variant, all else as it was.
Study with_model(Study study, const ModelVariant& combination);

}  // namespace pliant
