#include "pliant/experiment/model_options.h"

#include "pliant/experiment/test_type.h"

namespace pliant {

bool is_sheet(const ExperimentSpec& spec, const ModelOptions& model) {
  const TestFacts& facts = spec.test->type().facts;
  return facts.measures_sheets || (model.strips_as_sheets && facts.may_be_sheet);
}

}  // namespace pliant
