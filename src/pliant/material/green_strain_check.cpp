#include "pliant/material/green_strain_check.h"

#include <fmt/format.h>

#include "pliant/base/errors.h"

namespace pliant {

void require_green_strain(const std::string& component, MembraneMeasure measure,
                          const Value& node) {
  if (measure == MembraneMeasure::stvk || !solid_metric_of(component)) return;
  const SheetMetric* metric = find_sheet_metric(component);
  if (metric && metric->of_any_strain) return;
  node.fail(fmt::format("names {}, a function of Green's strain, and the membrane is `{}`",
                        quoted_value(component), name_of(measure)),
            "the membrane `stvk`");
}

}  // namespace pliant
