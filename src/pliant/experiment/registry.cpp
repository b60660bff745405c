#include "pliant/experiment/registry.h"

#include <algorithm>
#include <array>

#include "pliant/base/nearest_name.h"
#include "pliant/experiment/bending/pure_bending_type.h"
#include "pliant/experiment/bending_length/bending_length_type.h"
#include "pliant/experiment/buckling/buckling_bend_type.h"
#include "pliant/experiment/cantilever/cantilever_type.h"
#include "pliant/experiment/contraction/lateral_contraction_type.h"
#include "pliant/experiment/drape/drape_type.h"
#include "pliant/experiment/hanging/hanging_weights_type.h"
#include "pliant/experiment/homogeneous/homogeneous_type.h"
#include "pliant/experiment/indentation/indentation_type.h"
#include "pliant/experiment/moved_body/moved_body_type.h"
#include "pliant/experiment/press/press_type.h"
#include "pliant/experiment/rolled/rolled_strip_type.h"
#include "pliant/experiment/session/session_type.h"
#include "pliant/experiment/shear/shear_cycles_type.h"
#include "pliant/experiment/tensile/tensile_cycles_type.h"

namespace pliant {
namespace {

/// Known to come.
constexpr std::array kLaterTypes = {"image-poses"};

}  // namespace

std::span<const TestType* const> test_types() {
  static const std::array types{
      &hanging_weights_type(), &tensile_cycles_type(), &shear_cycles_type(),
      &pure_bending_type(),    &cantilever_type(),     &rolled_strip_type(),
      &bending_length_type(),  &buckling_bend_type(),  &session_type(),
      &drape_type(),           &homogeneous_type(),    &press_type(),
      &indentation_type(),     &moved_body_type(),     &lateral_contraction_type(),
  };
  return types;
}

const TestType* find_test_type(std::string_view name) {
  const auto found = std::ranges::find(test_types(), name, &TestType::name);
  return found == test_types().end() ? nullptr : *found;
}

const TestFacts& facts_of_test(std::string_view name) {
  static const TestFacts nothing;
  const TestType* type = find_test_type(name);
  return type ? type->facts : nothing;
}

const TestType& read_test_type(const Value& value) {
  std::vector<std::string_view> names;
  for (const TestType* type : test_types()) names.push_back(type->name);
  if (value.is_scalar() && std::ranges::find(kLaterTypes, value.text()) != kLaterTypes.end()) {
    value.fail(quoted_value(value.text()) + " is not there yet",
               list_of_names(std::vector<std::string>(names.begin(), names.end())));
  }
  return *find_test_type(value.choice(names));
}

std::string component_of_test(const TestFacts& facts, const std::string& direction) {
  if (!facts.deformation) return "";
  switch (*facts.deformation) {
    case Deformation::shear:
      return "shear";
    case Deformation::bend:
      return "bend." + (direction == "bias" ? "diagonal" : direction);
    case Deformation::contraction:
      return "contraction." + direction;
    case Deformation::stretch:
      break;
  }
  const bool oblique = direction != "warp" && direction != "weft" && direction != "bias";
  return oblique ? "shear" : "stretch." + direction;
}

std::string component_of_test(std::string_view type, const std::string& direction) {
  return component_of_test(facts_of_test(type), direction);
}

}  // namespace pliant
