#include "pliant/material/number_error.h"

namespace pliant {

std::string_view name_of(Determination determination) {
  switch (determination) {
    case Determination::within_10_percent:
      return "within 10 %";
    case Determination::within_30_percent:
      return "within 30 %";
    case Determination::weak:
      return "weak";
    case Determination::none:
      return "not determined";
  }
  return "";
}

std::optional<Determination> determination_named(std::string_view name) {
  for (const Determination grade :
       {Determination::within_10_percent, Determination::within_30_percent, Determination::weak,
        Determination::none}) {
    if (name == name_of(grade)) return grade;
  }
  return std::nullopt;
}

}  // namespace pliant
