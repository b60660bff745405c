#include "pliant/experiment/model_options.h"

#include "pliant/experiment/test_type.h"
#include "pliant/material/addend/dahl_branch.h"

namespace pliant {

std::vector<const AddendKind*> addends_with_branches(const ComponentModel& component,
                                                     const FrictionModel& friction) {
  std::vector<const AddendKind*> addends = component.addends;
  if (friction.choice == FrictionChoice::none) return addends;
  for (int branch = 1; branch < friction.branches; ++branch) addends.push_back(&dahl_branch());
  return addends;
}

FrictionModel friction_of(const ModelOptions& model, const std::string& component) {
  const auto own = model.components.find(component);
  const bool said = own != model.components.end() && own->second.friction;
  return said ? *own->second.friction : model.friction;
}

bool is_sheet(const ExperimentSpec& spec, const ModelOptions& model) {
  const TestFacts& facts = spec.test->type().facts;
  return facts.measures_sheets || (model.strips_as_sheets && facts.may_be_sheet);
}

}  // namespace pliant
