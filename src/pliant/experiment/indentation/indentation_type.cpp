#include "pliant/experiment/indentation/indentation_type.h"

#include "pliant/experiment/press/press_type.h"

namespace pliant {

const TestType& indentation_type() {
  static const TestType type{
      .name = "indentation",
      .facts = kPressFacts,
      .channels = {force_channel()},
      .template_files = template_files("indentation"),
      .required = {"mesh", "unit", "fixed", "direction"},
      .read = [](Fields& fields, const SpecimenDefaults&,
                 ExperimentSpec&) { return read_press(indentation_type(), fields); },
      .make_solid = make_press,
      .read_virtual = [](Fields& fields) { return read_virtual_press(indentation_type(), fields); },
      .own_quantities = {{"depth", Dimension::length}},
      .is_table =
          [](const TableColumns& columns) {
            return columns.has("depth", Dimension::length) &&
                   columns.has("force", Dimension::force);
          }};
  return type;
}

}  // namespace pliant
