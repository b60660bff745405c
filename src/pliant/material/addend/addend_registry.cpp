#include "pliant/material/addend/addend_registry.h"

#include <algorithm>
#include <array>
#include <vector>

#include "pliant/material/addend/dahl_branch.h"
#include "pliant/material/addend/lasting_addends.h"
#include "pliant/material/addend/plasticity.h"
#include "pliant/material/addend/rubber_addends.h"

namespace pliant {

std::span<const AddendKind* const> addend_kinds() {
  static const std::array kinds{
      &dahl_branch(),       &plasticity(),   &saturating_plasticity(), &linear_addend(),
      &polynomial_addend(), &ogden_addend(), &arruda_boyce_addend(),   &exponential_addend(),
      &softening_addend(),  &set_addend(),   &maxwell_addend(),        &rate_friction_addend(),
  };
  return kinds;
}

const AddendKind* find_addend_kind(std::string_view name) {
  const auto found = std::ranges::find(addend_kinds(), name, &AddendKind::name);
  return found == addend_kinds().end() ? nullptr : *found;
}

const AddendKind& read_addend_kind(const Value& value) {
  std::vector<std::string_view> names;
  for (const AddendKind* kind : addend_kinds()) names.push_back(kind->name);
  return *find_addend_kind(value.choice(names));
}

}  // namespace pliant
