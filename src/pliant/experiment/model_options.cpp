#include "pliant/experiment/model_options.h"

namespace pliant {

bool is_sheet(const ExperimentSpec& spec, const ModelOptions& model) {
  return measures_sheets(spec.type) || (model.strips_as_sheets && spec.type == "tensile-cycles");
}

}  // namespace pliant
